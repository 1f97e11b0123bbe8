#include "analysis/fits/robust.hpp"
#include "apps/studies/fits/film_drag.hpp"
#include "apps/studies/fits/film_impacts.hpp"
#include "apps/studies/fits/impact_laws.hpp"
#include "apps/studies/fits/noisier_films.hpp"
#include "map/model/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace swirl::studies {

namespace {

using analysis::Kink;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// The deviance knows the errors of each impact; that of the dish is common to all, and makes the true minimum worse by
/// some tens. The resamples know it.
constexpr double common_deviance = 100;

/// The kinks that are one impact on the wall.
std::vector<Kink> used_kinks(const FilmFit& film) {
    std::vector<Kink> used;
    for (const FilmImpact& found : film.impacts)
        if (found.use == KinkUse::used) used.push_back(found.kink);
    return used;
}

/// What is common to the errors of alike kinks turns the swirl's phase and the mark, too: fitted to the same kinks,
/// they are no better known than common_error of one of them, by the share of alike ones.
DishMotion with_common_error(const DishMotion& dish, const FilmFit& film, const std::vector<Kink>& used,
                             const FilmedScene& scene, const Vector3d& draws) {
    std::vector<double> along, turn;
    for (const Kink& kink : used) {
        const KinkErrors errors = errors_of(kink, {film.arcs.place_noise, film.arcs.angle_noise}, scene,
                                            contact_at(scene, dish, kink.time, kink.place));
        along.push_back(errors.along), turn.push_back(errors.turn);
    }
    const double share = analysis::common_error * static_cast<double>(film.alike) / static_cast<double>(used.size());
    DishMotion moved = dish;
    if (scene.beta > 0) moved.phase += share * draws[0] * analysis::quantile(along, 0.5) / scene.beta;
    if (scene.sides != disk_sides && !scene.mark) moved.mark += share * draws[1] * analysis::quantile(turn, 0.5);
    return moved;
}

std::vector<double> all_once(std::size_t count) {
    return std::vector<double>(count, 1.0);
}

/// The dish by the kinks that are an impact: in turn, since the dish tells which are.
void settle_dish(FilmFit& film, const std::vector<Kink>& kinks, const FilmNoise& noise, const FilmedScene& scene) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
        film.impacts = film_impacts(film.arcs, kinks, scene, film.dish);
        const std::vector<Kink> used = used_kinks(film);
        if (used.size() < fewest_kinks) return;
        if (round + 1 < rounds) film.dish = refined_dish(used, {}, noise, scene, film.dish);
    }
}

/// The film's later half, beyond the start, each frame as if the body struck the wall there.
std::vector<Kink> later_places(std::span<const analysis::FilmFrame> frames) {
    constexpr std::size_t most_frames = 1000;
    std::vector<Kink> places;
    for (std::size_t i = frames.size() - std::min(most_frames, frames.size() / 2); i < frames.size(); ++i) {
        if (!frames[i].place.allFinite()) continue;
        Kink place;
        place.time = frames[i].time, place.place = frames[i].place;
        place.error = 0, place.share = place.change_share = 1;
        place.change.setZero(), place.drift.setZero();
        places.push_back(place);
    }
    return places;
}

/// The dish, and with it the body's size where it is not known as well, by the frames alone, as if the body stayed on
/// its wall.
void look_for_sustained_contact(FilmFit& film, std::span<const analysis::FilmFrame> frames, const FilmedScene& scene,
                                const Vector2d& origin) {
    const FilmNoise noise{film.arcs.place_noise, film.arcs.angle_noise};
    const std::vector<Kink> places = later_places(frames);
    const std::optional<DishMotion> dish = fit_dish(places, noise, scene, origin);
    if (!dish) return;
    film.frames_off_wall = dish->off_wall;
    const auto size = size_on_wall(places, noise, scene, *dish, OnWall::frames);
    if (size && !(film.size && film.size->error < size->error)) film.size = size;
}

