#include "apps/command_line/record_files.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/modes/risk_document.hpp"
#include "apps/modes/steady_share_table.hpp"
#include "apps/output/write_table.hpp"
#include "apps/record/flag_text.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/sweep/result_tables.hpp"
#include "apps/sweep/run_cells.hpp"
#include "apps/sweep/start_settings.hpp"
#include "apps/sweep/sweep_command.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::sweep {

namespace {

struct Cell {
    std::size_t index;
    CellSummary summary;
};

/// The runs of a cell, as JSON has them.
Table<RunResult> run_table() {
    const auto period = [](const RunResult& run) { return static_cast<std::int64_t>(run.period); };
    const auto errors = mean_error_fields<RunResult>(mean_errors_of);
    Table<RunResult> table{
        {"run"},
        {{"mode", mode_of, no_column},
         kind_field<RunResult>(kind_of),
         {"outcome", [](const RunResult& run) { return static_cast<Outcome>(static_cast<int>(run.outcome)); },
          no_column},
         period_field<RunResult>(period),
         {"mean_S", &RunResult::mean_spin, no_column},
         {"mean_S_per_impact", &RunResult::mean_spin_per_impact, no_column},
         errors.per_time,
         errors.per_impact,
         errors.kind,
         {"largest_exponent", &RunResult::largest_exponent, no_column},
         {"impacts", [](const RunResult& run) { return static_cast<std::int64_t>(run.impacts); }, no_column}}};
    const auto driven = driven_fields<RunResult>(growth_of, &RunResult::limit_spin);
    table.fields.insert(table.fields.end(), driven.begin(), driven.end());
    return table;
}

void write_parameters(JsonWriter& json, const Sweep& sweep, const Cell& cell) {
    const auto point = cell_point(sweep.grid, cell.index);
    json.begin_object();
    for (std::size_t k = 0; k < point.size(); ++k)
        if (const GridAxis& axis = sweep.grid[k]; axis.name == "law" || (axis.has_words() && point[k] == disk_sides))
            json.member(axis.name, word_at(axis, point[k]));
        else
            json.member(axis.name, point[k]);
    json.end_object();
}

void write_shares(JsonWriter& json, const Cell& cell) {
    json.begin_object();
    for (std::size_t m = 0; m < mode_count; ++m)
        if (cell.summary.shares[m] > 0) json.member(name_of(all_modes[m]), cell.summary.shares[m]);
    json.end_object();
}

/// Of the cell that has most, 1 at least: a dimension of no length is nothing to plot.
std::size_t most_steady_modes(const Sweep& sweep) {
    std::size_t most = 1;
    for (const auto& modes : sweep.steady) most = std::max(most, modes.size());
    return most;
}

/// The shares of a cell's modes, with Wilson's intervals.
std::vector<Field<Cell>> share_fields(const Sweep& sweep) {
    using F = Field<Cell>;
    const auto shares = [](const Cell& cell) {
        return std::vector<double>(cell.summary.shares.begin(), cell.summary.shares.end());
    };
    const auto runs_in_all = static_cast<double>(sweep.runs);
    const auto bounds = [runs_in_all](double Interval::*bound) {
        return [runs_in_all, bound](JsonWriter& json, const Cell& cell) {
            json.begin_object();
            for (std::size_t m = 0; m < mode_count; ++m)
                if (const double share = cell.summary.shares[m]; share > 0)
                    json.member(name_of(all_modes[m]), wilson_interval(share, runs_in_all).*bound);
            json.end_object();
        };
    };
    const auto bound_list = [runs_in_all](double Interval::*bound) {
        return [runs_in_all, bound](const Cell& cell) {
            std::vector<double> values;
            for (const double share : cell.summary.shares) values.push_back(wilson_interval(share, runs_in_all).*bound);
            return values;
        };
    };
    return {{"modes_low", bounds(&Interval::low)},
            {"modes_high", bounds(&Interval::high)},
            F{"share", shares, "1", "share of the runs with this mode"}.along({"mode"}, mode_count).record_only(),
            F{"share_low", bound_list(&Interval::low), "1", "from this share on, by Wilson's interval at 95 %"}
                .along({"mode"}, mode_count)
                .record_only(),
            F{"share_high", bound_list(&Interval::high), "1", "up to this share"}
                .along({"mode"}, mode_count)
                .record_only()};
}

/// The attracting steady modes in a record: lists as long as the longest.
std::vector<Field<Cell>> steady_fields(const Sweep& sweep) {
    using F = Field<Cell>;
    const std::size_t most = most_steady_modes(sweep);
    const auto steady_column = [&sweep, most](double SteadyShare::*member) {
        return [&sweep, most, member](const Cell& cell) { return filled(sweep.steady_of(cell.index), member, most); };
    };
    return {F{"steady_S", steady_column(&SteadyShare::spin), "1", "S of an attracting steady mode; NaN: no more"}
                .along({"steady_mode"}, most)
                .record_only(),
            F{"steady_share", steady_column(&SteadyShare::share), "1", "share of the runs that came to it"}
                .along({"steady_mode"}, most)
                .record_only(),
            F{"steady_flight_time", steady_column(&SteadyShare::flight_time), "1/omega_s", "its flight time"}
                .along({"steady_mode"}, most)
                .record_only(),
            F{"steady_multiplier", steady_column(&SteadyShare::multiplier), "1", "its largest |multiplier|"}
                .along({"steady_mode"}, most)
                .record_only()};
}

/// The cells, along the dimensions `axes` of a record.
Table<Cell> cell_table(const Sweep& sweep, const std::vector<std::string>& axes = {}) {
    using F = Field<Cell>;
    const auto of = [](auto member) { return [member](const Cell& cell) { return cell.summary.*member; }; };
    const auto impacts_spent = [](const Cell& cell) { return static_cast<std::int64_t>(cell.summary.impacts_spent); };
    const auto parameters = [&sweep](JsonWriter& json, const Cell& cell) { write_parameters(json, sweep, cell); };
    const auto steady = [&sweep, table = steady_share_table()](JsonWriter& json, const Cell& cell) {
        write_rows(json, table, sweep.steady_of(cell.index), JsonLayout::line);
    };
    const bool tracked = !sweep.attractors.empty();
    const auto attractors = [&sweep, tracked, table = cell_attractor_table(tracked)](JsonWriter& json,
                                                                                     const Cell& cell) {
        const auto& rows = tracked ? sweep.attractors[cell.index] : cell_attractors(sweep.cell(cell.index));
        write_rows(json, table, rows, JsonLayout::line);
    };
    const auto runs = [&sweep, table = run_table()](JsonWriter& json, const Cell& cell) {
        write_rows(json, table, sweep.cell(cell.index), JsonLayout::line);
    };
    Table<Cell> table{
        axes,
        {{"parameters", parameters},
         {"modes", write_shares},
         {"mean_S", of(&CellSummary::mean_spin), "1", "mean over the runs of the time mean of S"},
         {"mean_S_error", of(&CellSummary::mean_spin_error), "1",
          "its standard error over the runs; of one run its own"},
         {"mean_S_per_impact", of(&CellSummary::mean_spin_per_impact), "1",
          "mean over the runs of the mean of S over impacts"},
         {"mean_S_per_impact_error", of(&CellSummary::mean_spin_per_impact_error), "1", "likewise"},
         {"recurrence_rate", of(&CellSummary::recurrence_rate), "1", "mean over the runs of RC of S"},
         {"largest_exponent", of(&CellSummary::largest_exponent), "1", "mean over the runs, per impact"},
         F{"impacts_spent", of(&CellSummary::impacts_spent), "1", "impacts that were followed, by all runs"}.json_as(
             impacts_spent),
         {"steady_modes", steady},
         {"attractors", attractors},
         {"runs", runs}}};
    const auto insert_after = [&](const std::string& name, const std::vector<F>& fields) {
        const auto at =
            std::find_if(table.fields.begin(), table.fields.end(), [&](const F& f) { return f.name == name; });
        table.fields.insert(at + 1, fields.begin(), fields.end());
    };
    if (sweep.basins) {
        const auto basin = [&sweep](const Cell& cell) {
            const std::int64_t place = sweep.basins->of_cell[cell.index];
            return place == no_basin ? std::nullopt : std::optional(place);
        };
        insert_after("modes", {F{"basin", [](const Cell&) { return std::int64_t{0}; }, no_column}.json_as(basin)});
    }
    insert_after("modes", share_fields(sweep));
    insert_after("steady_modes", steady_fields(sweep));
    return table;
}

std::vector<Cell> cells_of(const Sweep& sweep) {
    std::vector<Cell> cells;
    for (std::size_t c = 0; c < cell_count(sweep.grid); ++c) {
        cells.push_back({c, summary_of(sweep.cell(c))});
        if (!sweep.is_visited(c)) cells.back().summary.impacts_spent = 0;
    }
    return cells;
}

/// Those that were looked at.
std::vector<Cell> visited_cells(const Sweep& sweep) {
    std::vector<Cell> cells = cells_of(sweep);
    std::erase_if(cells, [&](const Cell& cell) { return !sweep.is_visited(cell.index); });
    return cells;
}

/// The axis' points, as its coordinate or along the cells of a sample.
void write_axis(const RecordGroup& group, const GridAxis& axis) {
    const std::vector<std::string> along = {axis.sampled ? "cell" : record_name(axis.name)};
    if (!axis.has_words()) {
        group.write<double>(record_name(axis.name), along, axis.points,
                            {units_of_axis(axis.name), "parameter " + axis.name, {}});
        return;
    }
    std::vector<std::string> words;
    words.reserve(axis.points.size());
    for (const double point : axis.points) words.push_back(word_at(axis, point));
    group.write_strings(record_name(axis.name), along, words, {"", "parameter " + axis.name, {}});
}

/// A group without rows is left out.
void write_boundaries(const RecordGroup& root, const Sweep& sweep) {
    if (!sweep.boundaries->saddles.empty()) {
        const RecordGroup saddles = root.group("saddles");
        saddles.dimension("coordinate", polygon_dimension);
        write_record(saddles, saddle_table(), sweep.boundaries->saddles);
    }
    if (!sweep.boundaries->places.empty())
        write_record(root.group("boundary"), place_table(sweep.grid), sweep.boundaries->places);
}

}  // namespace

