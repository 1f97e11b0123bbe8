// What `swirl fit --series` writes of the film: arcs, kinks, where the dish was, and what to run next.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/fit/dish_film.hpp"
#include "apps/record/record_writer.hpp"
#include "apps/studies/fits/film_impacts.hpp"
#include "map/model/scene.hpp"

#include <string>
#include <vector>

namespace swirl::apps::fit {

struct FilmReport {
    DishFilm source;
    studies::FilmFit film;
    std::vector<std::string> commands;         ///< on the scene that was found
    std::vector<studies::SpinStep> simulated;  ///< S(t) of that scene, beside the film's
};

/// The scene that was found: of a μ without an upper end that of `swirl classify` below.
Scene<double> scene_of(const DishFilm& source, const analysis::ImpactFit& fit);

/// `swirl classify` and `swirl sweep` on the scene that was found, over the intervals of e and μ.
std::vector<std::string> commands_on(const FilmOptions& options, const DishFilm& source, const studies::FilmFit& film);

void write_json(JsonWriter& json, const FilmReport& report);
void write_record(const RecordGroup& root, const FilmReport& report);
void print_film(const FilmReport& report);
void print_commands(const FilmReport& report);

}  // namespace swirl::apps::fit
