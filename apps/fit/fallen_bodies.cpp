#include "apps/fit/fallen_bodies.hpp"

#include "analysis/fits/robust.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/fit/body_track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace swirl::apps::fit {

namespace {

double length_from(const char* name, const std::string& text) {
    const double length = number_from<double>(name, text);
    constexpr double least = 1e-75, most = 1e75;
    if (!(length >= least && length <= most))
        throw BadInput(fmt::format("{} = {} is outside its range: {:g} to {:g}", name, text, least, most));
    return length;
}

void require_no_dish(const FilmOptions& film) {
    for (const char* name : {"alpha", "beta", "swirl-rate", "container-radius", "swirl-radius"})
        if (film.shape.count(name) != 0)
            throw BadInput(
                fmt::format("--{} is a dish's; of falls --side or --polygon-radius is the body's size", name));
    if (!film.floor.empty()) throw BadInput("--floor is a dish's; a plate that bodies fall on drags nothing");
    if (!film.series.origin.empty() || film.series.fits_origin)
        throw BadInput("--origin and --fit-origin are a dish's; of falls places alone count");
}

studies::FallenBody body_of(const FilmOptions& film, const FallsOptions& falls) {
    const auto given = [&](const char* name) { return film.shape.count(name) != 0; };
    if (!given("sides")) throw BadInput("--sides is missing: of the body, 3 or more, or disk");
    SceneOptions any;  // whose shape is checked as a scene's
    any.set("sides", film.shape.at("sides"));
    for (const auto& [name, text] : {std::pair{"alpha", "0.5"}, {"beta", "0.5"}, {"mu", "0"}, {"restitution", "1"}})
        any.set(name, text);
    if (given("inertia-factor")) any.set("inertia-factor", film.shape.at("inertia-factor"));
    const Scene<double> scene = any.scene<double>();
    studies::FallenBody body;
    body.sides = scene.sides;
    if (falls.side.empty() != given("polygon-radius"))
        throw BadInput(falls.side.empty() ? "the body's size is missing: --side L, or --polygon-radius R"
                                          : "--side and --polygon-radius are both given; give one");
    if (scene.is_disk() && !falls.side.empty()) throw BadInput("--side: a disk has none; give --polygon-radius R");
    body.radius = given("polygon-radius")
                      ? length_from("polygon-radius", film.shape.at("polygon-radius"))
                      : length_from("side", falls.side) / (2 * std::sin(std::numbers::pi / scene.sides));
    body.inertia = scene.inertia_factor * body.radius * body.radius;
    body.inertia_known = given("inertia-factor");
    if (!film.vertex.empty()) {
        body.mark = number_from<double>("vertex", film.vertex);
        if (!std::isfinite(*body.mark))
            throw BadInput(fmt::format("vertex = {} is outside its range: any finite number", film.vertex));
    }
    return body;
}

/// Median step of the times.
double step_of(const std::vector<analysis::FilmFrame>& fall) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < fall.size(); ++i) steps.push_back(fall[i].time - fall[i - 1].time);
    return analysis::quantile(std::move(steps), 0.5);
}

/// One of several files: what is wrong in it names it.
BodyTrack track_in(const SeriesChoice& series, const std::string& angle) {
    try {
        return read_track(series, angle, "1");
    } catch (const BadInput& wrong) {
        const std::string what = wrong.what();
        if (what.find(series.file) != std::string::npos) throw;
        throw BadInput(fmt::format("falls '{}': {}", series.file, what));
    }
}

std::vector<analysis::FilmFrame> frames_of(const BodyTrack& track, double scale) {
    std::vector<analysis::FilmFrame> frames;
    const std::vector<double>& times = track.turns.angle.times;
    for (std::size_t i = 0; i < times.size(); ++i) {
        analysis::FilmFrame frame;
        frame.time = times[i] - times.front();
        frame.place << scale * track.places[0][i], scale * track.mirror() * track.places[1][i],
            track.turns.angle.values[i];
        frames.push_back(frame);
    }
    return frames;
}

using Row = std::array<double, 3>;

/// Rows that a fall has, each once, without the lost ones; times apart, of which each fall has its own 0.
std::vector<Row> distinct_rows(const std::vector<analysis::FilmFrame>& fall) {
    std::vector<Row> rows;
    for (const analysis::FilmFrame& frame : fall)
        if (frame.place.allFinite()) rows.push_back({frame.place[0], frame.place[1], frame.place[2]});
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

/// Two films of one fall, written with other digits, from another origin or with other whole turns: what is between
/// them is the same in all rows, to half a hundredth of how far the body moves, which no launcher repeats through
/// impacts.
bool are_one_motion(const std::vector<analysis::FilmFrame>& a, const std::vector<analysis::FilmFrame>& b) {
    constexpr double alike = 5e-3;
    if (a.size() != b.size()) return false;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        double low = analysis::infinity, high = -low, least = analysis::infinity, most = -least;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const double place = a[i].place[axis], apart = b[i].place[axis] - place;
            if (std::isnan(apart)) continue;
            low = std::min(low, place), high = std::max(high, place);
            least = std::min(least, apart), most = std::max(most, apart);
        }
        if (!(most - least <= alike * (high - low))) return false;
    }
    return true;
}

