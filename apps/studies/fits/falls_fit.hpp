// From films of a body that falls on a straight plate to e, μ and the law of impact.
#pragma once

#include "analysis/fits/fit_impacts.hpp"
#include "apps/studies/fits/falls_arcs.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace swirl::studies {

/// e and μ of a part of the impacts.
struct SubsetFit {
    std::string name;
    std::size_t falls = 0, impacts = 0;
    analysis::FittedNumber restitution, friction;  ///< NaN: fewer than `analysis::fewest_impacts` impacts
    bool friction_open = false;                    ///< μ has no upper end
};

struct FallsFit : DividedFalls {
    bool angle_turned = false;  ///< the angle is taken clockwise: as it was given impacts contradict it
    /// Gravity along −y that free arcs tell where another is given, in R_p, and its standard error; NaN: none is told.
    double gravity_of_arcs = analysis::nan, gravity_of_arcs_error = analysis::nan;
    std::size_t thinned = 0, alike = 0;  ///< as of FilmFit
    double restitution_shift = 0, friction_shift = 0;
    std::size_t noisier = 0;  ///< films with as much noise again that could be fitted
    bool by_falls = false;    ///< resamples draw falls; else impacts
    std::vector<SubsetFit> subsets;
    /// Share of the held-out impacts that are predicted within the noise times how widely impacts scatter about the
    /// law.
    double predicted_in_scatter = analysis::nan;
    analysis::ImpactFit fit;  ///< in the caller's lengths
    std::vector<bool> rises;  ///< of each used impact: it surely adds energy (analysis::energy_change)
};

/// What of one fall is fitted, and what speaks against it.
struct FallEvidence {
    std::size_t used = 0, rising = 0;  ///< impacts, and of them those that surely add energy
    std::size_t contradicting = 0;     ///< kinks off the plate between arcs that fall

    /// Time runs the other way in it: energy surely rises at all of its impacts, two or more.
    bool is_backward() const { return used >= 2 && rising == used; }
    /// None of its impacts is on the plate that the others show, and several are off it.
    bool is_elsewhere() const { return used == 0 && contradicting > 1; }
};
/// Of each fall, in the given order.
std::vector<FallEvidence> evidence_of(const FallsFit& falls);

/// The body has surely (5 errors) another size than the given one, by `least` of it or more.
bool has_another_size(const FallsFit& falls, double least);
/// Of the size. A body is measured as well; its corners are sharp to some of that.
inline constexpr double least_fallen_size_error = 0.01;
/// Moves contact velocities by as much: e and μ are off by more than their intervals.
inline constexpr double most_fallen_size_error = 0.05;
/// Where vertices are off the plate beyond their errors: corners that are rounded by a radius ρ make a square √2 ρ
/// smaller than it is.
inline constexpr double most_round_size_error = 0.3;

/// Free arcs tell surely (5 errors) another gravity than the given one, by `least` of it or more.
bool has_another_gravity(const FallsFit& falls, const FallsSetting& setting, double radius, double least);
/// Of gravity: what a local one differs by.
inline constexpr double least_gravity_error = 0.002;
/// Of gravity: velocities at the ends of arcs of 0.1 s are off by some 5 cm/s of 1.5 m/s.
inline constexpr double most_gravity_error = 0.05;

/// Vertices are surely (5 errors) at another angle than the given mark says, by `least` or more.
bool has_another_mark(const FallsFit& falls, const FallenBody& body, double least);
/// How far (radians; less than half of 2π/N) they are from it.
double mark_off(const FallsFit& falls, const FallenBody& body);
inline constexpr double least_mark_error = 0.005;
/// Contacts are beside the vertex by as much of R_p: momentum is told by arms that are off by it.
inline constexpr double most_mark_error = 0.05;
/// Where corners are round (see most_round_size_error) contacts are beside the vertex by themselves: of a square of
/// 60 mm impacts put the mark 0.035 to either side of where it is.
inline constexpr double most_round_mark_error = 0.15;

/// Fewer falls are not drawn: resamples then draw impacts.
inline constexpr std::size_t fewest_drawn_falls = 10;

/// Free arcs are parabolas of one gravity (analysis::settled_fall), each fall's with its own velocities; two of them
/// meet at an impact if one vertex is on the plate there, and both leave it. What is fitted to the impacts is as of
/// fit_film(): plate and mark anew in each resample, fixed weights, films with as much noise again. Impacts of one fall
/// share what is common to it: with `fewest_drawn_falls` or more, resamples draw falls with all their impacts. Subsets:
/// the falls in two halves in two ways, the first impacts of each and the later ones, and all impacts as the other
/// divisions of the frames have them. Where momentum says that the angle is measured clockwise it is turned.
///   falls  frames of each fall: times rise, lengths in units of body.radius's, y up;   period  of the angle
/// @throws std::invalid_argument without frames
FallsFit fit_falls(const std::vector<std::vector<analysis::FilmFrame>>& falls, double period, const FallenBody& body,
                   const FallsSetting& setting, const analysis::ImpactFitSettings& settings);

}  // namespace swirl::studies
