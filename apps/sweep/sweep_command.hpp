// `swirl sweep`: the modes across parameters.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/sweep/grid.hpp"
#include "apps/sweep/sweep_results.hpp"

#include <string>
#include <vector>

namespace swirl::apps::sweep {

struct SweepOptions {
    SceneOptions scene;
    StartOptions start;
    OutputOptions output;
    std::vector<std::string> grid;
    std::int64_t runs = 1;
    analysis::ClassifyOptions settings;

    void add_to(Flags& command);
};

extern const char* const sweep_details;

/// A sweep, whole: what was asked for and what was found. Results of cell c, run r are at c · runs + r.
struct Sweep {
    std::vector<GridAxis> grid;
    std::int64_t runs = 1;
    Settings settings;  ///< everything that the results depend on, in the order in which it is compared
    std::vector<RunResult> results;

    std::span<const RunResult> cell(std::size_t index) const {
        return std::span(results).subspan(index * static_cast<std::size_t>(runs), static_cast<std::size_t>(runs));
    }
};

/// A record of a finished sweep. @throws RecordError
void write_sweep(const SweepOptions& options, const Sweep& sweep);

/// Reads the results of a record that was made with the same settings. @throws BadInput naming the first that differs
void read_sweep(const std::string& path, Sweep& sweep);

void print_sweep(const Sweep& sweep);  ///< a map in characters (1 or 2 axes) and the shares
void write_sweep_document(const SweepOptions& options, const Sweep& sweep);  ///< JSON

int sweep(SweepOptions& options);

}  // namespace swirl::apps::sweep
