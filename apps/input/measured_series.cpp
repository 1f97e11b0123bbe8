#include "apps/input/measured_series.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/number_checks.hpp"
#include "apps/input/delimited_file.hpp"
#include "apps/input/series_of_motion.hpp"
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

/// Counts what is missing and looks at the times. @throws BadInput with fewer than two values, none whose square can be
/// held, or times that are equal after rounding (of an angle they lie halfway between those of the file)
void describe(MeasuredSeries& series) {
    series.missing = 0;
    series.gaps = count_gaps(series.values);
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
        if (i == 0) continue;
        if (!(t[i] > t[i - 1]))
            throw BadInput(fmt::format(
                "series: samples {} and {} of column {} have the same time after rounding, {:.17g}; the times "
                "of an angle's S lie halfway between its own",
                i, i + 1, series.column, t[i]));
        series.largest_step = std::max(series.largest_step, t[i] - t[i - 1]);
    }
    series.even = series.largest_deviation <= even_within;
}

void check(const SeriesChoice& choice) {
    if (!choice.angle.empty() + !choice.position.empty() + !choice.column.empty() > 1)
        throw BadInput("--column, --angle and --position each say what is analysed; give one");
    if (choice.angle.empty() && (choice.degrees || choice.symmetry != 1 || choice.swirl_rate != 1))
        throw BadInput("--degrees, --symmetry and --swirl-rate of a series are an angle's; --angle COLUMN is missing");
    if (!(choice.swirl_rate > 0 && detail::is_holdable(choice.swirl_rate)))
        throw BadInput(fmt::format("swirl-rate = {} is outside its range: {:g} to {:g}", choice.swirl_rate,
                                   detail::smallest_magnitude, detail::largest_magnitude));
    if (!(choice.spacing > 0 && detail::is_holdable(choice.spacing)))
        throw BadInput(fmt::format("spacing = {} is outside its range: {:g} to {:g}", choice.spacing,
                                   detail::smallest_magnitude, detail::largest_magnitude));
}

std::vector<std::size_t> value_columns(const DelimitedFile& file, const SeriesChoice& choice,
                                       std::optional<std::size_t> time) {
    if (!choice.position.empty())
        return {column_of(file, "--position", choice.position.front()),
                column_of(file, "--position", choice.position.back())};
    if (!choice.angle.empty()) return {column_of(file, "--angle", choice.angle)};
    return {value_column(file, choice.column, time)};
}

/// Values, and of an angle their times, of the columns.
void take_values(const SeriesChoice& choice, std::vector<std::vector<double>>& columns, MeasuredSeries& series) {
    series.quantity = as_measured;
    series.values = std::move(columns[0]);
    if (!choice.position.empty()) {
        series.quantity = distance_of_position;
        for (std::size_t i = 0; i < series.values.size(); ++i)
            series.values[i] = std::hypot(series.values[i], columns[1][i]);
    } else if (!choice.angle.empty()) {
        series.quantity = spin_of_angle;
        const double unit = choice.degrees ? pi<double>() / 180 : 1;
        series.angle.resolution = decimal_resolution(series.values) * unit;
        for (double& angle : series.values) angle *= unit;
        series.angle.period = 2 * pi<double>() / choice.symmetry;
        series.angle.times = series.times;
        series.angle.values = series.values;
        AngleRates rates = rates_of_angle(series.times, series.values, series.angle.period, choice.swirl_rate);
        series.times = std::move(rates.times);
        series.values = std::move(rates.values);
        series.largest_turn = rates.largest_turn;
        series.swirl_rate = choice.swirl_rate;
    }
}

}  // namespace

void SeriesChoice::add_to(Flags& command, bool with_spacing) {
    const auto text = [&](const char* name, std::string& target, const char* type, const char* help) {
        command.add_option(name, target, help)->type_name(type)->group("Input");
    };
    text("--series", file, "FILE.csv", "a measured series, text; - reads standard input");
    text("--column", column, "NAME", "the series' values: name or number of the column");
    text("--time", time, "NAME", "the series' times: name or number of the column, or none");
    if (with_spacing)
        command.add_option("--spacing", spacing, "time between samples where there is no column of times (default 1)")
            ->type_name("DT")
            ->group("Input");
    command.add_flag("--degrees", degrees, "of --angle COLUMN, whose rate over --swirl-rate is S: it is in degrees")
        ->group("Input");
    command.add_option("--symmetry", symmetry, "of --angle COLUMN: it is known modulo 1/N of a turn (default 1)")
        ->type_name("N")
        ->transform(whole_number(1, 1'000'000))
        ->group("Input");
    command
        .add_option("--position", position,
                    "in place of --column: two columns, of which the distance from (0, 0) is analysed: the swirl's "
                    "centre in the laboratory, or the container's in its own frame")
        ->type_name("X Y")
        ->expected(2)
        ->group("Input");
}

MeasuredSeries read_series(const SeriesChoice& choice) {
    check(choice);
    const DelimitedFile file = read_delimited(choice.file);
    const auto time = time_column(file, choice.time);
    const auto wanted = value_columns(file, choice, time);
    MeasuredSeries series;
    for (const std::size_t k : wanted) series.column += (series.column.empty() ? "" : ", ") + column_name(file, k);
    std::vector<std::vector<double>> columns = numbers_of(file, wanted, std::vector<bool>(wanted.size(), true));
    for (std::size_t k = 0; k < wanted.size(); ++k)
        require_not_too_large(file, columns[k], column_name(file, wanted[k]));
    if (time) {
        series.time = column_name(file, *time);
        series.times = numbers_of(file, {*time}, {false})[0];
        require_not_too_large(file, series.times, series.time);
        require_rising(file, series.times, series.time);
    } else {
        for (std::size_t i = 0; i < columns[0].size(); ++i)
            series.times.push_back(static_cast<double>(i) * choice.spacing);
    }
    series.rows = columns[0].size();
    const bool is_motion = !(choice.angle.empty() && choice.position.empty());
    const bool is_sampled = is_motion && choice.long_steps == LongSteps::maybe;
    fill_lost_rows(series.times, columns, is_sampled ? LongSteps::lost_rows : choice.long_steps);
    take_values(choice, columns, series);
    describe(series);
    return series;
}

MeasuredSeries part_of(const MeasuredSeries& series, std::size_t first, std::size_t count) {
    MeasuredSeries part = series;
    const auto cut = [&](std::vector<double>& v, std::size_t size) {
        const auto begin = v.begin() + static_cast<std::ptrdiff_t>(first);
        v = std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(size));
    };
    cut(part.values, count);
    cut(part.times, count);
    if (!part.angle.values.empty()) {
        cut(part.angle.values, count + 1);
        cut(part.angle.times, count + 1);
    }
    describe(part);
    return part;
}

std::string series_in_words(const MeasuredSeries& series) {
    const std::string quantity = series.is_motion() ? fmt::format(" ({})", series.quantity) : "";
    const std::string gaps = series.gaps == 0 ? "no gaps"
                                              : fmt::format("{} gap{} ({} samples missing)", series.gaps,
                                                            series.gaps == 1 ? "" : "s", series.missing);
    const std::string turns =
        series.is_unwrapped()
            ? ""
            : fmt::format(", turns of up to {:.3g} of half a period: their direction is a guess", series.largest_turn);
    return fmt::format("column {}{}, {} rows, {} {:.6g}, {}{}", series.column, quantity, series.rows,
                       series.even ? "spacing" : "mean spacing", series.spacing, gaps, turns);
}

}  // namespace swirl::apps
