#include "analysis/fits/natural_units.hpp"

#include "analysis/fits/robust.hpp"
#include "analysis/fits/unexcluded.hpp"
#include "analysis/threads.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::analysis {

namespace {

double power_of_two_by(double median) {
    return median > 0 && std::isfinite(median) ? std::exp2(std::round(std::log2(median))) : 1;
}

}  // namespace

NaturalUnits natural_units(std::span<const MeasuredImpact> impacts) {
    std::vector<double> speeds, lengths;
    for (const MeasuredImpact& impact : impacts) {
        speeds.push_back((impact.after - impact.before).head<2>().cwiseAbs().maxCoeff());
        lengths.push_back(std::hypot(impact.offset[0], impact.offset[1]));
    }
    return {power_of_two_by(quantile(std::move(speeds), 0.5)), power_of_two_by(quantile(std::move(lengths), 0.5))};
}

MeasuredImpact in_units(const MeasuredImpact& impact, const NaturalUnits& units) {
    const Eigen::Vector3d of_velocity(1 / units.speed, 1 / units.speed, units.length / units.speed);
    MeasuredImpact scaled = impact;
    for (Eigen::Vector3d* velocity : {&scaled.before, &scaled.after, &scaled.error_before, &scaled.error_after})
        *velocity = velocity->cwiseProduct(of_velocity);
    scaled.offset /= units.length;
    if (impact.covariance) {
        Eigen::Matrix<double, 8, 1> all;
        all << of_velocity, of_velocity, Eigen::Vector2d::Constant(1 / units.length);
        scaled.covariance = all.asDiagonal() * *impact.covariance * all.asDiagonal();
    }
    return scaled;
}

bool has_gross_error(const MeasuredImpact& impact) {
    const double largest = std::max(
        {impact.before.cwiseAbs().maxCoeff(), impact.after.cwiseAbs().maxCoeff(), impact.offset.cwiseAbs().maxCoeff()});
    return !(largest <= gross_error);
}

