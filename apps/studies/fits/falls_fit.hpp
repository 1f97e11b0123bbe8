// From films of a body that falls on a straight plate to e, μ and the law of impact.
#pragma once

#include "analysis/fits/fit_impacts.hpp"
#include "analysis/fits/gravity.hpp"
#include "apps/studies/fits/film_impacts.hpp"
#include "apps/studies/fits/plate.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::studies {

/// The body, lengths in any unit.
struct FallenBody {
    int sides = 0;               ///< disk_sides: a disk
    double radius = 1;           ///< R_p, from the centre to a vertex
    double inertia = 0;          ///< I/m
    bool inertia_known = false;  ///< else I/m is what momentum tells, and that of a uniform lamina only weighs errors
    std::optional<double> mark;  ///< direction of a vertex at the film's angle 0, if it is known
};

struct FallsSetting {
    std::optional<double> gravity;  ///< along −y, if it is known
    /// Standard deviation of x, y and θ by the rounding of what was written alone.
    Eigen::Vector3d least_noise = Eigen::Vector3d::Zero();
};

enum class FallsFitOutcome {
    fitted,
    no_gravity,     ///< no arcs that bend alike were found
    falls_up,       ///< gravity points along +y: so does the image's axis
    another_size,   ///< bodies lie on the plate with another size (has_another_size)
    another_shape,  ///< or with another number of sides
    few_kinks,      ///< fewer than `fewest_kinks` meet
    no_plate,       ///< fewer than `analysis::fewest_impacts` can be used, and most kinks are on no common plate
    few_impacts,    ///< fewer than `analysis::fewest_impacts` can be used
    no_law          ///< see `fit.outcome`
};

/// e and μ of a part of the impacts.
struct SubsetFit {
    std::string name;
    std::size_t falls = 0, impacts = 0;
    analysis::FittedNumber restitution, friction;  ///< NaN: fewer than `analysis::fewest_impacts` impacts
    bool friction_open = false;                    ///< μ has no upper end
};

struct FallsFit {
    FallsFitOutcome outcome = FallsFitOutcome::fitted;
    analysis::FilmArcs arcs;     ///< of all falls, one after the other, lengths in R_p
    std::vector<double> starts;  ///< of each fall, in the arcs' times
    analysis::FallFit fall;      ///< by the arcs, per R_p; of a given one beside it
    double division = 1;         ///< frames were divided as if noise were so many times what it is
    Eigen::Matrix3d tracker_noise = Eigen::Matrix3d::Zero();  ///< FilmArcs::noise of the finest division
    std::size_t longest = 0;                                  ///< frames of a piece of an arc, by which velocities are
    Plate plate;
    std::optional<BodyOnPlate> body;              ///< as the film shows it, with the given sides
    std::optional<BodyOnPlate> shape;             ///< with other sides that are surely nearer to the plate
    std::vector<FilmImpact> impacts;              ///< one a kink
    std::array<std::size_t, kink_uses> counts{};  ///< of each KinkUse
    std::size_t thinned = 0, alike = 0;           ///< as of FilmFit
    double restitution_shift = 0, friction_shift = 0;
    std::size_t noisier = 0;  ///< films with as much noise again that could be fitted
    bool by_falls = false;    ///< resamples draw falls; else impacts
    std::vector<SubsetFit> subsets;
    /// Share of the held-out impacts that are predicted within the noise times how widely impacts scatter about the
    /// law.
    double predicted_in_scatter = analysis::nan;
    analysis::ImpactFit fit;  ///< in the caller's lengths

    /// The fall that a time is in.
    std::size_t fall_at(double time) const;
};

/// The body has surely (5 errors) another size than the given one, by `least` of it or more.
bool has_another_size(const FallsFit& falls, double least);
/// Of the size. A body is measured as well; its corners are sharp to some of that.
inline constexpr double least_fallen_size_error = 0.01;
/// Moves contact velocities by as much: e and μ are off by more than their intervals.
inline constexpr double most_fallen_size_error = 0.05;
/// Where vertices are off the plate beyond their errors: corners that are rounded by a radius ρ make a square √2 ρ
/// smaller than it is.
inline constexpr double most_round_size_error = 0.3;

/// Fewer falls are not drawn: resamples then draw impacts.
inline constexpr std::size_t fewest_drawn_falls = 10;

/// Free arcs are parabolas of one gravity (analysis::settled_fall), each fall's with its own velocities; two of them
/// meet at an impact if one vertex is on the plate there, and both leave it. What is fitted to the impacts is as of
/// fit_film(): plate and mark anew in each resample, fixed weights, films with as much noise again. Impacts of one fall
/// share what is common to it: with `fewest_drawn_falls` or more, resamples draw falls with all their impacts. Subsets:
/// the falls in two halves in two ways, and the first impacts of each and the later ones.
///   falls  frames of each fall: times rise, lengths in units of body.radius's, y up;   period  of the angle
/// @throws std::invalid_argument without frames
FallsFit fit_falls(const std::vector<std::vector<analysis::FilmFrame>>& falls, double period, const FallenBody& body,
                   const FallsSetting& setting, const analysis::ImpactFitSettings& settings);

}  // namespace swirl::studies
