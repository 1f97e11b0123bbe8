#define SWIRL_LANES advance_disks
#define SWIRL_LANES_SHAPE Shape::disk
#define SWIRL_LANES_RULE ImpactRule::poisson
#include "map/batch/kernels.inc"
