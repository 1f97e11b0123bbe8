#include "apps/input/series_columns.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/input/bodies.hpp"
#include "apps/input/cells.hpp"
#include "apps/input/column_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace swirl::apps {

namespace {

/// Rises over all rows or, of several bodies, over those of each.
bool may_be_time(const DelimitedFile& file, std::size_t column, bool whole) {
    if (!has_only_times(file, column)) return false;
    const std::vector<double> times = times_of(file, column).values;
    if (whole && std::any_of(times.begin(), times.end(), [](double t) { return t != std::floor(t); })) return false;
    return rises(times) || bodies_in(file, column, times).column.has_value();
}

std::optional<std::size_t> first_named(const DelimitedFile& file, bool (*names)(const std::string&), bool checked,
                                       bool whole = false) {
    for (std::size_t k = 0; k < file.header.size(); ++k)
        if (names(file.header[k]) && (!checked || may_be_time(file, k, whole))) return k;
    return std::nullopt;
}

/// Columns that rise beside the times, and are no row numbers: said, not used.
void note_rising(const DelimitedFile& file, SeriesColumns& columns) {
    std::vector<std::string> names;
    for (const std::size_t k : rising_columns(file))
        if (columns.time != k && file.header[k] != "row" && !names_spin(file.header[k]))
            names.push_back(file.header[k]);
    if (names.empty()) return;
    if (columns.time)
        columns.notes.push_back(
            fmt::format("times are column {}; {} too: --time NAME takes another", file.header[*columns.time],
                        names.size() == 1 ? names[0] + " rises" : fmt::format("{} rise", fmt::join(names, ", "))));
    else
        columns.notes.push_back(
            fmt::format("no column is named as times: rows are counted, though {}: --time NAME "
                        "takes it",
                        names.size() == 1 ? names[0] + " rises" : fmt::format("{} rise", fmt::join(names, ", "))));
}

void find_frames(const DelimitedFile& file, SeriesColumns& columns) {
    columns.time = first_named(file, names_frame, true, true);
    columns.in_frames = columns.time.has_value();
}

void choose_time(const DelimitedFile& file, const SeriesChoice& choice, SeriesColumns& columns) {
    const bool named_none = std::find(file.header.begin(), file.header.end(), "none") != file.header.end();
    if (choice.time == "none" && !named_none) return;
    if (!choice.time.empty()) {
        columns.time = column_of(file, "--time", choice.time);
        columns.in_frames = choice.fps || (!file.header.empty() && names_frame(file.header[*columns.time]));
        return;
    }
    if (file.columns < 2) return;
    if (file.header.empty()) {
        columns.time = 0;
        columns.in_frames = choice.fps.has_value();
        return;
    }
    if (choice.fps) {
        find_frames(file, columns);
        const auto times = first_named(file, names_time, false);
        if (!columns.time && times)
            throw BadInput(
                fmt::format("fps: '{}' has times, column {}; --fps is for frames (--time NAME says which "
                            "column counts them, --time none that rows are frames)",
                            file.name, file.header[*times]));
        return;
    }
    columns.time = first_named(file, names_time, false);
    if (columns.time) return;
    columns.time = first_named(file, may_name_time, true);
    if (!columns.time) find_frames(file, columns);
    if (!columns.in_frames) note_rising(file, columns);
}

void read_times(const DelimitedFile& file, const SeriesChoice& choice, SeriesColumns& columns) {
    if (!columns.time) {
        for (std::size_t row = 0; row < file.rows.size(); ++row)
            columns.times.push_back(static_cast<double>(row) * choice.spacing);
        columns.in_frames = choice.fps.has_value();
        columns.seconds = 1;
    } else {
        ReadTimes times = times_of(file, *columns.time);
        columns.times = std::move(times.values);
        if (times.of_clock && choice.fps) throw BadInput("fps: the times are those of a clock; --fps is for frames");
        if (times.of_clock) {
            columns.in_frames = false;
            columns.seconds = 1;
        } else if (!columns.in_frames) {
            const std::string unit = unit_of_column(file, *columns.time);
            columns.seconds = unit.empty() ? std::optional(1.0) : seconds_in(unit);
        }
    }
    if (!choice.fps) return;
    if (std::any_of(columns.times.begin(), columns.times.end(), [](double t) { return t != std::floor(t); }))
        throw BadInput(
            fmt::format("fps: column {} does not count frames: its numbers are not whole; --fps is for frames",
                        column_name(file, *columns.time)));
    for (double& time : columns.times) time /= *choice.fps;
    columns.seconds = 1;
}

/// Neither times nor what is no value; a column of words has a word in its first row.
bool may_be_value(const DelimitedFile& file, const std::vector<std::string>& first, std::size_t k) {
    if (names_no_value(file.header[k])) return false;
    return number_in(first[k], file.layout.decimal) || is_missing(first[k]);
}

std::size_t default_value(const DelimitedFile& file, SeriesColumns& columns) {
    for (std::size_t k = 0; k < file.header.size(); ++k)
        if (names_spin(file.header[k]) && columns.time != k) return k;
    const std::size_t last = columns.time == file.columns - 1 && file.columns > 1 ? file.columns - 2 : file.columns - 1;
    if (file.header.empty()) return last;
    std::vector<std::string> names;
    std::size_t found = last;
    const auto first = file.cells(0);
    for (std::size_t k = 0; k < file.columns; ++k)
        if (columns.time != k && may_be_value(file, first, k)) names.push_back(file.header[found = k]);
    if (names.size() > 1)
        columns.notes.push_back(fmt::format("column {} is analysed, the last of {}: --column NAME takes another",
                                            names.back(), fmt::join(names, ", ")));
    return found;
}

std::vector<std::size_t> values_for(const DelimitedFile& file, const SeriesChoice& choice, SeriesColumns& columns) {
    std::vector<std::size_t> found;
    const auto take = [&](const char* flag, const std::vector<std::string>& names) {
        for (const auto& name : names) found.push_back(column_of(file, flag, name));
    };
    take("--position", choice.position);
    take("--marks", choice.marks);
    take("--mark", choice.mark);
    if (!choice.angle.empty()) take("--angle", {choice.angle});
    if (!choice.column.empty()) take("--column", {choice.column});
    if (found.empty()) found.push_back(default_value(file, columns));
    return found;
}

/// A column that is named as times or frames and was not taken, for it does not rise.
void note_not_rising(const DelimitedFile& file, SeriesColumns& columns) {
    if (columns.time) return;
    for (std::size_t k = 0; k < file.header.size(); ++k) {
        if (!(may_name_time(file.header[k]) || names_frame(file.header[k])) || !has_only_times(file, k)) continue;
        const std::vector<double> times = times_of(file, k).values;
        const auto [low, high] = std::minmax_element(times.begin(), times.end());
        if (*low == *high) continue;
        columns.notes.push_back(
            fmt::format("column {} is named as times and does not rise: rows are counted, one {} "
                        "apart",
                        file.header[k], columns.in_frames ? "frame" : "unit of time"));
        return;
    }
}

}  // namespace

