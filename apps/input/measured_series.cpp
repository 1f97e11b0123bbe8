#include "apps/input/measured_series.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/text_file.hpp"
#include "apps/input/bodies.hpp"
#include "apps/input/column_names.hpp"
#include "apps/input/column_notes.hpp"
#include "apps/input/measured_motion.hpp"
#include "apps/input/row_order.hpp"
#include "apps/output/wrapped.hpp"
#include "map/model/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace swirl::apps {

namespace {

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

/// Even times that a clock with few digits rounded: none is further from them than its last digit.
bool is_rounded_clock(const MeasuredSeries& series) {
    constexpr double coarsest = 0.7;  // digit over spacing: whole numbers two of which are lost in a step are none
    if (series.largest_deviation > 0.5) return false;
    const double digit = decimal_resolution(series.times);
    return digit <= coarsest * series.spacing && series.largest_deviation * series.spacing <= 1.01 * digit;
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
    series.even = series.largest_deviation <= even_within || is_rounded_clock(series);
}

/// ω_s in radians per unit of the series' time.
double swirl_rate_of(const SeriesChoice& choice, const SeriesColumns& columns) {
    const double rate = std::abs(choice.swirl_rate);
    if (choice.rate_unit == RateUnit::radians) return rate;
    if (!columns.seconds)
        throw BadInput(
            columns.in_frames
                ? "swirl-rate: the times count frames, so that a rate in rpm, Hz or rad/s needs --fps F"
                : "swirl-rate: the times' unit is none that is known (s, ms, us, ns, min, h), so that a rate "
                  "is wanted in radians per unit of them, a number alone");
    const double turn = 2 * pi<double>();
    switch (choice.rate_unit) {
        case RateUnit::turns_a_minute:
            return rate * turn / 60 * *columns.seconds;
        case RateUnit::turns_a_second:
            return rate * turn * *columns.seconds;
        default:
            return rate * *columns.seconds;
    }
}

/// A column of rates of turn, over --swirl-rate.
void make_spin_of_rate(const DelimitedFile& file, const SeriesChoice& choice, const SeriesColumns& columns,
                       MeasuredSeries& series) {
    series.quantity = spin_of_rate;
    series.swirl_rate = swirl_rate_of(choice, columns);
    if (!columns.seconds)
        throw BadInput(
            fmt::format("swirl-rate: column {} is a rate per second, and the times count frames: --fps F "
                        "makes seconds of them",
                        series.column));
    const double per_time = *turning_rate_of(file, columns.values.front()) * *columns.seconds;
    const double factor = (series.clockwise ? -per_time : per_time) / series.swirl_rate;
    for (double& value : series.values) value *= factor;
}

/// Values, and of an angle their times, of the columns.
void take_values(const SeriesChoice& choice, double swirl_rate, std::vector<std::vector<double>>& columns,
                 MeasuredSeries& series) {
    series.quantity = as_measured;
    series.values = std::move(columns[0]);
    if (!choice.position.empty()) {
        series.quantity = distance_of_position;
        for (std::size_t i = 0; i < series.values.size(); ++i)
            series.values[i] = std::hypot(series.values[i], columns[1][i]);
    } else if (choice.is_angle()) {
        series.quantity = spin_of_angle;
        const double unit = series.angle_unit;
        const double sense = series.y_down == series.clockwise ? 1 : -1;
        if (!choice.angle.empty()) series.angle.resolution = decimal_resolution(series.values) * unit;
        for (double& angle : series.values) angle *= sense * unit;
        series.angle.period = 2 * pi<double>() / choice.symmetry;
        series.angle.values = series.values;
        constexpr double worth_a_note = 0.01;  // of a step
        if (choice.rows != "impacts" && even_out_times(series.times, series.values, series.angle.period) > worth_a_note)
            series.notes.push_back(fmt::format("times are even but for their last digits: rows are taken {:.9g} apart",
                                               series.times[1] - series.times[0]));
        series.angle.times = series.times;
        AngleRates rates = rates_of_angle(series.times, series.values, series.angle.period, swirl_rate);
        level_rounding(rates, series.angle.values, swirl_rate);
        series.times = std::move(rates.times);
        series.values = std::move(rates.values);
        series.largest_turn = rates.largest_turn;
        series.swirl_rate = swirl_rate;
    }
}

/// A body that turns with the swirl must turn by less than half a period between rows, or its turns can't be told.
void note_slow_camera(MeasuredSeries& series) {
    if (series.quantity != spin_of_angle) return;
    const double half = series.angle.period / 2, turn = series.swirl_rate * series.spacing;
    if (!(turn > half)) return;
    series.notes.push_back(fmt::format(
        "the camera is too slow: at the swirl's rate a body turns by {:.3g} of half of {} from row to row, so "
        "that its turns are a guess; {:.3g} or more rows per unit of time are needed",
        turn / half, half > 3 ? "a turn" : fmt::format("1/{:.0f} of a turn", pi<double>() / half),
        series.swirl_rate / half));
}

/// Rows at either end of which a value is missing tell nothing, and no spectrum needs to reach around them.
void cut_ends(std::vector<double>& times, std::vector<std::vector<double>>& columns, MeasuredSeries& series) {
    const auto is_whole = [&](std::size_t i) {
        return std::none_of(columns.begin(), columns.end(), [i](const auto& column) { return std::isnan(column[i]); });
    };
    std::size_t begin = 0, end = times.size();
    while (begin < end && !is_whole(begin)) ++begin;
    while (end > begin && !is_whole(end - 1)) --end;
    const std::size_t after = times.size() - end;
    if (begin == end || (begin == 0 && after == 0)) return;
    const auto cut = [&](std::vector<double>& column) {
        column.erase(column.begin() + static_cast<std::ptrdiff_t>(end), column.end());
        column.erase(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(begin));
    };
    cut(times);
    for (auto& column : columns) cut(column);
    const auto rows = [](std::size_t count) { return fmt::format("{} row{}", count, count == 1 ? "" : "s"); };
    series.notes.push_back(
        fmt::format("cut off, for no value is there: {}{}{}", begin > 0 ? rows(begin) + " at the beginning" : "",
                    begin > 0 && after > 0 ? ", " : "", after > 0 ? rows(after) + " at the end" : ""));
}

bool is_rate_of(const DelimitedFile& file, const SeriesChoice& choice, std::size_t column) {
    return !choice.is_angle() && choice.position.empty() && turning_rate_of(file, column).has_value();
}

/// The table of the file, of which --where leaves some rows.
std::shared_ptr<const DelimitedFile> rows_asked_for(const SeriesChoice& choice, MeasuredSeries& series) {
    auto table = choice.read();
    series.notes = table->layout.notes;
    if (choice.where.empty()) return rows_in_order(table, choice, series.notes);
    auto part = std::make_shared<DelimitedFile>(*table);
    for (const std::string& text : choice.where) {
        const Condition condition = condition_from(*part, text);
        keep_rows(*part, condition);
        series.body += (series.body.empty() ? "" : ", ") + printable(condition.value);
    }
    return rows_in_order(part, choice, series.notes);
}

LongSteps meaning_of_long_steps(const SeriesChoice& choice, bool in_frames) {
    if (choice.rows == "impacts") return LongSteps::long_flights;
    if (choice.rows == "samples") return LongSteps::lost_rows;
    const bool is_motion = choice.is_angle() || !choice.position.empty();
    const bool is_sampled = is_motion || in_frames || choice.fps;
    return is_sampled && choice.long_steps == LongSteps::maybe ? LongSteps::lost_rows : choice.long_steps;
}

}  // namespace

