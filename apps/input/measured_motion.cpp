#include "apps/input/measured_motion.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/numbers.hpp"
#include "map/model/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace swirl::apps {

namespace {

using Columns = std::vector<std::vector<double>>;

constexpr double unsure = 0.6;         // the likelihood below which DeepLabCut itself leaves points out (pcutoff)
constexpr double fewest_pixels = 100;  // an image that is smaller has no dish on it

void require_not_too_large(const DelimitedFile& file, const std::vector<double>& column, const std::string& name) {
    for (std::size_t i = 0; i < column.size(); ++i)
        if (std::abs(column[i]) > detail::largest_magnitude)
            throw BadInput(at_line(file, i,
                                   fmt::format("{:g} in column {} is outside its range: -{:g} to {:g}", column[i], name,
                                               detail::largest_magnitude, detail::largest_magnitude)));
}

std::vector<double> numbers_in_column(const DelimitedFile& file, std::size_t column) {
    return numbers_of(file, {column}, {true})[0];
}

/// The column that says how sure the tracker is of this one.
std::optional<std::size_t> likelihood_of_column(const DelimitedFile& file, std::size_t column) {
    std::optional<std::size_t> only;
    std::size_t count = 0;
    for (std::size_t k = 0; k < file.header.size(); ++k)
        if (names_likelihood(file.header[k])) only = k, ++count;
    for (const PointColumns& point : points_in(file))
        if (point.x == column || point.y == column) return point.likelihood;
    return count == 1 ? only : std::nullopt;
}

/// Makes gaps of what its tracker is unsure of, or notes that there is such.
void mask(const DelimitedFile& file, const SeriesChoice& choice, const SeriesColumns& columns, Columns& values,
          MeasuredSeries& series) {
    bool any = false;
    std::optional<std::size_t> noted;
    for (std::size_t k = 0; k < columns.values.size(); ++k) {
        const auto likelihood = likelihood_of_column(file, columns.values[k]);
        if (!likelihood) continue;
        any = true;
        const std::vector<double> sure = numbers_in_column(file, *likelihood);
        const double least = choice.likelihood.value_or(unsure);
        std::size_t below = 0;
        for (std::size_t i = 0; i < sure.size(); ++i) {
            if (!(sure[i] < least)) continue;
            ++below;
            if (choice.likelihood) values[k][i] = std::nan("");
        }
        if (choice.likelihood || below == 0 || noted == likelihood) continue;
        noted = likelihood;
        series.notes.push_back(fmt::format("{} of {} rows have a {} below {}: --likelihood {} makes gaps of them",
                                           below, sure.size(), column_name(file, *likelihood), unsure, unsure));
    }
    if (choice.likelihood && !any)
        throw BadInput(fmt::format("likelihood = {}: '{}' has no column of likelihoods for column {}",
                                   *choice.likelihood, file.name, series.column));
}

struct Box {
    double x_low = INFINITY, x_high = -INFINITY, y_low = INFINITY, y_high = -INFINITY;
    bool holds(double x, double y) const { return x_low <= x && x <= x_high && y_low <= y && y <= y_high; }
};

Box box_of(const std::vector<double>& x, const std::vector<double>& y) {
    Box box;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (std::isnan(x[i]) || std::isnan(y[i])) continue;
        box.x_low = std::min(box.x_low, x[i]), box.x_high = std::max(box.x_high, x[i]);
        box.y_low = std::min(box.y_low, y[i]), box.y_high = std::max(box.y_high, y[i]);
    }
    return box;
}

/// Pixels count from a corner of the image, and their y points down.
bool are_pixels(const DelimitedFile& file, std::size_t x, const Box& box) {
    const std::string unit = unit_of_column(file, x);
    if (unit == "px" || unit == "pixel" || unit == "pixels") return true;
    return unit.empty() && box.x_low >= 0 && box.y_low >= 0 && std::max(box.x_high, box.y_high) >= fewest_pixels;
}

