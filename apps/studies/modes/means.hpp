// Means of S and their errors: along one orbit, and over runs.
#pragma once

#include "analysis/classification/classify.hpp"
#include "analysis/classification/tail.hpp"
#include "analysis/means/mean_error.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace swirl::studies {

/// How the mean of S that a verdict gives was come by, and so what may be said of its error.
enum class MeanKind {
    none,      ///< no mean, or of an orbit that is still changing: no error
    exact,     ///< of a cycle, or of a motion in contact with a period: no sampling, error 0
    sampled,   ///< of chaos, with a standard error
    bounded,   ///< of a torus: no standard error, but a bound, as far as the orbit has filled it
    too_short  ///< of chaos that remembers for too long: no error can be told
};
std::string_view name_of(MeanKind kind);

/// What the means of one orbit are worth. NaN where there is none.
struct MeanErrors {
    MeanKind kind = MeanKind::none;
    double per_time = analysis::nan;    ///< standard error of the time mean; 0 where it is exact
    double per_impact = analysis::nan;  ///< of the mean over impacts
    double bound = analysis::nan;       ///< of a torus: how far the time mean is off, at most
};

/// Of chaos by analysis::error_of_ratio and error_of_mean over the impacts of the tail; of a torus bound_of_ratio.
///   spins  S after each impact of a tail
MeanErrors errors_of_means(const analysis::Classification& verdict, std::span<const double> spins,
                           std::span<const double> integrals, std::span<const double> durations);

/// The errors of a tail's means; the series of S is made only where it is asked for. Cost: some 5 ns an impact of
/// chaos, else none.
template <analysis::SectionMap M>
MeanErrors errors_of_means(const M& map, const analysis::Tail<M>& tail, const analysis::Classification& verdict) {
    const bool asked = verdict.kind == analysis::Kind::chaotic || verdict.kind == analysis::Kind::quasi_periodic;
    return errors_of_means(
        verdict, asked ? analysis::classification_detail::series_of(map, tail, M::integrated) : std::vector<double>{},
        tail.integrals, tail.durations);
}

/// x̄ = Σ x_i / n; NaN of none.
double mean_of(std::span<const double> values);

/// The error of x̄ over n runs that start independently, s t/(1.96 √n), whatever each run's own correlations, with
/// s² = Σ (x_i − x̄)²/(n − 1) and t the 97.5 % quantile of Student's distribution with n − 1 degrees of freedom: so
/// ± 2 errors hold the mean at 95 % however few runs there are, as those of blocks do (t/1.96 is 6.5, 2.2, 1.6, 1.2 for
/// n = 2, 3, 4, 8). Of one run its own error, if it was sampled. NaN where there is neither.
///   errors  the runs' own; none: those of one run are NaN
double error_of_mean(std::span<const double> values, std::span<const double> errors = {});

}  // namespace swirl::studies
