// A map of one's own, handed to Swirl::analysis from outside: the circle map θ ↦ θ + Ω satisfies SectionMap.
#include "analysis/section_map.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

struct Rotation {
    static constexpr int dimension = 1;
    double omega;

    double angle_period(int) const { return 2 * std::numbers::pi; }
    swirl::analysis::Advance<1> advance(const swirl::analysis::Vector<1>& z) const {
        return {.state = swirl::analysis::Vector<1>{z(0) + omega}};
    }
    swirl::analysis::Linearised<1> linearise(const swirl::analysis::Vector<1>& z) const {
        return {.state = advance(z).state, .derivative = swirl::analysis::Matrix<1>::Identity()};
    }
};
static_assert(swirl::analysis::SectionMap<Rotation>);

int main() {
    const Rotation rotation{.omega = 0.25};  // a power of two: the sum is exact
    const auto step = rotation.linearise(swirl::analysis::Vector<1>{1.0});
    const bool right = step.state(0) == 1.25 && step.derivative(0, 0) == 1.0 && step.alive;
    std::printf("rotation: 1 -> %g, derivative %g\n", step.state(0), step.derivative(0, 0));
    return right ? 0 : 1;
}
