// A straight plate that bodies fall on: where it is, from the impacts themselves.
#pragma once

#include "analysis/fits/free_arcs.hpp"
#include "apps/studies/fits/dish_motion.hpp"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace swirl::studies {

/// The plate is height along its normal (−sin tilt, cos tilt), which points to the bodies; vertex 0 of a body is at the
/// film's angle + mark. Lengths in units of the body's R_p: a FilmedScene with α = 1 and β = 0.
struct Plate {
    double height = 0, tilt = 0, mark = 0;
    bool by_momentum = true;  ///< the balance of momentum counts: I/m is known
    /// Robust standard deviation of how far the struck vertices are off it, and what of that their errors don't
    /// explain.
    double off_plate = analysis::nan, doubt = 0;

    Eigen::Vector2d normal() const;
};

/// The vertex that reaches farthest down, of a disk its lowest point; `normal` points into the plate.
Contact contact_on(const FilmedScene& body, const Plate& plate, const Eigen::Vector3d& place);

/// Height, tilt and mark for which vertices lie on the plate at the kinks, and impulses keep the balance of momentum,
/// k ΔS = r_x ΔV_y − r_y ΔV_x, where I/m is known: each weighs by its errors. From the best of lines through vertices
/// of two kinks each, at a grid of marks, and level ones through one, then Gauss–Newton with Tukey's biweight. Nothing
/// with fewer than `fewest_kinks`. O(kinks²), of at most some hundred kinks.
std::optional<Plate> fit_plate(std::span<const analysis::Kink> kinks, const FilmNoise& noise, const FilmedScene& body,
                               bool by_momentum);

/// The same from near by, kink i counted weights[i] times (all once without any).
Plate refined_plate(std::span<const analysis::Kink> kinks, std::span<const double> weights, const FilmNoise& noise,
                    const FilmedScene& body, const Plate& start);

}  // namespace swirl::studies