bool has_only_times(const DelimitedFile& file, std::size_t column) {
    CellReader reader(file);
    for (std::size_t row = 0; row < file.rows.size(); ++row) {
        const std::string_view cell = reader.at(row)[column];
        if (!number_in(cell, file.layout.decimal) && !clock_time_in(cell)) return false;
    }
    return true;
}

std::vector<std::size_t> rising_columns(const DelimitedFile& file) {
    std::vector<std::size_t> rising;
    for (std::size_t k = 0; k < file.columns; ++k) rising.push_back(k);
    std::vector<double> last(file.columns, -std::numeric_limits<double>::infinity());
    CellReader reader(file);
    for (std::size_t row = 0; row < file.rows.size() && !rising.empty(); ++row) {
        const auto& cells = reader.at(row);
        std::erase_if(rising, [&](std::size_t k) {
            const auto number = number_in(cells[k], file.layout.decimal);
            if (!number || !(*number > last[k])) return true;
            last[k] = *number;
            return false;
        });
    }
    return file.rows.size() < 3 ? std::vector<std::size_t>() : rising;  // two values rise by chance
}

SeriesColumns time_columns_of(const DelimitedFile& file, const SeriesChoice& choice) {
    SeriesColumns columns;
    choose_time(file, choice, columns);
    read_times(file, choice, columns);
    if (choice.time.empty()) note_not_rising(file, columns);
    return columns;
}

SeriesColumns columns_of(const DelimitedFile& file, const SeriesChoice& choice) {
    SeriesColumns columns = time_columns_of(file, choice);
    require_one_body(file, bodies_in(file, columns.time, columns.time ? columns.times : std::vector<double>()));
    columns.values = values_for(file, choice, columns);
    return columns;
}

}  // namespace swirl::apps
