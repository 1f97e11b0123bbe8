// The period of an orbit that has settled, or is settling, on a cycle.
#pragma once

#include "analysis/classification/returns.hpp"
#include "analysis/classification/rounding_growth.hpp"
#include "analysis/classification/tail.hpp"
#include "analysis/curves/newton.hpp"
#include "analysis/cycles/cycle.hpp"
#include "analysis/lyapunov/cycle_exponents.hpp"
#include "analysis/lyapunov/lyapunov_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace swirl::analysis {

struct PeriodOptions {
    std::int64_t max_period = 4096;  ///< longest period that is looked for
    double closure = 1e-9;           ///< |Fᵏ(z) − z| of an orbit that has settled
    double vicinity = 1e-2;          ///< an orbit this near to itself after k steps is taken for settling on a k-cycle
    int candidates = 4;              ///< periods tried by Newton's method
    double residual = 1e-12;         ///< |Fᵏ(z) − z| that Newton's method must reach
    double rounding = 1e-6;          ///< a cycle along which rounding grows to more than this is an accident of it
    bool exact_multipliers = true;   ///< always in 100 digits; false: only where double's own can't decide
    bool poor_starts = true;         ///< false: of long candidates only as `most_rise` says
};

/// A state that is to be overwritten: zero where the states of a map are its coordinates.
template <SectionMap M>
State<M> unset_state() {
    if constexpr (iterates_coordinates<M>)
        return State<M>::Zero();
    else
        return {};
}

/// A cycle with what is known of it.
template <SectionMap M>
struct FoundCycle {
    std::int64_t period = 0;                                    ///< 0: none found
    Vector<M::dimension> point = Vector<M::dimension>::Zero();  ///< on the cycle, polished
    State<M> state = unset_state<M>();  ///< there; bit for bit the orbit's own if that is the evidence
    double closure = 0;                 ///< the orbit's own |z_{i+k} − z_i|, largest over its last period
    double residual = 0;                ///< |Fᵏ(z) − z| at the point
    double distance = 0;                ///< from the orbit's last state to the point
    double farthest = 0;                ///< how far that may be, by the orbit's own return and the slowest multiplier
    std::vector<std::complex<double>> multipliers;
    bool family = false;            ///< a multiplier is 1
    bool attracting = false;        ///< `attracts`: all multipliers inside the unit circle, those of a family apart
    bool closure_persists = false;  ///< the orbit itself has closed all along the tail's last quarter
    bool approached = false;  ///< the orbit has come ever nearer, or is within 10⁻⁶ already, and its returns shrink
    double rounding = 0;      ///< of one that returns to `closure`: rounding_growth along it
    bool superstable = false;  ///< the cycle annihilates every direction: an orbit that returns once is on it
};

