// A film of the body in the dish: the columns of a tracker's table, the scene's shape, and both in units of R_c and
// ω_s.
#pragma once

#include "analysis/fits/free_arcs.hpp"
#include "apps/command_line/flags.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/input/series_choice.hpp"
#include "apps/studies/fits/dish_motion.hpp"
#include "apps/studies/fits/film_drag.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::fit {

struct FilmOptions {
    SeriesChoice series;
    std::string angle;                         ///< a column of angles
    std::map<std::string, std::string> shape;  ///< of the scene, by the names of its flags
    std::string vertex;                        ///< direction of a vertex at the film's angle 0, if it is known
    std::string floor;                         ///< dish or table, if it is known

    void add_to(Flags& command);
    bool given() const { return !series.file.empty(); }
    /// @throws BadInput for flags of a film without --series
    void require_none() const;
    std::optional<studies::Floor> known_floor() const;
};

struct DishFilm {
    std::vector<analysis::FilmFrame> frames;  ///< time in 1/ω_s, places in R_c, y up, the swirl counter-clockwise
    double period = 0;                        ///< of the angle
    studies::FilmedScene scene;
    double inertia_factor = 0;
    /// Standard deviation of x, y and θ by the rounding of the columns alone.
    Eigen::Vector3d least_noise = Eigen::Vector3d::Zero();
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< to start from, in R_c: of places less `zero`
    Eigen::Vector2d zero = Eigen::Vector2d::Zero();    ///< what was taken off, in the columns' units
    double length = 1;                                 ///< R_c in the columns' units
    double mirror = 1;                                 ///< −1: y was turned
    double rate = 1;                                   ///< ω_s in radians per unit of the table's time
    std::size_t rows = 0;
    std::vector<std::string> notes;
};

/// Reads angle and places: --angle or --marks, and --position, without which the first of the marks is the centre.
/// @throws BadInput for what read_series() refuses, no places, a shape that is missing or out of range
DishFilm read_film(FilmOptions& options);

}  // namespace swirl::apps::fit