namespace {

using Laws = std::span<const NamedImpactLaw>;
using Weights = std::vector<double>;

bool recede(std::span<const MeasuredImpact> impacts) {
    std::vector<double> before, after;
    for (const MeasuredImpact& impact : impacts) {
        before.push_back(contact_velocity(impact.offset, impact.before)[1]);
        after.push_back(contact_velocity(impact.offset, impact.after)[1] - before.back());
    }
    return !(quantile(before, 0.5) < 0 && quantile(after, 0.5) > 0);
}

/// k, and errors of the impacts that go with it; in units of the balance's scale unless they were stated.
InertiaFit settle_inertia(std::vector<MeasuredImpact>& impacts, const Weights& weights, double start,
                          const ImpactFitSettings& settings) {
    constexpr int rounds = 4;  // each moves k by a hundredth of the one before
    InertiaFit fit{start, 1};
    for (int round = 0; round < rounds; ++round) {
        if (!settings.stated_errors)
            impacts = with_shared_errors(impacts, fit.inertia, velocity_share(impacts, weights, fit.inertia));
        fit = settings.inertia ? known_inertia(impacts, weights, start) : fit_inertia(impacts, weights, fit.inertia);
        if (settings.stated_errors) return fit;
    }
    for (MeasuredImpact& impact : impacts) impact.error_before *= fit.scale, impact.error_after *= fit.scale;
    return fit;
}

double median_error(const std::vector<MeasuredImpact>& impacts, int component) {
    std::vector<double> errors;
    for (const MeasuredImpact& impact : impacts) {
        errors.push_back(impact.error_before[component]);
        errors.push_back(impact.error_after[component]);
    }
    return quantile(std::move(errors), 0.5);
}

void weigh(std::vector<MeasuredImpact>& impacts, double inertia, Laws laws,
           const std::optional<LawParameters>& parameters) {
    for (MeasuredImpact& impact : impacts) impact = with_fixed_weights(impact, inertia, laws[0].law, parameters);
}

/// All laws at the best one's scale.
void fit_laws(ImpactFit& fit, LawProblem& problem, Laws laws, const ImpactFitSettings& settings) {
    if (settings.fixed_weights) weigh(fit.impacts, problem.inertia, laws, {});
    const RobustStart start = first_parameters(with_law(problem, laws, 0));
    fit.weighed_at = start.parameters;
    if (settings.fixed_weights) weigh(fit.impacts, problem.inertia, laws, start.parameters);
    problem.scale = start.scale;
    for (const NamedImpactLaw& law : laws) fit.laws.push_back({law.name, start.parameters});
    // From the grid's coarse scale down to that of the misfits, which exact impacts have at rounding.
    constexpr int most_rounds = 20;
    constexpr double shrinking = 0.2;
    bool last = false;
    for (int round = 0; round < most_rounds; ++round) {
        double least = infinity;
        for (std::size_t i = 0; i < laws.size(); ++i) {
            const LawProblem with = with_law(problem, laws, i);
            LawFit found;
            if (last) {
                const std::vector<LawFit> minima = minima_of(with, fit.laws[i].parameters, settings.rivals_within);
                found = minima.front();
                for (std::size_t k = 1; k < minima.size(); ++k) fit.rivals.push_back({i, minima[k].parameters});
            } else {
                found = fit_law(with, fit.laws[i].parameters);
            }
            fit.laws[i].parameters = found.parameters;
            fit.laws[i].loss = found.loss;
            constexpr double rounding = 1e-6;  // laws that predict the same: the first of them
            if (found.loss < least * (1 - rounding)) least = found.loss, fit.best = i;
        }
        if (last) break;
        fit.scatter = misfit_scale(with_law(problem, laws, fit.best), fit.laws[fit.best].parameters);
        // Stated errors may be too small, and their fixed weights then count less; misfits below them are chance.
        const double scale = settings.fixed_weights ? std::max(1.0, fit.scatter) : fit.scatter;
        last = scale > 0.9 * problem.scale || round + 2 == most_rounds;
        problem.scale = std::max(scale, shrinking * problem.scale);
    }
    problem.law = &laws[fit.best].law;
    const std::vector<double> best = losses_of(problem, fit.laws[fit.best].parameters);
    fit.law_decided = true;
    for (std::size_t i = 0; i < laws.size(); ++i) {
        if (i == fit.best) continue;
        fit.laws[i].worse_by = worse_by(losses_of(with_law(problem, laws, i), fit.laws[i].parameters), best);
        fit.law_decided = fit.law_decided && fit.laws[i].worse_by > sure_law;
    }
}

struct Resample {
    double restitution, friction;
    double balance;  ///< k by momentum
};

WeighedImpacts resample_of(const ImpactFit& fit, const ImpactFitSettings& settings, std::uint64_t index) {
    if (!settings.resampled) return {fit.impacts, bootstrap_weights(fit.impacts.size(), settings.seed, index)};
    WeighedImpacts drawn = settings.resampled(index);
    for (MeasuredImpact& impact : drawn.impacts) impact = with_signs(impact, fit.signs);
    return drawn;
}

Resample fit_resample(const ImpactFit& fit, const LawProblem& problem, Laws laws, const ImpactFitSettings& settings,
                      std::uint64_t index) {
    auto [impacts, weights] = resample_of(fit, settings, index);
    const double inertia = settle_inertia(impacts, weights, problem.inertia, settings).inertia;
    if (settings.fixed_weights) weigh(impacts, inertia, laws, fit.weighed_at);
    const LawProblem part{impacts, weights, inertia, problem.law, problem.scale};
    LawFit best;
    for (std::size_t i = 0; i < laws.size(); ++i) {
        if (!contends(fit, i)) continue;
        const LawFit found = fit_from(with_law(part, laws, i), starts_of(fit, i));
        if (!(found.loss >= best.loss)) best = found;
    }
    const double balance = settings.inertia ? fit_inertia(impacts, weights, inertia).inertia : inertia;
    return {best.parameters.restitution, best.parameters.friction, balance};
}

FittedNumber interval_of(double value, const std::vector<Resample>& resamples, double Resample::*number) {
    std::vector<double> values;
    values.reserve(resamples.size());
    for (const Resample& resample : resamples) values.push_back(resample.*number);
    return {value, std::min(value, quantile(values, 0.025)), std::max(value, quantile(values, 0.975))};
}

/// k is a moment of inertia per mass, so some tenths of the offsets' r², which are 1 in natural units.
bool is_absurd(double inertia) {
    constexpr double most = 1e6;
    return !(inertia > 1 / most && inertia < most);
}

void bootstrap(ImpactFit& fit, const LawProblem& problem, Laws laws, const ImpactFitSettings& settings) {
    std::vector<Resample> resamples(settings.resamples);
    on_threads(settings.threads, [&] {
        tbb::parallel_for(std::size_t{0}, resamples.size(),
                          [&](std::size_t i) { resamples[i] = fit_resample(fit, problem, laws, settings, i); });
    });
    const LawParameters& best = fit.laws[fit.best].parameters;
    fit.restitution = interval_of(best.restitution, resamples, &Resample::restitution);
    fit.friction = interval_of(best.friction, resamples, &Resample::friction);
    fit.balance = interval_of(
        settings.inertia ? fit_inertia(fit.impacts, problem.weights, problem.inertia).inertia : problem.inertia,
        resamples, &Resample::balance);
    if (is_absurd(fit.balance.high)) fit.balance.high = nan;  // friction turns too little in some resamples
    fit.inertia = settings.inertia ? FittedNumber{problem.inertia, problem.inertia, problem.inertia} : fit.balance;
}

/// Each impact predicted by a fit of the best law to the other parts.
void hold_out(ImpactFit& fit, const LawProblem& problem, const ImpactFitSettings& settings) {
    const std::size_t count = fit.impacts.size();
    const std::vector<std::size_t> part = random_parts(count, settings.parts, settings.seed);
    fit.held_out.assign(count, nan);
    on_threads(settings.threads, [&] {
        tbb::parallel_for(std::size_t{0}, settings.parts, [&](std::size_t held) {
            Weights weights(count);
            for (std::size_t i = 0; i < count; ++i) weights[i] = part[i] == held ? 0 : 1;
            std::vector<MeasuredImpact> impacts = fit.impacts;
            const double inertia = settle_inertia(impacts, weights, problem.inertia, settings).inertia;
            const LawProblem others{impacts, weights, inertia, problem.law, problem.scale};
            const LawFit found = fit_law(others, fit.laws[fit.best].parameters);
            for (std::size_t i = 0; i < count; ++i)
                if (part[i] == held)
                    fit.held_out[i] = predict(impacts[i], others.inertia, *others.law, found.parameters).squared;
        });
    });
    const auto within = std::count_if(fit.held_out.begin(), fit.held_out.end(),
                                      [](double squared) { return squared <= sure_square_of_three; });
    fit.predicted = static_cast<double>(within) / static_cast<double>(count);
}

LossProfile profile_of(const LawProblem& problem, const ImpactFit& fit, double low, double high, bool of_friction) {
    constexpr int points = 41;
    LossProfile profile;
    const std::vector<LawParameters> starts = starts_of(fit, fit.best);
    for (int i = 0; i < points; ++i) {
        const double value = low + (high - low) * i / (points - 1);
        const LawFit found = of_friction ? fit_from(problem, starts, {}, value) : fit_from(problem, starts, value, {});
        profile.values.push_back(value);
        profile.deviances.push_back(2 * (found.loss - fit.laws[fit.best].loss));
    }
    return profile;
}

void profile_both(ImpactFit& fit, const LawProblem& problem) {
    const double e_room = 2 * (fit.restitution.high - fit.restitution.low) + 1e-6;
    fit.restitution_profile = profile_of(problem, fit, std::max(0.0, fit.restitution.low - e_room),
                                         std::min(1.0, fit.restitution.high + e_room), false);
    const double mu_low = fit.friction.low;
    const double mu_room = fit.friction_open ? mu_low : 2 * (fit.friction.high - mu_low) + 1e-6;
    const double mu_high = fit.friction_open ? 3 * mu_low + 0.1 : fit.friction.high + mu_room;
    fit.friction_profile = profile_of(problem, fit, std::max(0.0, mu_low - mu_room), mu_high, true);
}

bool is_known(const ImpactFit& fit) {
    const bool law_known = std::isfinite(fit.laws[fit.best].loss) && std::isfinite(fit.scatter);
    return law_known && std::isfinite(fit.velocity_noise) && std::isfinite(fit.spin_noise);
}

}  // namespace

