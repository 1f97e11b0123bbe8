#include "apps/fit/dish_film.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/fit/body_track.hpp"
#include "apps/input/measured_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
    require_body(options.series, options.angle);
    static_cast<void>(options.known_floor());
    DishFilm film;
    take_shape(options, film);
    const BodyTrack track = read_track(options.series, options.angle,
                                       options.shape.count("swirl-rate") != 0 ? options.shape.at("swirl-rate") : "1");
    const MeasuredSeries& turns = track.turns;
    const auto& places = track.places;
    film.zero = {track.zero[0], track.zero[1]};
    film.least_noise = track.rounding_noise(film.length);
    film.rows = turns.rows;
    film.period = turns.angle.period;
    film.rate = turns.swirl_rate;
    film.mirror = track.mirror();
    if (options.series.origin.empty()) {
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
    film.notes = track.notes;
    return film;
}

}  // namespace swirl::apps::fit
