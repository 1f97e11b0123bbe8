// The modes of a sweep's cells for people: a table over one parameter or of scenes, else maps in characters with the
// axes of the figure (notebooks-export/swirl_figures/sweep.py): the first parameter across, the second upwards, rising.
#include "apps/modes/mode_fields.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/basins/tracks.hpp"
#include "apps/sweep/result_tables.hpp"
#include "apps/sweep/start_settings.hpp"
#include "apps/sweep/sweep_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps::sweep {

namespace {

constexpr std::size_t most_lines = 100;                               // of a table
constexpr std::size_t most_shown_columns = 80, most_shown_rows = 60;  // of a map
constexpr std::size_t most_maps = 6;                                  // as the figure has panels
constexpr std::size_t widest = 100;                                   // characters of a line

/// The place of the mode that most runs have.
std::size_t most_shared(const CellSummary& cell) {
    return static_cast<std::size_t>(std::max_element(cell.shares.begin(), cell.shares.end()) - cell.shares.begin());
}

/// The mode that most runs of a cell have, apart of what rides and what else is steady; a capital letter if all have
/// it. Of two that have as many it is the first of: steady, riding, quasi-steady, chaotic, undecided, as in figures.
char letter_of(std::span<const RunResult> runs) {
    CellSummary cell = summary_of(runs);
    const auto riding = static_cast<double>(std::count_if(runs.begin(), runs.end(), is_riding));
    const double rides = runs.empty() ? 0 : riding / static_cast<double>(runs.size());
    cell.shares[0] -= rides;
    const std::size_t most = most_shared(cell);
    if (rides > cell.shares[most] || (rides == cell.shares[most] && most != 0)) return rides == 1 ? 'R' : 'r';
    constexpr std::string_view all = "SQC?", some = "sqc-";
    return cell.shares[most] == 1 ? all[most] : some[most];
}

/// The places of an axis' points as a figure has them: words as they were given, numbers rising.
std::vector<std::size_t> rising(const GridAxis& axis) {
    std::vector<std::size_t> places(axis.points.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    if (!axis.has_words())
        std::stable_sort(places.begin(), places.end(),
                         [&](std::size_t a, std::size_t b) { return axis.points[a] < axis.points[b]; });
    return places;
}

/// A point of an axis, in the user's units.
std::string label_of(const Sweep& sweep, std::size_t k, double point) {
    const GridAxis& axis = sweep.grid[k];
    if (axis.has_words()) return word_at(axis, point);
    return fmt::format("{:.6g}", in_units(point, sweep.units, units_of_axis(axis.name)));
}

std::string label_at(const Sweep& sweep, std::size_t k, std::size_t place) {
    return label_of(sweep, k, sweep.grid[k].points[place]);
}

/// "vx [m/s]" where the sweep is in SI units.
std::string name_with_unit(const Sweep& sweep, std::size_t k) {
    const std::string& name = sweep.grid[k].name;
    const std::string unit = sweep.units ? unit_label(units_of_axis(name)) : "";
    return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

/// A row of the table: a cell.
struct TableRow {
    std::vector<double> point;
    CellSummary summary;
    std::string way;       ///< of runs without a mean S, the first that goes somewhere
    bool chaotic = false;  ///< are some of the runs?
    bool differ = false;   ///< have its attractors each a mean S of their own?
};

std::string way_of(std::span<const RunResult> runs) {
    for (const RunResult& run : runs)
        if (const std::string way = way_in_words(growth_of(run), run.limit_spin); !way.empty()) return way;
    return "";
}

TableRow row_of(const Sweep& sweep, std::size_t c) {
    const std::span<const RunResult> runs = sweep.cell(c);
    const bool chaotic = std::any_of(runs.begin(), runs.end(),
                                     [](const RunResult& run) { return kind_of(run) == analysis::Kind::chaotic; });
    return {cell_point(sweep.grid, c), summary_of(runs), way_of(runs), chaotic, spins_differ(cell_attractors(runs, c))};
}

Table<TableRow> mode_table(const Sweep& sweep) {
    using F = Field<TableRow>;
    Table<TableRow> table{{"line"}, {}};
    for (std::size_t k = 0; k < sweep.grid.size(); ++k) {
        const auto text = [&sweep, k](const TableRow& line) { return label_of(sweep, k, line.point[k]); };
        const std::string name = name_with_unit(sweep, k);
        const std::size_t width = std::max<std::size_t>(name.size(), sweep.grid.size() == 1 ? 13 : 9);
        table.fields.push_back(
            F{sweep.grid[k].name, text, no_column}.shown(name, column_format_of(fmt::format(" {{:>{}}}", width))));
    }
    const auto in_percent = [](const Value& value) {
        return fmt::format(" {:>11.2f} %", 100 * std::get<double>(value));
    };
    const bool is_over_one = sweep.grid.size() == 1;  // of more there is room for the mode of most runs alone
    for (std::size_t m = 0; is_over_one && m < mode_count; ++m) {
        const std::string mode(name_of(all_modes[m]));
        table.fields.push_back(F{mode, [m](const TableRow& row) { return row.summary.shares[m]; }, no_column}.shown(
            mode, {" {:>13}", in_percent}));
    }
    if (!is_over_one) {
        const auto most = [](const TableRow& row) { return all_modes[most_shared(row.summary)]; };
        const auto share = [](const TableRow& row) { return row.summary.shares[most_shared(row.summary)]; };
        table.fields.push_back(F{"mode", most, no_column}.shown("mode", "  {:<12}"));
        table.fields.push_back(F{"share", share, no_column}.shown("share", {" {:>13}", in_percent}));
    }
    const auto spin = [](const TableRow& row) {
        const double mean = row.summary.mean_spin;
        const std::string way = row.way.empty() ? "-" : row.way;
        return (row.differ ? "* " : "") + spin_in_words(mean, row.summary.mean_spin_error, row.chaotic, way);
    };
    table.fields.push_back(F{"mean_S", spin, no_column}.shown("mean S", " {:>21}"));
    return table;
}

void print_table_of(const Sweep& sweep, const std::vector<std::size_t>& cells) {
    std::vector<TableRow> lines;
    for (const std::size_t c : std::span(cells).first(std::min(cells.size(), most_lines)))
        lines.push_back(row_of(sweep, c));
    print_table(in_units(mode_table(sweep), sweep.units), lines);
    if (std::any_of(lines.begin(), lines.end(), [](const TableRow& row) { return row.differ; }))
        fmt::print(
            "  * the mean of runs that came to different S, and no mode's own: --json lists them (attractors)\n");
    if (cells.size() > most_lines) fmt::print("  and {} more: --json lists all\n", cells.size() - most_lines);
}

/// Every n-th place, so that they are `most` at most.
std::size_t thinning(std::size_t count, std::size_t most) {
    return (count + most - 1) / most;
}

/// A map over two axes at one value of each other.
class Map {
public:
    Map(const Sweep& sweep, std::size_t across, std::size_t upwards, std::vector<std::size_t> places)
        : sweep_(sweep), across_(across), upwards_(upwards), places_(std::move(places)) {
        choose(across, most_shown_columns, columns_);
        choose(upwards, most_shown_rows, rows_);
        for (const std::size_t row : rows_) margin_ = std::max(margin_, label_at(sweep_, upwards, row).size());
        for (const std::size_t column : columns_)
            longest_ = std::max(longest_, label_at(sweep_, across, column).size());
        all_labels_ = margin_ + 4 + columns_.size() * (longest_ + 1) <= widest;
        width_ = all_labels_ ? longest_ + 1 : 1;
    }

    void print() {
        fmt::print("{}\n", name_with_unit(sweep_, upwards_));
        for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
            std::string line = fmt::format("{:>{}} |", label_at(sweep_, upwards_, *row), margin_);
            for (const std::size_t column : columns_)
                line += fmt::format("{:>{}}", letter_of(sweep_.cell(cell_at(column, *row))), width_);
            fmt::print("{}\n", line);
        }
        print_labels();
    }

private:
    const GridAxis& axis(std::size_t k) const { return sweep_.grid[k]; }

    void choose(std::size_t k, std::size_t most, std::vector<std::size_t>& chosen) {
        const std::vector<std::size_t> all = rising(axis(k));
        const std::size_t step = thinning(all.size(), most);
        for (std::size_t i = 0; i < all.size(); i += step) chosen.push_back(all[i]);
        if (step > 1) fmt::print("{}: one of {} of its {} values is shown\n", axis(k).name, step, all.size());
    }

    std::size_t cell_at(std::size_t column, std::size_t row) {
        places_[across_] = column;
        places_[upwards_] = row;
        std::size_t cell = 0;
        for (std::size_t k = 0; k < sweep_.grid.size(); ++k) cell = cell * axis(k).points.size() + places_[k];
        return cell;
    }

    /// The abscissa, with the values that stand beneath their columns.
    void print_labels() const {
        std::string line(margin_ + 1, ' '), labels(margin_ + 2, ' ');
        line += '+' + std::string(columns_.size() * width_, '-');
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const std::string label = label_at(sweep_, across_, columns_[i]);
            const std::size_t end = margin_ + 2 + (i + 1) * width_;  // beneath the letter
            const std::size_t begin = end - std::min(end, all_labels_ ? label.size() : 1);
            if (i > 0 && labels.size() + 1 > begin) continue;  // no room beside the one before
            labels.resize(begin, ' ');
            labels += label;
            line[end - 1] = '+';
        }
        fmt::print("{}\n{}  {}\n", line, labels, name_with_unit(sweep_, across_));
    }

    const Sweep& sweep_;
    std::size_t across_, upwards_;
    std::vector<std::size_t> places_;
    std::vector<std::size_t> columns_, rows_;  ///< places on the axes
    std::size_t margin_ = 1, longest_ = 1, width_ = 1;
    bool all_labels_ = true;
};

/// The axes that a figure draws: those with several values; of more than three those with the fewest values are left
/// out, laws last.
std::vector<std::size_t> drawn_axes(const std::vector<GridAxis>& grid) {
    std::vector<std::size_t> axes;
    for (std::size_t k = 0; k < grid.size(); ++k)
        if (grid[k].points.size() > 1) axes.push_back(k);
    while (axes.size() > 3)
        axes.erase(std::min_element(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) {
            return std::pair(grid[a].has_words(), grid[a].points.size()) <
                   std::pair(grid[b].has_words(), grid[b].points.size());
        }));
    return axes;
}

