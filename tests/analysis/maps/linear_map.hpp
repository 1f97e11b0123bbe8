// z′ = A z: exponents are ln|eigenvalues| of A, −∞ for each zero one.
#pragma once

#include "analysis/section_map.hpp"

namespace swirl::analysis::maps {

/// The derivative is A everywhere. With `lifetime` ≥ 0 the map ends once the first coordinate exceeds it.
template <int D>
struct LinearMap {
    static constexpr int dimension = D;
    Matrix<D> A = Matrix<D>::Identity();
    double lifetime = -1;

    Advance<D> advance(const Vector<D>& z) const {
        const Vector<D> next = A * z;
        return {next, 1, 0, lifetime < 0 || next[0] <= lifetime};
    }

    Linearised<D> linearise(const Vector<D>& z) const {
        const Advance<D> step = advance(z);
        return {step.state, step.duration, step.letter, step.alive, A};
    }

    static double angle_period(int) { return 0; }
};

static_assert(SectionMap<LinearMap<3>>);

}  // namespace swirl::analysis::maps
