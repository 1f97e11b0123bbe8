// Names the mode of an orbit, and says why.
#pragma once

#include "analysis/classification/mode.hpp"
#include "analysis/classification/period.hpp"
#include "analysis/classification/tail.hpp"
#include "analysis/lyapunov/exponent_sign.hpp"
#include "analysis/lyapunov/lyapunov_spectrum.hpp"
#include "analysis/recurrence/rates.hpp"
#include "analysis/rotation/rotation_number.hpp"
#include "analysis/special_values.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace swirl::analysis {

struct ClassifyOptions {
    std::int64_t transient = 10'000;     ///< steps before the tail
    std::int64_t collisions = 10'000;    ///< steps of the tail
    double recurrence_threshold = 1e-6;  ///< δ of RC
    double settled_spread = 1.1;         ///< a torus' spread changes by less than this factor along the tail
    double sigmas = 5;                   ///< standard errors from zero that make an exponent positive
    bool conserves = false;              ///< the map keeps volumes: nothing settles, and so nothing is a transient
    bool exhaustive = false;             ///< for those who choose: all steps, whatever the verdict needs
    /// What has not settled is chaotic or undecided, and nothing else is asked (`classify_followed`).
    bool chaos_alone = false;
    PeriodOptions period;
};

/// Everything that a verdict rests on. NaN where something could not be measured.
struct Classification {
    Mode mode = Mode::undecided;
    Kind kind = Kind::none;
    bool ended = false;         ///< the map ended before the tail was whole
    std::vector<double> end;    ///< if so: coordinates of the state that has no next one
    std::int64_t steps = 0;     ///< steps taken, the transient included
    std::int64_t period = 0;    ///< 0: none
    std::vector<double> point;  ///< of the cycle
    std::vector<std::complex<double>> multipliers;
    double mean = nan;  ///< time mean of the observable (over whole periods where there is one)
    double mean_per_step = nan;
    double recurrence_rate = nan;  ///< RC, the main diagonal counted
    double recurrence_rate_without_diagonal = nan;
    double largest_exponent = nan;  ///< per step
    double largest_exponent_error = nan;
    double rotation = nan;  ///< turns per step, of a quasi-periodic orbit
    std::vector<Evidence> evidence;
};

namespace classification_detail {

/// Where nothing else tells either, so many times as many periods are tried by Newton's method: a long one hides among
/// nearer returns of the torus that it was born from.
inline constexpr int more_candidates = 8;

/// What the verdict is made of; filled from a tail by the template below, judged by `decide`.
struct Findings {
    bool has_cycle = false;
    bool is_family = false, attracting = false, closure_persists = false, superstable = false, has_multipliers = false;
    double rounding = 0;  ///< of a cycle that was found, but is none for its sake (FoundCycle::rounding); 0: no such
    double closure = 0, residual = 0, distance = 0, farthest = 0, slowest_multiplier = 0;
    double spread_change = 1;  ///< of the tail's last quarter over its first; far from 1: still settling
    SignEvidence exponent;
    LyapunovOutcome exponent_outcome = LyapunovOutcome::completed;
    RotationNumber rotation;
};

/// The verdict: a cycle and a positive exponent contradict each other; so do chaos and a converged rotation number.
void decide(const Findings& findings, const ClassifyOptions& options, Classification& result);

/// The verdict on an orbit that has settled on an attracting cycle.
void decide_settled(const Findings& findings, const ClassifyOptions& options, Classification& result);

/// The observable after each step of a tail.
template <SectionMap M>
std::vector<double> series_of(const M& map, const Tail<M>& tail, int observable) {
    std::vector<double> series;
    series.reserve(tail.durations.size());
    for (const auto& point : tail.points) series.push_back(point[observable]);
    if (!series.empty()) return series;
    for (const auto& z : tail.states) series.push_back(coordinate(map, z, observable));
    return series;
}

/// Time mean ∫x dt / Σ d_i, with ∫x dt = Σ x_i d_i of a coordinate that is held, and plain mean.
struct Means {
    double per_time = 0;
    double per_step = 0;
};

///   series  of the coordinate
template <SectionMap M>
Means means_of(const Tail<M>& tail, const std::vector<double>& series, int coordinate) {
    const bool integrated = coordinate == integrated_coordinate<M>();
    double integral = 0, time = 0, plain = 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        integral += integrated ? tail.integrals[i] : series[i] * tail.durations[i];
        time += tail.durations[i];
        plain += series[i];
    }
    return {integral / time, plain / static_cast<double>(series.size())};
}

