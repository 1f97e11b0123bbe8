#include "apps/studies/fits/falls_arcs.hpp"

#include "analysis/fits/robust.hpp"
#include "apps/studies/fits/shown_body.hpp"
#include "map/model/scene.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <functional>
#include <stdexcept>
#include <utility>

namespace swirl::studies {

namespace {

using analysis::FilmFrame;
using analysis::Kink;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Of two falls, by their numbers; lost places have an order, too.
bool is_before(const FallFrames& a, const FallFrames& b) {
    const auto frame_is_before = [](const FilmFrame& one, const FilmFrame& other) {
        const double ones[] = {one.time, one.place[0], one.place[1], one.place[2]};
        const double others[] = {other.time, other.place[0], other.place[1], other.place[2]};
        for (std::size_t k = 0; k < 4; ++k)
            if (const auto order = std::strong_order(ones[k], others[k]); std::is_neq(order)) return std::is_lt(order);
        return false;
    };
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), frame_is_before);
}

Vector2d median_place(const std::vector<FallFrames>& falls) {
    std::vector<double> x, y;
    for (const FallFrames& fall : falls)
        for (const FilmFrame& frame : fall)
            if (frame.place.allFinite()) x.push_back(frame.place[0]), y.push_back(frame.place[1]);
    if (x.empty()) return Vector2d::Zero();
    return {analysis::quantile(std::move(x), 0.5), analysis::quantile(std::move(y), 0.5)};
}

/// The plate by the kinks that are an impact: in turn, since the plate tells which are.
void find_plate(DividedFalls& falls, const FilmedScene& scene) {
    const FilmNoise noise = noise_of(falls.arcs);
    falls.outcome = FallsFitOutcome::fitted, falls.counts = {}, falls.contradicting = 0;
    const std::vector<bool> free = analysis::falling_arcs(falls.arcs);
    if (std::isnan(falls.plate.off_plate)) {
        const std::optional<Plate> plate = fit_plate(free_meetings(falls.arcs), noise, scene, falls.plate.by_momentum);
        if (!plate) {
            falls.outcome = FallsFitOutcome::few_kinks;
            return;
        }
        falls.plate = *plate;
    }
    const std::vector<Kink> kinks = analysis::kinks_of(falls.arcs);
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
        falls.impacts = film_impacts(falls.arcs, kinks, scene, on_plate(scene, falls.plate));
        for (FilmImpact& found : falls.impacts) {
            if (found.use != KinkUse::used) continue;
            if (!has_both(free, found.kink)) found.use = KinkUse::stays_on_wall;
            if (errors_of(found.kink, noise, scene, found.contact).across > most_error_across_plate)
                found.use = KinkUse::no_meeting;
        }
        const std::vector<Kink> used = used_kinks(falls);
        if (used.size() < fewest_kinks) break;
        if (round + 1 < rounds) falls.plate = refined_plate(used, {}, noise, scene, falls.plate);
    }
    for (const FilmImpact& found : falls.impacts) {
        ++falls.counts[static_cast<std::size_t>(found.use)];
        if (contradicts_plate(found, free)) ++falls.contradicting;
    }
    if (falls.count(KinkUse::used) < analysis::fewest_impacts)
        falls.outcome = 2 * falls.count(KinkUse::off_the_wall) > falls.impacts.size() ? FallsFitOutcome::no_plate
                                                                                      : FallsFitOutcome::few_impacts;
}

/// Arcs of which the middle is clear of the plate: bodies that rest or roll are on it.
std::vector<bool> clear_arcs(const DividedFalls& falls, const FilmedScene& scene) {
    constexpr double clear = 0.05;  // R_p
    std::vector<bool> flies = analysis::falling_arcs(falls.arcs);
    for (std::size_t k = 0; k < flies.size(); ++k) {
        const analysis::FreeArc& arc = falls.arcs.arcs[k];
        const Contact contact = contact_on(scene, falls.plate, falls.arcs.place_on(arc, arc.mean_time));
        flies[k] = flies[k] && contact.gap < -std::max(clear, 3 * falls.plate.doubt);
    }
    return flies;
}

