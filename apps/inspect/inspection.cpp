#include "apps/inspect/inspection.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/input/column_names.hpp"
#include "apps/input/series_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace swirl::apps::inspect {

namespace {

constexpr double rigid = 0.05;  // of the mean distance: its standard deviation

/// The name by which a flag finds a column: its number where others have the same name.
std::string flag_of(const DelimitedFile& file, std::size_t column) {
    const std::string name = column_name(file, column);
    const bool unique = std::count(file.header.begin(), file.header.end(), name) == 1;
    return unique && !name.empty() ? name : fmt::format("{}", column + 1);
}

std::vector<double> numbers_or_none(const DelimitedFile& file, std::size_t column) {
    try {
        return numbers_of(file, {column}, {true})[0];
    } catch (const BadInput&) {  // words: no quantity
        return {};
    }
}

/// Two points of one rigid body: their distance stays.
bool are_rigid(const DelimitedFile& file, const PointColumns& a, const PointColumns& b) {
    const auto ax = numbers_or_none(file, a.x), ay = numbers_or_none(file, a.y);
    const auto bx = numbers_or_none(file, b.x), by = numbers_or_none(file, b.y);
    if (ax.empty() || ay.empty() || bx.empty() || by.empty()) return false;
    double sum = 0, squares = 0, count = 0;
    for (std::size_t i = 0; i < ax.size(); ++i) {
        const double distance = std::hypot(ax[i] - bx[i], ay[i] - by[i]);
        if (std::isnan(distance)) continue;
        sum += distance, squares += distance * distance, ++count;
    }
    if (count < 3) return false;
    const double mean = sum / count;
    return mean > 0 && squares / count - mean * mean <= rigid * rigid * mean * mean;
}

/// The first point, and the first that keeps its distance from it.
std::optional<std::pair<PointColumns, PointColumns>> rigid_pair(const DelimitedFile& file,
                                                                const std::vector<PointColumns>& points) {
    constexpr std::size_t most = 12;  // points that are tried
    const std::size_t count = std::min(points.size(), most);
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = a + 1; b < count; ++b)
            if (are_rigid(file, points[a], points[b])) return std::pair(points[a], points[b]);
    return std::nullopt;
}

bool is_in_degrees(const DelimitedFile& file, std::size_t column, const std::vector<double>& values) {
    const std::string unit = unit_of_column(file, column);
    if (radians_in(unit) || names_degrees(unit)) return names_degrees(unit);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : values)
        if (!std::isnan(value)) low = std::min(low, value), high = std::max(high, value);
    return high - low > more_than_turn;
}

/// Degrees that only the span tells: an angle in radians that is unwound spans as much.
bool is_guessed_in_degrees(const DelimitedFile& file, const SeriesChoice& asked, const SeriesChoice& chosen) {
    if (chosen.angle.empty() || !chosen.degrees || asked.degrees) return false;
    return !names_degrees(unit_of_column(file, column_of(file, "--angle", chosen.angle)));
}

bool says_what(const SeriesChoice& choice) {
    return choice.is_angle() || !choice.position.empty() || !choice.column.empty();
}

void choose_point(const DelimitedFile& file, const PointColumns& point, SeriesChoice& choice) {
    choice.position = {flag_of(file, point.x), flag_of(file, point.y)};
    if (!choice.origin.empty() || choice.fits_origin) return;
    const auto x = numbers_or_none(file, point.x), y = numbers_or_none(file, point.y);
    const auto around = [](const std::vector<double>& values) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const double value : values)
            if (!std::isnan(value)) low = std::min(low, value), high = std::max(high, value);
        return low <= 0 && high >= 0;
    };
    choice.fits_origin = !(around(x) && around(y));
}

/// What is analysed where no flag says it.
void choose_quantity(const DelimitedFile& file, const Inspection& found, SeriesChoice& choice) {
    if (says_what(choice) || std::any_of(file.header.begin(), file.header.end(), names_spin)) return;
    if (const auto pair = rigid_pair(file, found.points)) {
        const auto& [a, b] = *pair;
        choice.marks = {flag_of(file, a.x), flag_of(file, a.y), flag_of(file, b.x), flag_of(file, b.y)};
        return;
    }
    for (std::size_t k = 0; k < file.header.size(); ++k) {
        if (!names_angle(file.header[k])) continue;
        const auto values = numbers_or_none(file, k);
        if (values.empty()) continue;
        choice.angle = flag_of(file, k);
        choice.degrees = choice.degrees || is_in_degrees(file, k, values);
        return;
    }
    if (!found.points.empty()) choose_point(file, found.points.front(), choice);
}

