// How the errors of a film's frames make those of an impact's velocities and offset, with what they have in common.
#pragma once

#include "analysis/fits/free_arcs.hpp"
#include "analysis/fits/measured_impact.hpp"
#include "apps/studies/fits/dish_motion.hpp"
#include "apps/studies/fits/plate.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace swirl::studies {

/// Covariance of (before, after, offset) of the impact at a kink, to first order in the errors of the twelve numbers of
/// its two arcs (the places at their mean times, σ²/n, and their velocities, σ²/spread, of x, y and θ each), which move
/// the time at which they meet, and with it velocities and contact; of accelerations that the arcs' model does not have
/// (FilmArcs::wandering), each arc's its own; of how long impacts last (FilmArcs::impact_time); of the plate's tilt and
/// mark; and of the contact's place on the body, which is as far off as vertices are off the plate beyond their errors
/// (Plate::doubt), either way. Those of the plate are common to all impacts; of one impact they are errors as any. Some
/// 30 times the work of a kink.
analysis::ImpactCovariance impact_covariance(const analysis::FilmArcs& film, const analysis::Kink& kink,
                                             const FilmedScene& scene, const Plate& plate);

/// Adds to an impact's covariance what moves all of them by one standard error each, and states the errors that are its
/// diagonal's roots.
///   number  of the impact;   moved  all impacts as each such error makes them
void add_common_errors(analysis::MeasuredImpact& impact, std::size_t number,
                       std::span<const std::vector<analysis::MeasuredImpact>> moved);

}  // namespace swirl::studies
