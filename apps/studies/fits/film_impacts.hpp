// From a film's arcs to measured impacts: which kinks are one impact of one vertex on the wall, and their velocities.
#pragma once

#include "analysis/fits/fit_impacts.hpp"
#include "apps/studies/fits/dish_motion.hpp"
#include "apps/studies/fits/film_drag.hpp"
#include "map/model/scene.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace swirl::studies {

/// What becomes of a kink.
enum class KinkUse {
    used,
    no_meeting,     ///< the lines do not meet between their frames, or nowhere: more than one impact, or a lost kink
    off_the_wall,   ///< the lines meet, but no vertex is on the wall there
    two_vertices,   ///< two vertices are on the wall
    stays_on_wall,  ///< one of the arcs does not leave the wall: contact that lasts, or flights too low to be seen
    no_approach     ///< the contact does not move into the wall before
};
inline constexpr std::size_t kink_uses = 6;

/// What a use is called.
struct KinkUseNames {
    std::string_view name;   ///< in a record
    std::string_view key;    ///< of its count in documents
    std::string_view words;  ///< after its count, in a sentence of what was left out
};
const KinkUseNames& names_of(KinkUse use);

struct FilmImpact {
    analysis::Kink kink;
    KinkUse use = KinkUse::used;
    Contact contact;
    analysis::MeasuredImpact impact;  ///< of those used: the wall's velocity taken off, along its axes
};

/// Where a body at (x, y, θ) would be on the wall.
using ContactAt = std::function<Contact(double time, const Eigen::Vector3d& place)>;

/// Velocities relative to the wall and the contact's offset, along its axes; no errors.
analysis::MeasuredImpact in_contact_axes(const analysis::Kink& kink, const Contact& contact);

/// Velocities relative to the wall along the axes of the contact (x along the wall, counter-clockwise; y inwards), of
/// both arcs, with their errors; that of the place turns axes and offset, what the impulse, known from the velocities,
/// makes of it is added to the errors after.
std::vector<FilmImpact> film_impacts(const analysis::FilmArcs& film, std::span<const analysis::Kink> kinks,
                                     const FilmedScene& scene, const ContactAt& contact);
std::vector<FilmImpact> film_impacts(const analysis::FilmArcs& film, std::span<const analysis::Kink> kinks,
                                     const FilmedScene& scene, const DishMotion& dish);

/// Both arcs of the kink are among those that count.
inline bool has_both(const std::vector<bool>& counts, const analysis::Kink& kink) {
    return counts[kink.before] && counts[kink.before + 1];
}

/// Those both of whose arcs leave the wall.
std::vector<analysis::Kink> clear_kinks(const analysis::FilmArcs& film, std::span<const analysis::Kink> kinks,
                                        const FilmedScene& scene, const DishMotion& dish);

/// The lines of a kink meet in one place, and between their frames.
bool lines_meet(const analysis::Kink& kink);
/// The kinks of the arcs whose lines do.
std::vector<analysis::Kink> meeting_kinks(const analysis::FilmArcs& film);

/// Each kink as an impact of the vertex that reaches farthest, whatever its use.
std::vector<analysis::MeasuredImpact> impacts_at(const analysis::FilmArcs& film, std::span<const analysis::Kink> kinks,
                                                 const FilmedScene& scene, const ContactAt& contact);
std::vector<analysis::MeasuredImpact> impacts_at(const analysis::FilmArcs& film, std::span<const analysis::Kink> kinks,
                                                 const FilmedScene& scene, const DishMotion& dish);

enum class FilmFitOutcome {
    fitted,
    another_size,  ///< the body is of another α, by `most_size_error` or, of a film that can't be fitted, at all
    few_kinks,     ///< fewer than `fewest_kinks`
    no_wall,       ///< kinks are scattered about no wall of this scene: `off_wall` beyond `most_off_wall`
    few_impacts,   ///< fewer than `analysis::fewest_impacts` can be used, also of a body that stays on the wall
    no_law         ///< see `fit.outcome`, or the best law predicts less than `least_predicted`, or see `most_scatter`
};

/// R_c: a scale, radius or swirl that is wrong leaves more.
inline constexpr double most_off_wall = 0.1;

