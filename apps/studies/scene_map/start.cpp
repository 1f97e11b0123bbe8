#include "apps/studies/scene_map/start.hpp"

#include <Random123/philox.h>
#include <Random123/uniform.hpp>

#include <cmath>

namespace swirl::studies {

LabStart<double> random_start(double beta, double speed, std::uint64_t seed, std::uint64_t run) {
    const r123::Philox4x64 generator;
    const auto bits = generator({{run, 0, 0, 0}}, {{seed, 0}});
    const double turn = 2 * pi<double>();
    const double direction = turn * r123::u01<double>(bits[0]);
    LabStart<double> start;
    start.x = beta;
    start.vx = speed * std::cos(direction);
    start.vy = speed * std::sin(direction);
    start.angle = turn * r123::u01<double>(bits[1]);
    return start;
}

}  // namespace swirl::studies
