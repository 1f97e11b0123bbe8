#define SWIRL_LANES advance_newton_polygons
#define SWIRL_LANES_SHAPE Shape::polygon
#define SWIRL_LANES_RULE ImpactRule::newton
#include "map/batch/kernels.inc"
