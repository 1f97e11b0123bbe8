// The period of an orbit that has settled, or is settling, on a cycle.
#pragma once

#include "analysis/classification/rounding_growth.hpp"
#include "analysis/classification/tail.hpp"
#include "analysis/lyapunov/cycle_exponents.hpp"
#include "analysis/lyapunov/lyapunov_spectrum.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
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
    double neutral = 1e-6;           ///< a multiplier this near to 1 belongs to a family
    double rounding = 1e-6;          ///< a cycle along which rounding grows to more than this is an accident of it
    bool exact_multipliers = true;   ///< always in 100 digits; false: only where double's own can't decide
    double stable = 1e-8;            ///< an attracting cycle's multipliers are below 1 − stable, those near 1 apart
};

/// A cycle with what is known of it.
template <int D>
struct FoundCycle {
    std::int64_t period = 0;              ///< 0: none found
    Vector<D> point = Vector<D>::Zero();  ///< on the cycle, polished
    double closure = 0;                   ///< the orbit's own |z_{i+k} − z_i|, largest over its last period
    double residual = 0;                  ///< |Fᵏ(z) − z| at the point
    double distance = 0;                  ///< from the orbit's last state to the point
    double farthest = 0;                  ///< how far that may be, by the orbit's own return and the slowest multiplier
    std::vector<std::complex<double>> multipliers;
    bool family = false;            ///< a multiplier is 1
    bool attracting = false;        ///< all multipliers inside the unit circle, those of a family apart
    bool closure_persists = false;  ///< the orbit itself has closed all along the tail's last quarter
    bool approached = false;  ///< the orbit has come ever nearer, or is within 10⁻⁶ already, and its returns shrink
    double rounding = 0;      ///< of one that returns to `closure`: rounding_growth along it
    bool superstable =
        false;  ///< every direction is annihilated on the way: what comes again once comes again for ever
};

