#include "apps/studies/scene_map/rounded_dynamics.hpp"

namespace swirl::studies {

SWIRL_EVERY_MAP(SWIRL_COMPILE_BASELINE_DYNAMICS, double)

}  // namespace swirl::studies
