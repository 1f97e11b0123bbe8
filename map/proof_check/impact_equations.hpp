// What one flight and one impact ask of two neighbouring points, as equations between the two, and as inequalities.
#pragma once

#include "map/proof_check/gradient.hpp"
#include "map/proof_check/stated_cycle.hpp"

#include <string>
#include <vector>

namespace swirl::proof_check {

/// The scene's numbers as balls, or as other enclosed numbers.
template <class S>
struct SceneOver {
    S alpha, beta, mu, restitution, inertia, spacing;
    int sides = 0;
    std::string law;
    bool disk() const { return sides == 0; }
};
using StatedScene = SceneOver<Ball>;

/// κ of the uniform lamina, or the decimal. @throws std::invalid_argument for numbers out of range
StatedScene scene_of(const StatedCycle& cycle);

/// All equations of a step, in this order; a disk's `turn` and `spin` may be without content.
///   position_x, position_y  the centre after the flight is where the next point has it (from the swirl's centre, in
///   axes that
///                     turn with the swirl):
///                     β + cis ψ − α cis(ψ + χ) + cis ψ (v_n + i v_t) τ = cis τ (β + cis ψ′ − α cis(ψ′ + χ′))
///   turn              ψ + χ + Sτ + 2πk/N = ψ′ + χ′ + τ, modulo 2π
///   spin              I (S′ − S) = r_n q + r_t p,  p = v_n⁻ − v_n′, q = v_t′ − v_t⁻
///   friction          q = −sμp | u_t′ = 0 | q = sμ(p − 2p_k) | q = 0
///   restitution       by the law, in p and the velocities before and after
template <class S>
struct StepEquationsOver {
    GradientOver<S> position_x, position_y, turn, spin, friction, restitution;
};
using StepEquations = StepEquationsOver<Ball>;

/// An inequality, positive where it holds.
struct Inequality {
    std::string name;
    Ball value;
};

/// The state of a step and of the next, each with the derivative by itself.
template <class S>
struct StepVariablesOver {
    GradientOver<S> psi, chi, vn, vt, spin, tau, next_psi, next_chi, next_vn, next_vt, next_spin;
};
using StepVariables = StepVariablesOver<Ball>;

///   inequalities  null: not wanted
/// Over balls, and over numbers that depend on one or two others (curved.hpp).
///   N  the sort of the scene's numbers: S, or with derivatives where one of them is unknown
template <class S, class N>
StepEquationsOver<S> step_equations(const SceneOver<N>& scene, const StatedStep& step, const StepVariablesOver<S>& at,
                                    std::vector<Inequality>* inequalities);

}  // namespace swirl::proof_check
