#include "apps/modes/risk_document.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/sweep/run_cells.hpp"
#include "apps/sweep/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace swirl::apps::sweep {

bool read_sweep(const std::string& path, Sweep& sweep, std::vector<char>& done) {
    const RecordReader record(path);
    if (!record.contains("/sweep/run_mode"))
        throw BadInput(
            fmt::format("record '{}' is not a sweep's: name another file, or replace it with --force", path));
    Settings found;
    for (const auto& name : record.attributes("/settings"))
        if (name != "kinds" && name != "outcomes") found.emplace_back(name, record.attribute("/settings", name));
    const std::int64_t runs = runs_of_same_sweep(path, sweep.settings, found);
    const std::size_t cells = cell_count(sweep.grid);
    const auto results = read_run_columns(record, "/sweep");
    if (results.size() != cells * static_cast<std::size_t>(runs))
        throw BadInput(
            fmt::format("record '{}' has another grid: name another file, or replace it with --force", path));
    std::vector<char> visited(cells, 1);
    if (record.contains("/sweep/visited")) {
        const auto seen = record.read<std::uint8_t>("/sweep/visited");
        if (seen.size() != cells)
            throw BadInput(
                fmt::format("record '{}' is damaged: it does not say of each cell whether it was run", path));
        visited.assign(seen.begin(), seen.end());
        sweep.visited = visited;
    }
    for (std::size_t c = 0; c < cells; ++c)
        take_runs(std::span(results).subspan(c * static_cast<std::size_t>(runs), static_cast<std::size_t>(runs)), c,
                  visited[c], sweep, done);
    sweep.risk = read_risk(record);
    return runs == sweep.runs;
}

}  // namespace swirl::apps::sweep