/// Why there is no fit. A body that is near the wall in most frames is on this scene's: the kinks are those of arcs
/// that stay on it, or of flights too low or too short to be seen.
FilmFitOutcome without_impacts(FilmFit& film, std::span<const analysis::FilmFrame> frames, const FilmedScene& scene,
                               const Vector2d& origin) {
    auto& off = film.counts[static_cast<std::size_t>(KinkUse::off_the_wall)];
    look_for_sustained_contact(film, frames, scene, origin);
    if (2 * off <= film.impacts.size()) return FilmFitOutcome::few_impacts;
    if (!(film.frames_off_wall < near_wall)) return FilmFitOutcome::no_wall;
    film.counts[static_cast<std::size_t>(KinkUse::stays_on_wall)] += off;
    off = 0;
    for (FilmImpact& impact : film.impacts)
        if (impact.use == KinkUse::off_the_wall) impact.use = KinkUse::stays_on_wall;
    return FilmFitOutcome::few_impacts;
}

/// How the drags are looked for.
struct DragSearch {
    KnownFloor floor;
    std::optional<analysis::Drags> alike;  ///< arcs bend by those of which these are not 0; else by what is sure
};

/// γ where it is sure, and with it γ_r; else γ_r where that is.
analysis::Drags sure_drags(const analysis::DraggedArcs& found, const DragSearch& search) {
    const analysis::Drags values = found.values();
    if (std::isnan(values.places)) return {};
    if (search.alike)
        return {search.alike->places != 0 ? values.places : 0, search.alike->angle != 0 ? values.angle : 0};
    if (found.drag.surely_drags()) return values;
    return {0, found.spin.surely_drags() ? found.spin.value : 0};
}

/// The dish by the kinks of the arcs; false: there are too few.
bool find_dish(FilmFit& film, const FilmedScene& scene, const Vector2d& origin) {
    const FilmNoise noise{film.arcs.place_noise, film.arcs.angle_noise};
    const std::optional<DishMotion> dish = fit_dish(meeting_kinks(film.arcs), noise, scene, origin);
    if (!dish) return false;
    film.dish = *dish;
    settle_dish(film, analysis::kinks_of(film.arcs), noise, scene);
    return true;
}

/// Half of the kinks or more are impacts.
bool tells_wall(const FilmFit& film) {
    return 2 * used_kinks(film).size() >= film.impacts.size();
}

/// Arcs, dish and drag in turn: the dish is by the arcs' kinks, and the drag moves both. The arcs bend by what of
/// film.drag is sure, and are straight where nothing is. Where kinks of straight arcs are no impacts, the dish is first
/// found by arcs that bend.
bool find_arcs(FilmFit& film, std::span<const analysis::FilmFrame> frames, double period, const FilmedScene& scene,
               const FilmSetting& setting, const DragSearch& search) {
    constexpr int rounds = 3;
    constexpr double settled = 0.3;  // of the drag's error
    const analysis::FilmArcs straight = film.arcs = analysis::fit_arcs(frames, period, {{}, {}, setting.least_noise});
    const bool has_dish = find_dish(film, scene, setting.origin);
    if (search.alike && !search.alike->any()) return has_dish;
    analysis::FilmArcs start = straight;
    if (!has_dish || !tells_wall(film)) {
        const double rate = scene.beta == 0 || search.floor.floor == Floor::table ? 0 : 1;
        if (const auto bent = analysis::bent_arcs(frames, period, straight, rate)) {
            film.arcs = start = *bent;
            if (!find_dish(film, scene, setting.origin)) return false;
        } else if (!has_dish) {
            return false;
        }
    }
    for (int round = 0; round < rounds; ++round) {
        film.drag = film_drag(frames, period, start, scene, film.dish, search.floor);
        const analysis::DraggedArcs& found = film.drag.with;
        const analysis::Drags drags = sure_drags(found, search), before = film.arcs.drags;
        if (!drags.any() && !before.any()) return true;
        film.arcs = drags.any() ? with_drags(found.arcs, drags) : straight;
        if (!find_dish(film, scene, film.dish.origin)) return false;
        const auto stays = [](double now, double then, const analysis::DragFit& fit) {
            return !(std::abs(now - then) > settled * fit.error);
        };
        if (!drags.any() ||
            (stays(drags.places, before.places, found.drag) && stays(drags.angle, before.angle, found.spin)))
            return true;
    }
    return true;
}

