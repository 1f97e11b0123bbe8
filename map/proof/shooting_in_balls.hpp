// A cycle with a given itinerary as one system of equations over balls: multiple shooting with the flights' times.
#pragma once

#include "map/intervals/krawczyk.hpp"
#include "map/proof/step_in_balls.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace swirl::proof {

using intervals::BallVector;

/// The coordinates of a step by number: ψ, χ, v_n, v_t, S, and the flight's time.
inline constexpr std::size_t time_index = 5;
inline constexpr std::size_t spin_index = 4;
inline constexpr std::size_t normal_index = 2;
using StepDual = intervals::Dual<6>;

/// How the equations of a family are made square (README.md, "Families").
enum class FamilyForm {
    isolated,   ///< no family
    symmetric,  ///< a disk's fixed points at e = 1 with friction: restitution follows from the other equations
    conserved,  ///< e = 1 without friction: J is conserved, so that z_1 = Fᵏ(z_1) + λ a has λ = 0
};

/// The unknowns are, step by step, the state's coordinates that are not fixed and τ, then λ if there is one.
struct CycleSystem {
    BallScene scene;
    std::vector<Branch> itinerary;
    std::vector<double> advances;           ///< the wall's, roughly
    std::vector<std::size_t> active;        ///< a disk drops χ, a frictionless one S, too, which never changes
    double fixed_spin = 0;                  ///< where S is dropped
    std::vector<std::array<int, 2>> turns;  ///< of ψ and χ, in 2π, from F(z_i) to z_{i+1}
    FamilyForm form = FamilyForm::isolated;
    std::optional<Phase> phase;
    std::array<double, 5> conserved_gradient{};  ///< a ≈ ∇J(z_1)

    std::size_t period() const { return itinerary.size(); }
    std::size_t unknowns_of_step() const { return active.size() + 1; }
    std::size_t unknowns() const { return period() * unknowns_of_step() + (form == FamilyForm::conserved ? 1 : 0); }
    /// The state of step i and its time, from a vector of unknowns.
    BallPoint<Ball> point(const BallVector& unknowns, std::size_t i) const;
    const Ball& time(const BallVector& unknowns, std::size_t i) const {
        return unknowns[(i + 1) * unknowns_of_step() - 1];
    }
    BallStep<Ball> step(const BallVector& unknowns, std::size_t i, Margins* margins) const;
    /// With derivatives by ψ, χ, v_n, v_t, S, τ.
    BallStep<StepDual> differentiated_step(const BallVector& unknowns, std::size_t i) const;
};

/// G and G′.
intervals::Linearisation evaluate(const CycleSystem& system, const BallVector& unknowns);

/// DF of step i by the active coordinates, the flight's time by the implicit function theorem.
std::vector<BallVector> step_derivative(const CycleSystem& system, const BallVector& unknowns, std::size_t i);

/// ∇J over a box of states.
std::array<Ball, 5> conserved_gradient(const BallScene& scene, const BallPoint<Ball>& z);

}  // namespace swirl::proof
