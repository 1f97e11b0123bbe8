// A scene's return map for solvers: sizes at run time, one parameter if asked for.
#pragma once

#include "analysis/cycles/multi_shooting.hpp"
#include "apps/studies/scene_map/accuracy.hpp"
#include "map/model/parameter.hpp"

namespace swirl::studies {

/// True if the parameter is within its range there.
bool is_allowed(Parameter parameter, double value);

/// Solvers ask for cycles of impacts: contact that lasts longer than a few swings has none.
inline constexpr double solver_horizon = 50;

/// The return map of one scene for solvers, by SceneMap's coordinates; the observable is S, its integral ∫S dt. Through
/// sustained contact of up to `solver_horizon`; rebounds that end in contact count as one impact (chatter_once.hpp),
/// with the product of their derivatives. It also ends at an impact with u_n < 10⁻⁶, its `least_margin`: rest on the
/// wall is no cycle of impacts.
///   accuracy  in which each step is computed (SceneMap)
/// @throws std::invalid_argument for a scene out of range
analysis::ShootingMap shooting_map_of(const Scene<double>& scene, Accuracy accuracy = Accuracy::double_precision);

/// The scene's map with a parameter, whose value in `scene` is not used. It ends where the parameter leaves its range.
/// ∂F/∂p is exact, through contact too. Friction is what `scene` has: μ = 0 in a scene with friction is the limit
/// μ → 0.
analysis::ShootingMap shooting_map_of(const Scene<double>& scene, Parameter parameter,
                                      Accuracy accuracy = Accuracy::double_precision);

/// The scene's map with two parameters, different ones. Cost of a step: that with one, and ∂F/∂p once more.
analysis::PlaneMap plane_map_of(const Scene<double>& scene, Parameter first, Parameter second);

/// The scene's flights with the time of their impact as the last coordinate and the gap then as a constraint, for
/// `analysis::solve_near_grazing`. No sustained contact.
analysis::TimedMap timed_map_of(const Scene<double>& scene);

}  // namespace swirl::studies
