#include "analysis/continuation/border.hpp"

#include "analysis/cycles/cycle.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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
bool step_behind(const ShootingMap& map, const CurvePoint& base, const ShootingResidual& last, double sign,
                 CurvePoint& behind) {
    CorrectorOptions any;
    any.keep_word = false;
    any.farthest = 1e3;  // DF jumps, so the tangent may lead elsewhere; F does not
    for (double h = 1e-10; h < 1e-4; h *= 10) {
        if (correct(map, base, sign * h, behind, any) != Correction::converged) continue;
        if (word_of(behind.shooting) == word_of(last) || !is_continuous(behind.shooting, last, h)) continue;
        if (curve_product(behind.tangent, base.tangent, map.has_parameter, base.points.size()) * sign < 0)
            behind.tangent *= -1;
        return true;
    }
    return false;
}

/// The base with the derivative and tangent of the other side, from a nearby point with another itinerary.
bool seen_from(const ShootingMap& map, const CurvePoint& last, Eigen::Index coordinate, double shift,
               CurvePoint& base) {
    Eigen::VectorXd z = stacked(last.points);
    const bool along_parameter = coordinate == z.size();
    if (!along_parameter) z[coordinate] += shift;
    const double p = along_parameter ? last.p + shift : last.p;
    CurvePoint aside;
    const CyclePoints points = unstacked(z, map.dimension);
    const ShootingResidual shooting = shooting_residual(map, points, p);
    if (!shooting.alive || word_of(shooting) == word_of(last.shooting)) return false;
    if (!begin_curve(map, points, p, {}, aside)) return false;
    base = last;
    base.shooting = aside.shooting;
    base.tangent = aside.tangent;
    return true;
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
    CurvePoint before;
    if (correct(map, last, -back, before) != Correction::converged) return;
    const double slope = (margin_of(before.shooting) - margin) / back;
    if (!(slope > 0)) return;
    // The cubic through four points of the curve, with the margin as its variable, at 0. They lie a hundred times
    // farther back, at margins of 10⁻⁴: at the last cycle DF is 10⁶, and it is known to 10⁻⁹ only.
    const double apart = 100 * margin / slope;
    std::array<CurvePoint, 4> nodes;
    std::array<double, 4> margins{};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (correct(map, last, -static_cast<double>(i + 1) * apart, nodes[i]) != Correction::converged) return;
        margins[i] = margin_of(nodes[i].shooting);
        if (!(margins[i] > (i == 0 ? margin : margins[i - 1]))) return;
    }
    Eigen::VectorXd z = Eigen::VectorXd::Zero(last.shooting.gap.size());
    double p = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        double weight = 1;
        for (std::size_t j = 0; j < nodes.size(); ++j)
            if (j != i) weight *= margins[j] / (margins[j] - margins[i]);
        z += weight * stacked(nodes[i].points);
        p += weight * nodes[i].p;
    }
    last.points = unstacked(z, map.dimension);
    last.p = p;
}

bool find_behind(const ShootingMap& map, const CurvePoint& last, std::vector<std::int64_t>& word_after,
                 CurvePoint& behind) {
    word_after.clear();
    if (step_behind(map, last, last.shooting, 1, behind)) {
        word_after = word_of(behind.shooting);
        return true;
    }
    const Eigen::Index unknowns = last.shooting.gap.size() + (map.has_parameter ? 1 : 0);
    for (const double shift : {1e-9, 1e-7, 1e-5}) {
        for (Eigen::Index j = 0; j < unknowns; ++j) {
            for (const double sign : {1.0, -1.0}) {
                CurvePoint base;
                if (!seen_from(map, last, j, sign * shift, base)) continue;
                if (word_after.empty()) word_after = word_of(base.shooting);
                for (const double way : {1.0, -1.0})
                    if (step_behind(map, base, last.shooting, way, behind)) {
                        word_after = word_of(behind.shooting);
                        return true;
                    }
            }
        }
    }
    return false;
}

}  // namespace swirl::analysis
