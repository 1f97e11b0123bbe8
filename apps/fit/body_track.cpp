#include "apps/fit/body_track.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/input/bodies.hpp"
#include "apps/input/measured_motion.hpp"
#include "apps/input/series_columns.hpp"
#include "apps/input/series_of_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>

namespace swirl::apps::fit {

namespace {

/// The table, of which --where leaves some rows.
std::shared_ptr<const DelimitedFile> rows_of(const SeriesChoice& series) {
    auto rows = std::make_shared<DelimitedFile>(*series.read());
    for (const std::string& text : series.where) keep_rows(*rows, condition_from(*rows, text));
    return rows;
}

/// x and y of the rows, lost ones put in, from the origin that was given; those of the angle's rows, of which ends
/// without values are cut off.
std::vector<std::vector<double>> places_of(const SeriesChoice& choice, const MeasuredAngle& angle, BodyTrack& track) {
    MeasuredSeries read;
    const DelimitedFile& file = *choice.table;
    SeriesColumns columns = columns_of(file, choice);
    auto places = values_of_motion(file, choice, columns, read);
    track.zero = read.origin;
    fill_lost_rows(columns.times, places, LongSteps::lost_rows);
    track.notes.insert(track.notes.end(), read.notes.begin(), read.notes.end());
    const auto& times = columns.times;
    const auto distance = [&](double time) { return std::abs(time - angle.times.front()); };
    const auto nearest =
        std::min_element(times.begin(), times.end(), [&](double a, double b) { return distance(a) < distance(b); });
    const auto first = nearest - times.begin(), count = static_cast<std::ptrdiff_t>(angle.times.size());
    if (first + count > static_cast<std::ptrdiff_t>(times.size()))
        throw BadInput(fmt::format("series '{}': places and angles are not of the same rows", file.name));
    for (auto& column : places) column = std::vector<double>(column.begin() + first, column.begin() + first + count);
    return places;
}

}  // namespace

Eigen::Vector3d BodyTrack::rounding_noise(double length) const {
    const double uniform = 1 / std::sqrt(12.0);  // standard deviation, of a step
    const double place = uniform * step / length;
    // Of marks it is half of the farthest that four coordinates move the angle, √2 steps over their distance.
    return {place, place, uniform * turns.angle.resolution / (of_marks ? 2 : 1)};
}

void require_body(const SeriesChoice& series, const std::string& angle) {
    if (!(series.scale > 0 && std::isfinite(series.scale)))
        throw BadInput(fmt::format("scale = {:g} is outside its range: scale > 0, finite", series.scale));
    if (!series.column.empty()) throw BadInput("--column: a film is of --position and --angle or --marks");
    if (!series.mark.empty())
        throw BadInput("--mark: its direction from the origin is not the body's angle; give --angle or --marks");
    if (!series.each.empty()) throw BadInput("--each: fit takes one body; choose it by --where COLUMN=VALUE");
    if (series.rows == "impacts") throw BadInput("--rows impacts: a film has a row a frame");
    if (angle.empty() == series.marks.empty())
        throw BadInput(angle.empty() ? "the angle is missing: --angle COLUMN, or --marks X1 Y1 X2 Y2"
                                     : "--angle and --marks are both given; give one");
    if (series.position.empty() && series.marks.empty())
        throw BadInput("places are missing: --position X Y, the columns of the body's centre");
}

BodyTrack read_track(const SeriesChoice& series, const std::string& angle, const std::string& swirl_rate) {
    SeriesChoice turning = series;
    turning.table = rows_of(series);
    turning.where.clear();
    SeriesChoice moving = turning;
    turning.angle = angle;
    turning.position.clear(), turning.origin.clear();
    turning.fits_origin = false, turning.scale = 1;
    turning.set_swirl_rate(swirl_rate);
    if (moving.position.empty()) moving.position = {moving.marks[0], moving.marks[1]};
    moving.marks.clear();
    moving.symmetry = 1, moving.degrees = false;
    moving.check();
    moving.scale = 1;
    if (moving.origin.empty()) moving.origin = {"0", "0"};
    moving.fits_origin = false;
    BodyTrack track;
    track.turns = read_series(turning);
    track.places = places_of(moving, track.turns.angle, track);
    track.step = std::max(rounding_step(track.places[0]), rounding_step(track.places[1]));
    track.of_marks = !turning.marks.empty();
    std::vector<std::string> notes = track.turns.notes;
    add_notes(notes, track.notes);
    track.notes = notes;
    return track;
}

void add_notes(std::vector<std::string>& notes, const std::vector<std::string>& others) {
    for (const std::string& note : others)
        if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

}  // namespace swirl::apps::fit