/// Takes a cycle, if one was found, into the findings and the result.
template <SectionMap M>
void take_cycle(const M& map, const FoundCycle<M>& cycle, const ClassifyOptions& options, int observable,
                Findings& findings, Classification& result) {
    if (cycle.rounding > options.period.rounding) findings.rounding = cycle.rounding;
    findings.has_cycle = cycle.period > 0 && findings.rounding == 0;
    if (!findings.has_cycle) return;
    findings.is_family = cycle.family;
    findings.attracting = cycle.attracting;
    findings.closure_persists = cycle.closure_persists;
    findings.superstable = cycle.superstable;
    findings.has_multipliers = !cycle.multipliers.empty();
    findings.farthest = cycle.farthest;
    findings.closure = cycle.closure;
    findings.residual = cycle.residual;
    findings.distance = cycle.distance;
    findings.slowest_multiplier = slowest_of(cycle.multipliers);
    result.period = cycle.period;
    result.point.assign(cycle.point.data(), cycle.point.data() + cycle.point.size());
    result.multipliers = cycle.multipliers;
    const auto once = follow_tail(map, cycle.state, 0, cycle.period);
    if (once.ended) return;
    const Means means = means_of(once, series_of(map, once, observable), observable);
    result.mean = means.per_time;
    result.mean_per_step = means.per_step;
}

/// The spread (root mean square about the mean) of a tail's last quarter over that of its first, of the coordinate in
/// which it changed most. A torus keeps its size; what is still settling shrinks, however slowly.
template <SectionMap M>
double spread_change(const M& map, const Tail<M>& tail) {
    constexpr int D = M::dimension;
    const std::size_t quarter = tail.points.size() / 4;
    const auto spread = [&](std::size_t begin) {
        const Vector<D> origin = tail.points[begin];
        Vector<D> sum = Vector<D>::Zero(), squares = Vector<D>::Zero();
        for (std::size_t i = begin; i < begin + quarter; ++i) {
            const Vector<D> d = difference(map, tail.points[i], origin);
            sum += d;
            squares += d.cwiseProduct(d);
        }
        const Vector<D> mean = sum / static_cast<double>(quarter);
        return Vector<D>((squares / static_cast<double>(quarter) - mean.cwiseProduct(mean)).cwiseMax(0).cwiseSqrt());
    };
    const Vector<D> first = spread(0);
    const Vector<D> last = spread(tail.points.size() - quarter);
    double change = 1;
    for (int i = 0; i < D; ++i) {
        if (!(first[i] > 0 && last[i] > 0)) continue;
        const double ratio = last[i] / first[i];
        if (std::abs(std::log(ratio)) > std::abs(std::log(change))) change = ratio;
    }
    return change;
}

/// A rotation number this near to 0 or ½, in turns over the whole tail, is an angle that swings or a line at the border
/// of the spectrum: what is left of it is rounding, trend and window, and can't be told from rational.
constexpr double fewest_turns = 4;

/// The rotation number, from the first coordinate that gives a converged one: a torus shows in any of them.
template <SectionMap M>
RotationNumber rotation_of(const M& map, const Tail<M>& tail) {
    RotationNumber last;
    std::vector<double> series(tail.points.size());
    for (int i = 0; i < M::dimension; ++i) {
        for (std::size_t j = 0; j < series.size(); ++j) series[j] = tail.points[j][i];
        const double period = map.angle_period(i);
        for (const bool as_angle : {true, false}) {
            if (as_angle && !(period > 0)) continue;
            const RotationNumber rotation =
                as_angle ? rotation_number_of_angle(series, period) : rotation_of_observable(series);
            const double turns = std::abs(std::remainder(rotation.rotation, 0.5)) * static_cast<double>(series.size());
            if (rotation.outcome == RotationOutcome::quasi_periodic && turns >= fewest_turns) return rotation;
            if (last.outcome == RotationOutcome::too_short) last = rotation;
            if (last.outcome == RotationOutcome::quasi_periodic) last.outcome = RotationOutcome::not_converged;
        }
    }
    return last;
}

inline SignOptions sign_options(const ClassifyOptions& options) {
    SignOptions sign;
    sign.sigmas = options.sigmas;
    return sign;
}