/// The used impacts as other drags make them.
std::vector<analysis::MeasuredImpact> with_other_drags(const FilmFit& film, const std::vector<Kink>& used,
                                                       const FilmedScene& scene, const analysis::Drags& drags) {
    const analysis::FilmArcs arcs = analysis::with_drags(film.arcs, drags);
    std::vector<Kink> kinks;
    for (const Kink& kink : analysis::kinks_of(arcs))
        if (kinks.size() < used.size() && kink.before == used[kinks.size()].before) kinks.push_back(kink);
    const FilmNoise noise{arcs.place_noise, arcs.angle_noise};
    return impacts_at(arcs, kinks, scene, refined_dish(kinks, {}, noise, scene, film.dish));
}

/// The used impacts as each drag by which the arcs bend makes them where it is larger by its error; a γ_r that can't be
/// told is γ.
std::vector<std::vector<analysis::MeasuredImpact>> with_more_drag(const FilmFit& film, const std::vector<Kink>& used,
                                                                  const FilmedScene& scene) {
    const analysis::DraggedArcs& with = film.drag.with;
    const bool tied = std::isnan(with.spin.value);
    std::vector<std::vector<analysis::MeasuredImpact>> moved;
    analysis::Drags more = film.arcs.drags;
    if (more.places != 0) {
        more.places += with.drag.error;
        if (tied) more.angle += with.drag.error;
        moved.push_back(with_other_drags(film, used, scene, more));
    }
    more = film.arcs.drags;
    if (more.angle != 0 && !tied) {
        more.angle += with.spin.error;
        moved.push_back(with_other_drags(film, used, scene, more));
    }
    return moved;
}

/// The law by the used impacts.
void fit_law(FilmFit& film, const std::vector<Kink>& used, const FilmedScene& scene,
             analysis::ImpactFitSettings settings) {
    settings.inertia = scene.inertia;
    settings.stated_errors = settings.fixed_weights = true;
    settings.rivals_within = common_deviance;
    settings.signs_known = true;  // with another sense of the angle no wall would have been found
    const FilmNoise noise{film.arcs.place_noise, film.arcs.angle_noise};
    const std::vector<analysis::MeasuredImpact> impacts = impacts_at(film.arcs, used, scene, film.dish);
    const FittedGroups fitted = fitted_groups(impacts);
    const std::vector<analysis::AlikeImpacts>& groups = fitted.groups;
    film.thinned = fitted.thinned, film.alike = fitted.alike;
    const auto dragged = with_more_drag(film, used, scene);
    settings.resampled = [&](std::uint64_t index) {
        const std::vector<double> weights = analysis::bootstrap_weights(used.size(), settings.seed, index);
        constexpr std::uint64_t dish_after = 1ULL << 24;  // beyond the draws for clouds
        const Vector3d draws = analysis::normal_draws(settings.seed, dish_after + index, 0),
                       of_drags = analysis::normal_draws(settings.seed, dish_after + index, 1);
        const DishMotion moved =
            with_common_error(refined_dish(used, weights, noise, scene, film.dish), film, used, scene, draws);
        std::vector<analysis::MeasuredImpact> seen = impacts_at(film.arcs, used, scene, moved);
        for (std::size_t k = 0; k < dragged.size(); ++k)
            add_share(seen, of_drags[static_cast<Eigen::Index>(k)], dragged[k], impacts);
        analysis::WeighedImpacts drawn = analysis::merged_impacts(seen, weights, groups);
        analysis::move_clouds(drawn, groups, settings.seed, index);
        return drawn;
    };
    const analysis::WeighedImpacts merged = analysis::merged_impacts(impacts, all_once(used.size()), groups);
    film.fit = analysis::fit_impacts(merged.impacts, impact_laws(), settings);
}

