// The result of a quantification as JSON, as a record, and as lines for people.
#pragma once

#include "analysis/recurrence/image.hpp"
#include "analysis/recurrence/lines.hpp"
#include "analysis/recurrence/measures.hpp"
#include "analysis/recurrence/sampled_pairs.hpp"
#include "apps/recurrence/recurrence_points.hpp"

#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::recurrence {

/// What was found with one threshold.
struct ThresholdResult {
    double delta = 0;
    analysis::recurrence::Measures measures;
    double rc = 0, rc_without_diagonal = 0;  ///< of Sun 2019 (docs/references.md); NaN for a cross recurrence
};

struct Quantification {
    analysis::recurrence::Settings conventions;
    Thresholds thresholds;
    std::vector<analysis::recurrence::LineHistograms> lines;  ///< one entry a threshold; empty: too few points
    std::vector<ThresholdResult> results;                     ///< the same
    std::optional<analysis::recurrence::Image> image;
    std::optional<analysis::recurrence::SampledPairs> sampled;  ///< what `results` are estimated from
};

struct RecurrenceReport {
    const RecurrenceOptions& options;
    const RecurrencePoints& points;
    const std::optional<RecurrencePoints>& cross;
    const Quantification& result;
};

void write_json(const RecurrenceReport& report);
void write_record(const RecordGroup& root, const RecurrenceReport& report);
void print_table(const RecurrenceReport& report);

}  // namespace swirl::apps::recurrence