/// One map for each of up to six values of the axis that goes from map to map: laws, or that with the fewest values.
void print_maps(const Sweep& sweep, std::vector<std::size_t> axes) {
    std::vector<std::size_t> places;  // of what is not drawn: the middle one
    for (const GridAxis& axis : sweep.grid) places.push_back(rising(axis)[axis.points.size() / 2]);
    const bool rides = std::any_of(sweep.results.begin(), sweep.results.end(), is_riding);
    fmt::print("S steady, Q quasi-steady, C chaotic, ? undecided{}; small: not every run\n",
               rides ? ", R riding (steady, off the wall)" : "");
    for (std::size_t k = 0; k < sweep.grid.size(); ++k)
        if (sweep.grid[k].points.size() > 1 && std::find(axes.begin(), axes.end(), k) == axes.end())
            fmt::print("{} = {}, one of {} values\n", name_with_unit(sweep, k), label_at(sweep, k, places[k]),
                       sweep.grid[k].points.size());
    if (axes.size() == 2) return Map(sweep, axes[0], axes[1], places).print();
    const auto across = std::min_element(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(!sweep.grid[a].has_words(), sweep.grid[a].points.size()) <
               std::pair(!sweep.grid[b].has_words(), sweep.grid[b].points.size());
    });
    const std::size_t panels = *across;
    axes.erase(across);
    const std::vector<std::size_t> values = rising(sweep.grid[panels]);
    const std::size_t count = std::min(values.size(), most_maps);
    for (std::size_t i = 0; i < count; ++i) {
        const double at =
            count == 1 ? 0 : static_cast<double>(i * (values.size() - 1)) / static_cast<double>(count - 1);
        places[panels] = values[static_cast<std::size_t>(std::nearbyint(at))];
        fmt::print("{} = {}\n", name_with_unit(sweep, panels), label_at(sweep, panels, places[panels]));
        Map(sweep, axes[0], axes[1], places).print();
    }
    if (count < values.size()) fmt::print("{} of {} values of {}\n", count, values.size(), sweep.grid[panels].name);
}

}  // namespace

bool is_of_scenes(const Sweep& sweep) {
    return std::any_of(sweep.settings.begin(), sweep.settings.end(),
                       [](const auto& setting) { return setting.first == "scenes"; });
}

void print_modes(const Sweep& sweep) {
    const std::vector<std::size_t> axes = drawn_axes(sweep.grid);
    if (!sweep.grid.front().sampled && axes.size() > 1) return print_maps(sweep, axes);
    std::vector<std::size_t> cells(cell_count(sweep.grid));
    std::iota(cells.begin(), cells.end(), std::size_t{0});
    if (!sweep.grid.front().sampled && axes.size() == 1) cells = rising(sweep.grid[axes.front()]);
    print_table_of(sweep, cells);
}

}  // namespace swirl::apps::sweep