namespace classification_detail {

/// Does the tail come nearer to the cycle from window to window (four of a sixteenth of the tail, or of a period each
/// if that is longer; two of the longest periods; no farther back than where it was more than 0.1 away)? An orbit that
/// only passes by, or circles round it on a torus, does not. Within 10⁻⁶, where rounding through sustained contact may
/// stop it, it need not.
template <SectionMap M>
bool approaches(const M& map, const Tail<M::dimension>& tail, const Vector<M::dimension>& point, std::int64_t k) {
    std::vector<Vector<M::dimension>> cycle{point};
    while (static_cast<std::int64_t>(cycle.size()) < k) cycle.push_back(map.advance(cycle.back()).state);
    const auto n = static_cast<std::int64_t>(tail.states.size());
    const std::int64_t length = std::max(k, n / 16);
    const std::int64_t windows = std::min<std::int64_t>(4, n / length);
    double nearer = 0;
    for (std::int64_t w = 0; w < windows; ++w) {
        double farthest = 0;
        for (std::int64_t j = w * length; j < (w + 1) * length;
             ++j)  // j steps before the last state, which is at `point`
            farthest = std::max(farthest, distance(map, tail.states[static_cast<std::size_t>(n - 1 - j)],
                                                   cycle[static_cast<std::size_t>((k - j % k) % k)]));
        if (w == 0 && farthest <= 1e-6) return true;
        if (!(farthest > nearer)) return false;
        if (farthest > 0.1) return w > 0;
        nearer = farthest;
    }
    return windows > 1;
}

/// The orbit's largest return after k steps, over its last `count` states.
template <SectionMap M>
double return_distance(const M& map, const Tail<M::dimension>& tail, std::int64_t k, std::int64_t count,
                       double give_up) {
    const std::int64_t n = static_cast<std::int64_t>(tail.states.size());
    double largest = 0;
    for (std::int64_t j = n - 1; j >= std::max(n - count, k) && largest <= give_up; --j)
        largest = std::max(largest, distance(map, tail.states[static_cast<std::size_t>(j)],
                                             tail.states[static_cast<std::size_t>(j - k)], give_up));
    return largest;
}

/// Do the orbit's returns after k steps shrink along the tail, as an approach makes them: by half, or by half of what
/// the slowest multiplier m of the cycle (of period `period`) predicts, in the logarithm? On a torus near a rational
/// one they stay as they are, and Newton's method finds a cycle there all the same.
template <SectionMap M>
bool returns_shrink(const M& map, const Tail<M::dimension>& tail, std::int64_t k, double slowest, std::int64_t period) {
    const auto n = static_cast<std::int64_t>(tail.states.size());
    const std::int64_t count = std::max(k, n / 16);  // states, so that the phase of a complex multiplier plays no part
    const auto largest = [&](std::int64_t first) {   // from `first` on, to those k steps before
        double farthest = 0;
        for (std::int64_t j = first; j < first + count; ++j)
            farthest = std::max(farthest, distance(map, tail.states[static_cast<std::size_t>(j)],
                                                   tail.states[static_cast<std::size_t>(j - k)]));
        return farthest;
    };
    const double apart = static_cast<double>(n - count - k) / static_cast<double>(period);
    return largest(n - count) <= std::max(0.5, std::pow(slowest, 0.5 * apart)) * largest(k);
}

/// Fᵏ and its derivative at z; false if the map ends on the way.
template <SectionMap M>
bool iterate(const M& map, Vector<M::dimension>& z, Matrix<M::dimension>& derivative, std::int64_t k) {
    derivative.setIdentity();
    for (std::int64_t i = 0; i < k; ++i) {
        const auto step = map.linearise(z);
        if (!step.alive || !step.state.allFinite()) return false;
        derivative = step.derivative * derivative;
        z = step.state;
    }
    return true;
}

/// Newton's method for Fᵏ(z) = z with a minimum-norm step, so that members of a family are found near the start.
/// Returns the residual reached, +∞ if the map ended.
template <SectionMap M>
double polish(const M& map, Vector<M::dimension>& z, std::int64_t k, double goal) {
    constexpr int D = M::dimension;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double best = infinity;
    Vector<D> best_point = z;
    for (int iteration = 0; iteration < 20; ++iteration) {  // quadratic: 6 are usual; 20 allow a poor start
        Vector<D> image = z;
        Matrix<D> derivative;
        if (!iterate(map, image, derivative, k)) break;
        const Vector<D> gap = difference(map, image, z);
        const double residual = gap.template lpNorm<Eigen::Infinity>();
        if (residual < best) {
            best = residual;
            best_point = z;
        } else if (iteration > 3) {
            break;
        }
        if (residual <= 0.01 * goal) break;
        // Sizes known at run time: GCC 12 sees an overrun in Eigen's solver for 1 × 1.
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
        solver.setThreshold(1e-9);
        solver.compute(Matrix<D>::Identity() - derivative);
        z += Vector<D>(solver.solve(Eigen::VectorXd(gap)));
    }
    z = best_point;
    return best;
}

/// The smallest divisor of k after which the cycle through z closes already.
template <SectionMap M>
std::int64_t minimal_period(const M& map, const Vector<M::dimension>& z, std::int64_t k, double closure) {
    Vector<M::dimension> image = z;
    for (std::int64_t d = 1; d < k; ++d) {
        const auto step = map.advance(image);
        if (!step.alive) return k;
        image = step.state;
        if (k % d == 0 && distance(map, image, z) <= closure) return d;
    }
    return k;
}

/// Multipliers from double's eigenvalues, for a cycle that attracts clearly: ε‖A‖ may move them by its fifth root at
/// worst (a defective one of D = 5), 10⁻³, and none is nearer to the unit circle than 10⁻². Empty if that is not so.
template <SectionMap M>
std::vector<std::complex<double>> clear_multipliers(const M& map, Vector<M::dimension> z, std::int64_t k) {
    Matrix<M::dimension> derivative;
    if (!iterate(map, z, derivative, k) || !(derivative.norm() < 100)) return {};
    const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(derivative, false).eigenvalues();
    if (!(values.cwiseAbs().maxCoeff() < 0.99)) return {};
    return {values.data(), values.data() + values.size()};
}

/// Fills in the cycle of period k near the orbit's last state, if there is one.
template <SectionMap M>
FoundCycle<M::dimension> cycle_near(const M& map, const Tail<M::dimension>& tail, std::int64_t k, double closure,
                                    const PeriodOptions& options) {
    FoundCycle<M::dimension> found;
    Vector<M::dimension> z = tail.states.back();
    found.residual = polish(map, z, k, options.residual);
    if (!(found.residual <= options.residual)) return found;
    const std::int64_t returned_after = k;
    k = minimal_period(map, z, k, options.closure);
    if (!options.exact_multipliers) found.multipliers = clear_multipliers(map, z, k);
    if (found.multipliers.empty()) {
        const CycleExponents exponents = cycle_exponents(map, z, k);
        if (exponents.outcome != CycleOutcome::completed) return found;
        found.multipliers = exponents.multipliers;
    }
    found.period = k;
    found.point = z;
    found.closure = closure;
    found.attracting = true;
    for (const auto& multiplier : found.multipliers) {
        if (std::abs(multiplier - 1.0) <= options.neutral)
            found.family = true;
        else if (!(std::abs(multiplier) < 1 - options.stable))
            found.attracting = false;
    }
    // A return of size d after j periods of a cycle with slowest multiplier m means a distance of d/(1 − mʲ).
    double slowest = 0;
    for (const auto& multiplier : found.multipliers)
        if (std::abs(multiplier - 1.0) > options.neutral) slowest = std::max(slowest, std::abs(multiplier));
    found.distance = distance(map, tail.states.back(), z);
    const double along = std::pow(slowest, static_cast<double>(returned_after) / static_cast<double>(k));
    found.farthest = 10 * std::max(closure, options.residual) / std::max(1 - along, 1e-6);
    found.approached = approaches(map, tail, z, k) && returns_shrink(map, tail, returned_after, slowest, k);
    return found;
}

/// The cycle of an orbit that returns to `closure` after k steps. An attracting one needs no more; else the orbit must
/// have stayed: repelled by a multiplier m it would have left after ln(10⁷)/ln m of the returns along a quarter of the
/// tail. Where Newton's method leads elsewhere (on a border of the map, say) the orbit itself is the evidence.
template <SectionMap M>
FoundCycle<M::dimension> cycle_of_closed(const M& map, const Tail<M::dimension>& tail, std::int64_t k, double closure,
                                         const PeriodOptions& options) {
    auto found = cycle_near(map, tail, k, closure, options);
    const auto quarter = static_cast<std::int64_t>(tail.states.size() / 4);
    const bool closure_persists =
        return_distance(map, tail, k, std::max(k, quarter), options.closure) <= options.closure;
    if (found.period == 0 || found.distance > found.farthest) {
        found = {};
        found.period = k;
        found.point = tail.states.back();
        found.closure = found.residual = closure;
    }
    found.closure_persists = closure_persists;
    found.rounding = rounding_growth(map, found.point, found.period);
    return found;
}

}  // namespace classification_detail

