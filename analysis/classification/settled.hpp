// Does a quantity that changes ever more slowly come to a limit, and how far is it still from it?
#pragma once

#include "analysis/classification/period.hpp"
#include "analysis/linear_algebra/contraction_norm.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace swirl::analysis {

/// A rate of change ∝ n^(−p): with p > 1 the changes to come have a sum.
struct SlowSettling {
    double exponent = 0;          ///< p; 0 where the changes do not fall steadily
    double remaining = infinity;  ///< what is still to come after the last value
};

/// From the means of a quantity over four equal quarters of the second half of a history (n from 1 to 2): the changes
/// from quarter to quarter, at n = 5/4, 3/2 and 7/4, have one sign and fall. What falls faster than any power gives a
/// large p, and a bound of what is to come.
inline SlowSettling settling_of(std::span<const double, 4> quarters) {
    const double first = quarters[1] - quarters[0], second = quarters[2] - quarters[1],
                 third = quarters[3] - quarters[2];
    SlowSettling result;
    const bool steady = first * second > 0 && second * third > 0 && std::abs(first) > std::abs(second) &&
                        std::abs(second) > std::abs(third);
    if (!steady) return result;
    result.exponent = std::log(first / third) / std::log(7.0 / 5);
    if (result.exponent <= 1) return result;
    const double rate = std::abs(third) / 0.25;  // at n = 7/4
    result.remaining = rate * 2 * std::pow(7.0 / 8, result.exponent) / (result.exponent - 1);
    return result;
}

// Has an orbit come so near to an attracting cycle that no continuation can change its verdict?
// analysis/classification/README.md, "When a verdict is settled".

namespace classification_detail {

/// A k-cycle's linear part A = DFᵏ(z*), and the norm in which it contracts.
template <SectionMap M>
struct LinearPart {
    State<M> point;                ///< z*
    Vector<M::dimension> image;    ///< Fᵏ(z*), z* but for rounding
    Matrix<M::dimension> product;  ///< A
    ContractionNorm norm;
};

/// None where A does not contract, the map ends on the cycle, or `budget` is spent.
template <SectionMap M>
std::optional<LinearPart<M>> linear_part(const M& map, const FoundCycle<M>& cycle, StepBudget& budget) {
    LinearPart<M> part{cycle.state, {}, {}, {}};
    State<M> z = cycle.state;
    if (!iterate(map, z, part.product, cycle.period, budget)) return {};
    part.image = coordinates(map, z);
    auto norm = contraction_norm(part.product);
    if (!norm) return {};
    part.norm = std::move(*norm);
    return part;
}

/// ‖Fᵏ(z* + x) − Fᵏ(z*) − Ax‖: what the linear part leaves out. Infinite where the map ends, or `budget` is spent.
template <SectionMap M>
double beyond_linear(const M& map, const LinearPart<M>& part, std::int64_t k, const Vector<M::dimension>& x,
                     StepBudget& budget) {
    State<M> z = state_at(map, Vector<M::dimension>(coordinates(map, part.point) + x));
    if (follow(map, z, k, {}, budget) < k) return infinity;
    const Vector<M::dimension> moved = difference(map, coordinates(map, z), part.image);
    const Vector<M::dimension> beyond = moved - part.product * x;
    return part.norm.of(beyond);
}

/// Does Fᵏ lead the ball about the cycle's point, of twice the radius at which the orbit is, into itself? It is asked
/// on the 2D axes of the ball, in the norm of the linear part: what that leaves out, the second derivative and borders
/// of the map alike, must stay below half of what it takes, (1 − q)/2 of the radius. A part of second order grows with
/// the radius' square, so that there is a factor of four to what would let the orbit stay away.
/// Cost: k derivatives and 2D k steps.
template <SectionMap M>
bool linear_part_rules(const M& map, const Tail<M>& window, const FoundCycle<M>& cycle, StepBudget& budget) {
    const auto part = linear_part(map, cycle, budget);
    if (!part) return false;
    const ContractionNorm& norm = part->norm;
    const Eigen::VectorXd away = difference(map, window.points.back(), cycle.point);
    // Nearer than this rounding would be seen, not the map: 10⁻¹⁴ in the norm against (1 − q)/2, which is 1/(4 λ_max).
    const double least = 1e-9 * std::max(1.0, 1e-3 * std::pow(norm.largest, 1.5));
    const double radius = 2 * std::max(norm.of(away), least);
    for (int axis = 0; axis < M::dimension; ++axis)
        for (const double side : {radius, -radius}) {
            const Vector<M::dimension> x = norm.axis(axis, side);
            if (!(beyond_linear(map, *part, cycle.period, x, budget) <= 0.5 * (1 - norm.rate) * radius)) return false;
        }
    return true;
}

/// A member of a family attracts but along the family: the member that an orbit comes to is known where its returns are
/// so small that what is still to come does not show.
inline constexpr double member_known = 1e-9;

/// Is what Newton's method found what the orbit settles on?
template <SectionMap M>
bool is_certain(const M& map, const Tail<M>& window, const PeriodOptions& options, const FoundCycle<M>& cycle,
                StepBudget& budget) {
    if (cycle.period == 0 || !cycle.attracting || cycle.distance > cycle.farthest) return false;
    if (accumulates(map, window, cycle.period, options.vicinity)) return false;
    const bool closed = cycle.closure <= options.closure;  // rounding is all that is left: nothing shrinks any more
    if (!closed && !cycle.approached) return false;
    if (cycle.family ? cycle.farthest > member_known : !linear_part_rules(map, window, cycle, budget)) return false;
    return rounding_growth(map, cycle.state, cycle.period) <= options.rounding;
}

}  // namespace classification_detail

/// The cycle on which the orbit has settled for certain, from the last states that were seen of it; period 0: none yet.
/// Near returns (to `vicinity`, over the last k states, k up to a third of them) that have shrunk by half along the
/// window are polished by Newton's method; the cycle must attract, the orbit must have come nearer to it from window to
/// window, and lie where the linear part rules (`linear_part_rules`). A family's member: where returns are below 10⁻¹⁰.
/// Cost: a comparison for each k where nothing is near; else 20 k derivatives and 2D k steps for each candidate, which
/// `budget` counts: none is found where it is spent.
template <SectionMap M>
FoundCycle<M> settled_cycle(const M& map, const Tail<M>& window, const PeriodOptions& options, StepBudget& budget) {
    namespace detail = classification_detail;
    const auto n = static_cast<std::int64_t>(window.points.size());
    std::vector<std::pair<double, std::int64_t>> near;
    for (std::int64_t k = 1; k <= std::min(options.max_period, n / 3); ++k) {
        const double returned = detail::return_distance(map, window, k, k, options.vicinity);
        if (returned > options.vicinity) continue;
        const bool closed = returned <= options.closure;
        if (closed || detail::returns_shrink(map, window, k, 0.5)) near.emplace_back(returned, k);
        if (closed) break;  // its multiples are closed, too
    }
    std::stable_sort(near.begin(), near.end());
    std::int64_t not_yet = 0;  // the period of a cycle that is near, but not certain: its multiples are the same
    for (std::size_t i = 0; i < near.size() && i < static_cast<std::size_t>(options.candidates); ++i) {
        const auto [returned, k] = near[i];
        if (not_yet > 0 && k % not_yet == 0) continue;
        auto cycle = detail::cycle_near(map, window, k, returned, options, budget);
        if (detail::is_certain(map, window, options, cycle, budget)) return cycle;
        if (cycle.period > 0) not_yet = cycle.period;
    }
    return {};
}

}  // namespace swirl::analysis
