#include "apps/studies/fits/falls_fit.hpp"

#include "analysis/fits/natural_units.hpp"
#include "analysis/fits/robust.hpp"
#include "apps/studies/fits/impact_errors.hpp"
#include "apps/studies/fits/impact_laws.hpp"
#include "apps/studies/fits/noisier_films.hpp"
#include "apps/studies/fits/shown_body.hpp"
#include "map/model/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>

namespace swirl::studies {

namespace {

using analysis::FilmFrame;
using analysis::Kink;
using Eigen::Vector2d;
using Eigen::Vector3d;
using FallFrames = std::vector<FilmFrame>;

/// The falls as one film, and when each begins there.
struct OneFilm {
    FallFrames frames;
    std::vector<double> starts;
};

/// Lengths in R_p; between falls are so many steps, which no arc bridges.
OneFilm in_a_row(const std::vector<FallFrames>& falls, double radius) {
    constexpr double steps_between = 20;
    std::vector<double> steps;
    for (const FallFrames& fall : falls)
        for (std::size_t i = 1; i < fall.size(); ++i) steps.push_back(fall[i].time - fall[i - 1].time);
    if (steps.empty()) throw std::invalid_argument("fit_falls: no fall has two frames");
    const double between = steps_between * analysis::quantile(std::move(steps), 0.5);
    OneFilm film;
    double start = 0;
    for (const FallFrames& fall : falls) {
        film.starts.push_back(start);
        for (FilmFrame frame : fall) {
            frame.time += start - fall.front().time;
            frame.place.head<2>() /= radius;
            film.frames.push_back(frame);
        }
        if (!fall.empty()) start = film.frames.back().time + between;
    }
    return film;
}

FilmedScene scene_of(const FallenBody& body) {
    return {body.sides, 1, 0, body.inertia / (body.radius * body.radius), body.mark};
}

ContactAt on_plate(const FilmedScene& scene, const Plate& plate) {
    return [&scene, &plate](double, const Vector3d& place) { return contact_on(scene, plate, place); };
}

std::vector<Kink> used_kinks(const FallsFit& falls) {
    std::vector<Kink> used;
    for (const FilmImpact& found : falls.impacts)
        if (found.use == KinkUse::used) used.push_back(found.kink);
    return used;
}

FilmNoise noise_of(const analysis::FilmArcs& arcs) {
    return {arcs.place_noise, arcs.angle_noise};
}

/// The plate by the kinks that are an impact: in turn, since the plate tells which are.
void find_plate(FallsFit& falls, const FilmedScene& scene) {
    const FilmNoise noise = noise_of(falls.arcs);
    falls.outcome = FallsFitOutcome::fitted, falls.counts = {};
    const std::vector<bool> free = analysis::falling_arcs(falls.arcs);
    const auto is_free = [&free](const Kink& kink) { return free[kink.before] && free[kink.before + 1]; };
    if (std::isnan(falls.plate.off_plate)) {
        std::vector<Kink> meeting = meeting_kinks(falls.arcs);
        std::erase_if(meeting, [&](const Kink& kink) { return !is_free(kink); });
        const std::optional<Plate> plate = fit_plate(meeting, noise, scene, falls.plate.by_momentum);
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
            if (!is_free(found.kink)) found.use = KinkUse::stays_on_wall;
            if (errors_of(found.kink, noise, scene, found.contact).across > most_error_across_plate)
                found.use = KinkUse::no_meeting;
        }
        const std::vector<Kink> used = used_kinks(falls);
        if (used.size() < fewest_kinks) break;
        if (round + 1 < rounds) falls.plate = refined_plate(used, {}, noise, scene, falls.plate);
    }
    for (const FilmImpact& found : falls.impacts) ++falls.counts[static_cast<std::size_t>(found.use)];
    const auto count = [&](KinkUse use) { return falls.counts[static_cast<std::size_t>(use)]; };
    if (count(KinkUse::used) < analysis::fewest_impacts)
        falls.outcome = 2 * count(KinkUse::off_the_wall) > falls.impacts.size() ? FallsFitOutcome::no_plate
                                                                                : FallsFitOutcome::few_impacts;
}

/// Arcs of which the middle is clear of the plate: bodies that rest or roll are on it.
std::vector<bool> clear_arcs(const FallsFit& falls, const FilmedScene& scene) {
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
double impact_time(const FallsFit& falls, const FilmedScene& scene, const std::vector<bool>& flies) {
    constexpr double near = 0.1;  // R_p
    std::vector<double> squares, steps;
    for (const Kink& kink : analysis::kinks_of(falls.arcs)) {
        const Contact contact = contact_on(scene, falls.plate, kink.place);
        if (std::abs(contact.gap) > near || !flies[kink.before] || !flies[kink.before + 1]) continue;
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
FallsFit by_pieces(const FallsFit& divided, std::size_t longest, const FilmedScene& scene, bool is_given) {
    FallsFit falls = divided;
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

/// Arcs of bodies that fall bend by more than a tracker's noise from frame to frame, for reasons that no model has: a
/// centre that is not quite the tracked one wobbles with the spin, lenses bend, a guide rubs. The division is that of a
/// noise so many times as large, and the pieces of arcs are so long, that the most impacts can be used, of those whose
/// frames are within twice the tracker's own noise; the finer division and the longer pieces where the others do not
/// give a tenth more.
FallsFit best_divided(const OneFilm& film, double period, const FallenBody& body, analysis::FallSettings settings,
                      bool looks_for_body) {
    const FilmedScene scene = scene_of(body);
    FallsFit best;
    best.starts = film.starts, best.outcome = FallsFitOutcome::no_gravity;
    constexpr double factors[] = {1, 3, 10, 30};
    constexpr std::size_t lengths[] = {100'000, 20, 10};  // frames
    constexpr double better = 1.1, wide = 2;
    double most = -1, most_worth = -1;
    std::optional<BodyOnPlate> shown;
    analysis::FilmArcs shown_by;
    analysis::FilmArcs finest;
    for (const double factor : factors) {
        if (factor > 1)
            settings.division_noise << factor * finest.place_noise, factor * finest.place_noise,
                factor * finest.angle_noise;
        const std::optional<analysis::FallingArcs> found = analysis::settled_fall(film.frames, period, settings);
        if (!found || found->fall.model.gravity[1] >= 0) {
            if (factor > 1) continue;
            if (found) best.fall = found->fall, best.arcs = found->arcs, best.outcome = FallsFitOutcome::falls_up;
            return best;
        }
        FallsFit divided;
        divided.starts = film.starts, divided.division = factor, divided.plate.by_momentum = body.inertia_known;
        divided.fall = found->fall, divided.arcs = found->arcs;
        if (factor == 1) settings.start = found->fall.model, finest = found->arcs;
        divided.tracker_noise = finest.noise;
        for (const std::size_t longest : lengths) {
            const FallsFit other = by_pieces(divided, longest, scene, settings.gravity.has_value());
            const auto used = static_cast<double>(other.counts[static_cast<std::size_t>(KinkUse::used)]);
            if (looks_for_body) {
                const auto seen = shown_body(other.arcs, scene);
                if (worth_of(seen) > most_worth || shown_by.arcs.empty())
                    shown = seen, shown_by = other.arcs, most_worth = worth_of(seen);
            }
            const bool is_bent = other.arcs.place_noise > wide * finest.place_noise;
            if (most < 0 || (!is_bent && used > better * most)) best = other, most = used;
        }
    }
    if (looks_for_body) best.body = shown, best.shape = nearer_shape(shown_by, scene);
    return best;
}

/// Impacts in the caller's lengths.
std::vector<analysis::MeasuredImpact> impacts_on(const analysis::FilmArcs& arcs, std::span<const Kink> kinks,
                                                 const FilmedScene& scene, const Plate& plate, double radius) {
    std::vector<analysis::MeasuredImpact> impacts = impacts_at(arcs, kinks, scene, on_plate(scene, plate));
    for (analysis::MeasuredImpact& impact : impacts) impact = analysis::from_units(impact, {radius, radius});
    return impacts;
}

/// The kinks of the same arcs under another gravity.
std::vector<Kink> same_kinks(const analysis::FilmArcs& arcs, const std::vector<Kink>& used) {
    std::vector<Kink> kinks;
    for (const Kink& kink : analysis::kinks_of(arcs))
        if (kinks.size() < used.size() && kink.before == used[kinks.size()].before) kinks.push_back(kink);
    return kinks;
}

/// How often each kink counts in a resample: those of falls that are drawn with replacement, or kinks drawn alone.
std::vector<double> drawn_kinks(const std::vector<std::size_t>& fall_of, bool by_falls, std::uint64_t seed,
                                std::uint64_t index) {
    if (!by_falls) return analysis::bootstrap_weights(fall_of.size(), seed, index);
    std::vector<std::size_t> shown;  // falls that have impacts
    for (const std::size_t fall : fall_of)
        if (shown.empty() || shown.back() != fall) shown.push_back(fall);
    const std::vector<double> drawn = analysis::bootstrap_weights(shown.size(), seed, index);
    std::vector<double> weights;
    for (const std::size_t fall : fall_of)
        weights.push_back(
            drawn[static_cast<std::size_t>(std::lower_bound(shown.begin(), shown.end(), fall) - shown.begin())]);
    return weights;
}

std::size_t shown_falls(const std::vector<std::size_t>& fall_of) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < fall_of.size(); ++i)
        if (i == 0 || fall_of[i] != fall_of[i - 1]) ++count;
    return count;
}

/// The impacts as each step of the fall's errors makes them.
std::vector<std::vector<analysis::MeasuredImpact>> with_other_falls(const FallsFit& falls,
                                                                    const std::vector<Kink>& used,
                                                                    const FilmedScene& scene, double radius) {
    std::vector<std::vector<analysis::MeasuredImpact>> moved;
    for (const analysis::FallModel& model : falls.fall.moved) {
        const analysis::FilmArcs arcs = analysis::with_fall(falls.arcs, model.gravity, model.drags);
        moved.push_back(impacts_on(arcs, same_kinks(arcs, used), scene, falls.plate, radius));
    }
    return moved;
}

/// With their errors, those of the fall included.
std::vector<analysis::MeasuredImpact> measured_impacts(const FallsFit& falls, const std::vector<Kink>& used,
                                                       const FilmedScene& scene, double radius,
                                                       std::span<const std::vector<analysis::MeasuredImpact>> fallen) {
    auto impacts = impacts_at(falls.arcs, used, scene, on_plate(scene, falls.plate));
    for (std::size_t i = 0; i < used.size(); ++i) {
        impacts[i].covariance = impact_covariance(falls.arcs, used[i], scene, falls.plate);
        impacts[i] = analysis::from_units(impacts[i], {radius, radius});
        add_common_errors(impacts[i], i, fallen);
    }
    return impacts;
}

void take_errors(analysis::MeasuredImpact& impact, const analysis::MeasuredImpact& of) {
    impact.error_before = of.error_before, impact.error_after = of.error_after;
    impact.covariance = of.covariance;
}

/// What a law is fitted to.
struct Impacts {
    std::vector<Kink> kinks;
    std::vector<std::size_t> fall_of;
};

struct LawOfFalls {
    analysis::ImpactFit fit;
    FittedGroups groups;
    bool by_falls = false;
};

LawOfFalls fit_law(const FallsFit& falls, const Impacts& used, const FilmedScene& scene, const FallenBody& body,
                   analysis::ImpactFitSettings settings) {
    settings.inertia.reset();
    if (body.inertia_known) settings.inertia = body.inertia;
    settings.stated_errors = settings.fixed_weights = true;
    settings.signs_known = true;  // with another sense of the angle no plate would have been found
    const FilmNoise noise = noise_of(falls.arcs);
    const auto fallen = with_other_falls(falls, used.kinks, scene, body.radius);
    const auto impacts = measured_impacts(falls, used.kinks, scene, body.radius, fallen);
    LawOfFalls law;
    law.groups = fitted_groups(impacts);
    law.by_falls = shown_falls(used.fall_of) >= fewest_drawn_falls;
    const std::vector<analysis::AlikeImpacts>& groups = law.groups.groups;
    settings.resampled = [&](std::uint64_t index) {
        const std::vector<double> weights = drawn_kinks(used.fall_of, law.by_falls, settings.seed, index);
        constexpr std::uint64_t falls_after = 1ULL << 24;  // beyond the draws for clouds
        const Plate plate = refined_plate(used.kinks, weights, noise, scene, falls.plate);
        auto seen = impacts_on(falls.arcs, used.kinks, scene, plate, body.radius);
        for (std::size_t k = 0; k < fallen.size(); ++k)
            add_share(seen, analysis::normal_draws(settings.seed, falls_after + index, k)[0], fallen[k], impacts);
        for (std::size_t i = 0; i < seen.size(); ++i) take_errors(seen[i], impacts[i]);
        analysis::WeighedImpacts drawn = analysis::merged_impacts(seen, weights, groups);
        analysis::move_clouds(drawn, groups, settings.seed, index);
        return drawn;
    };
    const std::vector<double> once(impacts.size(), 1.0);
    law.fit = analysis::fit_impacts(analysis::merged_impacts(impacts, once, groups).impacts, impact_laws(), settings);
    return law;
}

Impacts used_impacts(const FallsFit& falls) {
    Impacts used;
    used.kinks = used_kinks(falls);
    for (const Kink& kink : used.kinks) used.fall_of.push_back(falls.fall_at(kink.time));
    return used;
}

FallsFit fit_once(const OneFilm& film, double period, const FallenBody& body, const FallsSetting& setting,
                  const analysis::ImpactFitSettings& settings, bool looks_for_body) {
    const FilmedScene scene = scene_of(body);
    analysis::FallSettings known;
    known.least_noise = setting.least_noise;
    known.least_noise.head<2>() /= body.radius;
    if (setting.gravity) known.gravity = Vector2d(0, -*setting.gravity / body.radius);
    FallsFit falls = best_divided(film, period, body, known, looks_for_body);
    double least = least_fallen_size_error;
    if (falls.outcome == FallsFitOutcome::fitted && falls.body)
        least = falls.body->is_sharp() ? most_fallen_size_error : most_round_size_error;
    if (falls.shape)
        falls.outcome = FallsFitOutcome::another_shape;
    else if (has_another_size(falls, least))
        falls.outcome = FallsFitOutcome::another_size;
    if (falls.outcome != FallsFitOutcome::fitted) return falls;
    LawOfFalls law = fit_law(falls, used_impacts(falls), scene, body, settings);
    falls.fit = std::move(law.fit);
    falls.thinned = law.groups.thinned, falls.alike = law.groups.alike, falls.by_falls = law.by_falls;
    if (falls.fit.outcome != analysis::ImpactFitOutcome::fitted) falls.outcome = FallsFitOutcome::no_law;
    return falls;
}

/// The impacts of which a test of the fall and of the impact's number in it is true.
template <class Test>
SubsetFit subset(const std::string& name, const FallsFit& falls, const FallenBody& body,
                 const analysis::ImpactFitSettings& settings, Test test) {
    const Impacts all = used_impacts(falls);
    Impacts some;
    for (std::size_t i = 0; i < all.kinks.size(); ++i) {
        const bool is_first = i == 0 || all.fall_of[i] != all.fall_of[i - 1];
        if (test(all.fall_of[i], is_first)) some.kinks.push_back(all.kinks[i]), some.fall_of.push_back(all.fall_of[i]);
    }
    SubsetFit found;
    found.name = name, found.falls = shown_falls(some.fall_of), found.impacts = some.kinks.size();
    if (some.kinks.size() < analysis::fewest_impacts) return found;
    const LawOfFalls law = fit_law(falls, some, scene_of(body), body, settings);
    if (law.fit.outcome != analysis::ImpactFitOutcome::fitted) return found;
    found.restitution = law.fit.restitution, found.friction = law.fit.friction;
    found.friction_open = law.fit.friction_open;
    return found;
}

}  // namespace

bool has_another_size(const FallsFit& falls, double least) {
    constexpr double surely = 5;  // standard errors
    if (!falls.body) return false;
    const double off = std::abs(falls.body->size - 1);
    return off > surely * falls.body->error && off > least;
}

std::size_t FallsFit::fall_at(double time) const {
    const auto after = std::upper_bound(starts.begin(), starts.end(), time);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, after - starts.begin())) - 1;
}

FallsFit fit_falls(const std::vector<FallFrames>& all, double period, const FallenBody& body,
                   const FallsSetting& setting, const analysis::ImpactFitSettings& settings) {
    OneFilm film = in_a_row(all, body.radius);
    FallsFit falls = fit_once(film, period, body, setting, settings, true);
    if (falls.outcome != FallsFitOutcome::fitted || settings.resamples == 0) return falls;
    analysis::ImpactFitSettings values_alone = settings;
    values_alone.resamples = 0;
    std::vector<analysis::ImpactFit> noisier;
    const OneFilm as_measured = film;
    for (std::size_t draw = 0; draw < noisier_films; ++draw) {
        film.frames = with_more_noise(as_measured.frames, falls.tracker_noise, settings.seed, draw);
        const FallsFit other = fit_once(film, period, body, setting, values_alone, false);
        if (other.outcome == FallsFitOutcome::fitted) noisier.push_back(other.fit);
    }
    const NoiseShift shift = add_noise_shift(falls.fit, noisier);
    falls.noisier = noisier.size();
    falls.restitution_shift = shift.restitution, falls.friction_shift = shift.friction;
    const double room = analysis::sure_square_of_three * std::pow(std::max(1.0, falls.fit.scatter), 2);
    const auto predicted = std::count_if(falls.fit.held_out.begin(), falls.fit.held_out.end(),
                                         [room](double square) { return square <= room; });
    falls.predicted_in_scatter = static_cast<double>(predicted) / static_cast<double>(falls.fit.held_out.size());
    const std::size_t half = all.size() / 2;
    const auto add = [&](const std::string& name, auto test) {
        falls.subsets.push_back(subset(name, falls, body, settings, test));
    };
    if (all.size() > 1) {
        add("odd falls", [](std::size_t fall, bool) { return fall % 2 == 0; });
        add("even falls", [](std::size_t fall, bool) { return fall % 2 == 1; });
        add("first half", [half](std::size_t fall, bool) { return fall < half; });
        add("second half", [half](std::size_t fall, bool) { return fall >= half; });
        add("first impacts", [](std::size_t, bool is_first) { return is_first; });
        add("later impacts", [](std::size_t, bool is_first) { return !is_first; });
    }
    return falls;
}

}  // namespace swirl::studies
