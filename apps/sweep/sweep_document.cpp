#include "apps/sweep/sweep_command.hpp"

#include "apps/modes/kind_document.hpp"

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

void print_map(const Sweep& sweep) {
    const auto& last = sweep.grid.back();
    const std::size_t columns = last.points.size(), rows = cell_count(sweep.grid) / columns;
    fmt::print("{} from {:g} to {:g} across; S steady, Q quasi-steady, C chaotic, ? undecided; small: not every run\n",
               last.name, last.points.front(), last.points.back());
    for (std::size_t row = rows; row-- > 0;) {
        std::string line;
        for (std::size_t column = 0; column < columns; ++column)
            line += letter_of(summary_of(sweep.cell(row * columns + column)));
        std::string label;
        const auto point = cell_point(sweep.grid, row * columns);
        for (std::size_t k = 0; k + 1 < sweep.grid.size(); ++k)
            label += fmt::format("{} {:<10.6g} ", sweep.grid[k].name, point[k]);
        fmt::print("{}{}\n", label, line);
    }
}

void write_runs(JsonWriter& json, std::span<const RunResult> runs) {
    json.key("runs");
    json.begin_array();
    for (const auto& run : runs) {
        json.begin_object();
        json.member("mode", name_of(static_cast<analysis::Mode>(static_cast<int>(run.mode))));
        write_kind(json, static_cast<analysis::Kind>(static_cast<int>(run.kind)));
        json.member("outcome", name_of(static_cast<Outcome>(static_cast<int>(run.outcome))));
        write_period(json, static_cast<std::int64_t>(run.period));
        json.member("mean_S", run.mean_spin);
        json.member("largest_exponent", run.largest_exponent);
        json.end_object();
    }
    json.end_array();
}

}  // namespace

void print_sweep(const Sweep& sweep) {
    print_map(sweep);
    std::string shares;
    const CellSummary whole = summary_of(sweep.results);
    for (std::size_t m = 0; m < mode_count; ++m)
        shares += fmt::format("{}{} {:.2f} %", m ? ", " : "", name_of(all_modes[m]), 100 * whole.shares[m]);
    fmt::print("{} cells x {} runs: {}\n", cell_count(sweep.grid), sweep.runs, shares);
}

void write_sweep_document(const SweepOptions& options, const Sweep& sweep) {
    JsonWriter json(stdout);
    json.begin_object(JsonLayout::rows);
    if (const auto units = options.scene.units()) write_json(json, "units", unit_settings(*units));
    json.key("cells");
    json.begin_array(JsonLayout::rows);
    for (std::size_t c = 0; c < cell_count(sweep.grid); ++c) {
        const CellSummary cell = summary_of(sweep.cell(c));
        const auto point = cell_point(sweep.grid, c);
        json.begin_object();
        json.key("parameters");
        json.begin_object();
        for (std::size_t k = 0; k < point.size(); ++k) json.member(sweep.grid[k].name, point[k]);
        json.end_object();
        json.key("modes");
        json.begin_object();
        for (std::size_t m = 0; m < mode_count; ++m)
            if (cell.shares[m] > 0) json.member(name_of(all_modes[m]), cell.shares[m]);
        json.end_object();
        json.member("mean_S", cell.mean_spin);
        json.member("mean_S_error", cell.mean_spin_error);
        json.member("recurrence_rate", cell.recurrence_rate);
        json.member("largest_exponent", cell.largest_exponent);
        write_runs(json, sweep.cell(c));
        json.end_object();
    }
    json.end_array();
    write_json(json, "settings", sweep.settings);
    json.member("swirl_version", std::string_view(version()));
    json.end_object();
    json.finish();
}

}  // namespace swirl::apps::sweep
