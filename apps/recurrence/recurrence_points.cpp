#include "apps/recurrence/recurrence_points.hpp"

#include "apps/input/resampled_series.hpp"
#include "apps/record/record_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <utility>

namespace swirl::apps::recurrence {

namespace recurrence = analysis::recurrence;

namespace {

double positive(const char* option, const std::string& text) {
    const double value = number_from<double>(option, text);
    if (!(value > 0 && std::isfinite(value)))
        throw BadInput(fmt::format("{} = {} is outside its range: {} > 0, finite", option, text, option));
    return value;
}

/// Delay vectors of a series with gaps: those that touch one are left out, and lines end there unless gaps are joined.
recurrence::Points embed_around_gaps(const std::vector<double>& values, const RecurrenceOptions& options, double period,
                                     std::size_t& left_out) {
    const auto dimension = static_cast<std::size_t>(options.dimension);
    const std::size_t reach = (dimension - 1) * static_cast<std::size_t>(options.delay);
    std::vector<double> rows, row(dimension);
    std::vector<std::size_t> row_numbers;
    for (std::size_t i = 0; i + reach < values.size(); ++i) {
        bool whole = true;
        for (std::size_t m = 0; m < dimension; ++m) {
            row[m] = values[i + m * static_cast<std::size_t>(options.delay)];
            whole = whole && !std::isnan(row[m]);
        }
        if (!whole) {
            ++left_out;
            continue;
        }
        rows.insert(rows.end(), row.begin(), row.end());
        row_numbers.push_back(i);
    }
    if (rows.empty())
        throw BadInput(fmt::format("series: no {} samples at delay {} lie free of gaps", dimension, options.delay));
    recurrence::Points points =
        dimension == 1 ? recurrence::embed_series(rows, 1, 1, period)
                       : recurrence::section_points(rows, options.dimension, std::vector<double>(dimension, period));
    return options.join_gaps ? points : recurrence::at_rows(std::move(points), row_numbers);
}

RecurrencePoints points_of(MeasuredSeries series, const RecurrenceOptions& options) {
    if (options.observables != "S")
        throw BadInput(fmt::format("observable = '{}' is an orbit's; a series has --column", options.observables));
    RecurrencePoints result;
    std::vector<double> values = series.values;
    if (!options.resample.empty()) {
        const analysis::Resampled even = resampled(options.resample, series.times, values, result.resampled);
        values = even.series.values;
        if (even.low_pass > 0) result.notes.push_back(resampling_in_words(even));
    } else if (!series.even) {
        result.notes.push_back(
            fmt::format("the times are uneven (steps up to {:g}, mean {:g}): points follow each other "
                        "by sample, not by time; --resample DT makes them even",
                        series.largest_step, series.spacing));
    }
    const double period = options.period.empty() ? 0 : positive("period", options.period);
    const bool gaps = std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
    if (gaps) {
        result.points = embed_around_gaps(values, options, period, result.left_out);
        std::erase_if(values, [](double v) { return std::isnan(v); });
        result.observed = recurrence::embed_series(values, 1, 1, period);
        result.notes.push_back(fmt::format("{} points touch a gap and are left out; {}", result.left_out,
                                           options.join_gaps
                                               ? "lines count the points on either side of one as neighbours"
                                               : "lines and recurrence times end there (--join-gaps: they go on)"));
    } else {
        result.points = recurrence::embed_series(values, options.dimension, options.delay, period);
    }
    result.series = std::move(series);
    return result;
}

RecurrencePoints points_of(OrbitColumns orbit, const RecurrenceOptions& options) {
    for (const auto& [given, flag] :
         {std::pair(!options.resample.empty(), "resample"), std::pair(!options.period.empty(), "period"),
          std::pair(options.join_gaps, "join-gaps")})
        if (given) throw BadInput(fmt::format("--{} is a measured series'; an orbit's points are its impacts", flag));
    const std::size_t names = orbit.names.size();
    if (names > 1 && options.dimension > 1)
        throw BadInput(fmt::format("dimension = {} embeds one observable; {} are given", options.dimension, names));
    RecurrencePoints result;
    const std::size_t count = orbit.values.front().size();
    const std::size_t reach = static_cast<std::size_t>(options.dimension - 1) * static_cast<std::size_t>(options.delay);
    if (orbit.every > 1)
        result.notes.push_back(
            fmt::format("the record lists every {}th impact: points follow each other by row", orbit.every));
    result.enough = count >= reach + 2;
    const bool cut = orbit.outcome != "completed";
    if (!result.enough && !cut)
        throw BadInput(fmt::format("orbit of {} impacts: dimension {} and delay {} need {} or more", count,
                                   options.dimension, options.delay, reach + 2));
    if (result.enough && names == 1) {
        result.points =
            recurrence::embed_series(orbit.values[0], options.dimension, options.delay, period_of(orbit.names[0]));
    } else if (result.enough) {
        std::vector<double> rows(count * names), periods(names);
        for (std::size_t m = 0; m < names; ++m) {
            periods[m] = period_of(orbit.names[m]);
            for (std::size_t i = 0; i < count; ++i) rows[i * names + m] = orbit.values[m][i];
        }
        result.points = recurrence::section_points(rows, static_cast<int>(names), periods);
    }
    result.orbit = std::move(orbit);
    return result;
}

std::vector<double> numbers_in(const char* option, const std::vector<std::string>& texts) {
    std::vector<double> numbers;
    for (const auto& text : texts)
        for (const double number : numbers_from<double>(option, text, values_in(text))) numbers.push_back(number);
    return numbers;
}

/// Distances below this are rounding: an orbit at a fixed point scatters by some units of ε times its own scale. Of
/// zeros alone it is not 0, which with < nothing is below.
double rounding_floor(const recurrence::Points& points) {
    double largest = 0;
    for (const double v : points.values) largest = std::max(largest, std::abs(v));
    return std::max(1e-12 * largest, std::numeric_limits<double>::min());
}

}  // namespace

std::optional<Units> units_of(const RecurrencePoints& points) {
    return points.orbit ? units_of(*points.orbit) : std::nullopt;
}

std::string unit_of(const RecurrencePoints& points) {
    return points.orbit ? unit_of_observables(points.orbit->names) : "1";
}

std::size_t values_in(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), ',')) + 1;
}

