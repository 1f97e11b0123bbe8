// Films of falls as one film, divided into free arcs and the impacts on the plate between them.
#pragma once

#include "analysis/fits/free_arcs.hpp"
#include "analysis/fits/gravity.hpp"
#include "apps/studies/fits/film_impacts.hpp"
#include "apps/studies/fits/plate.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
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
    no_gravity,       ///< no arcs that bend alike were found
    falls_up,         ///< gravity points along +y: so does the image's axis
    another_size,     ///< bodies lie on the plate with another size (has_another_size)
    another_shape,    ///< or with another number of sides
    few_kinks,        ///< fewer than `fewest_kinks` meet
    no_plate,         ///< fewer than `analysis::fewest_impacts` can be used, and most kinks are on no common plate
    few_impacts,      ///< fewer than `analysis::fewest_impacts` can be used
    another_gravity,  ///< than the one that is given (has_another_gravity)
    another_mark,     ///< than the one that is given (has_another_mark)
    no_law            ///< see `fit.outcome`
};

/// Frames of each fall: times rise, y points up.
using FallFrames = std::vector<analysis::FilmFrame>;

/// The falls as one film: in an order of their own, so that the same falls in another order are the same film to the
/// bit, with places from their common median, so that where the axes have their origin takes no digits.
struct FallsInARow {
    FallFrames frames;               ///< lengths in R_p; between falls are so many steps that no arc bridges them
    std::vector<double> starts;      ///< of each fall as they were given, in the frames' times
    std::vector<std::size_t> order;  ///< the given number of the first one, of the second one, …
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< of the places, in R_p
};

/// @throws std::invalid_argument where no fall has two frames
FallsInARow in_a_row(const std::vector<FallFrames>& falls, double radius);

/// A film of falls, divided.
struct DividedFalls {
    FallsFitOutcome outcome = FallsFitOutcome::fitted;
    std::vector<double> starts;                        ///< of each fall, in the arcs' times
    std::vector<std::size_t> order;                    ///< as of FallsInARow
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< of all places, in R_p
    analysis::FilmArcs arcs;                           ///< of all falls, one after the other, lengths in R_p
    analysis::FallFit fall;                            ///< by the arcs, per R_p; of a given one beside it
    double division = 1;  ///< frames were divided as if noise were so many times what it is
    Eigen::Matrix3d tracker_noise = Eigen::Matrix3d::Zero();  ///< FilmArcs::noise of the finest division
    std::size_t longest = 0;                                  ///< frames of a piece of an arc, by which velocities are
    Plate plate;
    std::optional<BodyOnPlate> body;   ///< as the film shows it, with the given sides
    std::optional<Plate> unmarked;     ///< of a given mark: where impacts put it, of all vertices the nearest
    std::optional<BodyOnPlate> shape;  ///< with other sides that are surely nearer to the plate
    std::vector<FilmImpact> impacts;   ///< one a kink
    std::array<std::size_t, kink_uses> counts{};  ///< of each KinkUse
    std::size_t contradicting = 0;                ///< kinks that contradicts_plate() is true of

    std::size_t count(KinkUse use) const { return counts[static_cast<std::size_t>(use)]; }
    /// How many falls are before the one that a time is in, and its given number.
    std::size_t index_at(double time) const;
    std::size_t fall_at(double time) const { return order[index_at(time)]; }
    /// Of the plate over the given origin, in R_p.
    double plate_height() const { return plate.height + plate.normal().dot(origin); }
};

/// A kink off the plate between arcs that fall (`free`, of each arc: analysis::falling_arcs).
bool contradicts_plate(const FilmImpact& found, const std::vector<bool>& free);

/// Kinks that are impacts of one vertex, less those that contradict the plate: what a right division has most of.
double merit_of(const DividedFalls& falls);

struct FallsDivisions {
    DividedFalls best;
    std::vector<DividedFalls> others;  ///< of the other noises, the best each that can be fitted
};

/// Arcs of bodies that fall bend by more than a tracker's noise from frame to frame, for reasons that no model has: a
/// centre that is not quite the tracked one wobbles with the spin, lenses bend, a guide rubs. The division is that of a
/// noise so many times as large, and the pieces of arcs are so long, that impacts and merit are largest, of those whose
/// frames are within twice the tracker's own noise; the finer division and the longer pieces where the others do not
/// give a tenth more. Where no gravity is found, or one along +y, that is all that is returned.
///   looks_for_body  its size and sides are told, too
FallsDivisions divided_falls(const FallsInARow& film, double period, const FallenBody& body,
                             const FallsSetting& setting, bool looks_for_body);

/// The first fall, in the given order, that alone bends otherwise than the falls do in the median, by 30 % or the other
/// way, and of which the frames cost less (by an arc, analysis::cost_of_division) with its own gravity than with the
/// common one: in other lengths, by another clock, or with another axis. Nothing with fewer than 3 falls that tell it.
/// O(frames log frames).
struct OtherFall {
    std::size_t number = 0;
    double gravity = 0, usual = 0;  ///< along −y, in the caller's lengths
};
std::optional<OtherFall> other_fall(const std::vector<FallFrames>& falls, double period, const FallenBody& body,
                                    const FallsSetting& setting);

/// As settled_fall() takes it, lengths in R_p.
analysis::FallSettings fall_settings(const FallsSetting& setting, double radius);
FilmedScene scene_of(const FallenBody& body);
/// Where a body would be on the plate; both outlive it.
ContactAt on_plate(const FilmedScene& scene, const Plate& plate);
FilmNoise noise_of(const analysis::FilmArcs& arcs);
/// Kinks that are used.
std::vector<analysis::Kink> used_kinks(const DividedFalls& falls);

}  // namespace swirl::studies
