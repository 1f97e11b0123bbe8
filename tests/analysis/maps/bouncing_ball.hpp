// The bouncing ball on a shaken table (Holmes 1982): φ′ = φ + v, v′ = αv − γ cos φ′; state (φ, v).
#pragma once

#include "analysis/section_map.hpp"
#include "tests/analysis/maps/angle.hpp"

#include <cmath>

namespace swirl::analysis::maps {

/// det DF = α. Fixed points v = 2πn, cos φ = −2πn(1 − α)/γ (φ modulo 2π); saddle-nodes at γ = 2πn(1 − α), doublings at
/// γ² = 4(1 + α)² + (2πn(1 − α))².
struct BouncingBall {
    static constexpr int dimension = 2;
    double alpha = 0.8;
    double gamma = 3.0;

    Advance<2> advance(const Vector<2>& z) const {
        const double phase = z[0] + z[1];
        return {Vector<2>(wrap_angle(phase), alpha * z[1] - gamma * std::cos(phase)), 1, 0, true};
    }

    Linearised<2> linearise(const Vector<2>& z) const {
        const Advance<2> step = advance(z);
        const double slope = gamma * std::sin(z[0] + z[1]);
        Matrix<2> derivative;
        derivative << 1, 1, slope, alpha + slope;
        return {step.state, step.duration, step.letter, step.alive, derivative};
    }

    static double angle_period(int i) { return i == 0 ? two_pi : 0; }
};

static_assert(SectionMap<BouncingBall>);

}  // namespace swirl::analysis::maps
