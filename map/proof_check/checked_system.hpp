// The equations of all steps together, and Krawczyk's operator on the box that is stated.
#pragma once

#include "map/proof_check/impact_equations.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace swirl::proof_check {

using Balls = std::vector<Ball>;

/// Which equations stand for a cycle. A family's lack one (README.md of map/proof, "Families"): `symmetric` leaves
/// restitution out; `conserved` has one unknown more, λ, and z_1 − λ a for the image of the last point.
enum class Shortage { none, symmetric, conserved };

struct CheckedSystem {
    StatedScene scene;
    std::vector<StatedStep> steps;
    std::vector<std::size_t> kept;  ///< of ψ, χ, v_n, v_t, S those that are unknown
    Shortage shortage = Shortage::none;
    StatedCycle::Phase phase;
    std::array<double, 5> direction{};  ///< a

    std::size_t width() const { return kept.size() + 1; }
    std::size_t size() const { return steps.size() * width() + (shortage == Shortage::conserved ? 1 : 0); }
    StepVariables variables_of(const Balls& unknowns, std::size_t i) const;
};

/// Its contact modes, slips and vertex steps are known ones. @throws std::invalid_argument
void require_itinerary(const StatedCycle& cycle);

/// From the certificate. @throws std::invalid_argument where its parts contradict each other
CheckedSystem checked_system(const StatedCycle& cycle);

/// The stated box, and its middle.
Balls stated_box(const CheckedSystem& system);
Balls stated_middle(const CheckedSystem& system);

/// True if K of the box lies in its interior; then `image` is K.
bool holds_one_solution(const CheckedSystem& system, const Balls& middle, const Balls& box, Balls& image);

/// DF of a step by the unknown coordinates, from the linearised equations; empty where they cannot be solved.
std::vector<Balls> derivative_of_step(const CheckedSystem& system, const Balls& unknowns, std::size_t i);

/// ∇J, of J = ½|V|² + ½I S² − P × V − I S seen from the swirl's centre.
std::array<Ball, 5> gradient_of_energy(const StatedScene& scene, const std::array<Ball, 5>& z);

}  // namespace swirl::proof_check
