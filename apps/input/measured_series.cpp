#include "apps/input/measured_series.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/input/delimited_file.hpp"
#include "map/model/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

namespace swirl::apps {

namespace {

/// "t", "Time", "time [s]", "t_ms": t or time, and then no letter or digit.
bool names_time(const std::string& name) {
    std::string lower = name;
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    for (const std::string word : {"time", "t"})
        if (lower.rfind(word, 0) == 0 &&
            (lower.size() == word.size() || std::isalnum(static_cast<unsigned char>(lower[word.size()])) == 0))
            return true;
    return false;
}

bool names_spin(const std::string& name) {
    return name == "S" || name == "spin";
}

std::optional<std::size_t> time_column(const DelimitedFile& file, const std::string& wanted) {
    if (wanted == "none" && std::find(file.header.begin(), file.header.end(), wanted) == file.header.end())
        return std::nullopt;
    if (!wanted.empty()) return column_of(file, "--time", wanted);
    if (file.columns < 2) return std::nullopt;
    if (file.header.empty()) return 0;
    const auto found = std::find_if(file.header.begin(), file.header.end(), names_time);
    if (found == file.header.end()) return std::nullopt;
    return static_cast<std::size_t>(found - file.header.begin());
}

std::size_t value_column(const DelimitedFile& file, const std::string& wanted, std::optional<std::size_t> time) {
    if (!wanted.empty()) return column_of(file, "--column", wanted);
    for (std::size_t k = 0; k < file.header.size(); ++k)
        if (names_spin(file.header[k]) && time != k) return k;
    return time == file.columns - 1 && file.columns > 1 ? file.columns - 2 : file.columns - 1;
}

void require_rising(const DelimitedFile& file, const std::vector<double>& times, const std::string& column) {
    for (std::size_t i = 1; i < times.size(); ++i)
        if (!(times[i] > times[i - 1]))
            throw BadInput(at_line(file, i,
                                   fmt::format("time {:.17g} {} {:.17g} of line {}; times must rise (--time NAME says "
                                               "which column they are, now {}; "
                                               "--time none: no column)",
                                               times[i], times[i] == times[i - 1] ? "repeats" : "falls behind",
                                               times[i - 1], file.rows[i - 1].line, column)));
}

void require_not_too_large(const DelimitedFile& file, const std::vector<double>& column, const std::string& name) {
    for (std::size_t i = 0; i < column.size(); ++i)
        if (std::abs(column[i]) > detail::largest_magnitude)
            throw BadInput(at_line(file, i,
                                   fmt::format("{:g} in column {} is outside its range: -{:g} to {:g}", column[i], name,
                                               detail::largest_magnitude, detail::largest_magnitude)));
}

/// Counts what is missing and looks at the times. @throws BadInput with fewer than two values, or none whose square can
/// be held
void describe(MeasuredSeries& series) {
    series.missing = 0;
    double largest = 0;
    for (const double v : series.values) {
        series.missing += std::isnan(v) ? 1 : 0;
        largest = std::max(largest, std::isnan(v) ? 0 : std::abs(v));
    }
    if (!detail::is_holdable(largest))
        throw BadInput(
            fmt::format("series: the largest value of column {}, {:g}, is outside its range: 0, or {:g} to "
                        "{:g}",
                        series.column, largest, detail::smallest_magnitude, detail::largest_magnitude));
    if (series.values.size() - series.missing < 2)
        throw BadInput(fmt::format("series: column {} has {} values; at least 2 are needed", series.column,
                                   series.values.size() - series.missing));
    const auto& t = series.times;
    series.spacing = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
    series.largest_step = series.largest_deviation = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
        const double deviation = t[i] - (t.front() + static_cast<double>(i) * series.spacing);
        series.largest_deviation = std::max(series.largest_deviation, std::abs(deviation) / series.spacing);
        if (i > 0) series.largest_step = std::max(series.largest_step, t[i] - t[i - 1]);
    }
    series.even = series.largest_deviation <= even_within;
}

}  // namespace

MeasuredSeries read_series(const SeriesChoice& choice) {
    const DelimitedFile file = read_delimited(choice.file);
    const auto time = time_column(file, choice.time);
    const std::size_t value = value_column(file, choice.column, time);
    MeasuredSeries series;
    series.column = column_name(file, value);
    std::vector<std::vector<double>> columns;
    if (time) {
        columns = numbers_of(file, {value, *time}, {true, false});
        series.time = column_name(file, *time);
        require_not_too_large(file, columns[1], series.time);
        require_rising(file, columns[1], series.time);
        series.times = std::move(columns[1]);
    } else {
        if (!(choice.spacing > 0 && detail::is_holdable(choice.spacing)))
            throw BadInput(fmt::format("spacing = {} is outside its range: {:g} to {:g}", choice.spacing,
                                       detail::smallest_magnitude, detail::largest_magnitude));
        columns = numbers_of(file, {value}, {true});
        for (std::size_t i = 0; i < columns[0].size(); ++i)
            series.times.push_back(static_cast<double>(i) * choice.spacing);
    }
    require_not_too_large(file, columns[0], series.column);
    series.values = std::move(columns[0]);
    describe(series);
    return series;
}

MeasuredSeries part_of(const MeasuredSeries& series, std::size_t first, std::size_t count) {
    MeasuredSeries part = series;
    const auto cut = [&](std::vector<double>& v) {
        const auto begin = v.begin() + static_cast<std::ptrdiff_t>(first);
        v = std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(count));
    };
    cut(part.values);
    cut(part.times);
    describe(part);
    return part;
}

}  // namespace swirl::apps
