#include "apps/studies/fits/film_impacts.hpp"

#include "analysis/fits/resampling.hpp"
#include "apps/studies/fits/impact_laws.hpp"
#include "map/model/scene.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace swirl::studies {

namespace {

using analysis::FilmArcs;
using analysis::FreeArc;
using analysis::Kink;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// The deviance knows the errors of each impact; that of the dish is common to all, and makes the true minimum worse by
/// some tens. The resamples know it.
constexpr double common_deviance = 100;

/// Beyond so many standard errors noise does not reach.
constexpr double sure = 4;

/// Standard error of a vertex' distance from the wall, of a place whose variance is `share` σ².
double gap_error(const FilmArcs& film, const FilmedScene& scene, double share) {
    const double turned = scene.sides == disk_sides ? 0 : scene.alpha * film.angle_noise;
    return std::sqrt(share) * std::hypot(film.place_noise, turned);
}

/// Contact that lasts bends an arc by up to some 5 of these before it is two; a chord of it is off the wall by that.
constexpr double unseen = 8;

/// The body is clear of the wall at the middle of the arc.
bool leaves_wall(const FilmArcs& film, const FreeArc& arc, const FilmedScene& scene, const DishMotion& dish) {
    const Contact contact = contact_at(scene, dish, arc.mean_time, arc.middle);
    return contact.gap < -unseen * gap_error(film, scene, 1 / static_cast<double>(arc.count));
}

bool lines_meet(const Kink& kink) {
    constexpr double one_place = 13.8;  // χ²(2) beyond which lies 1 in 1000
    const double room = 3 * kink.error;
    return kink.distance <= one_place && kink.time >= kink.earliest - room && kink.time <= kink.latest + room;
}

/// Relative to the wall, in the axes of the contact.
Vector3d in_contact_axes(const Vector3d& velocity, const Vector2d& wall, const Vector2d& normal) {
    const Vector2d relative = velocity.head<2>() - wall;
    return {normal[0] * relative[1] - normal[1] * relative[0], -normal.dot(relative), velocity[2]};
}

analysis::MeasuredImpact measured(const FilmArcs& film, const Kink& kink, const FilmedScene& scene,
                                  const DishMotion& dish, const Contact& contact) {
    const FreeArc &before = film.arcs[kink.before], &after = film.arcs[kink.before + 1];
    const Vector3d noise(film.place_noise, film.place_noise, film.angle_noise);
    const Vector2d wall = dish.velocity(scene, kink.time);
    analysis::MeasuredImpact impact;
    impact.before = in_contact_axes(before.velocity, wall, contact.normal);
    impact.after = in_contact_axes(after.velocity, wall, contact.normal);
    impact.offset << contact.normal[0] * contact.offset[1] - contact.normal[1] * contact.offset[0],
        -contact.normal.dot(contact.offset);
    impact.error_before = noise / std::sqrt(before.spread);
    impact.error_after = noise / std::sqrt(after.spread);
    // An error along the wall turns the axes, and with the body's own the offset.
    const KinkErrors errors = errors_of(kink, {film.place_noise, film.angle_noise}, scene, dish, contact);
    const double impulse = (impact.after - impact.before).head<2>().norm();
    const double of_axes = impulse * errors.along;
    const double of_offset =
        scene.sides == disk_sides ? 0 : impulse * scene.alpha * std::hypot(errors.turn, errors.along) / scene.inertia;
    impact.error_after[0] = std::hypot(impact.error_after[0], of_axes);
    impact.error_after[1] = std::hypot(impact.error_after[1], of_axes);
    impact.error_after[2] = std::hypot(impact.error_after[2], of_offset);
    return impact;
}

KinkUse use_of(const FilmArcs& film, const FilmImpact& found, const FilmedScene& scene, const DishMotion& dish) {
    const Kink& kink = found.kink;
    if (!lines_meet(kink)) return KinkUse::no_meeting;
    const double error = errors_of(kink, {film.place_noise, film.angle_noise}, scene, dish, found.contact).across;
    if (std::abs(found.contact.gap) > sure * error) return KinkUse::off_the_wall;
    if (found.contact.next_gap > -sure * error) return KinkUse::two_vertices;
    if (!leaves_wall(film, film.arcs[kink.before], scene, dish) ||
        !leaves_wall(film, film.arcs[kink.before + 1], scene, dish))
        return KinkUse::stays_on_wall;
    if (analysis::contact_velocity(found.impact.offset, found.impact.before)[1] >= 0) return KinkUse::no_approach;
    return KinkUse::used;
}

/// The kinks whose impacts are fitted.
std::vector<Kink> used_kinks(FilmFit& film) {
    std::vector<Kink> used;
    for (const FilmImpact& found : film.impacts) {
        ++film.counts[static_cast<std::size_t>(found.use)];
        if (found.use == KinkUse::used) used.push_back(found.kink);
    }
    if (used.size() <= most_fitted_impacts) return used;
    film.thinned = used.size() - most_fitted_impacts;
    std::vector<Kink> part;
    for (std::size_t i = 0; i < most_fitted_impacts; ++i) part.push_back(used[i * used.size() / most_fitted_impacts]);
    return part;
}

std::vector<analysis::MeasuredImpact> impacts_at(const FilmArcs& film, std::span<const Kink> kinks,
                                                 const FilmedScene& scene, const DishMotion& dish) {
    std::vector<analysis::MeasuredImpact> impacts;
    for (const Kink& kink : kinks)
        impacts.push_back(measured(film, kink, scene, dish, contact_at(scene, dish, kink.time, kink.place)));
    return impacts;
}

/// The dish by the kinks that are an impact: in turn, since the dish tells which are.
void settle_dish(FilmFit& film, const std::vector<Kink>& kinks, const FilmNoise& noise, const FilmedScene& scene) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
        film.impacts = film_impacts(film.arcs, kinks, scene, film.dish);
        std::vector<Kink> used;
        for (const FilmImpact& found : film.impacts)
            if (found.use == KinkUse::used) used.push_back(found.kink);
        if (used.size() < fewest_kinks) return;
        if (round + 1 < rounds) film.dish = refined_dish(used, {}, noise, scene, film.dish);
    }
}

}  // namespace

