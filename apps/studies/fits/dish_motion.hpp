// Where the wall was while a film was made: the dish's place on the swirl's circle, from the impacts themselves.
#pragma once

#include "analysis/fits/free_arcs.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <span>

namespace swirl::studies {

/// The body and the dish, lengths in R_c.
struct FilmedScene {
    int sides = 0;  ///< disk_sides: a disk
    double alpha = 0, beta = 0;
    double inertia = 0;          ///< I/m = κ α²
    std::optional<double> mark;  ///< direction of a vertex at the film's angle 0, if it is known
};

/// The dish's centre is origin + β (cos, sin)(rate t + phase); vertex 0 of the body is at the film's angle + mark.
struct DishMotion {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();
    double phase = 0, rate = 1, mark = 0;
    double off_wall = analysis::nan;  ///< robust standard deviation of how far the struck vertices are off the wall

    Eigen::Vector2d centre(const FilmedScene& scene, double time) const;
};

/// The vertex that reaches farthest out.
struct Contact {
    Eigen::Vector2d normal;  ///< outwards
    Eigen::Vector2d offset;  ///< from the body's centre to it
    Eigen::Vector2d wall;    ///< the wall's velocity
    double gap = 0;          ///< of it: 0 on the wall, > 0 outside
    double next_gap = 0;     ///< of the vertex that reaches farthest of the others; −1 of a disk
    double curvature = 1;    ///< of the wall; 0: it is straight
    double doubt = 0;        ///< standard error of the wall's place
};
Contact contact_at(const FilmedScene& scene, const DishMotion& dish, double time, const Eigen::Vector3d& place);

/// Standard deviations of x or y and of θ in one frame.
struct FilmNoise {
    double place = 0, angle = 0;
};

/// Standard errors of a kink's place relative to the wall, across it and along, and of the direction of its offset:
/// those of the lines, and of the time at which they meet.
struct KinkErrors {
    double across = 0, along = 0, turn = 0;
};
KinkErrors errors_of(const analysis::Kink& kink, const FilmNoise& noise, const FilmedScene& scene,
                     const Contact& contact);

/// Origin, phase, rate and mark for which the kinks lie on the wall and their impulses keep the balance of momentum,
/// k ΔS = r_x ΔV_y − r_y ΔV_x: each weighs by its errors. The wall alone does not tell phase and mark of impacts that
/// are all alike; where the impulse passes does. From the best of a grid of phases and marks over the first kinks, then
/// Gauss–Newton with Tukey's biweight over more and more of them, so that a rate that is a little off is found. From
/// the rate 1 and `origin`; nothing with fewer than `fewest_kinks`. O(kinks).
std::optional<DishMotion> fit_dish(std::span<const analysis::Kink> kinks, const FilmNoise& noise,
                                   const FilmedScene& scene, const Eigen::Vector2d& origin);
inline constexpr std::size_t fewest_kinks = 8;

/// α with which the kinks lie on the wall best.
struct SizeFit {
    double alpha = 0, error = 0;
};

/// What is on the wall.
enum class OnWall {
    impacts,  ///< kinks, of known errors
    frames    ///< frames of a body that stays on it, as kinks without a change; lines through them bend, and their
              ///< noise is too large
};

/// The same fit with α free as well, from what is given: a body of another size, or a scale of the film that is wrong,
/// leaves the kinks off the wall by one distance, which the dish's motion does not take up. The error is in units of
/// how the kinks scatter where that is more than their errors; of frames also where it is less, if they lie to either
/// side of the wall independently of the ones before, as noise does. Nothing where α does not settle, where the kinks
/// are scattered about the wall by more than their errors, where the error is more than 0.004, and of fewer than
/// `fewest_kinks`. O(kinks).
std::optional<SizeFit> size_on_wall(std::span<const analysis::Kink> kinks, const FilmNoise& noise,
                                    const FilmedScene& scene, const DishMotion& dish, OnWall what = OnWall::impacts);

/// The same from near by, kink i counted weights[i] times (all once without any).
DishMotion refined_dish(std::span<const analysis::Kink> kinks, std::span<const double> weights, const FilmNoise& noise,
                        const FilmedScene& scene, const DishMotion& start);

}  // namespace swirl::studies
