#include "apps/fit/dish_film.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/input/bodies.hpp"
#include "apps/input/measured_motion.hpp"
#include "apps/input/measured_series.hpp"
#include "apps/input/series_columns.hpp"
#include "apps/input/series_of_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace swirl::apps::fit {

namespace {

struct ShapeFlag {
    const char *name, *type, *help;
};

constexpr ShapeFlag shape_flags[] = {
    {"sides", "N", "of the body: 3 or more, or disk"},
    {"alpha", "A", "R_p/R_c, body over container; or --polygon-radius and --container-radius"},
    {"beta", "B", "r_s/R_c, circle of the swirl over container; or --swirl-radius and --container-radius"},
    {"inertia-factor", "K", "kappa, I = kappa m R_p^2 (default: the uniform lamina's)"},
    {"swirl-rate", "W", "omega_s: radians per unit of time, or as 33rpm, 0.5Hz; < 0: clockwise"},
    {"container-radius", "R", "R_c in the table's lengths times --scale (default 1)"},
    {"swirl-radius", "R", "r_s, instead of --beta"},
    {"polygon-radius", "R", "R_p, instead of --alpha"},
};

void require_usable(const SeriesChoice& series, const std::string& angle) {
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

/// The table, of which --where leaves some rows.
std::shared_ptr<const DelimitedFile> rows_of(const SeriesChoice& series) {
    auto rows = std::make_shared<DelimitedFile>(*series.read());
    for (const std::string& text : series.where) keep_rows(*rows, condition_from(*rows, text));
    return rows;
}

/// x and y of the rows, lost ones put in, from the origin that was given; those of the angle's rows, of which ends
/// without values are cut off.
std::vector<std::vector<double>> places_of(const SeriesChoice& choice, const MeasuredAngle& angle, DishFilm& film) {
    MeasuredSeries read;
    const DelimitedFile& file = *choice.table;
    SeriesColumns columns = columns_of(file, choice);
    auto places = values_of_motion(file, choice, columns, read);
    film.zero = {read.origin[0], read.origin[1]};
    fill_lost_rows(columns.times, places, LongSteps::lost_rows);
    film.notes.insert(film.notes.end(), read.notes.begin(), read.notes.end());
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

/// Standard deviation of x, y and θ by the rounding of what was written, each part of a step being as likely.
Eigen::Vector3d noise_of_rounding(const std::vector<std::vector<double>>& places, const MeasuredSeries& turns,
                                  bool of_marks, double length) {
    const double uniform = 1 / std::sqrt(12.0);  // standard deviation, of a step
    const double place = uniform * std::max(rounding_step(places[0]), rounding_step(places[1])) / length;
    // Of marks it is half of the farthest that four coordinates move the angle, √2 steps over their distance.
    return {place, place, uniform * turns.angle.resolution / (of_marks ? 2 : 1)};
}

void take_shape(const FilmOptions& options, DishFilm& film) {
    const auto given = [&](const char* name) { return options.shape.count(name) != 0; };
    if (!given("sides")) throw BadInput("--sides is missing: of the body, 3 or more, or disk");
    if (!given("container-radius") && (given("swirl-radius") || given("polygon-radius")))
        throw BadInput("--container-radius is missing: R_c, of which --swirl-radius and --polygon-radius are parts");
    SceneOptions scene;
    for (const auto& [name, text] : options.shape)
        if (name != "swirl-rate") scene.set(name, text);
    scene.set("mu", "0");  // what is looked for
    scene.set("restitution", "1");
    const Scene<double> found = scene.scene<double>();
    film.scene = {found.sides, found.alpha, found.beta, found.inertia_factor * found.alpha * found.alpha, {}};
    film.inertia_factor = found.inertia_factor;
    film.length = scene.units().value_or(Units{}).length / options.series.scale;
    if (options.vertex.empty()) return;
    film.scene.mark = number_from<double>("vertex", options.vertex);
    if (!std::isfinite(*film.scene.mark))
        throw BadInput(fmt::format("vertex = {} is outside its range: any finite number", options.vertex));
}

void add_notes(std::vector<std::string>& notes, const std::vector<std::string>& others) {
    for (const std::string& note : others)
        if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

}  // namespace

void FilmOptions::add_to(Flags& command) {
    series.add_to(command, true);
    command.add_option("--angle", angle, "NAME", "a column of the body's angle; --degrees, --symmetry as of classify")
        ->group("Input");
    for (const ShapeFlag& flag : shape_flags)
        command.add_option(fmt::format("--{}", flag.name), shape[flag.name], flag.type, flag.help)
            ->group("Scene of a film");
    command
        .add_option("--vertex", vertex, "A",
                    "direction of a vertex where the film's angle is 0, in radians (default: fitted)")
        ->group("Scene of a film");
    command
        .add_option("--floor", floor, "FLOOR",
                    "that drags: dish, which moves with the wall, or table (default: the arcs tell)")
        .group("Scene of a film")
        .offer({"dish", "table"});
}

std::optional<studies::Floor> FilmOptions::known_floor() const {
    if (floor.empty()) return std::nullopt;
    for (const studies::Floor one : {studies::Floor::dish, studies::Floor::table})
        if (floor == name_of(one)) return one;
    throw BadInput(fmt::format("floor = {} is outside its range: dish, table", floor));
}

void FilmOptions::require_none() const {
    const auto of_shape =
        std::find_if(shape.begin(), shape.end(), [](const auto& flag) { return !flag.second.empty(); });
    if (of_shape != shape.end()) throw BadInput(fmt::format("--{} is a film's; give --series FILE", of_shape->first));
    for (const auto& [name, text] : {std::pair{"angle", angle}, {"vertex", vertex}, {"floor", floor}})
        if (!text.empty()) throw BadInput(fmt::format("--{} is a film's; give --series FILE", name));
    if (series.given() || !series.rows.empty())
        throw BadInput("columns and how they are read are a film's; give --series FILE");
}

DishFilm read_film(FilmOptions& options) {
    std::erase_if(options.shape, [](const auto& flag) { return flag.second.empty(); });
    require_usable(options.series, options.angle);
    static_cast<void>(options.known_floor());
    DishFilm film;
    take_shape(options, film);
    SeriesChoice turning = options.series;
    turning.table = rows_of(options.series);
    turning.where.clear();
    SeriesChoice moving = turning;
    turning.angle = options.angle;
    turning.position.clear(), turning.origin.clear();
    turning.fits_origin = false, turning.scale = 1;
    turning.set_swirl_rate(options.shape.count("swirl-rate") != 0 ? options.shape.at("swirl-rate") : "1");
    if (moving.position.empty()) moving.position = {moving.marks[0], moving.marks[1]};
    moving.marks.clear();
    moving.symmetry = 1, moving.degrees = false;
    moving.check();
    moving.scale = 1;
    const bool fits_origin = moving.origin.empty();
    if (fits_origin) moving.origin = {"0", "0"};
    moving.fits_origin = false;
    const MeasuredSeries turns = read_series(turning);
    const auto places = places_of(moving, turns.angle, film);
    film.least_noise = noise_of_rounding(places, turns, !turning.marks.empty(), film.length);
    film.rows = turns.rows;
    film.period = turns.angle.period;
    film.rate = turns.swirl_rate;
    film.mirror = turns.y_down == turns.clockwise ? 1 : -1;
    if (fits_origin) {
        const FittedCircle circle = fitted_circle(places[0], places[1]);
        film.origin = Eigen::Vector2d(circle.centre[0], film.mirror * circle.centre[1]) / film.length;
    }
    const std::vector<double>& times = turns.angle.times;
    for (std::size_t i = 0; i < times.size(); ++i) {
        analysis::FilmFrame frame;
        frame.time = (times[i] - times.front()) * film.rate;
        frame.place << places[0][i] / film.length, film.mirror * places[1][i] / film.length, turns.angle.values[i];
        film.frames.push_back(frame);
    }
    std::vector<std::string> notes = turns.notes;
    add_notes(notes, film.notes);
    film.notes = notes;
    return film;
}

}  // namespace swirl::apps::fit
