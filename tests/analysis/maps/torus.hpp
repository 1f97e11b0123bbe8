// A map with an attracting smooth invariant circle, known in closed form: θ′ = θ + 2πρ, x′ = a x + cos θ; state (θ, x).
#pragma once

#include "analysis/section_map.hpp"
#include "tests/analysis/maps/angle.hpp"

#include <cmath>
#include <complex>

namespace swirl::analysis::maps {

/// Exponents 0 and ln|a|. The circle is x = Re(e^{iθ}/(e^{2πiρ} − a)). Steps last 1 + τ cos θ, of mean 1.
struct DrivenTorus {
    static constexpr int dimension = 2;
    double rotation = golden_mean;
    double a = 0.5;
    double tau = 0;

    Advance<2> advance(const Vector<2>& z) const {
        return {Vector<2>(wrap_angle(z[0] + two_pi * rotation), a * z[1] + std::cos(z[0])), 1 + tau * std::cos(z[0]), 0,
                true};
    }

    Linearised<2> linearise(const Vector<2>& z) const {
        const Advance<2> step = advance(z);
        Matrix<2> derivative;
        derivative << 1, 0, -std::sin(z[0]), a;
        return {step.state, step.duration, step.letter, step.alive, derivative};
    }

    static double angle_period(int i) { return i == 0 ? two_pi : 0; }

    Vector<2> on_circle(double theta) const {
        const std::complex<double> response = std::polar(1.0, theta) / (std::polar(1.0, two_pi * rotation) - a);
        return {wrap_angle(theta), response.real()};
    }
};

static_assert(SectionMap<DrivenTorus>);

}  // namespace swirl::analysis::maps
