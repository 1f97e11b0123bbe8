#include "apps/fit/impact_table.hpp"

#include "analysis/fits/fit_impacts.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/input/delimited_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace swirl::apps::fit {

namespace {

bool has(const DelimitedFile& file, const std::string& column) {
    return std::find(file.header.begin(), file.header.end(), column) != file.header.end();
}

void require_columns(const DelimitedFile& file, const std::vector<std::string>& wanted) {
    for (const std::string& column : wanted)
        if (!has(file, column))
            throw BadInput(
                fmt::format("impacts '{}': column {} is missing; wanted are {}; the file has {}", file.name, column,
                            fmt::join(wanted, ", "),
                            file.header.empty() ? "no header" : fmt::format("{}", fmt::join(file.header, ", "))));
}

const std::vector<std::string> error_columns = {"velocity_error_before", "spin_error_before", "velocity_error_after",
                                                "spin_error_after"};

bool is_usable(const analysis::MeasuredImpact& impact) {
    const auto known = [](const Eigen::Vector3d& error) { return error.allFinite() && error.minCoeff() > 0; };
    return impact.before.allFinite() && impact.after.allFinite() && impact.offset.allFinite() &&
           known(impact.error_before) && known(impact.error_after);
}

}  // namespace

ImpactTable read_impacts(const std::string& name) {
    LayoutChoice layout;
    layout.what = "impacts";
    const DelimitedFile file = read_delimited(name, layout);
    ImpactTable table;
    table.rows = file.rows.size();
    table.by_rows = !(has(file, "rx") && has(file, "ry")) && (has(file, "n3") || has(file, "d3"));
    std::vector<std::string> wanted = {"vx_before", "vy_before", "spin_before", "vx_after", "vy_after", "spin_after"};
    wanted.insert(wanted.end(), {table.by_rows ? "n3" : "rx", table.by_rows ? "d3" : "ry"});
    require_columns(file, wanted);
    if (has(file, "flags")) wanted.emplace_back("flags");
    const bool flagged = wanted.size() > 8;
    table.has_errors = std::any_of(error_columns.begin(), error_columns.end(),
                                   [&](const std::string& column) { return has(file, column); });
    if (table.has_errors) {
        require_columns(file, error_columns);
        wanted.insert(wanted.end(), error_columns.begin(), error_columns.end());
    }
    std::vector<std::size_t> places;
    for (const std::string& column : wanted) places.push_back(column_of(file, "--impacts", column));
    const auto columns = numbers_of(file, places, std::vector<bool>(places.size(), true));
    for (std::size_t row = 0; row < table.rows; ++row) {
        const auto at = [&](std::size_t column) { return columns[column][row]; };
        if (flagged && at(8) > 0) {
            ++table.flagged;
            continue;
        }
        analysis::MeasuredImpact impact;
        impact.before << at(0), at(1), at(2);
        impact.after << at(3), at(4), at(5);
        impact.offset << at(6), table.by_rows ? -at(7) : at(7);
        if (table.has_errors) {
            const std::size_t first = flagged ? 9 : 8;
            impact.error_before << at(first), at(first), at(first + 1);
            impact.error_after << at(first + 2), at(first + 2), at(first + 3);
        }
        if (!(flagged && std::isnan(at(8))) && is_usable(impact))
            table.impacts.push_back(impact);
        else
            ++table.missing;
    }
    if (table.impacts.size() < analysis::fewest_impacts)
        throw BadInput(fmt::format("impacts '{}' has {} usable rows of {}; {} or more are needed", name,
                                   table.impacts.size(), table.rows, analysis::fewest_impacts));
    return table;
}

}  // namespace swirl::apps::fit