void write_sweep_document(const Sweep& sweep) {
    print_document([&](JsonWriter& json) {
        if (sweep.units) write_json(json, "units", unit_settings(*sweep.units));
        if (sweep.basins) write_json(json, "basins", basin_table(), sweep.basins->basins);
        if (sweep.boundaries) {
            write_json(json, "saddles", saddle_table(), sweep.boundaries->saddles);
            write_json(json, "boundary", place_table(sweep.grid), sweep.boundaries->places);
        }
        if (!sweep.attractors.empty()) {
            json.key("tracking");
            write_object(json, tracking_table(), sweep.tracking);
        }
        write_json(json, "cells", cell_table(sweep), visited_cells(sweep));
        write_risk(json, sweep.risk);
        write_json(json, "settings", sweep.settings);
    });
}

void write_sweep(const SweepOptions& options, const Sweep& sweep) {
    RecordWriter record = create_record(options.output, "Modes of a swirled polygon across parameters", sweep.units);
    const RecordGroup root = record.root();
    const RecordGroup settings = root.group("settings");
    write_attributes(settings, sweep.settings);
    settings.attribute("kinds", kind_names(sweep.results));
    settings.attribute("outcomes", outcome_names(sweep.results));
    const RecordGroup group = root.group("sweep");
    std::vector<std::string> axes;
    if (sweep.grid.front().sampled) {
        axes = {"cell"};
        group.dimension("cell", cell_count(sweep.grid));
    }
    for (const auto& axis : sweep.grid) {
        if (!axis.sampled) {
            axes.push_back(record_name(axis.name));
            group.dimension(axes.back(), axis.points.size());
        }
        write_axis(group, axis);
    }
    group.dimension("run", static_cast<std::uint64_t>(sweep.runs));
    group.dimension("mode", mode_count);
    group.dimension("steady_mode", most_steady_modes(sweep));
    std::vector<std::string> modes;
    modes.reserve(mode_count);
    for (const auto mode : all_modes) modes.emplace_back(name_of(mode));
    group.write_strings("mode", {"mode"}, modes, {"", "mode", {}});
    std::vector<std::int64_t> runs;
    for (std::int64_t r = 0; r < sweep.runs; ++r) runs.push_back(r);
    group.write<std::int64_t>("run", {"run"}, runs,
                              {"1",
                               starts_are_placed(sweep.grid) ? "the start that the cell and the settings say"
                                                             : "start number: swirl classify --seed (seed + run)",
                               {}});
    write_columns(group, cell_table(sweep, axes), cells_of(sweep));
    if (!sweep.visited.empty())
        group.write<std::uint8_t>("visited", axes,
                                  std::vector<std::uint8_t>(sweep.visited.begin(), sweep.visited.end()),
                                  {"1", "1: has runs of its own; 0: has the results of a neighbour", {}});
    auto by_run = axes;
    by_run.push_back("run");
    write_run_columns(group, by_run, sweep.results);
    if (sweep.basins) {
        group.write<std::int64_t>("basin", axes, sweep.basins->of_cell,
                                  {"1", "place in the group basins; -1: none", {}});
        write_record(root.group("basins"), basin_table(), sweep.basins->basins);
    }
    if (sweep.boundaries) write_boundaries(root, sweep);
    if (!sweep.attractors.empty()) write_attractors(root.group("attractors"), sweep);
    write_risk(root, sweep.risk);
    record.finish();
}

}  // namespace swirl::apps::sweep