/// The largest exponent, and its sign.
inline void take_exponent(const LyapunovSpectrum& spectrum, const ClassifyOptions& options, Findings& findings,
                          Classification& result) {
    findings.exponent_outcome = spectrum.outcome;
    if (spectrum.outcome != LyapunovOutcome::completed) return;
    findings.exponent = judge_sign(spectrum, 0, sign_options(options));
    result.largest_exponent = findings.exponent.exponent;
    result.largest_exponent_error = findings.exponent.standard_error;
}

/// The exponent of a tail in which DF = 0 at a step: −∞, without a derivative.
inline void take_forgotten(Findings& findings, Classification& result) {
    findings.exponent.sign = ExponentSign::negative;
    findings.exponent.exponent = result.largest_exponent = -infinity;
    findings.exponent.standard_error = nan;
}

/// Everything after the search for a period and the exponent of the tail, and the verdict.
///   budget  what a second search for a period may cost
template <SectionMap M>
void look_further(const M& map, const Tail<M>& tail, int observable, const ClassifyOptions& options, Findings& findings,
                  Classification& result, StepBudget& budget) {
    const auto take = [&](const FoundCycle<M>& cycle) {
        take_cycle(map, cycle, options, observable, findings, result);
    };
    const bool superstable = std::isinf(findings.exponent.exponent) && findings.exponent.exponent < 0;
    if (!findings.has_cycle && findings.rounding == 0 && superstable)
        take(find_superstable_period(map, tail, options.period));
    findings.spread_change = spread_change(map, tail);
    if (!findings.has_cycle && findings.rounding == 0 && findings.exponent.sign != ExponentSign::positive) {
        findings.rotation = rotation_of(map, tail);
        PeriodOptions thorough = options.period;
        thorough.candidates *= more_candidates;
        if (findings.rotation.outcome != RotationOutcome::quasi_periodic)
            take(find_period(map, tail, thorough, budget));
    }
    decide(findings, options, result);
}

}  // namespace classification_detail

/// What an orbit's tail tells before any verdict (which stays `undecided`, without evidence): its end if it ended,
/// means and recurrence rate.
template <SectionMap M>
Classification measure_tail(const M& map, const Tail<M>& tail, int observable, double recurrence_threshold) {
    Classification result;
    result.ended = tail.ended;
    result.steps = tail.steps;
    if (tail.ended) {
        const Vector<M::dimension> end = coordinates(map, tail.end);
        result.end.assign(end.data(), end.data() + end.size());
        return result;
    }
    const std::vector<double> series = classification_detail::series_of(map, tail, observable);
    const auto rate = recurrence::recurrence_rate(recurrence::embed_series(series), recurrence_threshold);
    result.recurrence_rate = rate.with_diagonal();
    result.recurrence_rate_without_diagonal = rate.without_diagonal();
    const auto means = classification_detail::means_of(tail, series, observable);
    result.mean = means.per_time;
    result.mean_per_step = means.per_step;
    return result;
}

/// Names the mode of the orbit that a tail is of.
///   observable  the coordinate whose means and recurrence rate are reported (S)
/// In this order: does the tail return to itself (`find_period`)? Is the largest exponent positive (`judge_sign`)? If
/// neither, has it a rotation number and a size that lasts? Disagreement gives `undecided`; the kind is `transient` if
/// the orbit is seen to change still. Cost: n steps of the map and n derivatives for a tail of n.
template <SectionMap M>
Classification classify_tail(const M& map, const Tail<M>& tail, int observable, const ClassifyOptions& options = {}) {
    namespace detail = classification_detail;
    Classification result = measure_tail(map, tail, observable, options.recurrence_threshold);
    if (result.ended) return result;
    detail::Findings findings;
    detail::take_cycle(map, find_period(map, tail, options.period), options, observable, findings, result);
    const auto steps = static_cast<std::int64_t>(tail.points.size());
    if (tail.derivative_is_zero)
        detail::take_forgotten(findings, result);
    else
        detail::take_exponent(detail::exponent_from(map, tail.first, steps), options, findings, result);
    StepBudget budget;
    detail::look_further(map, tail, observable, options, findings, result, budget);
    return result;
}

/// Follows an orbit from `start` and names its mode. Cost: `transient` steps of the map more than `classify_tail`.
template <SectionMap M>
Classification classify(const M& map, const State<M>& start, int observable, const ClassifyOptions& options = {}) {
    return classify_tail(map, follow_tail(map, start, options.transient, options.collisions), observable, options);
}

}  // namespace swirl::analysis
