#define SWIRL_LANES advance_poisson_polygons
#define SWIRL_LANES_SHAPE Shape::polygon
#define SWIRL_LANES_RULE ImpactRule::poisson
#include "map/batch/kernels.inc"
