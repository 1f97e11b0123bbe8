// The Hénon map x′ = 1 − a x² + y, y′ = b x (Hénon 1976).
#pragma once

#include "analysis/section_map.hpp"

#include <cmath>

namespace swirl::analysis::maps {

/// det DF = −b everywhere, so the exponents sum to ln|b|. Far from the attractor the orbit runs away: the map ends.
struct Henon {
    static constexpr int dimension = 2;
    static constexpr double escape_radius = 1e6;
    double a = 1.4;
    double b = 0.3;

    Advance<2> advance(const Vector<2>& z) const {
        const Vector<2> next(1 - a * z[0] * z[0] + z[1], b * z[0]);
        return {next, 1, 0, std::abs(next[0]) < escape_radius};
    }

    Linearised<2> linearise(const Vector<2>& z) const {
        const Advance<2> step = advance(z);
        Matrix<2> derivative;
        derivative << -2 * a * z[0], 1, b, 0;
        return {step.state, step.duration, step.letter, step.alive, derivative};
    }

    static double angle_period(int) { return 0; }

    /// x of the two fixed points, roots of a x² + (1 − b) x − 1 = 0; y = b x. sign = +1 or −1.
    double fixed_point(int sign) const { return (-(1 - b) + sign * std::sqrt((1 - b) * (1 - b) + 4 * a)) / (2 * a); }
};

static_assert(SectionMap<Henon>);

}  // namespace swirl::analysis::maps
