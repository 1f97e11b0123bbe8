// A sweep for people: the modes of its cells, and the shares.
#include "apps/modes/escape_document.hpp"
#include "apps/modes/risk_document.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"
#include "apps/sweep/result_tables.hpp"
#include "apps/sweep/sweep_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::sweep {

namespace {

void print_basins(const Sweep& sweep) {
    print_table(in_units(basin_table(), sweep.units), sweep.basins->basins);
    const auto none = std::count(sweep.basins->of_cell.begin(), sweep.basins->of_cell.end(), no_basin);
    if (none > 0)
        fmt::print("  the verdicts of {} of {} cells name no attractor\n", none, sweep.basins->of_cell.size());
}

void print_saddles(const Boundaries& boundaries, const std::optional<Units>& units) {
    using analysis::StraddleEnd;
    const auto count = [&](StraddleEnd where) {
        return std::count_if(boundaries.places.begin(), boundaries.places.end(),
                             [&](const BoundaryPlace& place) { return place.leads_to == where; });
    };
    fmt::print("boundaries of basins at {} points:", boundaries.places.size());
    for (const StraddleEnd where : {StraddleEnd::found, StraddleEnd::border, StraddleEnd::rounding,
                                    StraddleEnd::undecided, StraddleEnd::ended, StraddleEnd::not_found})
        if (count(where) > 0) fmt::print(" {} {}", name_of(where), count(where));
    fmt::print("\n");
    if (!boundaries.saddles.empty()) print_table(in_units(saddle_table(), units), boundaries.saddles);
}

/// Those over most cells.
void print_tracks(const Sweep& sweep) {
    constexpr std::size_t most = 20;
    std::vector<Track> tracks = tracks_of(sweep.attractors);
    const std::size_t all = tracks.size();
    tracks.resize(std::min(all, most));
    print_table(in_units(track_table(), sweep.units), tracks);
    if (all > most) fmt::print("  and {} more, over fewer cells each\n", all - most);
    const Tracking& t = sweep.tracking;
    const std::string carried = fmt::format(
        "cycles were carried to a neighbour {} times: {} came to an attractor there, {} to one that no start showed, "
        "{} do not attract there, {} were not found",
        t.carried, t.arrived, t.unseen, t.not_attracting, t.not_found());
    fmt::print("{}\n", wrapped(carried, 4));
}

}  // namespace

void print_sweep(const Sweep& sweep) {
    if ((!sweep.grid.front().sampled || is_of_scenes(sweep)) && !sweep.shard) print_modes(sweep);
    std::vector<RunResult> results;
    std::size_t cells = 0;
    std::vector<JudgedRun> judged;
    for (std::size_t c = 0; c < cell_count(sweep.grid); ++c) {
        if (!sweep.is_visited(c)) continue;
        ++cells;
        for (const RunResult& run : sweep.cell(c)) {
            results.push_back(run);
            judged.push_back({kind_of(run), static_cast<Outcome>(static_cast<int>(run.outcome)),
                              static_cast<std::int64_t>(run.impacts), c});
        }
    }
    std::string shares;
    const CellSummary whole = summary_of(results);
    for (std::size_t m = 0; m < mode_count; ++m)
        shares += fmt::format("{}{} {:.2f} %", m ? ", " : "", name_of(all_modes[m]), 100 * whole.shares[m]);
    fmt::print("{} cells x {} runs: {}\n", cells, sweep.runs, shares);
    fmt::print("{}", chaos_in_words(judged));
    if (cells < cell_count(sweep.grid) && !sweep.shard)
        fmt::print("the grid has {} cells; the others have their neighbours' verdicts\n", cell_count(sweep.grid));
    for (const RiskEvidence& evidence : sweep.risk)
        fmt::print("{}\n", wrapped(in_words(evidence, error_in(sweep.settings)), 2));
    if (sweep.basins) print_basins(sweep);
    if (sweep.boundaries) print_saddles(*sweep.boundaries, sweep.units);
    if (!sweep.attractors.empty()) print_tracks(sweep);
}

}  // namespace swirl::apps::sweep