struct FilmFit {
    FilmFitOutcome outcome = FilmFitOutcome::fitted;
    analysis::FilmArcs arcs;
    DishMotion dish;
    std::vector<FilmImpact> impacts;              ///< one a kink
    std::array<std::size_t, kink_uses> counts{};  ///< of each KinkUse
    std::size_t thinned = 0;                      ///< usable impacts that are left out beyond `most_fitted_impacts`
    std::size_t alike = 0;                        ///< usable impacts that are fitted as the means of alike ones
    double frames_off_wall = analysis::nan;  ///< of few kinks or impacts: robust standard deviation of the later frames
    double restitution_shift = 0, friction_shift = 0;  ///< of the fits of noisier films, in the mean
    std::size_t noisier = 0;                           ///< of these films those that could be fitted
    FilmDrag drag;                ///< of the floor and the spin; where they are sure arcs bend by them (arcs.drags)
    std::optional<SizeFit> size;  ///< of the body, see size_on_wall()
    analysis::ImpactFit fit;
};

/// What a drag at the upper end of its interval (95 %) would add to e of straight arcs: some γτe, τ the used impacts'
/// median flight; straight arcs have the velocities of their middles, too fast before an impact and too slow after it.
/// 0 where arcs bend, NaN where the drag can't be told.
double unseen_drag_shift(const FilmFit& film);

/// The body has surely (5 errors) another α than the scene's, by `least` or more.
bool has_another_size(const FilmFit& film, const FilmedScene& scene, double least);
/// Of α: 0.004 moved e by 0.03 and μ by 0.014, ten times their intervals.
inline constexpr double most_size_error = 0.01;
/// Of α: as well as a body is measured.
inline constexpr double least_size_error = 0.001;

/// R_c: of `frames_off_wall`, below which a body stays on the wall. One in flight is off it by tenths.
inline constexpr double near_wall = 0.05;

/// More impacts that are like no others are thinned evenly: beyond that errors that are common to all count more than
/// those of each, and time grows. (Those with the smallest errors would be chosen by how kinks lie to the frames, and
/// turn the means.)
inline constexpr std::size_t most_fitted_impacts = 200;

/// Share of the held-out impacts. Where the law holds within the noise it was 0.39 to 1; kinks of contact that lasts,
/// taken for impacts, follow no law, and the best one predicts none of them.
inline constexpr double least_predicted = 0.2;
/// Of the impacts of a body that stays on the wall later, about the law, in units of their noise. Of films of a disk
/// with noise of 1 % of R_c that mostly stays on the wall it was 0.4 to 2.1 where e and μ were right, and more where
/// kinks of that contact were among the impacts.
inline constexpr double most_scatter = 2.5;

/// What is known of how the film was made.
struct FilmSetting {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< the swirl's centre, nearly
    std::optional<Floor> floor = {};                   ///< on which the body moves, see film_drag()
    /// Standard deviation of x, y and θ by the rounding of what was written alone. Exact frames have no other noise,
    /// and from how they scatter it is not seen: of three of a resting body it is 0.
    Eigen::Vector3d least_noise = Eigen::Vector3d::Zero();
};

/// Films with as much noise again that are fitted to see what it does to e and μ.
inline constexpr std::size_t noisier_films = 3;

/// Arcs, kinks, wall, impacts; alike ones are fitted as their means (analysis::alike_impacts), by fixed weights
/// (analysis::with_fixed_weights). Resamples draw kinks, fit the dish anew, and move what alike impacts have in common,
/// swirl's phase and mark included, by as little as that is known. Intervals hold all that the loss does not exclude.
/// What noise does beyond scatter
/// (errors before the impact, kinks that are missed, contacts that are turned) grows as its square: films with as much
/// noise again, of the same covariance, are fitted alike, and the intervals are longer by the mean shift of e and μ,
/// towards where it came from (SIMEX: Cook & Stefanski, J. Am. Stat. Assoc. 89 (1994) 1314). If they come to another
/// minimum, the interval holds that, too. A floor's drag that is sure (DragFit::surely_drags) bends the arcs, and with
/// it the spin's own, which does where it is sure, too; their errors move the impacts of resamples. A drag that is not
/// sure is left out of all, as if there were none. Frames: times in 1/ω_s (or nearly: the rate is fitted), lengths in
/// R_c.
///   period  of the angle
FilmFit fit_film(std::span<const analysis::FilmFrame> frames, double period, const FilmedScene& scene,
                 const FilmSetting& setting, const analysis::ImpactFitSettings& settings);

// The orbit of the scene that a film tells, from a place of the film on.

/// S from a time of the film on, to the next one.
struct SpinStep {
    double time = 0, spin = 0;
};

/// S(t) of `found` from the first arc between two used impacts, at the middle of it, to the film's end, the end of the
/// orbit (contact that lasts) or `most_steps` impacts. An orbit that is chaotic stays beside the film for a few
/// impacts, and shares its statistics after. Empty if no arc lies between two used impacts.
std::vector<SpinStep> simulated_spin(const Scene<double>& found, const FilmFit& film);
inline constexpr long long most_steps = 100'000;

}  // namespace swirl::studies