/// The smallest k ≤ max_period whose cycle the orbit is on, or is settling on: either it returns to `closure` after k
/// steps, or Newton's method from its last state finds an attracting k-cycle within the distance that its own return
/// suggests, which the tail has come nearer to. Period 0 if neither.
/// Cost: max_period² comparisons at worst, few in practice; 20 k derivatives per candidate.
template <SectionMap M>
FoundCycle<M::dimension> find_period(const M& map, const Tail<M::dimension>& tail, const PeriodOptions& options = {}) {
    namespace detail = classification_detail;
    const std::int64_t longest =
        std::min<std::int64_t>(options.max_period, static_cast<std::int64_t>(tail.states.size()) / 2);
    std::vector<std::pair<double, std::int64_t>> near;
    for (std::int64_t k = 1; k <= longest; ++k) {
        const double returned = detail::return_distance(map, tail, k, k, options.vicinity);
        if (returned <= options.closure) {
            const auto found = detail::cycle_of_closed(map, tail, k, returned, options);
            if (found.attracting || found.closure_persists) return found;
            break;  // passes an unstable cycle: the multiples of k do, too
        }
        if (returned <= options.vicinity) near.emplace_back(returned, k);
    }
    std::sort(near.begin(), near.end());
    FoundCycle<M::dimension> best;
    for (std::size_t i = 0; i < near.size() && i < static_cast<std::size_t>(options.candidates); ++i) {
        const auto found = detail::cycle_near(map, tail, near[i].second, near[i].first, options);
        if (found.period == 0 || !found.attracting || !found.approached || found.distance > found.farthest) continue;
        if (best.period == 0 || found.period < best.period) best = found;
    }
    return best;
}

/// The cycle of an orbit whose derivatives annihilate every direction: one return is enough, so that periods up to the
/// tail's length are found. The last 64 states must come back to `closure`, and the annihilation must lie within the
/// period: else it may be an unstable cycle in passing. Period 0 if not so. O(n), k derivatives.
template <SectionMap M>
FoundCycle<M::dimension> find_superstable_period(const M& map, const Tail<M::dimension>& tail,
                                                 const PeriodOptions& options = {}) {
    constexpr std::int64_t states = 64;
    FoundCycle<M::dimension> found;
    const auto n = static_cast<std::int64_t>(tail.states.size());
    for (std::int64_t k = 1; k <= n - states; ++k) {
        const double returned = classification_detail::return_distance(map, tail, k, states, options.closure);
        if (returned > options.closure) continue;
        LyapunovOptions once;
        once.transient = 0;
        once.steps = k;
        const auto growth = largest_exponent(map, tail.states.back(), once);
        if (growth.outcome != LyapunovOutcome::completed || !std::isinf(growth.exponents.front())) break;
        found.period = k;
        found.point = tail.states.back();
        found.closure = found.residual = returned;
        found.closure_persists = found.approached = found.superstable = true;
        found.rounding = rounding_growth(map, found.point, k);
        break;
    }
    return found;
}

}  // namespace swirl::analysis
