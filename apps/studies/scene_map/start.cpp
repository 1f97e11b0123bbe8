#include "apps/studies/scene_map/start.hpp"

#include "analysis/random_draws.hpp"

#include <cmath>

namespace swirl::studies {

LabStart<double> random_start(double beta, double speed, std::uint64_t seed, std::uint64_t run) {
    const auto u = analysis::uniform_draws({run, 0, 0, 0}, {seed, 0});
    const double turn = 2 * pi<double>();
    const double direction = turn * u[0];
    LabStart<double> start;
    start.x = beta;
    start.vx = speed * std::cos(direction);
    start.vy = speed * std::sin(direction);
    start.angle = turn * u[1];
    return start;
}

}  // namespace swirl::studies