/// Of what turns: is it seen from above, or in an image whose y points down?
void note_pixels(const DelimitedFile& file, const SeriesChoice& choice, const SeriesColumns& columns,
                 const Columns& raw, MeasuredSeries& series) {
    if (choice.y_down || choice.shows_down) return;
    std::size_t x = 0;
    Box box;
    if (raw.size() > 1) {
        x = columns.values[0];
        box = box_of(raw[0], raw[1]);
    } else {
        const bool turns = choice.is_angle() || names_spin(column_name(file, columns.values[0]));
        const auto points = turns ? points_in(file) : std::vector<PointColumns>();
        if (points.empty()) return;
        x = points.front().x;
        try {
            box = box_of(numbers_in_column(file, x), numbers_in_column(file, points.front().y));
        } catch (const BadInput&) {  // columns that are not analysed may hold anything
            return;
        }
    }
    if (!are_pixels(file, x, box)) return;
    const char* const what =
        raw.size() > 1 ? "--y-down changes the sign of turns"
                       : "if turns were measured in these axes (TrackMate, TRex, Bonsai), --y-down changes their sign; "
                         "those of ImageJ and scikit-image (OCTRON) count counter-clockwise as they are";
    series.notes.push_back(
        fmt::format("column {} is likely to be of pixels, whose y points down: {}", column_name(file, x), what));
}

/// Places given as y and x, as their names say.
void note_exchanged(const DelimitedFile& file, const SeriesColumns& columns, MeasuredSeries& series) {
    for (std::size_t k = 0; k + 1 < columns.values.size(); k += 2)
        for (const PointColumns& point : points_in(file))
            if (point.x == columns.values[k + 1] && point.y == columns.values[k])
                series.notes.push_back(
                    fmt::format("columns {} and {} are taken as x and y, in this order: turns are seen "
                                "the other way round",
                                column_name(file, point.y), column_name(file, point.x)));
}

std::array<double, 2> origin_of(const SeriesChoice& choice, const Columns& points, MeasuredSeries& series) {
    if (choice.fits_origin) {
        const FittedCircle circle = fitted_circle(points[0], points[1]);
        series.notes.push_back(
            fmt::format("origin ({:.6g}, {:.6g}) is the centre of the circle fitted, of radius {:.6g}; the points lie "
                        "{:.2g} of it away "
                        "from it{}",
                        circle.centre[0], circle.centre[1], circle.radius, circle.residual / circle.radius,
                        circle.residual > 0.1 * circle.radius ? ": they are no circle, --origin X Y is surer" : ""));
        return circle.centre;
    }
    if (!choice.origin.empty())
        return {number_from<double>("origin", choice.origin[0]), number_from<double>("origin", choice.origin[1])};
    if (!box_of(points[0], points[1]).holds(0, 0))
        series.notes.emplace_back(
            "(0, 0), from where positions are taken, lies outside of them: --origin X Y or --fit-origin gives another");
    return {0, 0};
}

/// Two marks of one body keep their distance, up to what is measured wrong.
void require_one_body(const Columns& c, MeasuredSeries& series) {
    constexpr double rigid = 0.2;  // a body's 5th and 95th percentile differ by some noise of its marks
    std::vector<double> distances;
    for (std::size_t i = 0; i < c[0].size(); ++i)
        if (const double d = std::hypot(c[2][i] - c[0][i], c[3][i] - c[1][i]); !std::isnan(d)) distances.push_back(d);
    if (distances.empty()) return;
    std::sort(distances.begin(), distances.end());
    const double low = distances[distances.size() / 20], high = distances[distances.size() - 1 - distances.size() / 20];
    if (high == 0) throw BadInput("marks: both marks are at one place in most rows; two places of the body are needed");
    if (high - low > rigid * high)
        series.notes.push_back(fmt::format(
            "the marks' distance is {:.3g} to {:.3g} (5 and 95 % of the rows): two marks of one body keep theirs", low,
            high));
}

/// The direction from x1, y1 to x2, y2, and how far rounding may have moved it: by half of the last digit of each
/// coordinate, across the line, at either end, so that all lie within 2 √2 digits over the mean distance.
std::vector<double> angle_of_line(const Columns& c, double digit, MeasuredSeries& series) {
    std::vector<double> angle(c[0].size());
    double sum = 0, count = 0;
    std::size_t at_one_place = 0;
    for (std::size_t i = 0; i < angle.size(); ++i) {
        const double x = c[2][i] - c[0][i], y = c[3][i] - c[1][i];
        const bool has_direction = x != 0 || y != 0;
        angle[i] = has_direction ? std::atan2(y, x) : std::nan("");
        if (!has_direction) ++at_one_place;
        if (!std::isnan(angle[i])) sum += std::hypot(x, y), ++count;
    }
    if (at_one_place > 0)
        series.notes.push_back(fmt::format("in {} row{} both points are at one place, and have no direction: gaps",
                                           at_one_place, at_one_place == 1 ? "" : "s"));
    if (sum > 0) series.angle.resolution = 2 * std::sqrt(2.0) * digit * count / sum;
    return angle;
}

