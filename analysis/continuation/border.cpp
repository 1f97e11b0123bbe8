#include "analysis/continuation/border.hpp"

#include "analysis/curves/walk.hpp"
#include "analysis/cycles/family.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swirl::analysis {

namespace {

/// F is continuous across a border, and so is the time of each step, unless an impact is gained or lost: then it jumps.
/// Near grazing the time changes by up to 1/margin per unit of length, hence the factor.
bool is_continuous(const ShootingResidual& behind, const ShootingResidual& last, double h) {
    const double tolerated = 1e-6 + std::min(1e3 * h, 1e-2);
    for (std::size_t i = 0; i < last.steps.size(); ++i)
        if (std::abs(behind.steps[i].duration - last.steps[i].duration) > tolerated) return false;
    return true;
}

/// Steps from `base` until a cycle with another itinerary than that of `last` is met; F is continuous across, so that
/// it is as near as the step was long.
bool step_behind(const CurveProblem& problem, const CurvePoint& base, const ShootingResidual& last, double sign,
                 CurvePoint& behind) {
    constexpr double farthest = 1e3;  // DF jumps, so the tangent may lead elsewhere; F does not
    for (double h = 1e-10; h < 1e-4; h *= 10) {
        if (correct(problem, base, sign * h, behind, farthest) != Correction::converged) continue;
        if (behind.shooting.itinerary == last.itinerary || !is_continuous(behind.shooting, last, h)) continue;
        if (problem.product(behind.tangent, base.tangent) * sign < 0) turn(behind);
        return true;
    }
    return false;
}

/// The base with the derivative and tangent of the other side, from a nearby point with another itinerary.
bool seen_from(const ShootingMap& map, const CurvePoint& last, Eigen::Index unknown, double shift, CurvePoint& base) {
    base = last;
    base.y[unknown] += shift;
    const CyclePoints points = base.points();
    const ShootingResidual shooting = shooting_residual(map, points, base.p());
    if (!shooting.alive || shooting.itinerary == last.shooting.itinerary) return false;
    const bool has_tangent = begin_curve(map, points, base.p(), {}, base);
    base.y = last.y;
    return has_tangent;
}

double margin_of(const ShootingResidual& shooting) {
    double least = infinity;
    for (const auto& step : shooting.steps) least = std::min(least, step.margin);
    return least;
}

}  // namespace

void extrapolate_to_border(const ShootingMap& map, CurvePoint& last) {
    constexpr double back = 1e-5;
    const double margin = margin_of(last.shooting);
    if (!(map.least_margin > 0 && margin < 2 * map.least_margin)) return;
    const CurveProblem problem = cycle_problem(map, last.shooting.period, last.p());
    CurvePoint before;
    if (correct(problem, last, -back, before) != Correction::converged) return;
    const double slope = (margin_of(before.shooting) - margin) / back;
    if (!(slope > 0)) return;
    // The cubic through four points of the curve, with the margin as its variable, at 0. They lie a hundred times
    // farther back, at margins of 10⁻⁴: at the last cycle DF is 10⁶, and it is known to 10⁻⁹ only.
    const double apart = 100 * margin / slope;
    std::array<CurvePoint, 4> nodes;
    std::array<double, 4> margins{};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (correct(problem, last, -static_cast<double>(i + 1) * apart, nodes[i]) != Correction::converged) return;
        margins[i] = margin_of(nodes[i].shooting);
        if (!(margins[i] > (i == 0 ? margin : margins[i - 1]))) return;
    }
    Eigen::VectorXd y = Eigen::VectorXd::Zero(last.y.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        double weight = 1;
        for (std::size_t j = 0; j < nodes.size(); ++j)
            if (j != i) weight *= margins[j] / (margins[j] - margins[i]);
        y += weight * nodes[i].y;
    }
    last.y = y;
}

bool find_behind(const ShootingMap& map, const CurvePoint& last, std::vector<std::int64_t>& itinerary_after,
                 CurvePoint& behind) {
    CurveProblem problem = cycle_problem(map, last.shooting.period, last.p());
    problem.keeps_itinerary = false;
    itinerary_after.clear();
    if (step_behind(problem, last, last.shooting, 1, behind)) {
        itinerary_after = behind.shooting.itinerary;
        return true;
    }
    for (const double shift : {1e-9, 1e-7, 1e-5}) {
        for (Eigen::Index j = 0; j < last.y.size(); ++j) {
            for (const double sign : {1.0, -1.0}) {
                CurvePoint base;
                if (!seen_from(map, last, j, sign * shift, base)) continue;
                if (itinerary_after.empty()) itinerary_after = base.shooting.itinerary;
                for (const double direction : {1.0, -1.0})
                    if (step_behind(problem, base, last.shooting, direction, behind)) {
                        itinerary_after = behind.shooting.itinerary;
                        return true;
                    }
            }
        }
    }
    return false;
}

}  // namespace swirl::analysis