bool is_rate_column(const DelimitedFile& file, const SeriesChoice& choice) {
    return is_rate_of(file, choice, columns_of(file, choice).values.front());
}

MeasuredSeries read_series(const SeriesChoice& choice) {
    choice.check();
    MeasuredSeries series;
    const auto table = rows_asked_for(choice, series);
    const DelimitedFile& file = *table;
    SeriesColumns columns = columns_of(file, choice);
    for (const std::size_t k : columns.values)
        series.column += (series.column.empty() ? "" : ", ") + column_name(file, k);
    series.notes.insert(series.notes.end(), columns.notes.begin(), columns.notes.end());
    series.y_down = choice.y_down;
    const bool is_rate = choice.has_swirl_rate() && is_rate_of(file, choice, columns.values.front());
    if (choice.has_swirl_rate() && !choice.is_angle() && !is_rate)
        throw BadInput(
            fmt::format("swirl-rate: it is of an angle (--angle COLUMN), or of a column whose unit is a "
                        "rate of turn, as rad/s; column {} is neither",
                        series.column));
    series.clockwise = (choice.is_angle() || is_rate) && choice.swirl_rate < 0;
    std::vector<std::vector<double>> values = values_of_motion(file, choice, columns, series);
    note_column(file, choice, columns.values.front(), values.front(), series);
    series.times = std::move(columns.times);
    if (columns.time) {
        series.time = column_name(file, *columns.time);
        for (std::size_t i = 0; i < series.times.size(); ++i)
            if (std::abs(series.times[i]) > detail::largest_magnitude)
                throw BadInput(
                    at_line(file, i,
                            fmt::format("{:g} in column {} is outside its range: -{:g} to {:g}", series.times[i],
                                        series.time, detail::largest_magnitude, detail::largest_magnitude)));
        require_rising(file, series.times, series.time);
    }
    series.rows = file.rows.size();
    cut_ends(series.times, values, series);
    fill_lost_rows(series.times, values, meaning_of_long_steps(choice, columns.in_frames));
    take_values(choice, choice.is_angle() ? swirl_rate_of(choice, columns) : 1, values, series);
    if (is_rate) make_spin_of_rate(file, choice, columns, series);
    describe(series);
    note_slow_camera(series);
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

bool MeasuredSeries::is_film() const {
    if (even) return true;
    constexpr double nearly = 0.01, jitter = 0.1;  // of the median
    std::vector<double> steps;
    for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
    const double median = steps[steps.size() / 2];
    const auto within = [&](double share) {
        return static_cast<double>(std::count_if(
            steps.begin(), steps.end(), [&](double step) { return std::abs(step - median) <= share * median; }));
    };
    const double count = static_cast<double>(steps.size());
    return within(nearly) >= 0.9 * count && within(jitter) >= 0.99 * count;
}

std::string notes_in_lines(const MeasuredSeries& series) {
    std::string lines;
    for (const std::string& note : series.notes) lines += wrapped("note: " + note, 2) + "\n";
    return lines;
}

std::string series_in_words(const MeasuredSeries& series) {
    const std::string quantity = series.quantity != as_measured ? fmt::format(" ({})", series.quantity) : "";
    const std::string gaps = series.gaps == 0 ? "no gaps"
                                              : fmt::format("{} gap{} ({} samples missing)", series.gaps,
                                                            series.gaps == 1 ? "" : "s", series.missing);
    const std::string turns =
        series.is_unwrapped()
            ? ""
            : fmt::format(", turns of up to {:.3g} of half a period: their direction is a guess", series.largest_turn);
    const std::string body = series.body.empty() ? "" : fmt::format("body {}, ", printable(series.body));
    return fmt::format("{}column {}{}, {} rows, {} {:.6g}, {}{}", body, series.column, quantity, series.rows,
                       series.even ? "spacing" : "mean spacing", series.spacing, gaps, turns);
}

}  // namespace swirl::apps
