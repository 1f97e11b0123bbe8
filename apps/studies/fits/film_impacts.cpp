#include "apps/studies/fits/film_impacts.hpp"

#include "apps/studies/scene_map/scene_orbit.hpp"
#include "apps/studies/scene_map/start.hpp"
#include "map/model/scene.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <optional>

namespace swirl::studies {

namespace {

using analysis::FilmArcs;
using analysis::FreeArc;
using analysis::Kink;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Beyond so many standard errors noise does not reach.
constexpr double sure = 4;

/// Standard error of a vertex' distance from the wall, of a place whose variance is `share` σ².
double gap_error(const FilmArcs& film, const FilmedScene& scene, double share) {
    const double turned = scene.sides == disk_sides ? 0 : scene.alpha * film.angle_noise;
    return std::sqrt(share) * std::hypot(film.place_noise, turned);
}

/// Contact that lasts bends an arc until it costs less as two: by then its middle is off the wall by some 6 of these,
/// with its noise by up to 9. Of films of a disk with noise of 1 % a few of a thousand such kinks were beyond 8.
constexpr double unseen = 11;

/// The body is clear of the wall at the middle of the arc.
bool leaves_wall(const FilmArcs& film, const FreeArc& arc, const FilmedScene& scene, const ContactAt& contact_of) {
    const Contact contact = contact_of(arc.mean_time, film.place_on(arc, arc.mean_time));
    return contact.gap <
           -std::hypot(unseen * gap_error(film, scene, 1 / static_cast<double>(arc.count)), sure * contact.doubt);
}

/// Both arcs of the kink do.
bool leave_wall(const FilmArcs& film, const Kink& kink, const FilmedScene& scene, const ContactAt& contact_of) {
    return leaves_wall(film, film.arcs[kink.before], scene, contact_of) &&
           leaves_wall(film, film.arcs[kink.before + 1], scene, contact_of);
}

ContactAt on_dish(const FilmedScene& scene, const DishMotion& dish) {
    return [&scene, &dish](double time, const Vector3d& place) { return contact_at(scene, dish, time, place); };
}

/// Relative to the wall, in the axes of the contact.
Vector3d in_contact_axes(const Vector3d& velocity, const Vector2d& wall, const Vector2d& normal) {
    const Vector2d relative = velocity.head<2>() - wall;
    return {normal[0] * relative[1] - normal[1] * relative[0], -normal.dot(relative), velocity[2]};
}

}  // namespace

analysis::MeasuredImpact in_contact_axes(const Kink& kink, const Contact& contact) {
    analysis::MeasuredImpact impact;
    impact.before = in_contact_axes(kink.velocity_before, contact.wall, contact.normal);
    impact.after = in_contact_axes(kink.velocity_after, contact.wall, contact.normal);
    impact.offset << contact.normal[0] * contact.offset[1] - contact.normal[1] * contact.offset[0],
        -contact.normal.dot(contact.offset);
    return impact;
}

namespace {

analysis::MeasuredImpact measured(const FilmArcs& film, const Kink& kink, const FilmedScene& scene,
                                  const Contact& contact) {
    const FreeArc &before = film.arcs[kink.before], &after = film.arcs[kink.before + 1];
    const Vector3d noise(film.place_noise, film.place_noise, film.angle_noise);
    analysis::MeasuredImpact impact = in_contact_axes(kink, contact);
    const auto error_of = [&](const FreeArc& arc) -> Vector3d {
        return noise.cwiseQuotient(arc.spread.cwiseSqrt()).cwiseProduct(arc.decay(kink.time));
    };
    impact.error_before = error_of(before), impact.error_after = error_of(after);
    // An error along the wall turns the axes, and with the body's own the offset.
    const KinkErrors errors = errors_of(kink, {film.place_noise, film.angle_noise}, scene, contact);
    const double impulse = (impact.after - impact.before).head<2>().norm();
    const double turn = contact.curvature * errors.along;
    const double of_axes = impulse * turn;
    const double of_offset =
        scene.sides == disk_sides ? 0 : impulse * scene.alpha * std::hypot(errors.turn, turn) / scene.inertia;
    impact.error_after[0] = std::hypot(impact.error_after[0], of_axes);
    impact.error_after[1] = std::hypot(impact.error_after[1], of_axes);
    impact.error_after[2] = std::hypot(impact.error_after[2], of_offset);
    return impact;
}

KinkUse use_of(const FilmArcs& film, const FilmImpact& found, const FilmedScene& scene, const ContactAt& contact_of) {
    const Kink& kink = found.kink;
    if (!lines_meet(kink)) return KinkUse::no_meeting;
    const double error = std::hypot(errors_of(kink, {film.place_noise, film.angle_noise}, scene, found.contact).across,
                                    found.contact.doubt);
    if (std::abs(found.contact.gap) > sure * error) return KinkUse::off_the_wall;
    if (found.contact.next_gap > -sure * error) return KinkUse::two_vertices;
    if (!leave_wall(film, kink, scene, contact_of)) return KinkUse::stays_on_wall;
    if (analysis::contact_velocity(found.impact.offset, found.impact.before)[1] >= 0) return KinkUse::no_approach;
    return KinkUse::used;
}

}  // namespace

const KinkUseNames& names_of(KinkUse use) {
    static constexpr KinkUseNames names[kink_uses] = {
        {"used", "used", "used"},
        {"arcs do not meet", "do_not_meet", "arcs that don't meet"},
        {"off the wall", "off_the_wall", "off the wall"},
        {"two vertices", "two_vertices", "two vertices on the wall"},
        {"stays on the wall", "stay_on_wall", "an arc that stays on the wall"},
        {"no approach", "no_approach", "no approach"},
    };
    return names[static_cast<std::size_t>(use)];
}

bool lines_meet(const Kink& kink) {
    constexpr double one_place = 13.8;  // χ²(2) beyond which lies 1 in 1000
    const double room = 3 * kink.error;
    return kink.distance <= one_place && kink.time >= kink.earliest - room && kink.time <= kink.latest + room;
}

std::vector<Kink> meeting_kinks(const FilmArcs& film) {
    std::vector<Kink> kinks = analysis::kinks_of(film);
    std::erase_if(kinks, [](const Kink& kink) { return !lines_meet(kink); });
    return kinks;
}

std::vector<Kink> clear_kinks(const FilmArcs& film, std::span<const Kink> kinks, const FilmedScene& scene,
                              const DishMotion& dish) {
    std::vector<Kink> clear;
    for (const Kink& kink : kinks)
        if (leave_wall(film, kink, scene, on_dish(scene, dish))) clear.push_back(kink);
    return clear;
}

std::vector<FilmImpact> film_impacts(const FilmArcs& film, std::span<const Kink> kinks, const FilmedScene& scene,
                                     const ContactAt& contact_of) {
    std::vector<FilmImpact> impacts;
    for (const Kink& kink : kinks) {
        FilmImpact found;
        found.kink = kink;
        found.contact = contact_of(kink.time, kink.place);
        found.impact = measured(film, kink, scene, found.contact);
        found.use = use_of(film, found, scene, contact_of);
        impacts.push_back(found);
    }
    return impacts;
}

std::vector<FilmImpact> film_impacts(const FilmArcs& film, std::span<const Kink> kinks, const FilmedScene& scene,
                                     const DishMotion& dish) {
    return film_impacts(film, kinks, scene, on_dish(scene, dish));
}

std::vector<analysis::MeasuredImpact> impacts_at(const FilmArcs& film, std::span<const Kink> kinks,
                                                 const FilmedScene& scene, const ContactAt& contact_of) {
    std::vector<analysis::MeasuredImpact> impacts;
    for (const Kink& kink : kinks) impacts.push_back(measured(film, kink, scene, contact_of(kink.time, kink.place)));
    return impacts;
}

std::vector<analysis::MeasuredImpact> impacts_at(const FilmArcs& film, std::span<const Kink> kinks,
                                                 const FilmedScene& scene, const DishMotion& dish) {
    return impacts_at(film, kinks, scene, on_dish(scene, dish));
}

namespace {

/// An arc with a used impact at either end.
std::optional<analysis::FreeArc> first_whole_arc(const FilmFit& film) {
    for (std::size_t i = 0; i + 1 < film.impacts.size(); ++i) {
        const FilmImpact &start = film.impacts[i], &end = film.impacts[i + 1];
        const bool follows = end.kink.before == start.kink.before + 1;
        if (follows && start.use == KinkUse::used && end.use == KinkUse::used) return film.arcs.arcs[end.kink.before];
    }
    return std::nullopt;
}

/// The laboratory turned so that the dish's centre is at (β, 0), in units of the swirl's own rate.
LabStart<double> start_on(const analysis::FreeArc& arc, const DishMotion& dish) {
    const Eigen::Rotation2Dd back(-(dish.rate * arc.mean_time + dish.phase));
    const Eigen::Vector2d place = back * (arc.middle.head<2>() - dish.origin);
    const Eigen::Vector2d velocity = back * arc.velocity.head<2>() / dish.rate;
    return {place[0],
            place[1],
            velocity[0],
            velocity[1],
            arc.middle[2] + dish.mark + back.angle(),
            arc.velocity[2] / dish.rate};
}

}  // namespace

std::vector<SpinStep> simulated_spin(const Scene<double>& found, const FilmFit& film) {
    const std::optional<analysis::FreeArc> arc = first_whole_arc(film);
    if (!arc || film.arcs.drags.any()) return {};
    const double end = (film.arcs.arcs.back().end - arc->mean_time) * film.dish.rate;
    SceneOrbit<double> orbit(found, start_on(*arc, film.dish));
    std::vector<SpinStep> steps = {{arc->mean_time, arc->velocity[2]}};
    double now = 0;
    while (orbit.impacts() < most_steps && orbit.advance(end - now)) {
        now = orbit.frame().time.unwound();
        if (now > end) break;
        steps.push_back({arc->mean_time + now / film.dish.rate, orbit.post_impact().spin * film.dish.rate});
    }
    return steps;
}

}  // namespace swirl::studies
