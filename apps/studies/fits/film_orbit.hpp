// The orbit of the scene that a film tells, from a place of the film on.
#pragma once

#include "apps/studies/fits/film_impacts.hpp"
#include "map/model/scene.hpp"

#include <vector>

namespace swirl::studies {

/// S from a time of the film on, to the next one.
struct SpinStep {
    double time = 0, spin = 0;
};

/// S(t) of `found` from the first arc between two used impacts, at the middle of it, to the film's end, the end of the
/// orbit (contact that lasts) or `most_steps` impacts. An orbit that is chaotic stays beside the film for a few
/// impacts, and shares its statistics after. Empty if no arc lies between two used impacts.
std::vector<SpinStep> simulated_spin(const Scene<double>& found, const FilmFit& film);
inline constexpr long long most_steps = 100'000;

}  // namespace swirl::studies
