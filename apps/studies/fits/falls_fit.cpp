#include "apps/studies/fits/falls_fit.hpp"

#include "analysis/fits/natural_units.hpp"
#include "analysis/fits/robust.hpp"
#include "apps/studies/fits/impact_errors.hpp"
#include "apps/studies/fits/impact_laws.hpp"
#include "apps/studies/fits/noisier_films.hpp"
#include "map/model/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace swirl::studies {

namespace {

using analysis::FilmFrame;
using analysis::Kink;

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
    weights.reserve(fall_of.size());
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
std::vector<std::vector<analysis::MeasuredImpact>> with_other_falls(const DividedFalls& falls,
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
std::vector<analysis::MeasuredImpact> measured_impacts(const DividedFalls& falls, const std::vector<Kink>& used,
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
    std::vector<std::size_t>
        fall_of;  ///< its index in the row, so that draws are the same in whatever order falls are given
};

struct LawOfFalls {
    analysis::ImpactFit fit;
    std::vector<bool> rises;
    FittedGroups groups;
    bool by_falls = false;
};

LawOfFalls fit_law(const DividedFalls& falls, const Impacts& used, const FilmedScene& scene, const FallenBody& body,
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
    for (const analysis::MeasuredImpact& impact : impacts)
        law.rises.push_back(analysis::energy_change({&impact, 1}, law.fit.inertia.value).rises > 0);
    return law;
}

Impacts used_impacts(const DividedFalls& falls) {
    Impacts used;
    used.kinks = used_kinks(falls);
    for (const Kink& kink : used.kinks) used.fall_of.push_back(falls.index_at(kink.time));
    return used;
}

/// A film of which the angle is measured in the other sense.
FallsInARow turned_film(FallsInARow film) {
    for (FilmFrame& frame : film.frames) frame.place[2] *= -1;
    return film;
}

/// Momentum says that the angle is measured clockwise: the other products of the balance, of r_x and the spin, both
/// turn with it. (Where vertices are tells nothing: a body is as high in one sense as in the other.)
bool contradicts_angle(const DividedFalls& falls, const FallenBody& body) {
    if (falls.outcome != FallsFitOutcome::fitted) return false;
    const auto impacts = impacts_on(falls.arcs, used_kinks(falls), scene_of(body), falls.plate, body.radius);
    return analysis::momentum_signs(impacts).tangent < 0;
}

struct SensedFilm {
    FallsInARow film;
    FallsDivisions divisions;
    bool angle_turned = false;
};

SensedFilm in_its_sense(const FallsInARow& film, double period, const FallenBody& body, const FallsSetting& setting) {
    SensedFilm given{film, divided_falls(film, period, body, setting, true), false};
    if (!contradicts_angle(given.divisions.best, body)) return given;
    SensedFilm other{turned_film(film), {}, true};
    other.divisions = divided_falls(other.film, period, body, setting, true);
    const DividedFalls& best = other.divisions.best;
    return best.outcome == FallsFitOutcome::fitted && !contradicts_angle(best, body) ? other : given;
}

void look_for_another_gravity(FallsFit& falls, const FallsInARow& film, double period, const FallenBody& body,
                              FallsSetting setting) {
    setting.gravity.reset();
    const auto found = analysis::settled_fall(film.frames, period, fall_settings(setting, body.radius));
    if (!found) return;
    falls.gravity_of_arcs = -found->fall.model.gravity[1];
    falls.gravity_of_arcs_error = found->fall.error[1];
}

/// The body that the impacts show is the given one.
FallsFitOutcome body_outcome(const FallsFit& falls, const FallenBody& body) {
    const bool is_fitted = falls.outcome == FallsFitOutcome::fitted;
    const bool is_round = falls.body && !falls.body->is_sharp();
    const double most_mark = is_round ? most_round_mark_error : most_mark_error;
    if (has_another_mark(falls, body, is_fitted ? most_mark : least_mark_error)) return FallsFitOutcome::another_mark;
    if (falls.shape) return FallsFitOutcome::another_shape;
    double least = is_round ? most_round_size_error : most_fallen_size_error;
    if (!is_fitted && !is_round) least = least_fallen_size_error;
    return has_another_size(falls, least) ? FallsFitOutcome::another_size : falls.outcome;
}

void fit_divided(FallsFit& falls, const FallenBody& body, const analysis::ImpactFitSettings& settings) {
    LawOfFalls law = fit_law(falls, used_impacts(falls), scene_of(body), body, settings);
    falls.fit = std::move(law.fit);
    falls.rises = std::move(law.rises);
    falls.thinned = law.groups.thinned, falls.alike = law.groups.alike, falls.by_falls = law.by_falls;
    if (falls.fit.outcome != analysis::ImpactFitOutcome::fitted) falls.outcome = FallsFitOutcome::no_law;
}

/// The impacts of which a test of the fall and of the impact's number in it is true.
template <class Test>
SubsetFit subset(const std::string& name, const DividedFalls& falls, const FallenBody& body,
                 const analysis::ImpactFitSettings& settings, Test test) {
    const Impacts all = used_impacts(falls);
    Impacts some;
    for (std::size_t i = 0; i < all.kinks.size(); ++i) {
        const bool is_first = i == 0 || all.fall_of[i] != all.fall_of[i - 1];
        if (test(falls.order[all.fall_of[i]], is_first))
            some.kinks.push_back(all.kinks[i]), some.fall_of.push_back(all.fall_of[i]);
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

std::vector<SubsetFit> subsets_of(const FallsFit& falls, const std::vector<DividedFalls>& others,
                                  const FallenBody& body, const analysis::ImpactFitSettings& settings) {
    std::vector<SubsetFit> subsets;
    const std::size_t count = falls.order.size(), half = count / 2;
    const auto add = [&](const std::string& name, auto test) {
        subsets.push_back(subset(name, falls, body, settings, test));
    };
    if (count > 1) {
        add("odd falls", [](std::size_t fall, bool) { return fall % 2 == 0; });
        add("even falls", [](std::size_t fall, bool) { return fall % 2 == 1; });
        add("first half", [half](std::size_t fall, bool) { return fall < half; });
        add("second half", [half](std::size_t fall, bool) { return fall >= half; });
        add("first impacts", [](std::size_t, bool is_first) { return is_first; });
        add("later impacts", [](std::size_t, bool is_first) { return !is_first; });
    }
    for (const DividedFalls& other : others)
        subsets.push_back(subset("division " + std::to_string(static_cast<int>(other.division)), other, body, settings,
                                 [](std::size_t, bool) { return true; }));
    return subsets;
}

void add_noisier(FallsFit& falls, const FallsInARow& film, double period, const FallenBody& body,
                 const FallsSetting& setting, analysis::ImpactFitSettings settings) {
    settings.resamples = 0;
    std::vector<analysis::ImpactFit> noisier;
    for (std::size_t draw = 0; draw < noisier_films; ++draw) {
        FallsInARow other = film;
        other.frames = with_more_noise(film.frames, falls.tracker_noise, settings.seed, draw);
        FallsFit fit;
        static_cast<DividedFalls&>(fit) = divided_falls(other, period, body, setting, false).best;
        if (fit.outcome == FallsFitOutcome::fitted) fit_divided(fit, body, settings);
        if (fit.outcome == FallsFitOutcome::fitted) noisier.push_back(fit.fit);
    }
    const NoiseShift shift = add_noise_shift(falls.fit, noisier);
    falls.noisier = noisier.size();
    falls.restitution_shift = shift.restitution, falls.friction_shift = shift.friction;
}

}  // namespace

std::vector<FallEvidence> evidence_of(const FallsFit& falls) {
    std::vector<FallEvidence> evidence(falls.order.size());
    const std::vector<bool> free = analysis::falling_arcs(falls.arcs);
    std::size_t used = 0;
    for (const FilmImpact& found : falls.impacts) {
        FallEvidence& of_fall = evidence[falls.fall_at(found.kink.time)];
        if (found.use == KinkUse::used) {
            ++of_fall.used;
            if (used < falls.rises.size() && falls.rises[used]) ++of_fall.rising;
            ++used;
        }
        if (contradicts_plate(found, free)) ++of_fall.contradicting;
    }
    return evidence;
}

namespace {

bool is_surely_off(double off, double error, double least) {
    constexpr double surely = 5;  // standard errors
    return std::abs(off) > surely * error && std::abs(off) > least;
}

}  // namespace

bool has_another_size(const FallsFit& falls, double least) {
    return falls.body && is_surely_off(falls.body->size - 1, falls.body->error, least);
}

bool has_another_gravity(const FallsFit& falls, const FallsSetting& setting, double radius, double least) {
    if (!setting.gravity || std::isnan(falls.gravity_of_arcs)) return false;
    const double given = *setting.gravity / radius;
    return is_surely_off(falls.gravity_of_arcs - given, falls.gravity_of_arcs_error, least * given);
}

double mark_off(const FallsFit& falls, const FallenBody& body) {
    return falls.unmarked->mark - *body.mark;
}

bool has_another_mark(const FallsFit& falls, const FallenBody& body, double least) {
    if (!body.mark || !falls.unmarked) return false;
    return is_surely_off(mark_off(falls, body), std::sqrt(falls.unmarked->errors(1, 1)), least);
}

FallsFit fit_falls(const std::vector<FallFrames>& all, double period, const FallenBody& body,
                   const FallsSetting& setting, const analysis::ImpactFitSettings& settings) {
    const FallsInARow as_given = in_a_row(all, body.radius);
    FallsFit falls;
    if (setting.gravity) look_for_another_gravity(falls, as_given, period, body, setting);
    if (has_another_gravity(falls, setting, body.radius, most_gravity_error)) {
        falls.outcome = FallsFitOutcome::another_gravity;
        return falls;
    }
    const SensedFilm sensed = in_its_sense(as_given, period, body, setting);
    static_cast<DividedFalls&>(falls) = sensed.divisions.best;
    falls.angle_turned = sensed.angle_turned;
    falls.outcome = body_outcome(falls, body);
    if (falls.outcome == FallsFitOutcome::fitted) fit_divided(falls, body, settings);
    if (falls.outcome != FallsFitOutcome::fitted || settings.resamples == 0) return falls;
    add_noisier(falls, sensed.film, period, body, setting, settings);
    const double room = analysis::sure_square_of_three * std::pow(std::max(1.0, falls.fit.scatter), 2);
    const auto predicted = std::count_if(falls.fit.held_out.begin(), falls.fit.held_out.end(),
                                         [room](double square) { return square <= room; });
    falls.predicted_in_scatter = static_cast<double>(predicted) / static_cast<double>(falls.fit.held_out.size());
    falls.subsets = subsets_of(falls, sensed.divisions.others, body, settings);
    return falls;
}

}  // namespace swirl::studies
