#include "apps/branches/section_point.hpp"
#include "apps/modes/driven_fields.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/sweep/result_tables.hpp"

#include <fmt/format.h>

#include <optional>

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

}  // namespace swirl::apps::sweep