namespace classification_detail {

/// Without `poor_starts` Newton's method is given up for candidates longer than this where a residual is ten times the
/// best before. In a map of a hexagon (μ = 0.5, e = 0.95, α = 0.5 … 0.6, β = 0.3 … 0.4; 2026-11-26) 824 of 894 such led
/// to no cycle, and took nine tenths of all derivatives: now less than half of that. The 70 that did still do.
constexpr std::int64_t longest_with_poor_start = 200;
constexpr double most_rise = 10;

/// Does the tail come nearer to the cycle from window to window (four of a sixteenth of the tail, or of a period each
/// if that is longer; two of the longest periods; no farther back than where it was more than `approach_begins` away)?
/// An orbit that only passes by, or circles round it on a torus, does not. Within 10⁻⁶, where rounding through
/// sustained contact may stop it, it need not.
template <SectionMap M>
bool approaches(const M& map, const Tail<M>& tail, const std::vector<Vector<M::dimension>>& cycle) {
    const auto k = static_cast<std::int64_t>(cycle.size());
    const auto n = static_cast<std::int64_t>(tail.points.size());
    const std::int64_t length = window_length(n, k);
    const std::int64_t windows = std::min<std::int64_t>(4, n / length);
    const auto farthest = [&](std::int64_t w) {
        double largest = 0;
        for (std::int64_t j = w * length; j < (w + 1) * length;
             ++j)  // j steps before the last state, which is at the cycle's first point
            largest = std::max(largest, distance(map, tail.points[static_cast<std::size_t>(n - 1 - j)],
                                                 cycle[static_cast<std::size_t>((k - j % k) % k)]));
        return largest;
    };
    return shrinks_by_windows(farthest, windows, 2, 1e-6);
}

/// Fᵏ and its derivative at z; false if the map ends on the way, has no derivative there (NaN), or `budget` is spent.
template <SectionMap M>
bool iterate(const M& map, State<M>& z, Matrix<M::dimension>& derivative, std::int64_t k, StepBudget& budget) {
    derivative.setIdentity();
    for (std::int64_t i = 0; i < k; ++i) {
        if (budget.is_spent()) return false;
        const auto step = map.linearise(z);
        budget.spent += step.cost;
        if (!goes_on(map, step) || !step.derivative.allFinite()) return false;
        derivative = step.derivative * derivative;
        z = step.state;
    }
    return true;
}

/// Newton's method for Fᵏ(z) = z, from a point of the orbit itself: for cycles that attract one point is enough,
/// however long they are. It is given up where it leads farther away than any cycle that the orbit settles on is, as
/// on a torus, where Fᵏ − 1 is nearly singular. Returns the least residual reached, +∞ if there was none: the map
/// ended, or `budget` was spent.
template <SectionMap M>
double polish(const M& map, Vector<M::dimension>& point, std::int64_t k, const PeriodOptions& options,
              StepBudget& budget) {
    const Vector<M::dimension> begin = point;
    const auto equations = [&](const Eigen::VectorXd& z) {
        ShootingResidual at;
        const Vector<M::dimension> from = z;
        if (!(distance(map, from, begin) <= 3 * approach_begins)) return at;
        State<M> image = state_at(map, from);
        Matrix<M::dimension> product;
        at.alive = iterate(map, image, product, k, budget);
        if (!at.alive) return at;
        at.gap = difference(map, coordinates(map, image), from);
        at.jacobian = product - Matrix<M::dimension>::Identity();
        return at;
    };
    NewtonRule rule = until_rounding(0.01 * options.residual);
    rule.most_iterations = 20;  // 6 are usual; 20 allow a poor start
    rule.may_rise_until = 3;
    if (!options.poor_starts && k > longest_with_poor_start) rule.most_rise = most_rise;
    Eigen::VectorXd z = point;
    const double residual = newton_of_least_norm(equations, z, rule);
    point = z;
    return residual;
}

/// The point and the k − 1 after it; fewer if the map ends.
template <SectionMap M>
std::vector<Vector<M::dimension>> points_from(const M& map, State<M> z, std::int64_t k) {
    std::vector<Vector<M::dimension>> points{coordinates(map, z)};
    while (static_cast<std::int64_t>(points.size()) < k) {
        const auto step = map.advance(z);
        if (!step.alive) break;
        z = step.state;
        points.push_back(coordinates(map, z));
    }
    return points;
}

/// Multipliers from double's eigenvalues, for a cycle that attracts clearly: ε‖A‖ may move them by its fifth root at
/// worst (a defective one of D = 5), 10⁻³, and the largest is neither nearer to the unit circle nor to 0 than 10⁻².
/// Empty if that is not so.
template <SectionMap M>
std::vector<std::complex<double>> clear_multipliers(const M& map, State<M> z, std::int64_t k, StepBudget& budget) {
    Matrix<M::dimension> derivative;
    if (!iterate(map, z, derivative, k, budget) || !(derivative.norm() < 100)) return {};
    auto multipliers = sorted_multipliers(derivative);
    const double largest = std::abs(multipliers.front());
    if (!(largest < 0.99 && largest > 0.01)) return {};
    return multipliers;
}

/// Multipliers, family and attraction of a cycle whose point and period are known. False if the map ends on it, or
/// `budget` is spent.
template <SectionMap M>
bool judge_multipliers(const M& map, const PeriodOptions& options, FoundCycle<M>& found, StepBudget& budget) {
    if (!options.exact_multipliers) found.multipliers = clear_multipliers(map, found.state, found.period, budget);
    if (found.multipliers.empty()) {
        if (budget.is_spent()) return false;
        const CycleExponents exponents = cycle_exponents(map, found.state, found.period);
        if (exponents.outcome != CycleOutcome::completed) return false;
        found.multipliers = exponents.multipliers;
    }
    found.family = std::any_of(found.multipliers.begin(), found.multipliers.end(), &is_one);
    found.attracting = attracts(found.multipliers);
    return true;
}

/// Fills in the cycle of period k near the orbit's last state, if there is one.
template <SectionMap M>
FoundCycle<M> cycle_near(const M& map, const Tail<M>& tail, std::int64_t k, double closure,
                         const PeriodOptions& options, StepBudget& budget) {
    FoundCycle<M> found;
    found.point = tail.points.back();
    found.residual = polish(map, found.point, k, options, budget);
    if (!(found.residual <= options.residual)) return found;
    found.state = state_at(map, found.point);
    auto points = points_from(map, found.state, k);
    if (static_cast<std::int64_t>(points.size()) < k) return found;
    const auto apart = [&](std::size_t i, std::size_t j) { return distance(map, points[i], points[j]); };
    points.resize(minimal_period(points.size(), options.closure, apart));
    found.period = static_cast<std::int64_t>(points.size());
    if (!judge_multipliers(map, options, found, budget)) return {};
    found.closure = closure;
    // A return of size d after j periods of a cycle with slowest multiplier m means a distance of d/(1 − mʲ).
    const double slowest = slowest_of(found.multipliers);
    found.distance = distance(map, tail.points.back(), found.point);
    const double along = std::pow(slowest, static_cast<double>(k) / static_cast<double>(found.period));
    found.farthest = 10 * std::max(closure, options.residual) / std::max(1 - along, 1e-6);
    found.approached = approaches(map, tail, points) &&
                       returns_shrink(map, tail, k, largest_ratio_of_approach(tail, k, slowest, found.period));
    return found;
}

/// The cycle of an orbit that returns to `closure` after k steps. An attracting one needs no more; else the orbit must
/// have stayed: repelled by a multiplier m it would have left after ln(10⁷)/ln m of the returns along a quarter of the
/// tail. Where Newton's method leads elsewhere (on a border of the map, say) the orbit itself is the evidence.
template <SectionMap M>
FoundCycle<M> cycle_of_closed(const M& map, const Tail<M>& tail, std::int64_t k, double closure,
                              const PeriodOptions& options, StepBudget& budget) {
    auto found = cycle_near(map, tail, k, closure, options, budget);
    const auto quarter = static_cast<std::int64_t>(tail.points.size() / 4);
    const bool closure_persists =
        return_distance(map, tail, k, std::max(k, quarter), options.closure) <= options.closure;
    if (found.period == 0 || found.distance > found.farthest) {
        found = {};
        found.period = k;
        found.point = tail.points.back();
        found.state = tail.last;
        found.closure = found.residual = closure;
    }
    found.closure_persists = closure_persists;
    found.rounding = rounding_growth(map, found.state, found.period);
    return found;
}

}  // namespace classification_detail

