// Judgements on a computed Lyapunov spectrum: is an exponent positive, negative or neutral, and has it settled?
#pragma once

#include "analysis/lyapunov/exponent_record.hpp"
#include "analysis/section_map.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace swirl::analysis {

enum class ExponentSign {
    positive,
    negative,
    neutral,    ///< zero: the summed growth stays bounded, or grows like its logarithm (a sheared family)
    undecided,  ///< within the error of zero, but the sum grows like a random walk: zero, or too small for this length
};
std::string_view name_of(ExponentSign sign);

struct SignOptions {
    double sigmas = 5;               ///< standard errors from zero that make a sign
    double neutral_scale = 10;       ///< a neutral plain mean is at most neutral_scale · (1 + ln n)/n
    double neutral_growth = 0.25;    ///< largest growth order of a bounded sum (random walk ½, drift 1)
    double shear_octave = 0.8;       ///< a sheared direction grows by ln 2 = 0.69 each time n doubles …
    double shear_ratio = 1.5;        ///< … by as much as in the octave before (a drift: by twice as much)
    double neutral_weighted = 1e-7;  ///< or: a weighted mean that is, with its half difference, below this
    double burst_sigmas = 3;         ///< standard errors that are enough where growth goes on in every quarter
    double drift = 20;               ///< Σ ln growth beyond this excludes a bounded sum and a shear, if …
    double drift_share = 0.25;       ///< … so much of it comes in the last half (a drift: ½, a shear: 0.07)
};

/// The evidence for a sign, in the order in which it decides.
struct SignEvidence {
    ExponentSign sign = ExponentSign::undecided;
    double exponent = 0;  ///< per step
    double standard_error = 0;
    double growth_order = 0;       ///< LyapunovSpectrum::growth_orders
    double last_octave = 0;        ///< Σ ln growth over the last half of the blocks
    double octave_before = 0;      ///< over the quarter before
    double least_quarter = 0;      ///< the smallest of the last three quarters' Σ ln growth
    double shrinking_bound = 0;    ///< neutral_scale (1 + ln n)/n
    double weighted_exponent = 0;  ///< NaN if not available
    double weighted_half_difference = 0;
};

/// Judges exponent `index` (0: the largest). −∞ is negative. Neutral if its weighted mean is zero to
/// `neutral_weighted`, or if it is within the shrinking bound and Σ ln growth is bounded (`neutral_growth`) or grows
/// like ln n (`shear_octave`, `shear_ratio`; for a Jordan block of size 2). A sum that drifts is not neutral: beyond
/// `drift`, with at least `drift_share` of it in the last half. Otherwise signed if it is `sigmas` standard errors from
/// zero, else undecided; undecided too where there are too few steps for the evidence. Positive beyond `burst_sigmas`
/// already (the error is large where growth comes in bursts) if each of the last three quarters has grown by more than
/// neutral_scale (1 + ln n): on a regular orbit the product of derivatives grows at most like a power of n. Throws
/// std::invalid_argument for an index out of range.
SignEvidence judge_sign(const LyapunovSpectrum& spectrum, std::size_t index, const SignOptions& options = {});

/// Is it positive on as few steps as these, too: beyond what the sum of a bounded or a sheared direction may be?
bool is_clearly_positive(const SignEvidence& evidence);

/// How many steps that will take if the exponent stays what it is: its standard error falls like the root of the steps,
/// the bound of a neutral direction like (1 + ln n)/n. 0 for an exponent that is not positive.
///   steps  those of the evidence
std::int64_t steps_until_positive(const SignEvidence& evidence, std::int64_t steps, const SignOptions& options = {});

/// Whether the running mean has converged, or the orbit is still a transient.
struct Settling {
    bool settled = false;
    double early = 0;        ///< mean over the first quarter of the blocks, per step
    double late = 0;         ///< over the last half
    double error = 0;        ///< standard error of late − early, from the last half's scatter
    double last_change = 0;  ///< |λ(n) − λ(n/2)| from the record
};

/// Settled if |late − early| ≤ max(sigmas · error, tolerance): during a transient the growth rate differs. −∞ is
/// settled. NaN and not settled below 32 blocks. `tolerance` is per step. Throws for an index out of range.
Settling judge_settling(const LyapunovSpectrum& spectrum, std::size_t index, double tolerance = 1e-3,
                        double sigmas = 5);

/// Tests whether g is the gradient of a conserved quantity, g(F(z)) DF(z) = g(z); one direction is then neutral.
struct GradientInvariance {
    LyapunovOutcome outcome = LyapunovOutcome::completed;
    std::int64_t steps = 0;
    double largest_residual = 0;  ///< max ‖g(F(z)) DF − g(z)‖ / (‖g(F(z))‖ ‖DF‖ + ‖g(z)‖): rounding if invariant
};

/// Follows `steps` steps from `state`. gradient(z) → Vector<D>, of a state. Cost O(D²) per step besides DF.
template <SectionMap M, class Gradient>
GradientInvariance gradient_invariance(const M& map, State<M> state, const Gradient& gradient, std::int64_t steps) {
    constexpr int D = M::dimension;
    GradientInvariance result;
    for (; result.steps < steps; ++result.steps) {
        const auto step = map.linearise(state);
        if (!goes_on(map, step) || !step.derivative.allFinite()) {
            result.outcome = step.alive ? LyapunovOutcome::not_finite : LyapunovOutcome::ended_early;
            return result;
        }
        const Vector<D> here = gradient(state);
        const Vector<D> there = gradient(step.state);
        const double scale = there.norm() * step.derivative.norm() + here.norm();
        const double residual = (step.derivative.transpose() * there - here).norm();
        if (scale > 0) result.largest_residual = std::max(result.largest_residual, residual / scale);
        state = step.state;
    }
    return result;
}

}  // namespace swirl::analysis
