#include "apps/sweep/cell_attractors.hpp"

#include "apps/branches/branches.hpp"
#include "apps/modes/attractors.hpp"
#include "apps/modes/driven_fields.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/system/section_coordinates.hpp"

namespace swirl::apps::sweep {

namespace {

RunVerdict verdict_of(const RunResult& run) {
    RunVerdict verdict;
    verdict.mode = mode_of(run);
    verdict.kind = kind_of(run);
    verdict.outcome = static_cast<Outcome>(static_cast<int>(run.outcome));
    verdict.period = static_cast<std::int64_t>(run.period);
    verdict.mean_spin = run.mean_spin;
    verdict.mean_spin_per_impact = run.mean_spin_per_impact;
    verdict.mean_errors.per_time = run.mean_spin_error;
    verdict.growth = growth_of(run);
    verdict.limit_spin = run.limit_spin;
    return verdict;
}

}  // namespace

std::vector<CellAttractor> cell_attractors(std::span<const RunResult> runs, std::size_t cell) {
    std::vector<RunVerdict> verdicts;
    verdicts.reserve(runs.size());
    for (const RunResult& run : runs) verdicts.push_back(verdict_of(run));
    std::vector<CellAttractor> found;
    const auto all = static_cast<double>(runs.size());
    for (const SharedAttractor& shared : attractors_of(verdicts)) {
        const double share = static_cast<double>(shared.runs.size()) / all;
        const std::size_t first = shared.runs.front();
        found.push_back({runs[first],
                         share,
                         wilson_interval(share, all),
                         shared.mean_spin,
                         shared.mean_spin_error,
                         first,
                         cell,
                         no_track,
                         {}});
    }
    return found;
}

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

}  // namespace swirl::apps::sweep