std::string_view name_of(KinkUse use) {
    switch (use) {
        case KinkUse::used:
            return "used";
        case KinkUse::no_meeting:
            return "arcs do not meet";
        case KinkUse::off_the_wall:
            return "off the wall";
        case KinkUse::two_vertices:
            return "two vertices";
        case KinkUse::stays_on_wall:
            return "stays on the wall";
        case KinkUse::no_approach:
            return "no approach";
    }
    return "";
}

std::vector<FilmImpact> film_impacts(const FilmArcs& film, std::span<const Kink> kinks, const FilmedScene& scene,
                                     const DishMotion& dish) {
    std::vector<FilmImpact> impacts;
    for (const Kink& kink : kinks) {
        FilmImpact found;
        found.kink = kink;
        found.contact = contact_at(scene, dish, kink.time, kink.place);
        found.impact = measured(film, kink, scene, dish, found.contact);
        found.use = use_of(film, found, scene, dish);
        impacts.push_back(found);
    }
    return impacts;
}

namespace {

/// The film with as much noise again as was found in it, other noise for each draw.
std::vector<analysis::FilmFrame> with_more_noise(std::span<const analysis::FilmFrame> frames,
                                                 const Eigen::Matrix3d& covariance, std::uint64_t seed,
                                                 std::size_t draw) {
    const Eigen::Matrix3d root = covariance.llt().matrixL();
    std::vector<analysis::FilmFrame> noisier(frames.begin(), frames.end());
    for (std::size_t i = 0; i < noisier.size(); ++i) {
        Vector3d& place = noisier[i].place;
        Vector3d added = root * analysis::normal_draws(seed, draw, i);
        added.head<2>() = Eigen::Rotation2Dd(place[2]) * Vector2d(added.head<2>());
        place += added;
    }
    return noisier;
}

FilmFit fit_once(std::span<const analysis::FilmFrame> frames, double period, const FilmedScene& scene,
                 const Eigen::Vector2d& origin, analysis::ImpactFitSettings settings) {
    FilmFit film;
    film.arcs = analysis::fit_arcs(frames, period);
    const std::vector<Kink> kinks = analysis::kinks_of(film.arcs);
    std::vector<Kink> meeting;
    std::copy_if(kinks.begin(), kinks.end(), std::back_inserter(meeting), lines_meet);
    const FilmNoise noise{film.arcs.place_noise, film.arcs.angle_noise};
    const std::optional<DishMotion> dish = fit_dish(meeting, noise, scene, origin);
    film.outcome = dish ? FilmFitOutcome::fitted : FilmFitOutcome::few_kinks;
    if (!dish) return film;
    film.dish = *dish;
    settle_dish(film, kinks, noise, scene);
    const std::vector<Kink> used = used_kinks(film);
    if (used.size() < analysis::fewest_impacts)
        film.outcome = 2 * film.counts[static_cast<std::size_t>(KinkUse::off_the_wall)] > kinks.size()
                           ? FilmFitOutcome::no_wall
                           : FilmFitOutcome::few_impacts;
    else if (film.dish.off_wall > far_off_wall)
        film.outcome = FilmFitOutcome::no_wall;
    if (film.outcome != FilmFitOutcome::fitted) return film;
    settings.inertia = scene.inertia;
    settings.stated_errors = settings.fixed_weights = true;
    settings.rivals_within = common_deviance;
    settings.signs_known = true;  // with another sense of the angle no wall would have been found
    settings.remade = [&](std::span<const double> weights) {
        return impacts_at(film.arcs, used, scene, refined_dish(used, weights, noise, scene, film.dish));
    };
    film.fit = analysis::fit_impacts(impacts_at(film.arcs, used, scene, film.dish), impact_laws(), settings);
    if (film.fit.outcome != analysis::ImpactFitOutcome::fitted) film.outcome = FilmFitOutcome::no_law;
    return film;
}

/// μ of a noisier film that is so many times the other, or less than one over that, is another minimum's.
constexpr double another_minimum = 1.5;

void lengthen(analysis::FittedNumber& number, double shift) {
    number.low = std::max(0.0, number.low - std::max(0.0, shift));
    number.high -= std::min(0.0, shift);
}

/// Intervals longer by what noise does.
void add_noise_shift(FilmFit& film, const std::vector<FilmFit>& noisier) {
    analysis::FittedNumber &e = film.fit.restitution, &mu = film.fit.friction;
    std::vector<double> others;
    double near = 0;
    for (const FilmFit& other : noisier) {
        if (other.outcome != FilmFitOutcome::fitted) continue;
        ++film.noisier;
        film.restitution_shift += other.fit.restitution.value - e.value;
        const double ratio = other.fit.friction.value / mu.value;
        if (film.fit.friction_open || ratio > another_minimum || ratio * another_minimum < 1)
            others.push_back(other.fit.friction.value);
        else
            film.friction_shift += other.fit.friction.value - mu.value, near += 1;
    }
    if (film.noisier == 0) return;
    film.restitution_shift /= static_cast<double>(film.noisier);
    film.friction_shift /= std::max(1.0, near);
    // Resamples of few different impacts may lie to one side of what they are resamples of.
    const double room = std::max(e.value - e.low, e.high - e.value);
    e.low = std::max(0.0, e.value - room), e.high = e.value + room;
    lengthen(e, film.restitution_shift);
    e.high = std::min(1.0, e.high);
    lengthen(mu, film.friction_shift);
    for (const double other : others) mu.low = std::min(mu.low, other), mu.high = std::max(mu.high, other);
    constexpr double held = analysis::largest_friction / 2;  // no impact tells friction from any that is larger
    film.fit.friction_open = film.fit.friction_open || mu.high > held;
    if (film.fit.friction_open) mu.value = mu.high = analysis::nan;
}

}  // namespace

FilmFit fit_film(std::span<const analysis::FilmFrame> frames, double period, const FilmedScene& scene,
                 const Eigen::Vector2d& origin, const analysis::ImpactFitSettings& settings) {
    FilmFit film = fit_once(frames, period, scene, origin, settings);
    if (film.outcome != FilmFitOutcome::fitted || settings.resamples == 0) return film;
    analysis::ImpactFitSettings values_alone = settings;
    values_alone.resamples = 0;
    std::vector<FilmFit> noisier;
    for (std::size_t draw = 0; draw < noisier_films; ++draw)
        noisier.push_back(fit_once(with_more_noise(frames, film.arcs.noise, settings.seed, draw), period, scene,
                                   film.dish.origin, values_alone));
    add_noise_shift(film, noisier);
    return film;
}

}  // namespace swirl::studies
