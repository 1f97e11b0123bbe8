#define SWIRL_LANES advance_frictionless_disks
#define SWIRL_LANES_SHAPE Shape::disk
#define SWIRL_LANES_RULE ImpactRule::frictionless
#include "map/batch/kernels.inc"