ImpactFit fit_in_natural_units(std::span<const MeasuredImpact> impacts, Laws laws, const ImpactFitSettings& settings) {
    ImpactFit fit;
    fit.signs = momentum_signs(impacts);
    if (settings.signs_known) fit.signs.spin = fit.signs.tangent = 1;
    for (const MeasuredImpact& impact : impacts) fit.impacts.push_back(with_signs(impact, fit.signs));
    fit.outcome = recede(fit.impacts) ? ImpactFitOutcome::receding : ImpactFitOutcome::fitted;
    if (fit.outcome != ImpactFitOutcome::fitted) return fit;
    const double start = settings.inertia.value_or(first_inertia(fit.impacts));
    if (!(start > 0 && std::isfinite(start)))
        fit.outcome = ImpactFitOutcome::no_inertia;
    else if (is_absurd(start))
        fit.outcome = ImpactFitOutcome::inertia_absurd;
    fit.inertia.value = start;
    if (fit.outcome != ImpactFitOutcome::fitted) return fit;
    const Weights once(fit.impacts.size(), 1.0);
    const InertiaFit balance = settle_inertia(fit.impacts, once, start, settings);
    fit.velocity_noise = median_error(fit.impacts, 0);
    fit.spin_noise = median_error(fit.impacts, 2);
    fit.inertia.value = balance.inertia;
    if (is_absurd(balance.inertia)) fit.outcome = ImpactFitOutcome::inertia_absurd;
    if (fit.outcome != ImpactFitOutcome::fitted) return fit;
    LawProblem problem{fit.impacts, once, balance.inertia, nullptr, 1};
    fit_laws(fit, problem, laws, settings);
    if (!settings.fixed_weights) fit.scatter = problem.scale;
    fit.energy = energy_change(fit.impacts, balance.inertia);
    if (2 * fit.energy.rises > fit.impacts.size()) fit.outcome = ImpactFitOutcome::gains_energy;
    if (!is_known(fit)) fit.outcome = ImpactFitOutcome::not_fitted;
    fit.restitution.value = fit.laws[fit.best].parameters.restitution;
    fit.friction.value = fit.laws[fit.best].parameters.friction;
    if (fit.outcome != ImpactFitOutcome::fitted || settings.resamples == 0) return fit;
    bootstrap(fit, problem, laws, settings);
    if (settings.fixed_weights) add_unexcluded(fit, problem, laws);
    fit.friction_open = any_friction_does(fit, problem, laws);
    if (fit.friction_open) {
        const double least = least_friction(fit, problem, laws);
        const bool has_others = settings.fixed_weights || !fit.rivals.empty();
        fit.friction = {nan, has_others ? std::min(least, fit.friction.low) : least, nan};
    }
    hold_out(fit, problem, settings);
    profile_both(fit, problem);
    fit.residuals = residuals_of(problem, fit.laws[fit.best].parameters);
    fit.constancy = constancy_tests(fit.residuals);
    return fit;
}

}  // namespace swirl::analysis
