#include "apps/record/record_reader.hpp"
#include "apps/sweep/run_columns.hpp"
#include "apps/sweep/sweep_command.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace swirl::apps::sweep {

void read_sweep(const std::string& path, Sweep& sweep) {
    const RecordReader record(path);
    if (!record.contains("/sweep/run_mode"))
        throw BadInput(
            fmt::format("record '{}' is not a sweep's: name another file, or replace it with --force", path));
    const auto differs = [&](const std::string& name) {
        throw BadInput(
            fmt::format("record '{}' was made with another {}; give the same, or another file, or replace it with "
                        "--force",
                        path, name));
    };
    for (const auto& [name, value] : sweep.settings)
        if (!record.has_attribute("/settings", name) || record.attribute("/settings", name) != value) differs(name);
    for (const auto& name : record.attributes("/settings"))
        if (name != "kinds" && name != "outcomes" &&
            std::none_of(sweep.settings.begin(), sweep.settings.end(), [&](const auto& s) { return s.first == name; }))
            differs(name);
    auto results = read_run_columns(record, "/sweep");
    if (results.size() != sweep.results.size())
        throw BadInput(
            fmt::format("record '{}' has another grid: name another file, or replace it with --force", path));
    sweep.results = std::move(results);
    if (!record.contains("/sweep/visited")) return;
    for (const std::uint8_t seen : record.read<std::uint8_t>("/sweep/visited"))
        sweep.visited.push_back(static_cast<char>(seen));
    if (sweep.visited.size() != cell_count(sweep.grid))
        throw BadInput(fmt::format("record '{}' is damaged: it does not say of each cell whether it was run", path));
}

}  // namespace swirl::apps::sweep