/// How long impacts last: median of what their arcs' distance tells, over kinks that are near the plate; at most a
/// frame.
double impact_time(const DividedFalls& falls, const FilmedScene& scene, const std::vector<bool>& flies) {
    constexpr double near = 0.1;  // R_p
    std::vector<double> squares, steps;
    for (const Kink& kink : analysis::kinks_of(falls.arcs)) {
        const Contact contact = contact_on(scene, falls.plate, kink.place);
        if (std::abs(contact.gap) > near || !has_both(flies, kink)) continue;
        if (!(contact.next_gap < -near)) continue;  // two vertices do not meet at one time
        squares.push_back(kink.apart_for);
        const analysis::FreeArc& arc = falls.arcs.arcs[kink.before];
        steps.push_back((arc.end - arc.start) / static_cast<double>(arc.count - 1));
    }
    if (squares.size() < fewest_kinks) return 0;
    const double square = analysis::quantile(std::move(squares), 0.5);
    return square > 0 ? std::min(std::sqrt(square), analysis::quantile(std::move(steps), 0.5)) : 0;
}

/// The plate by pieces of arcs, and noise and gravity and drags by those that fly.
DividedFalls by_pieces(const DividedFalls& divided, std::size_t longest, const FilmedScene& scene, bool is_given) {
    DividedFalls falls = divided;
    falls.longest = longest;
    falls.arcs = analysis::end_pieces(divided.arcs, longest);
    constexpr int rounds = 2;
    for (int round = 0; round < rounds; ++round) {
        find_plate(falls, scene);
        if (std::isnan(falls.plate.off_plate)) return falls;
        const std::vector<bool> flies = clear_arcs(falls, scene);
        falls.arcs = analysis::with_noise_of(falls.arcs, flies);
        const auto fall = analysis::fit_fall(falls.arcs, is_given, flies);
        if (!fall) return falls;
        falls.fall = *fall;
        falls.arcs = analysis::with_fall(falls.arcs, fall->model.gravity, fall->model.drags);
        falls.arcs = analysis::with_noise_of(falls.arcs, flies);
        falls.arcs.wandering = analysis::unmodelled_accelerations(falls.arcs, flies);
        falls.arcs.impact_time = 0;
        falls.arcs.impact_time = impact_time(falls, scene, flies);
    }
    find_plate(falls, scene);
    return falls;
}

/// The finer division and the longer pieces where the others do not give a tenth more impacts, and as much more merit:
/// where noise divides well a coarser division only misses small impacts.
bool is_better(const DividedFalls& coarser, const DividedFalls& finer) {
    constexpr double better = 0.1;
    const double merit = merit_of(finer);
    const auto used = [](const DividedFalls& falls) { return static_cast<double>(falls.count(KinkUse::used)); };
    return merit_of(coarser) > merit + better * std::abs(merit) && used(coarser) > (1 + better) * used(finer);
}

/// Frames are off their arcs by more than the tracker's noise is.
bool is_bent(const DividedFalls& falls, double noise) {
    constexpr double wide = 2;
    return falls.arcs.place_noise > wide * noise;
}

/// Of the pieces of arcs of one division the best.
///   noise  of a place, by the finest division
DividedFalls best_pieces(const DividedFalls& divided, const FilmedScene& scene, bool is_given, double noise,
                         const std::function<void(const DividedFalls&)>& look) {
    constexpr std::size_t lengths[] = {100'000, 20, 10};  // frames
    std::optional<DividedFalls> best;
    for (const std::size_t longest : lengths) {
        DividedFalls other = by_pieces(divided, longest, scene, is_given);
        look(other);
        const bool bends = is_bent(other, noise), bent_before = best && is_bent(*best, noise);
        if (!best || (bent_before && !bends) || (bends == bent_before && is_better(other, *best)))
            best = std::move(other);
    }
    return *best;
}

/// What the film shows of the body, by the division that shows it best.
struct ShownBody {
    std::optional<BodyOnPlate> body;
    analysis::FilmArcs arcs;
    double worth = -1;

    void look(const analysis::FilmArcs& other, const FilmedScene& scene) {
        auto seen = shown_body(other, scene);
        if (!(worth_of(seen) > worth || arcs.arcs.empty())) return;
        worth = worth_of(seen), body = std::move(seen), arcs = other;
    }
};

/// By all clear meetings or by the impacts that are used then, and with the body's size as the film shows it: that
/// which is nearest to the given mark, for corners that are round make them differ.
std::optional<Plate> plate_without_mark(const DividedFalls& divided, const analysis::FilmArcs& shown,
                                        const FilmedScene& scene) {
    FilmedScene unmarked = scene;
    unmarked.mark.reset();
    std::vector<Plate> plates;
    if (const auto sized = shown_body(shown, unmarked)) plates.push_back(sized->plate);
    if (const auto plate = fit_plate(free_meetings(divided.arcs), noise_of(divided.arcs), unmarked, false)) {
        plates.push_back(*plate);
        DividedFalls used = divided;
        used.plate = *plate;
        find_plate(used, unmarked);
        plates.push_back(used.plate);
    }
    for (Plate& plate : plates)  // of all vertices the nearest
        plate.mark = *scene.mark + std::remainder(plate.mark - *scene.mark, 2 * pi<double>() / scene.sides);
    const auto off = [&scene](const Plate& plate) { return std::abs(plate.mark - *scene.mark); };
    const auto nearest = std::min_element(plates.begin(), plates.end(),
                                          [&off](const Plate& a, const Plate& b) { return off(a) < off(b); });
    if (nearest == plates.end()) return std::nullopt;
    return *nearest;
}

}  // namespace

