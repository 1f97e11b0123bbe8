// A scene's return map for solvers: sizes at run time, one parameter if asked for.
#pragma once

#include "analysis/orbits/multi_shooting.hpp"
#include "map/derivative/parameter.hpp"
#include "map/orbit/outcome.hpp"

namespace swirl::apps {

/// The return map of one scene, coordinates (ψ, χ, v_n, v_t, S) or the disk's four; the observable is S, its integral
/// ∫S dt. Through sustained contact of up to 50 time units as SectionSystem. It also ends at an impact with
/// u_n < 10⁻⁶, its `least_margin`: rest on the wall is no cycle of impacts. @throws std::invalid_argument for a scene
/// out of range
analysis::ShootingMap scene_map(const Scene<double>& scene);

/// The same with a parameter, whose value in `scene` is not used. The map ends where the parameter leaves its range.
/// ∂F/∂p is exact for a flight, a central difference through contact. Friction is what `scene` has: μ = 0 in a scene
/// with friction is the limit μ → 0.
analysis::ShootingMap scene_map(const Scene<double>& scene, Parameter parameter);

/// The scene's flights with the time of their impact as the last coordinate and the gap then as a constraint, for
/// `analysis::solve_near_grazing`. No sustained contact.
analysis::TimedMap timed_scene_map(const Scene<double>& scene);

/// A section point from its coordinates, and back.
SectionPoint<double> section_point_of(const Eigen::VectorXd& z);
Eigen::VectorXd state_of(const SectionPoint<double>& z, bool disk);

/// A letter of a word: 6 · vertex step + contact mode; −1 less that where the way led through sustained contact.
struct Letter {
    int vertex_step = 0;
    ContactMode mode = ContactMode::frictionless;
    bool through_contact = false;
};
Letter letter_from(std::int64_t letter);

}  // namespace swirl::apps
