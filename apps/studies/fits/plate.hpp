// A straight plate that bodies fall on: where it is, from the impacts themselves.
#pragma once

#include "analysis/fits/free_arcs.hpp"
#include "apps/studies/fits/dish_motion.hpp"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
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
    /// Covariance of tilt and mark as the kinks tell them; 0 of a mark that is given, or of a disk.
    Eigen::Matrix2d errors = Eigen::Matrix2d::Zero();

    Eigen::Vector2d normal() const;
};

/// R_p: kinks whose error across the plate is more say nothing of it. Where noise has bent an arc, lines meet anywhere,
/// also within four of these.
inline constexpr double most_error_across_plate = 0.025;

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

/// A body of so many sides as the film shows it.
struct BodyOnPlate {
    int sides = 0;
    double size = analysis::nan, error = analysis::nan;        ///< R_p in units of the given one; NaN of a disk
    double scatter = analysis::nan, expected = analysis::nan;  ///< of the vertices off the plate, and by errors alone
    std::size_t kinks = 0;
    Plate plate;

    /// Vertices are points that lie on the plate, as far as can be seen: plate and size are fitted to few kinks.
    bool is_sharp() const {
        constexpr double fitted = 4;
        const double n = static_cast<double>(kinks);
        return n > fitted && scatter * std::sqrt(n / (n - fitted)) < 1.5 * expected;
    }
};

/// The plate and the body's size with which vertices lie on the plate at the kinks: the centre is higher there, the
/// steeper it stands on one, by size · cos φ, φ from straight down to the vertex. From the best of planes y = h + t x +
/// size cos φ through three kinks each, at a grid of marks, whatever the size that was given, then Gauss–Newton. The
/// error is in units of how the kinks scatter where that is more than their errors. A disk's size tells nothing: its
/// centre is as high at all of them. Nothing with fewer than `fewest_kinks`, or where no size settles. O(kinks), of at
/// most some hundred for the start.
std::optional<BodyOnPlate> body_on_plate(std::span<const analysis::Kink> kinks, const FilmNoise& noise,
                                         const FilmedScene& body);

}  // namespace swirl::studies
