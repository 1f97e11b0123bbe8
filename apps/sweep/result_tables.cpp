#include "apps/sweep/result_tables.hpp"

#include "apps/branches/section_point.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/sweep/start_settings.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace swirl::apps::sweep {

Table<CellAttractor> cell_attractor_table(bool tracked) {
    using Row = CellAttractor;
    using F = Field<Row>;
    const auto cell = [](const Row& row) { return static_cast<std::int64_t>(row.cell); };
    const auto point = [](const Row& row) { return row.point.empty() ? std::nullopt : std::optional(row.point); };
    const auto track = [](const Row& row) { return row.track == no_track ? std::nullopt : std::optional(row.track); };
    Table<Row> table{
        {"attractor"},
        {F{"cell", cell, "1", "place of its cell on the grid, the last axis fastest"}.record_only(),
         F{"track", &Row::track, "1", "number of the attractor that it continues over the cells; -1: none"}
             .json_as(track)
             .when(tracked),
         {"mode", [](const Row& row) { return mode_of(row.first); }, "", "mode of the attractor"},
         kind_field<Row>([](const Row& row) { return kind_of(row.first); }),
         {"outcome", [](const Row& row) { return static_cast<Outcome>(static_cast<int>(row.first.outcome)); }, "",
          "how the first of its orbits ended"},
         period_field<Row>([](const Row& row) { return static_cast<std::int64_t>(row.first.period); }),
         {"share", &Row::share, "1", "share of the cell's runs"},
         {"share_low", [](const Row& row) { return row.interval.low; }, "1",
          "from this share on, by Wilson's interval at 95 %"},
         {"share_high", [](const Row& row) { return row.interval.high; }, "1", "up to this share"},
         {"mean_S", &Row::mean_spin, "1", "mean over its runs of the time mean of S"},
         {"mean_S_error", &Row::spin_error, "1", "its standard error over these runs; of one its own"},
         F{"point", &Row::point, "1", "a cycle's first state: psi, chi, vn, vt, S (disk: psi, vn, vt, S)"}
             .json_as(point)
             .along({"coordinate"}, polygon_dimension)
             .when(tracked),
         F{"section_point", [](JsonWriter& json, const Row& row) { write_point_or_null(json, row.point); }}.when(
             tracked)}};
    const auto driven = driven_fields<Row>([](const Row& row) { return growth_of(row.first); },
                                           [](const Row& row) { return row.first.limit_spin; });
    table.fields.insert(table.fields.end(), driven.begin(), driven.end());
    return table;
}

Table<Tracking> tracking_table() {
    using T = Tracking;
    return {{},
            {{"carried", &T::carried, no_column},
             {"arrived", &T::arrived, no_column},
             {"unseen", &T::unseen, no_column},
             {"not_attracting", &T::not_attracting, no_column},
             {"not_found", &T::not_found, no_column}}};
}

void write_attractors(const RecordGroup& group, const Sweep& sweep) {
    std::vector<CellAttractor> rows;
    for (const auto& attractors : sweep.attractors) rows.insert(rows.end(), attractors.begin(), attractors.end());
    group.dimension("coordinate", polygon_dimension);
    write_attributes(group, tracking_table(), sweep.tracking);
    write_record(group, cell_attractor_table(true), rows);
}

Table<Track> track_table() {
    using F = Field<Track>;
    const auto in_percent = [](const Value& value) { return fmt::format("{:>7.2f} %", 100 * std::get<double>(value)); };
    const auto mode = [](const Track& track) { return mode_of(track.first.first); };
    const auto kind = [](const Track& track) { return kind_of(track.first.first); };
    const auto period = [](const Track& track) { return static_cast<std::int64_t>(track.first.first.period); };
    const auto number = [](const Track& track) { return track.first.track; };
    return {{"track"},
            {F{"track", number, no_column}.shown("track", "{:>5}"),
             F{"mode", mode, no_column}.shown("mode", "  {:<12}"), kind_field<Track>(kind).shown("kind", " {:<19}"),
             period_field<Track>(period).shown("period", dash_for_zero(" {:>6}")),
             F{"cells", &Track::cells, no_column}.shown("cells", " {:>7}"),
             F{"least_share", &Track::least_share, no_column}.shown("share from", {" {:>11}", in_percent}),
             F{"largest_share", &Track::largest_share, no_column}.shown("to", {" {:>11}", in_percent}),
             F{"least_mean_S", &Track::least_spin, "1", "least of the cells"}.shown("mean S from", " {:>13.6g}"),
             F{"largest_mean_S", &Track::largest_spin, "1", "largest of the cells"}.shown("to", " {:>13.6g}")}};
}

