// The logistic map x′ = r x (1 − x).
#pragma once

#include "analysis/section_map.hpp"

namespace swirl::analysis::maps {

/// Fixed point 1 − 1/r with multiplier 2 − r; at r = 4 the Lyapunov exponent is ln 2. Outside [0, 1] the orbit has
/// escaped: the map ends.
struct Logistic {
    static constexpr int dimension = 1;
    double r = 4;

    Advance<1> advance(const Vector<1>& z) const {
        const double next = r * z[0] * (1 - z[0]);
        return {Vector<1>{next}, 1, z[0] < 0.5 ? 0 : 1, next >= 0 && next <= 1};
    }

    Linearised<1> linearise(const Vector<1>& z) const {
        const Advance<1> step = advance(z);
        return {step.state, step.duration, step.letter, step.alive, Matrix<1>{r * (1 - 2 * z[0])}};
    }

    static double angle_period(int) { return 0; }
};

static_assert(SectionMap<Logistic>);

}  // namespace swirl::analysis::maps
