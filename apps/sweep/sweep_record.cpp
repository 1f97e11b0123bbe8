#include "apps/record/record_reader.hpp"
#include "apps/sweep/sweep_command.hpp"

#include <algorithm>

namespace swirl::apps::sweep {

namespace {

struct RunColumn {
    const char* name;
    double RunResult::*member;
    const char* units;
    const char* long_name;
};

constexpr RunColumn run_columns[] = {
    {"run_mode", &RunResult::mode, "1", "mode: steady 0, quasi-steady 1, chaotic 2, undecided 3"},
    {"run_kind", &RunResult::kind, "1", "kind, by the names in attribute kinds of the settings"},
    {"run_outcome", &RunResult::outcome, "1", "outcome, by the names in attribute outcomes of the settings"},
    {"run_period", &RunResult::period, "1", "period, 0: none"},
    {"run_mean_S", &RunResult::mean_spin, "omega_s", "time mean of S"},
    {"run_recurrence_rate", &RunResult::recurrence_rate, "1", "RC of S"},
    {"run_largest_exponent", &RunResult::largest_exponent, "1", "largest Lyapunov exponent per impact"},
    {"run_impacts", &RunResult::impacts, "1", "impacts followed"},
};

std::string dimension_of(const GridAxis& axis) {
    std::string name = axis.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

template <class Enum>
std::vector<std::string> names_up_to(Enum last) {
    std::vector<std::string> names;
    for (int i = 0; i <= static_cast<int>(last); ++i) names.emplace_back(name_of(static_cast<Enum>(i)));
    return names;
}

void write_cells(const RecordGroup& group, const Sweep& sweep, const std::vector<std::string>& axes) {
    std::vector<double> shares, spin, error, rate, exponent;
    for (std::size_t c = 0; c < cell_count(sweep.grid); ++c) {
        const CellSummary cell = summary_of(sweep.cell(c));
        shares.insert(shares.end(), cell.shares.begin(), cell.shares.end());
        spin.push_back(cell.mean_spin);
        error.push_back(cell.mean_spin_error);
        rate.push_back(cell.recurrence_rate);
        exponent.push_back(cell.largest_exponent);
    }
    auto by_mode = axes;
    by_mode.push_back("mode");
    group.write<double>("share", by_mode, shares, {"1", "share of the runs with this mode", {}});
    group.write<double>("mean_S", axes, spin, {"omega_s", "mean over the runs of the time mean of S", {}});
    group.write<double>("mean_S_error", axes, error, {"omega_s", "its standard error over the runs", {}});
    group.write<double>("recurrence_rate", axes, rate, {"1", "mean over the runs of RC of S", {}});
    group.write<double>("largest_exponent", axes, exponent, {"1", "mean over the runs, per impact", {}});
}

}  // namespace

void write_sweep(const std::string& path, const Sweep& sweep) {
    RecordWriter record = open_record(path, "Modes of a swirled polygon across parameters");
    const RecordGroup root = record.root();
    const RecordGroup settings = root.group("settings");
    write_attributes(settings, sweep.settings);
    settings.attribute("kinds", names_up_to(analysis::Kind::transient));
    settings.attribute("outcomes", names_up_to(Outcome::unresolved));
    const RecordGroup group = root.group("sweep");
    std::vector<std::string> axes;
    for (const auto& axis : sweep.grid) {
        axes.push_back(dimension_of(axis));
        group.dimension(axes.back(), axis.points.size());
        group.write<double>(axes.back(), {axes.back()}, axis.points, {"1", "parameter " + axis.name, {}});
    }
    group.dimension("run", static_cast<std::uint64_t>(sweep.runs));
    group.dimension("mode", mode_count);
    std::vector<std::string> modes;
    for (const auto mode : all_modes) modes.emplace_back(name_of(mode));
    group.write_strings("mode", {"mode"}, modes);
    std::vector<std::int64_t> runs;
    for (std::int64_t r = 0; r < sweep.runs; ++r) runs.push_back(r);
    group.write<std::int64_t>("run", {"run"}, runs, {"1", "start number: swirl classify --seed (seed + run)", {}});
    write_cells(group, sweep, axes);
    auto by_run = axes;
    by_run.push_back("run");
    for (const auto& column : run_columns) {
        std::vector<double> values;
        for (const auto& result : sweep.results) values.push_back(result.*column.member);
        group.write<double>(column.name, by_run, values, {column.units, column.long_name, {}});
    }
    record.finish();
}

void read_sweep(const std::string& path, Sweep& sweep) {
    const RecordReader record(path);
    if (!record.contains("/sweep/run_mode")) throw BadInput(fmt::format("record '{}' is not a sweep's", path));
    for (const auto& [name, value] : sweep.settings)
        if (!record.has_attribute("/settings", name) || record.attribute("/settings", name) != value)
            throw BadInput(
                fmt::format("record '{}' was made with another {}; give the same, or another file", path, name));
    for (const auto& column : run_columns) {
        const auto values = record.read<double>(std::string("/sweep/") + column.name);
        if (values.size() != sweep.results.size()) throw BadInput(fmt::format("record '{}' has another grid", path));
        for (std::size_t i = 0; i < values.size(); ++i) sweep.results[i].*column.member = values[i];
    }
}

}  // namespace swirl::apps::sweep