bool contradicts_plate(const FilmImpact& found, const std::vector<bool>& free) {
    return found.use == KinkUse::off_the_wall && has_both(free, found.kink);
}

double merit_of(const DividedFalls& falls) {
    return static_cast<double>(falls.count(KinkUse::used)) - static_cast<double>(falls.contradicting);
}

std::size_t DividedFalls::index_at(double time) const {
    const auto after =
        std::upper_bound(order.begin(), order.end(), time, [this](double t, std::size_t k) { return t < starts[k]; });
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, after - order.begin())) - 1;
}

FallsInARow in_a_row(const std::vector<FallFrames>& falls, double radius) {
    constexpr double steps_between = 20;
    std::vector<double> steps;
    for (const FallFrames& fall : falls)
        for (std::size_t i = 1; i < fall.size(); ++i) steps.push_back(fall[i].time - fall[i - 1].time);
    if (steps.empty()) throw std::invalid_argument("in_a_row: no fall has two frames");
    const double between = steps_between * analysis::quantile(std::move(steps), 0.5);
    FallsInARow film;
    for (std::size_t k = 0; k < falls.size(); ++k) film.order.push_back(k);
    std::stable_sort(film.order.begin(), film.order.end(),
                     [&](std::size_t a, std::size_t b) { return is_before(falls[a], falls[b]); });
    const Vector2d origin = median_place(falls);
    film.origin = origin / radius;
    film.starts.resize(falls.size());
    double start = 0;
    for (const std::size_t k : film.order) {
        film.starts[k] = start;
        for (FilmFrame frame : falls[k]) {
            frame.time += start - falls[k].front().time;
            frame.place.head<2>() = (frame.place.head<2>() - origin) / radius;
            film.frames.push_back(frame);
        }
        if (!falls[k].empty()) start = film.frames.back().time + between;
    }
    return film;
}

analysis::FallSettings fall_settings(const FallsSetting& setting, double radius) {
    analysis::FallSettings known;
    known.least_noise = setting.least_noise;
    known.least_noise.head<2>() /= radius;
    if (setting.gravity) known.gravity = Vector2d(0, -*setting.gravity / radius);
    return known;
}

FilmNoise noise_of(const analysis::FilmArcs& arcs) {
    return {arcs.place_noise, arcs.angle_noise};
}

FilmedScene scene_of(const FallenBody& body) {
    return {body.sides, 1, 0, body.inertia / (body.radius * body.radius), body.mark};
}

ContactAt on_plate(const FilmedScene& scene, const Plate& plate) {
    return [&scene, &plate](double, const Vector3d& place) { return contact_on(scene, plate, place); };
}

std::vector<Kink> used_kinks(const DividedFalls& falls) {
    std::vector<Kink> used;
    for (const FilmImpact& found : falls.impacts)
        if (found.use == KinkUse::used) used.push_back(found.kink);
    return used;
}

