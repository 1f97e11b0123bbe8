// Lyapunov exponents of a section map: the whole spectrum by QR of DF, or the largest alone.
#pragma once

#include "analysis/linear_algebra/turned_frame.hpp"
#include "analysis/lyapunov/exponent_record.hpp"
#include "analysis/lyapunov/generic_frame.hpp"
#include "analysis/section_map.hpp"
#include "analysis/special_values.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace swirl::analysis {

namespace lyapunov_detail {

/// ln of the growth |r|, −∞ when it is rounding of a derivative of size `norm`.
inline double log_growth(double r, double norm, double rank_tolerance) {
    return std::abs(r) <= rank_tolerance * norm ? -infinity : std::log(std::abs(r));
}

/// The last part of the transient is followed with the frame, so that the frame has converged to the orbit's Lyapunov
/// directions.
inline std::int64_t frame_transient(std::int64_t transient) {
    return transient - transient / 2;
}

}  // namespace lyapunov_detail

/// All D Lyapunov exponents λ_i = lim (1/n) Σ ln R_ii, where DF(z_n) Q_{n−1} = Q_n R_n (Householder QR, so Q stays
/// orthonormal to rounding even where DF is singular).
///   state    start, on the section; `options.transient` steps come first, the second half of them with the frame
/// A step on which R_ii is zero to rounding has annihilated direction i: that exponent is −∞ from then on, the others
/// continue in the new frame. −∞ sorts last. The transient does not count losses. A pair of complex or a neutral,
/// sheared direction converges only as (ln n)/n in the plain mean; see `weighted_exponents` and `judge_sign`. Outcomes:
/// LyapunovOutcome. Cost O(D³) per step besides DF. Source: Benettin, Galgani, Giorgilli & Strelcyn, Meccanica 15
/// (1980) 9; Geist, Parlitz & Lauterborn, Prog. Theor. Phys. 83 (1990) 875.
template <SectionMap M>
LyapunovSpectrum lyapunov_spectrum(const M& map, State<M> state, const LyapunovOptions& options = {}) {
    constexpr int D = M::dimension;
    ExponentAccumulator accumulator(D, options);
    const std::int64_t aligning = lyapunov_detail::frame_transient(options.transient);
    if (const auto steps = options.transient - aligning; follow(map, state, steps) < steps) {
        return accumulator.finish(LyapunovOutcome::ended_in_transient);
    }
    Matrix<D> frame = generic_frame(D);
    for (std::int64_t i = -aligning; i < options.steps; ++i) {
        const auto step = map.linearise(state);
        const bool finite = goes_on(map, step) && step.derivative.allFinite();
        if (!finite) {
            if (i < 0) return accumulator.finish(LyapunovOutcome::ended_in_transient);
            return accumulator.finish(step.alive ? LyapunovOutcome::not_finite : LyapunovOutcome::ended_early);
        }
        frame = (step.derivative * frame).eval();
        const Vector<D> diagonal = turn_frame<D>(frame);
        state = step.state;
        if (i < 0) continue;
        const double norm = step.derivative.norm();
        std::array<double, D> growth;
        for (int j = 0; j < D; ++j) {
            growth[j] = lyapunov_detail::log_growth(diagonal[j], norm, options.rank_tolerance);
        }
        accumulator.add(growth, step.duration);
    }
    return accumulator.finish(LyapunovOutcome::completed);
}

/// One tangent vector in general position, carried along an orbit by its derivatives, which are passed step by step.
template <int D>
class TangentVector {
public:
    ///   rank_tolerance  LyapunovOptions::rank_tolerance
    explicit TangentVector(double rank_tolerance) : rank_tolerance_(rank_tolerance) {}

    /// ln of its growth by DF; −∞ where DF annihilates it, and it begins anew. Cost O(D²).
    double grow(const Matrix<D>& derivative) {
        const Vector<D> grown = derivative * direction_;
        const double growth = lyapunov_detail::log_growth(grown.norm(), derivative.norm(), rank_tolerance_);
        direction_ = std::isinf(growth) ? generic_ : Vector<D>(grown.normalized());
        return growth;
    }

private:
    double rank_tolerance_;
    Vector<D> generic_ = generic_frame(D).col(0), direction_ = generic_;
};

namespace lyapunov_detail {

/// The largest exponent of steps that `next()` gives one after the other, with their derivatives.
///   aligning  of them come first, which are not counted
template <SectionMap M, class Next>
LyapunovSpectrum largest_exponent_of(const M& map, ExponentAccumulator accumulator, std::int64_t aligning,
                                     const LyapunovOptions& options, const Next& next) {
    TangentVector<M::dimension> tangent(options.rank_tolerance);
    for (std::int64_t i = -aligning; i < options.steps; ++i) {
        const auto step = next();
        if (!goes_on(map, step) || !step.derivative.allFinite()) {
            if (i < 0) return accumulator.finish(LyapunovOutcome::ended_in_transient);
            return accumulator.finish(step.alive ? LyapunovOutcome::not_finite : LyapunovOutcome::ended_early);
        }
        const std::array<double, 1> growth = {tangent.grow(step.derivative)};
        if (i >= 0) accumulator.add(growth, step.duration);
    }
    return accumulator.finish(LyapunovOutcome::completed);
}

}  // namespace lyapunov_detail

/// The largest exponent alone, by the growth of one tangent vector: vectors of length 1 in the result. It is −∞ only if
/// the product of the derivatives annihilates a vector in general position. Cost O(D²) per step besides DF.
template <SectionMap M>
LyapunovSpectrum largest_exponent(const M& map, State<M> state, const LyapunovOptions& options = {}) {
    ExponentAccumulator accumulator(1, options);
    const std::int64_t aligning = lyapunov_detail::frame_transient(options.transient);
    if (const auto steps = options.transient - aligning; follow(map, state, steps) < steps)
        return accumulator.finish(LyapunovOutcome::ended_in_transient);
    return lyapunov_detail::largest_exponent_of(map, std::move(accumulator), aligning, options, [&] {
        const auto step = map.linearise(state);
        state = step.state;
        return step;
    });
}

}  // namespace swirl::analysis
