// Normal forms of maps at a doubling and at a Neimark–Sacker point, with coefficients published for BifurcationKit.jl.
#pragma once

#include "analysis/section_map.hpp"

#include <complex>

namespace swirl::analysis::maps {

/// u′ = (−1 + 0.456 p) u − 1.234 u³: period doubling of u = 0 at p = 0.
struct FlipNormalForm {
    static constexpr int dimension = 1;
    double p = 0;
    double linear = 0.456;
    double cubic = -1.234;

    Advance<1> advance(const Vector<1>& z) const {
        return {Vector<1>{(-1 + linear * p) * z[0] + cubic * z[0] * z[0] * z[0]}, 1, 0, true};
    }

    Linearised<1> linearise(const Vector<1>& z) const {
        return {advance(z).state, 1, 0, true, Matrix<1>{-1 + linear * p + 3 * cubic * z[0] * z[0]}};
    }

    static double angle_period(int) { return 0; }
};

/// z′ = z e^{0.1 i} (1 + 1.123 p + (−6.789 − 0.456 i)|z|²), z = u₀ + i u₁: Neimark–Sacker of z = 0 at p = 0.
struct NeimarkSackerNormalForm {
    static constexpr int dimension = 2;
    double p = 0;
    double theta = 0.1;
    double linear = 1.123;
    std::complex<double> cubic{-6.789, -0.456};

    Advance<2> advance(const Vector<2>& u) const {
        const std::complex<double> z(u[0], u[1]);
        const std::complex<double> next = z * std::polar(1.0, theta) * (1 + linear * p + cubic * std::norm(z));
        return {Vector<2>(next.real(), next.imag()), 1, 0, true};
    }

    Linearised<2> linearise(const Vector<2>& u) const {
        // ∂z′/∂z = e^{iθ}(1 + l p + 2 c|z|²) and ∂z′/∂z̄ = e^{iθ} c z²; dz = du₀ + i du₁.
        const std::complex<double> z(u[0], u[1]);
        const std::complex<double> turn = std::polar(1.0, theta);
        const std::complex<double> along = turn * (1 + linear * p + 2.0 * cubic * std::norm(z));
        const std::complex<double> conjugate = turn * cubic * z * z;
        const std::complex<double> first = along + conjugate;
        const std::complex<double> second = std::complex<double>(0, 1) * (along - conjugate);
        Matrix<2> derivative;
        derivative << first.real(), second.real(), first.imag(), second.imag();
        return {advance(u).state, 1, 0, true, derivative};
    }

    static double angle_period(int) { return 0; }
};

static_assert(SectionMap<FlipNormalForm> && SectionMap<NeimarkSackerNormalForm>);

}  // namespace swirl::analysis::maps
