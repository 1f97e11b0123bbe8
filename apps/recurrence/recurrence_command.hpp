// `swirl recurrence`: recurrence quantification of an orbit, a record or a measured series.
#pragma once

#include "analysis/recurrence/rates.hpp"
#include "analysis/recurrence/settings.hpp"
#include "apps/input/input_options.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::recurrence {

/// The recurrence conventions as the flags give them; what is not given is the convention's.
struct ConventionOptions {
    std::string convention, norm, rate_pairs, recurrence_time, triangles, border_lines, logarithm;
    std::optional<int> theiler, min_diagonal, min_vertical;
    bool strict = false;

    void add_to(Flags& command);

    /// @throws BadInput, std::invalid_argument naming the option
    analysis::recurrence::Settings settings() const;
    /// Of which standard deviation --threshold-std takes multiples: pyunicorn divides by n.
    analysis::recurrence::Deviation deviation() const;
};

struct RecurrenceOptions {
    InputOptions input;
    ConventionOptions conventions;
    OutputOptions output;
    std::string observables = "S";
    std::vector<std::string> thresholds, thresholds_std, rates;  ///< texts, each a number or a comma-separated list
    int dimension = 1;
    int delay = 1;
    std::string period;    ///< of a measured angle
    std::string resample;  ///< spacing; empty: as measured
    bool join_gaps = false;
    std::string cross;  ///< file of the second series
    std::string cross_column;
    std::size_t image = 0;           ///< pixels; 0: none
    std::int64_t sampled_pairs = 0;  ///< random pairs that stand for all; 0: all pairs
    std::uint64_t sample_seed = 1;

    void add_to(Flags& command);
};

extern const char* const recurrence_details;

/// @return the exit code
int quantify_recurrence(RecurrenceOptions& options);

}  // namespace swirl::apps::recurrence
