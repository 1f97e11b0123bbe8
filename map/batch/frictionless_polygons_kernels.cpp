#define SWIRL_LANES advance_frictionless_polygons
#define SWIRL_LANES_SHAPE Shape::polygon
#define SWIRL_LANES_RULE ImpactRule::frictionless
#include "map/batch/kernels.inc"