Table<Basin> basin_table() {
    using F = Field<Basin>;
    const auto kind = [](const Basin& basin) { return kind_of(basin.attractor); };
    const auto period = [](const Basin& basin) { return static_cast<std::int64_t>(basin.attractor.period); };
    const auto mode = [](const Basin& basin) { return mode_of(basin.attractor); };
    const auto spin = [](const Basin& basin) { return basin.attractor.mean_spin; };
    const auto in_percent = [](const Value& value) {
        return fmt::format("  {:>8.2f} %", 100 * std::get<double>(value));
    };
    return {
        {"basin"},
        {F{"mode", mode, "", "mode of the attractor"}.shown("mode", "  {:<12}"),
         kind_field<Basin>(kind).shown("kind", " {:<19}"),
         period_field<Basin>(period).shown("period", dash_for_zero(" {:>6}")),
         F{"mean_S", spin, "1", "time mean of S of a polished cycle"}.shown("mean S", " {:>14.8g}"),
         F{"starts", &Basin::starts, "1", "starts that were run and came to it"}.shown("starts", "  {:>8}"),
         F{"share", &Basin::share, "1", "share of all cells"}.shown("share", {"  {:>10}", in_percent}),
         {"share_low", [](const Basin& b) { return b.interval.low; }, "1", "from this share on, by Wilson's interval"},
         {"share_high", [](const Basin& b) { return b.interval.high; }, "1", "up to this share"}}};
}

Table<BoundaryPlace> place_table(const std::vector<GridAxis>& grid) {
    using Place = BoundaryPlace;
    using F = Field<Place>;
    const auto parameters = [grid](JsonWriter& json, const Place& place) {
        json.begin_object();
        for (std::size_t k = 0; k < grid.size(); ++k) json.member(grid[k].name, place.point[k]);
        json.end_object();
    };
    const auto saddle = [](const Place& place) {
        return place.saddle == no_saddle ? std::nullopt : std::optional(place.saddle);
    };
    const auto leads_to = [](const Place& place) { return std::string(name_of(place.leads_to)); };
    Table<Place> table{{"place"}, {{"parameters", parameters}}};
    for (std::size_t k = 0; k < grid.size(); ++k) {
        const auto at = [k](const Place& place) { return place.point[k]; };
        table.fields.push_back(
            F{grid[k].name, at, units_of_axis(grid[k].name), "of the start on the boundary"}.record_only());
    }
    table.fields.emplace_back("from", &Place::from, "1", "basin on one side: place in the group basins");
    table.fields.emplace_back("to", &Place::to, "1", "basin on the other");
    table.fields.emplace_back("leads_to", leads_to, "", "saddle, border, rounding, undecided, ended, not-found");
    table.fields.push_back(F{"saddle", &Place::saddle, "1", "place in the group saddles; -1: none"}.json_as(saddle));
    return table;
}

Table<Saddle> saddle_table() {
    using F = Field<Saddle>;
    const auto in_percent = [](const Value& value) {
        return fmt::format("  {:>8.2f} %", 100 * std::get<double>(value));
    };
    const auto index = [](const Saddle& saddle) {
        return saddle.period == 0 ? std::nullopt : std::optional(saddle.index);
    };
    const auto point = [](const Saddle& saddle) {
        const auto& z = saddle.points.front();
        return std::vector<double>(z.begin(), z.end());
    };
    const auto padded = [point](const Saddle& saddle) {
        std::vector<double> z = point(saddle);
        z.resize(polygon_dimension, std::numeric_limits<double>::quiet_NaN());
        return z;
    };
    const auto low = [](const Saddle& saddle) { return saddle.interval.low; };
    const auto high = [](const Saddle& saddle) { return saddle.interval.high; };
    return {
        {"saddle"},
        {kind_field<Saddle>(&Saddle::kind).shown("kind", "  {:<15}"),
         period_field<Saddle>(&Saddle::period).shown("period", dash_for_zero(" {:>6}")),
         F{"mean_S", &Saddle::mean_spin, "1", "time mean of S"}.shown("mean S", " {:>14.8g}"),
         {"mean_S_per_impact", &Saddle::mean_spin_per_impact, "1", "mean of S over its impacts"},
         F{"index", &Saddle::index, "1", "of a cycle: multipliers outside the unit circle"}.json_as(index).shown(
             "index", dash_for_zero(" {:>6}")),
         F{"multiplier", &Saddle::multiplier, "1", "of a cycle: its largest |multiplier|"}.shown("|multiplier|",
                                                                                                 " {:>12.6g}"),
         F{"rotation_number", &Saddle::rotation, "1", "of a torus: the strongest line of S, turns per impact"}.shown(
             "rotation", " {:>11.7g}"),
         F{"places", &Saddle::places, "1", "points on the boundaries that lead to it"}.shown("points", " {:>7}"),
         F{"share", &Saddle::share, "1", "of all points on boundaries"}.shown("share", {"  {:>10}", in_percent}),
         {"share_low", low, "1", "from this share on, by Wilson's interval"},
         {"share_high", high, "1", "up to this share"},
         F{"point", padded, "1", "its first state: psi, chi, vn, vt, S (disk: psi, vn, vt, S)"}.json_as(point).along(
             {"coordinate"}, polygon_dimension),
         {"section_point",
          [point](JsonWriter& json, const Saddle& saddle) { write_point_or_null(json, point(saddle)); }}}};
}

}  // namespace swirl::apps::sweep
