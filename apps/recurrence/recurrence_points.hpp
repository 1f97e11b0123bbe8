// The points of an orbit, a record or a series whose recurrences are counted.
#pragma once

#include "analysis/recurrence/metric.hpp"
#include "apps/recurrence/recurrence_command.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::recurrence {

/// Points with where they come from.
struct RecurrencePoints {
    analysis::recurrence::Points points;
    bool enough = true;        ///< false: the orbit ended too early for a pair of points
    std::size_t left_out = 0;  ///< points that embed across a gap
    /// Of a series with gaps, its values one by one: standard deviations are theirs, whatever delay vectors are left.
    std::optional<analysis::recurrence::Points> observed;
    std::vector<std::string> notes;
    std::optional<OrbitColumns> orbit;
    std::optional<MeasuredSeries> series;
    Settings resampled;  ///< what --resample did; empty: nothing
};

/// "psi,chi" -> psi, chi. @throws BadInput for an empty name
std::vector<std::string> observables_of(const std::string& text);

/// How many comma-separated values a threshold's text has.
std::size_t values_in(const std::string& text);

RecurrencePoints main_points(RecurrenceOptions& options);

/// The second trajectory, if --cross or --cross-column was given: a record's, if the file is one, or a series'.
std::optional<RecurrencePoints> cross_points(const RecurrenceOptions& options);

/// The thresholds that the flags ask for. @throws BadInput for two kinds, a value out of range
struct Thresholds {
    std::string kind;  ///< threshold, threshold_std or recurrence_rate
    std::vector<double> given;
    std::vector<double> delta;  ///< the distances they stand for
    bool floored = false;       ///< the observable is constant to rounding: the floor stands for --threshold-std
};
Thresholds thresholds_of(const RecurrenceOptions& options, const RecurrencePoints& points, bool cross,
                         const analysis::recurrence::Settings& settings);

/// The user's units, and that of the observable: thresholds are given and read in it.
std::optional<Units> units_of(const RecurrencePoints& points);
std::string unit_of(const RecurrencePoints& points);

}  // namespace swirl::apps::recurrence
