#include "apps/branches/section_point.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/sweep/result_tables.hpp"
#include "apps/sweep/start_settings.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <string>

namespace swirl::apps::sweep {

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