/// Arcs, dish, impacts and law.
FilmFit fit_with_size(std::span<const analysis::FilmFrame> frames, double period, const FilmedScene& scene,
                      const FilmSetting& setting, const analysis::ImpactFitSettings& settings,
                      const DragSearch& search) {
    FilmFit film;
    if (!find_arcs(film, frames, period, scene, setting, search)) {
        film.outcome = FilmFitOutcome::few_kinks;
        look_for_sustained_contact(film, frames, scene, setting.origin);
        return film;
    }
    const FilmNoise noise{film.arcs.place_noise, film.arcs.angle_noise};
    film.size =
        size_on_wall(clear_kinks(film.arcs, meeting_kinks(film.arcs), scene, film.dish), noise, scene, film.dish);
    if (!film.size) look_for_sustained_contact(film, frames, scene, film.dish.origin);
    for (const FilmImpact& found : film.impacts) ++film.counts[static_cast<std::size_t>(found.use)];
    const std::vector<Kink> used = used_kinks(film);
    if (has_another_size(film, scene, most_size_error)) return film;
    if (used.size() < analysis::fewest_impacts)
        film.outcome = without_impacts(film, frames, scene, setting.origin);
    else if (film.dish.off_wall > most_off_wall)
        film.outcome = FilmFitOutcome::no_wall;
    if (film.outcome != FilmFitOutcome::fitted) return film;
    fit_law(film, used, scene, settings);
    const bool is_fitted = film.fit.outcome == analysis::ImpactFitOutcome::fitted;
    const bool is_unpredicted = settings.resamples > 0 && film.fit.predicted < least_predicted;
    if (is_fitted && !is_unpredicted && !(film.fit.scatter > most_scatter)) return film;
    look_for_sustained_contact(film, frames, scene, setting.origin);
    if (!is_fitted || is_unpredicted || film.frames_off_wall < near_wall) film.outcome = FilmFitOutcome::no_law;
    return film;
}

/// A film that is not fitted is one of another size where that is sure at all: no wall is where its impacts are.
FilmFit fit_once(std::span<const analysis::FilmFrame> frames, double period, const FilmedScene& scene,
                 const FilmSetting& setting, const analysis::ImpactFitSettings& settings, const DragSearch& search) {
    FilmFit film = fit_with_size(frames, period, scene, setting, settings, search);
    const double least = film.outcome == FilmFitOutcome::fitted ? most_size_error : least_size_error;
    if (has_another_size(film, scene, least)) film.outcome = FilmFitOutcome::another_size;
    return film;
}

}  // namespace

double unseen_drag_shift(const FilmFit& film) {
    const analysis::DragFit& drag = film.drag.with.drag;
    if (film.arcs.drags.places != 0) return 0;
    if (std::isnan(drag.value)) return analysis::nan;
    std::vector<double> times;
    for (const FilmImpact& impact : film.impacts)
        if (impact.use == KinkUse::used) {
            const analysis::FreeArc &before = film.arcs.arcs[impact.kink.before],
                                    &after = film.arcs.arcs[impact.kink.before + 1];
            times.push_back((before.end - before.start + after.end - after.start) / 2);
        }
    const double most = std::max(0.0, drag.value + analysis::sure_drag * drag.error);
    return most * analysis::quantile(times, 0.5) * film.fit.restitution.value;
}

bool has_another_size(const FilmFit& film, const FilmedScene& scene, double least) {
    constexpr double surely = 5;  // standard errors
    if (!film.size) return false;
    const double off = std::abs(film.size->alpha - scene.alpha);
    return off > surely * film.size->error && off > least;
}

FilmFit fit_film(std::span<const analysis::FilmFrame> frames, double period, const FilmedScene& scene,
                 const FilmSetting& setting, const analysis::ImpactFitSettings& settings) {
    FilmFit film = fit_once(frames, period, scene, setting, settings, {{setting.floor, true}, {}});
    if (film.outcome != FilmFitOutcome::fitted || settings.resamples == 0) return film;
    analysis::ImpactFitSettings values_alone = settings;
    values_alone.resamples = 0;
    const DragSearch alike{{film.drag.floor, false}, film.arcs.drags};
    FilmSetting found = setting;
    found.origin = film.dish.origin;
    std::vector<analysis::ImpactFit> noisier;
    for (std::size_t draw = 0; draw < noisier_films; ++draw) {
        const FilmFit other = fit_once(with_more_noise(frames, film.arcs.noise, settings.seed, draw), period, scene,
                                       found, values_alone, alike);
        if (other.outcome == FilmFitOutcome::fitted) noisier.push_back(other.fit);
    }
    const NoiseShift shift = add_noise_shift(film.fit, noisier);
    film.noisier = noisier.size();
    film.restitution_shift = shift.restitution, film.friction_shift = shift.friction;
    return film;
}

}  // namespace swirl::studies
