// Means of a measured series and their errors.
#pragma once

#include "analysis/means/mean_error.hpp"
#include "apps/command_line/plain_names.hpp"
#include "apps/input/measured_series.hpp"
#include "apps/studies/modes/means.hpp"

#include <cstddef>
#include <vector>

namespace swirl::apps::classify {

/// Of values at impacts, each of which holds until the next: ∫S dt over the time.
inline double time_mean(const MeasuredSeries& series) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < series.values.size(); ++i)
        sum += series.values[i] * (series.times[i + 1] - series.times[i]);
    return sum / (series.times.back() - series.times.front());
}

/// Of values at impacts without times, which have no mean over time.
inline MeanErrors errors_over_impacts(const analysis::Classification& verdict, const MeasuredSeries& used) {
    MeanErrors errors;
    if (verdict.kind != analysis::Kind::chaotic) return errors;
    const analysis::MeanError found = analysis::error_of_mean(used.values);
    errors.kind = found.outcome == analysis::SamplingOutcome::sampled ? MeanKind::sampled : MeanKind::too_short;
    errors.per_impact = found.standard_error;
    return errors;
}

/// Of chaos and of a torus, as of an orbit (MeanErrors). Of all else nothing: a cycle's mean in a series has noise that
/// nothing here tells from its values.
///   used          the values judged, in one stretch
///   sampled_flow  samples evenly in time, so that the mean is one of time; else impacts, of which it is one as well
inline MeanErrors errors_of_series(const analysis::Classification& verdict, const MeasuredSeries& used,
                                   bool sampled_flow) {
    const bool has_error = verdict.kind == analysis::Kind::chaotic || verdict.kind == analysis::Kind::quasi_periodic;
    if (!has_error || used.values.size() < 2) return {};
    if (!sampled_flow && used.time.empty()) return errors_over_impacts(verdict, used);
    std::vector<double> integrals, durations;
    for (std::size_t i = 0; i + (sampled_flow ? 0 : 1) < used.values.size(); ++i) {
        durations.push_back(sampled_flow ? 1 : used.times[i + 1] - used.times[i]);
        integrals.push_back(used.values[i] * durations.back());
    }
    MeanErrors errors = studies::errors_of_means(verdict, used.values, integrals, durations);
    if (sampled_flow) errors.per_impact = analysis::nan;
    return errors;
}

}  // namespace swirl::apps::classify