/// The smallest k ≤ max_period whose cycle the orbit is on, or is settling on: either it returns to `closure` after k
/// steps, or Newton's method from its last state finds an attracting k-cycle within the distance that its own return
/// suggests, which the tail has come nearer to. Period 0 if neither, or if steps accumulate (`accumulates`). What
/// `budget` ends is not polished: an orbit that returns is then its own evidence, and one that settles has period 0.
/// Cost: max_period² comparisons at worst, few in practice; 4 to 20 k derivatives per candidate.
template <SectionMap M>
FoundCycle<M> find_period(const M& map, const Tail<M>& tail, const PeriodOptions& options, StepBudget& budget) {
    namespace detail = classification_detail;
    const std::int64_t longest =
        std::min<std::int64_t>(options.max_period, static_cast<std::int64_t>(tail.points.size()) / 2);
    detail::NearestReturns near(options.candidates, options.vicinity);
    for (std::int64_t k = 1; k <= longest; ++k) {
        const double returned = detail::return_distance(map, tail, k, k, near.farthest());
        if (returned <= options.closure) {
            auto found = detail::cycle_of_closed(map, tail, k, returned, options, budget);
            const bool lasts = !accumulates(map, tail, found.period, options.vicinity);
            if (lasts && (found.attracting || found.closure_persists)) return found;
            break;  // passes an unstable cycle, or steps accumulate: the multiples of k do, too
        }
        near.add(returned, k);
    }
    FoundCycle<M> best;
    for (const auto& [returned, k] : near.all()) {
        if (!detail::may_approach(map, tail, k)) continue;
        const auto found = detail::cycle_near(map, tail, k, returned, options, budget);
        if (found.period == 0 || !found.attracting || !found.approached || found.distance > found.farthest) continue;
        if (accumulates(map, tail, found.period, options.vicinity)) continue;
        if (best.period == 0 || found.period < best.period) best = found;
    }
    return best;
}

/// Finds the period, whatever the search costs.
template <SectionMap M>
FoundCycle<M> find_period(const M& map, const Tail<M>& tail, const PeriodOptions& options = {}) {
    StepBudget budget;
    return find_period(map, tail, options, budget);
}

// The period of an orbit on a superstable cycle.

/// The cycle of an orbit whose derivatives annihilate every direction: one return is enough, so that periods up to the
/// tail's length are found. The last 64 states must come back to `closure`, and the annihilation must lie within the
/// period: else it may be an unstable cycle in passing. Period 0 if not so. O(n), k derivatives.
template <SectionMap M>
FoundCycle<M> find_superstable_period(const M& map, const Tail<M>& tail, const PeriodOptions& options = {}) {
    constexpr std::int64_t states = 64;
    FoundCycle<M> found;
    const auto n = static_cast<std::int64_t>(tail.points.size());
    for (std::int64_t k = 1; k <= n - states; ++k) {
        const double returned = classification_detail::return_distance(map, tail, k, states, options.closure);
        if (returned > options.closure) continue;
        LyapunovOptions once;
        once.transient = 0;
        once.steps = k;
        const auto growth = largest_exponent(map, tail.last, once);
        if (growth.outcome != LyapunovOutcome::completed || !std::isinf(growth.exponents.front())) break;
        found.period = k;
        found.point = tail.points.back();
        found.state = tail.last;
        found.closure = found.residual = returned;
        found.closure_persists = found.approached = found.superstable = true;
        found.rounding = rounding_growth(map, found.state, k);
        break;
    }
    return found;
}

}  // namespace swirl::analysis
