// A sweep for people: a map in characters and the shares.
#include "apps/output/write_table.hpp"
#include "apps/sweep/starts.hpp"
#include "apps/sweep/sweep_command.hpp"
#include "apps/sweep/tracks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace swirl::apps::sweep {

namespace {

/// The mode that most runs of a cell have; a capital letter if all have it.
char letter_of(const CellSummary& cell) {
    constexpr std::string_view all = "SQC?", some = "sqc-";
    std::size_t most = 0;
    for (std::size_t m = 1; m < mode_count; ++m)
        if (cell.shares[m] > cell.shares[most]) most = m;
    return cell.shares[most] == 1 ? all[most] : some[most];
}

std::string shown(const Sweep& sweep, const GridAxis& axis, double point) {
    if (axis.has_words()) return axis.word_at(point);
    return fmt::format("{:.6g}", in_units(point, sweep.units, units_of_axis(axis.name)));
}

/// "vx [m/s]" where the sweep is in SI units.
std::string named(const Sweep& sweep, const GridAxis& axis) {
    const std::string unit = sweep.units ? unit_label(units_of_axis(axis.name)) : "";
    return unit.empty() ? axis.name : fmt::format("{} [{}]", axis.name, unit);
}

void print_map(const Sweep& sweep) {
    const auto& last = sweep.grid.back();
    const std::size_t columns = last.points.size(), rows = cell_count(sweep.grid) / columns;
    fmt::print("{} across; S steady, Q quasi-steady, C chaotic, ? undecided; small: not every run\n",
               last.has_words()
                   ? last.text
                   : fmt::format("{} from {} to {}", named(sweep, last), shown(sweep, last, last.points.front()),
                                 shown(sweep, last, last.points.back())));
    for (std::size_t row = rows; row-- > 0;) {
        std::string line;
        for (std::size_t column = 0; column < columns; ++column)
            line += letter_of(summary_of(sweep.cell(row * columns + column)));
        std::string label;
        const auto point = cell_point(sweep.grid, row * columns);
        for (std::size_t k = 0; k + 1 < sweep.grid.size(); ++k)
            label += fmt::format("{} {:<10} ", named(sweep, sweep.grid[k]), shown(sweep, sweep.grid[k], point[k]));
        fmt::print("{}{}\n", label, line);
    }
}

void print_basins(const Sweep& sweep) {
    print_table(in_units(basin_table(), sweep.units), sweep.basins->basins);
    const auto none = std::count(sweep.basins->of_cell.begin(), sweep.basins->of_cell.end(), no_basin);
    if (none > 0)
        fmt::print("  of {} of {} cells the verdict names no attractor\n", none, sweep.basins->of_cell.size());
}

void print_saddles(const Boundaries& boundaries, const std::optional<Units>& units) {
    using analysis::StraddleEnd;
    const auto count = [&](StraddleEnd where) {
        return std::count_if(boundaries.places.begin(), boundaries.places.end(),
                             [&](const BoundaryPlace& place) { return place.leads_to == where; });
    };
    fmt::print("boundaries of basins at {} places:", boundaries.places.size());
    for (const StraddleEnd where : {StraddleEnd::found, StraddleEnd::border, StraddleEnd::rounding,
                                    StraddleEnd::undecided, StraddleEnd::ended, StraddleEnd::not_found})
        if (count(where) > 0) fmt::print(" {} {}", name_of(where), count(where));
    fmt::print("\n");
    if (!boundaries.saddles.empty()) print_table(in_units(saddle_table(), units), boundaries.saddles);
}

/// Those over most cells.
void print_tracks(const Sweep& sweep) {
    constexpr std::size_t most = 20;
    std::vector<Track> tracks = tracks_of(sweep);
    const std::size_t all = tracks.size();
    tracks.resize(std::min(all, most));
    print_table(in_units(track_table(), sweep.units), tracks);
    if (all > most) fmt::print("  and {} more, over fewer cells each\n", all - most);
    const Tracking& t = sweep.tracking;
    fmt::print(
        "cycles were carried to a neighbour {} times: {} came to an attractor there, {} to one that no start showed, "
        "{} do not attract there, {} were not found\n",
        t.carried, t.arrived, t.unseen, t.not_attracting, t.not_found());
}

}  // namespace

void print_sweep(const Sweep& sweep) {
    if (!sweep.grid.front().sampled && (sweep.visited.empty() || !sweep.shard)) print_map(sweep);
    std::vector<RunResult> results;
    std::size_t cells = 0;
    for (std::size_t c = 0; c < cell_count(sweep.grid); ++c) {
        if (!sweep.is_visited(c)) continue;
        ++cells;
        for (const RunResult& run : sweep.cell(c)) results.push_back(run);
    }
    std::string shares;
    const CellSummary whole = summary_of(results);
    for (std::size_t m = 0; m < mode_count; ++m)
        shares += fmt::format("{}{} {:.2f} %", m ? ", " : "", name_of(all_modes[m]), 100 * whole.shares[m]);
    fmt::print("{} cells x {} runs: {}\n", cells, sweep.runs, shares);
    if (cells < cell_count(sweep.grid) && !sweep.shard)
        fmt::print("of a grid of {}; the others have the verdict of their neighbours\n", cell_count(sweep.grid));
    if (sweep.basins) print_basins(sweep);
    if (sweep.boundaries) print_saddles(*sweep.boundaries, sweep.units);
    if (!sweep.attractors.empty()) print_tracks(sweep);
}

}  // namespace swirl::apps::sweep