/// A fall that is counted twice makes intervals too short; some rows are alike by chance where digits are few.
/// O(files × rows).
void require_no_fall_twice(const std::vector<std::string>& files,
                           const std::vector<std::vector<analysis::FilmFrame>>& falls) {
    constexpr std::size_t by_chance = 3, tenth = 10;
    std::vector<std::vector<Row>> rows;
    rows.reserve(falls.size());
    for (const auto& fall : falls) rows.push_back(distinct_rows(fall));
    for (std::size_t i = 0; i < falls.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (files[i] == files[j])
                throw BadInput(fmt::format("falls '{}' is given twice; each fall counts once", files[i]));
            std::vector<Row> common;
            std::set_intersection(rows[i].begin(), rows[i].end(), rows[j].begin(), rows[j].end(),
                                  std::back_inserter(common));
            const std::size_t fewer = std::min(rows[i].size(), rows[j].size());
            if (common.size() > std::max(by_chance, fewer / tenth))
                throw BadInput(fmt::format("falls '{}' and '{}' have {} rows in common; each fall counts once",
                                           files[j], files[i], common.size()));
            if (are_one_motion(falls[i], falls[j]))
                throw BadInput(fmt::format("falls '{}' and '{}' are one motion, row by row; each fall counts once",
                                           files[j], files[i]));
        }
}

void require_alike(const std::vector<std::string>& files, const FallenBodies& read) {
    const auto other = studies::other_fall(read.falls, read.period, read.body, read.setting);
    if (!other) return;
    throw BadInput(fmt::format(
        "falls '{}' fall by {:.3g} along -y per time squared, those of the other files in the median by {:.3g}: its "
        "lengths, clock or axes are not theirs",
        files[other->number], other->gravity, other->usual));
}

}  // namespace

void FallsOptions::add_to(Flags& command) {
    Flags falls = command.under("Falls on a plate");
    falls.add_option("--falls", files, "FILE",
                     "films of a body that falls on a straight plate, a file each; read as --series is");
    falls.add_option("--side", side, "L", "of the body, in the table's lengths times --scale; or --polygon-radius");
    falls.add_option("--gravity", gravity, "G",
                     "along -y, in those lengths per time squared (default: what free arcs tell)");
}

void FallsOptions::require_none() const {
    for (const auto& [name, text] : {std::pair{"side", side}, {"gravity", gravity}})
        if (!text.empty()) throw BadInput(fmt::format("--{} is of falls; give --falls FILE...", name));
}

FallenBodies read_falls(FilmOptions& film, const FallsOptions& options) {
    std::erase_if(film.shape, [](const auto& flag) { return flag.second.empty(); });
    require_no_dish(film);
    require_body(film.series, film.angle);
    FallenBodies read;
    read.y_down = film.series.y_down;
    read.body = body_of(film, options);
    if (!options.gravity.empty()) read.setting.gravity = length_from("gravity", options.gravity);
    double shortest = analysis::infinity, longest = 0;
    for (const std::string& file : options.files) {
        SeriesChoice series = film.series;
        series.file = file;
        series.shows_down = true;
        const BodyTrack track = track_in(series, film.angle);
        read.falls.push_back(frames_of(track, series.scale));
        if (read.falls.back().size() < analysis::fewest_frames)
            throw BadInput(fmt::format("falls '{}': {} frames, {} or more are needed", file, read.falls.back().size(),
                                       analysis::fewest_frames));
        read.setting.least_noise = read.setting.least_noise.cwiseMax(track.rounding_noise(1 / series.scale));
        read.period = track.turns.angle.period;
        read.rows += track.turns.rows;
        shortest = std::min(shortest, step_of(read.falls.back()));
        longest = std::max(longest, step_of(read.falls.back()));
        add_notes(read.notes, track.notes);
    }
    require_no_fall_twice(options.files, read.falls);
    constexpr double alike = 3.5;  // longer steps are gaps, where no arc goes on
    if (!(longest < alike * shortest))
        throw BadInput(
            fmt::format("falls are {:g} to {:g} of time from frame to frame; those of one fit are to be less "
                        "than {} times apart",
                        shortest, longest, alike));
    require_alike(options.files, read);
    return read;
}

}  // namespace swirl::apps::fit
