#include "apps/studies/modes/means.hpp"

#include "analysis/enum_name.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <cmath>

namespace swirl::studies {

namespace {

/// Is nothing sampled? A cycle's mean is that of one period; what stays on the wall rests, turns
/// evenly or swings, and what rides turns as it does in the end.
bool is_exact(analysis::Kind kind) {
    using analysis::Kind;
    switch (kind) {
        case Kind::fixed_point:
        case Kind::family:
        case Kind::cycle:
        case Kind::landing:
        case Kind::rolling:
        case Kind::rolling_librating:
        case Kind::rolling_circulating:
        case Kind::sliding:
        case Kind::two_vertex:
        case Kind::riding:
            return true;
        default:
            return false;
    }
}

}  // namespace

std::string_view name_of(MeanKind kind) {
    using enum MeanKind;
    return analysis::name_in<MeanKind>(
        {{none, "none"}, {exact, "exact"}, {sampled, "sampled"}, {bounded, "bounded"}, {too_short, "too-short"}}, kind);
}

MeanErrors errors_of_means(const analysis::Classification& verdict, std::span<const double> spins,
                           std::span<const double> integrals, std::span<const double> durations) {
    MeanErrors errors;
    if (!std::isfinite(verdict.mean)) return errors;
    if (is_exact(verdict.kind)) return {MeanKind::exact, 0, 0, analysis::nan};
    if (verdict.kind == analysis::Kind::quasi_periodic) {
        errors.kind = MeanKind::bounded;
        errors.bound = analysis::bound_of_ratio(integrals, durations);
    }
    if (verdict.kind != analysis::Kind::chaotic) return errors;
    const analysis::MeanError per_time = analysis::error_of_ratio(integrals, durations);
    errors.kind = per_time.outcome == analysis::SamplingOutcome::sampled ? MeanKind::sampled : MeanKind::too_short;
    errors.per_time = per_time.standard_error;
    errors.per_impact = analysis::error_of_mean(spins).standard_error;
    return errors;
}

double mean_of(std::span<const double> values) {
    return values.empty() ? analysis::nan : gsl_stats_mean(values.data(), 1, values.size());
}

double error_of_mean(std::span<const double> values, std::span<const double> errors) {
    if (values.size() == 1 && errors.size() == 1 && errors[0] > 0) return errors[0];
    if (values.size() < 2) return analysis::nan;
    const double count = static_cast<double>(values.size());
    const double few_runs = gsl_cdf_tdist_Pinv(0.975, count - 1) / gsl_cdf_ugaussian_Pinv(0.975);
    return few_runs * gsl_stats_sd(values.data(), 1, values.size()) / std::sqrt(count);
}

}  // namespace swirl::studies