/// The last digit of coordinates, the coarsest of the columns.
double digit_of(const Columns& columns) {
    double digit = 0;
    for (const auto& column : columns) digit = std::max(digit, decimal_resolution(column));
    return digit;
}

}  // namespace

FittedCircle fitted_circle(const std::vector<double>& x, const std::vector<double>& y) {
    double mean_x = 0, mean_y = 0, count = 0;
    const auto each = [&](const auto& use) {
        for (std::size_t i = 0; i < x.size(); ++i)
            if (!std::isnan(x[i]) && !std::isnan(y[i])) use(x[i] - mean_x, y[i] - mean_y);
    };
    double sum_x = 0, sum_y = 0;
    each([&](double u, double v) { sum_x += u, sum_y += v, ++count; });
    if (count < 3) throw BadInput(fmt::format("fit-origin: {} points make no circle; 3 or more are needed", count));
    mean_x = sum_x / count;
    mean_y = sum_y / count;
    double uu = 0, uv = 0, vv = 0, uz = 0, vz = 0, z = 0;
    each([&](double u, double v) {
        const double square = u * u + v * v;
        uu += u * u, uv += u * v, vv += v * v, uz += u * square, vz += v * square, z += square;
    });
    const double determinant = uu * vv - uv * uv;
    if (!(determinant > 1e-9 * z * z)) throw BadInput("fit-origin: the points lie on a line, and make no circle");
    const double u0 = (uz * vv - vz * uv) / (2 * determinant), v0 = (vz * uu - uz * uv) / (2 * determinant);
    FittedCircle circle;
    circle.centre = {mean_x + u0, mean_y + v0};
    circle.radius = std::sqrt(u0 * u0 + v0 * v0 + z / count);
    double squares = 0;
    each([&](double u, double v) { squares += std::pow(std::hypot(u - u0, v - v0) - circle.radius, 2); });
    circle.residual = std::sqrt(squares / count);
    return circle;
}

std::vector<std::vector<double>> values_of_motion(const DelimitedFile& file, const SeriesChoice& choice,
                                                  const SeriesColumns& columns, MeasuredSeries& series) {
    Columns values = numbers_of(file, columns.values, std::vector<bool>(columns.values.size(), true));
    for (std::size_t k = 0; k < values.size(); ++k)
        require_not_too_large(file, values[k], column_name(file, columns.values[k]));
    mask(file, choice, columns, values, series);
    note_pixels(file, choice, columns, values, series);
    note_exchanged(file, columns, series);
    const double digit = choice.is_angle() ? digit_of(values) : 0;
    if (!choice.marks.empty()) {
        require_one_body(values, series);
        return {angle_of_line(values, digit, series)};
    }
    if (values.size() == 2) {
        series.origin = origin_of(choice, values, series);
        for (std::size_t k = 0; k < 2; ++k)
            for (double& value : values[k]) value -= series.origin[k];
    }
    if (!choice.mark.empty()) {
        const std::vector<double> zeros(values[0].size(), 0.0);
        return {angle_of_line({zeros, zeros, values[0], values[1]}, digit, series)};
    }
    const bool is_mirrored = !choice.is_angle() && choice.position.empty() && choice.y_down;  // a column of spins
    if (is_mirrored && !names_spin(column_name(file, columns.values[0])) && !turning_rate_of(file, columns.values[0]))
        throw BadInput(
            fmt::format("y-down: it is of what turns: an angle, marks, S, or a rate of turn; column {} is "
                        "none of these",
                        series.column));
    if (choice.scale != 1 || is_mirrored)
        for (auto& column : values)
            for (double& value : column) value *= is_mirrored ? -choice.scale : choice.scale;
    return values;
}

}  // namespace swirl::apps
