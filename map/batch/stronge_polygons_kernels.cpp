#define SWIRL_LANES advance_stronge_polygons
#define SWIRL_LANES_SHAPE Shape::polygon
#define SWIRL_LANES_RULE ImpactRule::stronge
#include "map/batch/kernels.inc"