FallsDivisions divided_falls(const FallsInARow& film, double period, const FallenBody& body,
                             const FallsSetting& setting, bool looks_for_body) {
    const FilmedScene scene = scene_of(body);
    analysis::FallSettings settings = fall_settings(setting, body.radius);
    DividedFalls first;
    first.starts = film.starts, first.order = film.order, first.origin = film.origin;
    first.plate.by_momentum = body.inertia_known;
    FallsDivisions divisions{first, {}};
    divisions.best.outcome = FallsFitOutcome::no_gravity;
    constexpr double factors[] = {1, 3, 10, 30};
    ShownBody shown;
    for (const double factor : factors) {
        const analysis::FilmArcs& finest = first.arcs;
        if (factor > 1)
            settings.division_noise << factor * finest.place_noise, factor * finest.place_noise,
                factor * finest.angle_noise;
        const std::optional<analysis::FallingArcs> found = analysis::settled_fall(film.frames, period, settings);
        if (!found || found->fall.model.gravity[1] >= 0) {
            if (factor > 1) continue;
            if (found)
                divisions.best.fall = found->fall, divisions.best.arcs = found->arcs,
                divisions.best.outcome = FallsFitOutcome::falls_up;
            return divisions;
        }
        if (factor == 1)
            settings.start = found->fall.model, first.arcs = found->arcs, first.tracker_noise = found->arcs.noise;
        DividedFalls divided = first;
        divided.division = factor, divided.fall = found->fall, divided.arcs = found->arcs;
        DividedFalls other = best_pieces(divided, scene, setting.gravity.has_value(), finest.place_noise,
                                         [&](const DividedFalls& pieces) {
                                             if (looks_for_body) shown.look(pieces.arcs, scene);
                                         });
        if (factor == 1) {
            divisions.best = std::move(other);
            continue;
        }
        if (!is_bent(other, finest.place_noise) && is_better(other, divisions.best)) std::swap(other, divisions.best);
        if (other.outcome == FallsFitOutcome::fitted) divisions.others.push_back(std::move(other));
    }
    std::sort(divisions.others.begin(), divisions.others.end(),
              [](const DividedFalls& a, const DividedFalls& b) { return a.division < b.division; });
    if (!looks_for_body) return divisions;
    divisions.best.body = shown.body, divisions.best.shape = nearer_shape(shown.arcs, scene);
    if (scene.mark) divisions.best.unmarked = plate_without_mark(divisions.best, shown.arcs, scene);
    return divisions;
}

std::optional<OtherFall> other_fall(const std::vector<FallFrames>& falls, double period, const FallenBody& body,
                                    const FallsSetting& setting) {
    constexpr std::size_t fewest = 3;
    constexpr double apart = 1.3;
    const analysis::FallSettings known = fall_settings(setting, body.radius);
    std::vector<OtherFall> told;
    std::vector<double> values;
    for (std::size_t k = 0; k < falls.size(); ++k) {
        const FallsInARow alone = in_a_row({falls[k]}, body.radius);
        const auto gravity =
            analysis::first_gravity(analysis::fit_arcs(alone.frames, period, {{}, {}, known.least_noise}));
        if (!gravity) continue;
        told.push_back({k, -body.radius * (*gravity)[1], 0});
        values.push_back(told.back().gravity);
    }
    if (told.size() < fewest) return std::nullopt;
    const double usual = analysis::quantile(std::move(values), 0.5);
    for (OtherFall& fall : told) {
        fall.usual = usual;
        const double share = fall.gravity / usual;
        if (share > 1 / apart && share < apart) continue;
        const FallsInARow alone = in_a_row({falls[fall.number]}, body.radius);
        const auto divided_by = [&](double gravity) {
            const analysis::UniformFall by{{0, -gravity / body.radius}, alone.frames.front().time};
            return analysis::fit_arcs(alone.frames, period, {{}, {}, known.least_noise, by});
        };
        const analysis::FilmArcs own = divided_by(fall.gravity), common = divided_by(usual);
        const double noise = std::min(own.place_noise, common.place_noise);
        const double angle_noise = std::min(own.angle_noise, common.angle_noise);
        const auto cost = [&](const analysis::FilmArcs& arcs) {
            return analysis::cost_of_division(arcs, noise, angle_noise);
        };
        if (cost(own) + analysis::cost_of_arc < cost(common)) return fall;
    }
    return std::nullopt;
}

}  // namespace swirl::studies