/// What cannot be read is refused by read_chosen().
bool is_rate_or_refused(const DelimitedFile& file, const SeriesChoice& choice) {
    try {
        return is_rate_column(file, choice);
    } catch (const BadInput&) {
        return false;
    }
}

/// Reads what was chosen, and turns the image's axis where it seems to point down.
void read_chosen(SeriesChoice& choice, Inspection& found) {
    try {
        found.series = read_series(choice);
        found.notes = found.series->notes;
        const bool is_image = std::any_of(found.notes.begin(), found.notes.end(), [](const std::string& note) {
            return note.find("--y-down") != std::string::npos;
        });
        // The note says why. Of a column of angles nothing tells in which axes it was measured.
        if (is_image && choice.angle.empty() && choice.is_angle()) choice.y_down = true;
    } catch (const BadInput& error) {
        found.problem = error.what();
    }
}

}  // namespace

Inspection inspection_of(SeriesChoice choice, const std::string& swirl_rate) {
    if (!swirl_rate.empty()) choice.set_swirl_rate(swirl_rate);
    Inspection found;
    choice.table = found.file = choice.read();
    const SeriesColumns times = time_columns_of(*found.file, choice);
    for (std::size_t k = 0; k < found.file->columns; ++k) found.columns.push_back(column_name(*found.file, k));
    if (times.time) found.time = column_name(*found.file, *times.time);
    found.in_frames = times.in_frames && !choice.fps;
    if (choice.where.empty())
        found.bodies = bodies_in(*found.file, times.time, times.time ? times.times : std::vector<double>());
    found.points = points_in(*found.file);
    SeriesChoice one = choice;
    const std::string column = found.bodies.column ? flag_of(*found.file, *found.bodies.column) : "";
    if (!column.empty()) one.where.push_back(column + "=" + found.bodies.ids.front());
    auto rows = std::make_shared<DelimitedFile>(*found.file);
    for (const auto& text : one.where) keep_rows(*rows, condition_from(*rows, text));
    one.table = rows;
    choose_quantity(*rows, found, one);
    const bool takes_rate = !swirl_rate.empty() && (one.is_angle() || is_rate_or_refused(*rows, one));
    if (choice.symmetry == 1 && !takes_rate && !swirl_rate.empty())
        one.swirl_rate = 1, one.rate_unit = RateUnit::radians;
    read_chosen(one, found);
    if (found.series && found.time.empty() && !found.series->time.empty()) {  // once the rows are sorted by it
        found.time = found.series->time;
        found.in_frames = names_frame(found.time) && !choice.fps;
    }
    if (is_guessed_in_degrees(*rows, choice, one))
        found.notes.push_back(
            fmt::format("column {} is taken in degrees, for it spans more than a turn in radians does, and "
                        "no unit is named: of unwound radians leave --degrees out",
                        one.angle));
    if (found.in_frames) found.notes.emplace_back("times count frames: --fps F makes seconds of them");
    if (!column.empty()) {
        found.notes.push_back(fmt::format("what is said of rows and gaps is of body {}", found.bodies.ids.front()));
        one.where = choice.where;
        if (one.each.empty()) one.each = column;
    }
    if (one.is_angle() && swirl_rate.empty())
        found.notes.emplace_back("S is the rate over --swirl-rate W, 1 radian per unit of time unless given");
    found.command = fmt::format("swirl classify --series {}", in_one_word(choice.file));
    if (!one.angle.empty()) found.command += fmt::format(" --angle {}", in_one_word(one.angle));
    if (const std::string flags = one.flags(); !flags.empty()) found.command += " " + flags;
    if (takes_rate) found.command += fmt::format(" --swirl-rate {}", swirl_rate);
    return found;
}

}  // namespace swirl::apps::inspect
