// Two circle maps: one whose rotation number is known exactly, and Arnold's, which locks.
#pragma once

#include "analysis/section_map.hpp"
#include "tests/analysis/maps/angle.hpp"

#include <cmath>
#include <complex>

namespace swirl::analysis::maps {

/// h⁻¹ ∘ (rotation by 2πρ) ∘ h with h the Möbius map z ↦ (z + a)/(1 + a z) of the unit circle, |a| < 1: analytic, not a
/// rigid rotation, and its rotation number is exactly ρ. Its exponent is zero for every ρ.
struct ConjugatedRotation {
    static constexpr int dimension = 1;
    double rotation = golden_mean;
    double a = 0.4;

    Advance<1> advance(const Vector<1>& z) const { return {linearise(z).state, 1, 0, true}; }

    Linearised<1> linearise(const Vector<1>& z) const {
        const std::complex<double> from = std::polar(1.0, z[0]);
        const std::complex<double> turned = (from + a) / (1.0 + a * from) * std::polar(1.0, two_pi * rotation);
        const std::complex<double> to = (turned - a) / (1.0 - a * turned);
        // d arg h / d arg z = (1 − a²)/|1 + a z|², and its inverse at the image.
        const double derivative = std::norm(1.0 + a * to) / std::norm(1.0 + a * from);
        return {Vector<1>{wrap_angle(std::arg(to))}, 1, 0, true, Matrix<1>{derivative}};
    }

    static double angle_period(int) { return two_pi; }
};

/// Arnold's θ′ = θ + 2πΩ − K sin θ. For |Ω| < K/2π it has a fixed point sin θ = 2πΩ/K with multiplier
/// 1 − K cos θ: rotation number 0.
struct ArnoldCircleMap {
    static constexpr int dimension = 1;
    double omega = 0.1;
    double K = 0.8;

    Advance<1> advance(const Vector<1>& z) const {
        return {Vector<1>{wrap_angle(z[0] + two_pi * omega - K * std::sin(z[0]))}, 1, 0, true};
    }

    Linearised<1> linearise(const Vector<1>& z) const {
        return {advance(z).state, 1, 0, true, Matrix<1>{1 - K * std::cos(z[0])}};
    }

    static double angle_period(int) { return two_pi; }
};

static_assert(SectionMap<ConjugatedRotation> && SectionMap<ArnoldCircleMap>);

}  // namespace swirl::analysis::maps
