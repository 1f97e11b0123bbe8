#include "apps/sweep/run_columns.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/output/value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace swirl::apps::sweep {

namespace {

struct RunColumn {
    const char* name;
    double RunResult::*member;
    const char* units;
    const char* long_name;
    ElementType type = ElementType::float64;
    std::vector<std::string> meanings = {};  ///< of a name's number
    std::optional<double> before = {};       ///< what stands for it where an older record lacks it
};

/// A number that older records lack.
RunColumn added(const char* name, double RunResult::*member, const char* long_name) {
    return {name, member, "1", long_name, ElementType::float64, {}, analysis::nan};
}

/// What a record holds of each run.
std::vector<RunColumn> run_columns() {
    const auto names = ElementType::uint8, count = ElementType::int64;
    std::vector<std::string> modes;
    for (const auto mode : all_modes) modes.emplace_back(name_of(mode));
    return {
        {"run_mode", &RunResult::mode, "", "mode", names, modes},
        {"run_kind", &RunResult::kind, "", "kind", names, names_up_to(analysis::Kind::chord)},
        {"run_outcome", &RunResult::outcome, "", "outcome", names, names_up_to(Outcome::unresolved)},
        {"run_period", &RunResult::period, "1", "period, 0: none", count},
        {"run_mean_S", &RunResult::mean_spin, "1", "time mean of S"},
        {"run_mean_S_per_impact", &RunResult::mean_spin_per_impact, "1", "mean of S over impacts"},
        {"run_recurrence_rate", &RunResult::recurrence_rate, "1", "RC of S"},
        {"run_largest_exponent", &RunResult::largest_exponent, "1", "largest Lyapunov exponent per impact"},
        {"run_impacts", &RunResult::impacts, "1", "impacts followed", count},
        added("run_mean_S_error", &RunResult::mean_spin_error, "standard error of run_mean_S along the run"),
        added("run_mean_S_per_impact_error", &RunResult::mean_spin_per_impact_error, "that of run_mean_S_per_impact"),
        {"run_mean_S_kind", &RunResult::mean_kind, "", "how its mean was come by", names,
         names_up_to(MeanKind::too_short), 0},
        added("run_growth_exponent", &RunResult::growth, "of kind accelerated: power of n by which J grows"),
        added("run_growth_exponent_low", &RunResult::growth_low, "from this power on, at 95 %"),
        added("run_growth_exponent_high", &RunResult::growth_high, "up to this power"),
        added("run_limit_S", &RunResult::limit_spin, "of kind chord: S to which the chord leads"),
    };
}

/// `use.template operator()<T>()` with the column's type in a record.
template <class Use>
void in_type_of(const RunColumn& column, const Use& use) {
    if (column.type == ElementType::uint8)
        use.template operator()<std::uint8_t>();
    else if (column.type == ElementType::int64)
        use.template operator()<std::int64_t>();
    else
        use.template operator()<double>();
}

}  // namespace

void write_run_columns(const RecordGroup& group, const std::vector<std::string>& axes,
                       std::span<const RunResult> results) {
    for (const auto& column : run_columns())
        in_type_of(column, [&]<class T>() {
            std::vector<T> values;
            for (const auto& result : results) values.push_back(static_cast<T>(result.*column.member));
            group.write<T>(column.name, axes, values, {column.units, column.long_name, column.meanings});
        });
}

std::vector<RunResult> read_run_columns(const RecordReader& record, const std::string& group) {
    std::vector<RunResult> results;
    for (const auto& column : run_columns())
        in_type_of(column, [&]<class T>() {
            const std::string path = group + "/" + column.name;
            const auto values = column.before && !record.contains(path)
                                    ? std::vector<T>(results.size(), static_cast<T>(*column.before))
                                    : record.read<T>(path);
            if (results.empty()) results.resize(values.size());
            const auto named = [&](T value) {
                return column.meanings.empty() || static_cast<std::size_t>(value) < column.meanings.size();
            };
            if (values.size() != results.size() || !std::all_of(values.begin(), values.end(), named))
                throw BadInput(fmt::format("a record's {}/{} does not fit its runs", group, column.name));
            for (std::size_t i = 0; i < values.size(); ++i) results[i].*column.member = static_cast<double>(values[i]);
        });
    return results;
}

}  // namespace swirl::apps::sweep
