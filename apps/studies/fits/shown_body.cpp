#include "apps/studies/fits/shown_body.hpp"

#include "analysis/fits/gravity.hpp"
#include "apps/studies/fits/film_impacts.hpp"
#include "map/model/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace swirl::studies {

namespace {

using analysis::Kink;

/// What of a film tells the body.
struct Evidence {
    std::vector<Kink> kinks;
    FilmNoise noise;
};

/// Kinks that meet between arcs that fall, and of which noise tells where they are.
std::vector<Kink> clear_meetings(const analysis::FilmArcs& arcs, const FilmNoise& noise, const FilmedScene& scene) {
    std::vector<Kink> kinks = free_meetings(arcs);
    std::erase_if(kinks, [&](const Kink& kink) {
        return !(errors_of(kink, noise, scene, contact_on(scene, {}, kink.place)).across < most_error_across_plate);
    });
    return kinks;
}

/// Those that are clear impacts of one vertex as a first fit has it: with two vertices near the plate a body rocks, and
/// arcs meet beside it.
std::vector<Kink> of_one_vertex(const std::vector<Kink>& kinks, const FilmedScene& scene, const BodyOnPlate& body) {
    constexpr double clear = 0.15;  // of how far the next one is off at most
    FilmedScene sized = scene;
    sized.alpha = body.size;
    const double least = clear * body.size * (1 - std::cos(2 * pi<double>() / scene.sides));
    std::vector<Kink> clear_kinks;
    for (const Kink& kink : kinks) {
        const Contact contact = contact_on(sized, body.plate, kink.place);
        if (contact.next_gap < contact.gap - least) clear_kinks.push_back(kink);
    }
    return clear_kinks;
}

Evidence evidence_of(const analysis::FilmArcs& arcs, const FilmedScene& scene) {
    Evidence film;
    film.noise = {arcs.place_noise, arcs.angle_noise};
    film.kinks = clear_meetings(arcs, film.noise, scene);
    return film;
}

}  // namespace

std::vector<Kink> free_meetings(const analysis::FilmArcs& arcs) {
    const std::vector<bool> free = analysis::falling_arcs(arcs);
    std::vector<Kink> kinks = meeting_kinks(arcs);
    std::erase_if(kinks, [&free](const Kink& kink) { return !has_both(free, kink); });
    return kinks;
}

std::optional<BodyOnPlate> shown_body(const analysis::FilmArcs& arcs, const FilmedScene& scene) {
    constexpr int rounds = 3;
    if (scene.sides == disk_sides) return std::nullopt;
    const Evidence film = evidence_of(arcs, scene);
    std::optional<BodyOnPlate> found = body_on_plate(film.kinks, film.noise, scene);
    for (int round = 0; round < rounds && found; ++round)
        found = body_on_plate(of_one_vertex(film.kinks, scene, *found), film.noise, scene);
    return found;
}

double worth_of(const std::optional<BodyOnPlate>& body) {
    return body ? static_cast<double>(body->kinks) * std::log(1 / std::max(body->scatter, body->expected)) : -1;
}

std::optional<BodyOnPlate> nearer_shape(const analysis::FilmArcs& arcs, const FilmedScene& scene) {
    constexpr double sure = 12, as_noise = 1.5, fitted = 4, far_off = 0.1;  // R_p
    constexpr int most_sides = 12, disk = 2;
    const Evidence film = evidence_of(arcs, scene);
    FilmedScene unmarked = scene;
    unmarked.mark.reset();
    auto given = body_on_plate(film.kinks, film.noise, unmarked);  // a wrong mark is no wrong number of sides
    if (scene.mark) {
        const auto marked = body_on_plate(film.kinks, film.noise, scene);
        if (marked && !(given && given->scatter <= marked->scatter)) given = marked;
    }
    if (given && given->scatter < as_noise * given->expected) return std::nullopt;
    std::optional<BodyOnPlate> nearest;
    for (int sides = disk; sides <= most_sides; ++sides) {
        FilmedScene other = unmarked;
        other.sides = sides == disk ? disk_sides : sides;
        if (other.sides == scene.sides) continue;
        const auto found = body_on_plate(film.kinks, film.noise, other);
        if (found && !(nearest && nearest->scatter <= found->scatter)) nearest = found;
    }
    if (!nearest) return std::nullopt;
    const double off = given ? given->scatter : far_off, least = std::max(nearest->scatter, nearest->expected);
    return (static_cast<double>(film.kinks.size()) - fitted) * std::log(off / least) > sure ? nearest : std::nullopt;
}

}  // namespace swirl::studies
