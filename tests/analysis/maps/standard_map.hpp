// The Chirikov standard map p′ = p + K sin θ, θ′ = θ + p′, both modulo 2π; state (θ, p).
#pragma once

#include "analysis/section_map.hpp"
#include "tests/analysis/maps/angle.hpp"

#include <cmath>

namespace swirl::analysis::maps {

/// Area preserving: det DF = 1, the exponents are ±λ. K = 0 is a pure shear: both exponents zero.
struct StandardMap {
    static constexpr int dimension = 2;
    double K = 0.971635;

    Advance<2> advance(const Vector<2>& z) const {
        const double p = z[1] + K * std::sin(z[0]);
        return {Vector<2>(wrap_angle(z[0] + p), wrap_angle(p)), 1, 0, true};
    }

    Linearised<2> linearise(const Vector<2>& z) const {
        const Advance<2> step = advance(z);
        const double kick = K * std::cos(z[0]);
        Matrix<2> derivative;
        derivative << 1 + kick, 1, kick, 1;
        return {step.state, step.duration, step.letter, step.alive, derivative};
    }

    static double angle_period(int) { return two_pi; }
};

static_assert(SectionMap<StandardMap>);

}  // namespace swirl::analysis::maps