std::vector<std::string> observables_of(const std::string& text) {
    std::vector<std::string> names = pieces_of(text, ',');
    if (std::find(names.begin(), names.end(), "") != names.end())
        throw BadInput(fmt::format("observable = '{}' has an empty name", text));
    return names;
}

RecurrencePoints main_points(RecurrenceOptions& options) {
    if (options.input.kind() == InputKind::series) return points_of(options.input.measured(), options);
    return points_of(options.input.orbit(options.output, observables_of(options.observables)), options);
}

std::optional<RecurrencePoints> cross_points(const RecurrenceOptions& options) {
    if (options.cross.empty() && options.cross_column.empty()) return std::nullopt;
    if (!options.cross.empty() && is_hdf5_file(options.cross)) {
        if (!options.cross_column.empty()) throw BadInput("--cross-column is a series'; --cross names a record");
        return points_of(
            read_orbit(options.cross, {options.input.transient.value_or(0), -1}, observables_of(options.observables)),
            options);
    }
    InputOptions second = options.input;
    if (!options.cross.empty()) second.series.file = options.cross;
    if (second.series.file.empty()) throw BadInput("--cross-column needs --series FILE or --cross FILE");
    if (!options.cross_column.empty()) second.series.column = options.cross_column;
    RecurrenceOptions plain;
    plain.dimension = options.dimension;
    plain.delay = options.delay;
    plain.period = options.period;
    plain.join_gaps = options.join_gaps && options.input.kind() == InputKind::series;
    plain.resample = options.input.kind() == InputKind::series ? options.resample : "";
    return points_of(second.measured(), plain);
}

Thresholds thresholds_of(const RecurrenceOptions& options, const RecurrencePoints& points, bool cross,
                         const recurrence::Settings& settings) {
    Thresholds thresholds;
    int kinds = 0;
    const auto take = [&](const char* option, const char* kind, const std::vector<std::string>& texts) {
        if (texts.empty()) return;
        if (++kinds > 1) throw BadInput("of --threshold, --threshold-std and --recurrence-rate only one can be given");
        thresholds.kind = kind;
        thresholds.given = numbers_in(option, texts);
        const bool rate = thresholds.kind == "recurrence_rate";
        for (const double value : thresholds.given)
            if (!(std::isfinite(value) && value >= 0 && (!rate || (value > 0 && value <= 1))))
                throw BadInput(fmt::format("{} = {:g} is outside its range: {}", option, value,
                                           rate ? "0 < recurrence-rate <= 1" : "0 or more, finite"));
    };
    take("threshold", "threshold", options.thresholds);
    take("threshold-std", "threshold_std", options.thresholds_std);
    take("recurrence-rate", "recurrence_rate", options.rates);
    if (kinds == 0) {
        thresholds.kind = "threshold_std";
        thresholds.given = {0.1};
    }
    if (!points.enough) return thresholds;
    if (thresholds.kind == "threshold_std") {
        const double floor = rounding_floor(points.points);
        const auto deviations = [&](double factor) {
            return recurrence::threshold_of_deviation(points.observed ? *points.observed : points.points, factor,
                                                      options.conventions.deviation());
        };
        thresholds.floored = deviations(1) <= floor;
        for (const double factor : thresholds.given)
            thresholds.delta.push_back(thresholds.floored ? floor : deviations(factor));
        return thresholds;
    }
    if (thresholds.kind == "recurrence_rate" && cross)
        throw BadInput("recurrence-rate sets the threshold of one trajectory; a cross recurrence takes --threshold");
    for (const double value : thresholds.given)
        thresholds.delta.push_back(thresholds.kind == "threshold"
                                       ? without_units(value, units_of(points), unit_of(points))
                                       : recurrence::threshold_of_rate(points.points, value, settings));
    return thresholds;
}

}  // namespace swirl::apps::recurrence
