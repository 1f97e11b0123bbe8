#include "analysis/continuation/border.hpp"

#include "analysis/orbits/cycle.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::analysis {

namespace {

/// Steps from `base` until a cycle with another word than `word` is met; F is continuous across, so that it is as near as
/// the step was long.
bool step_behind(const ShootingMap& map, const CurvePoint& base, const std::vector<std::int64_t>& word,
                 double sign, CurvePoint& behind) {
    CorrectorOptions any;
    any.keep_word = false;
    any.farthest = 1e3;  // DF jumps, so the tangent may lead elsewhere; F does not
    for (double h = 1e-10; h < 1e-4; h *= 10) {
        if (correct(map, base, sign * h, behind, any) != Correction::converged) continue;
        if (word_of(behind.closing) == word) continue;
        if (curve_product(behind.tangent, base.tangent, map.has_parameter, base.points.size()) * sign < 0)
            behind.tangent *= -1;
        return true;
    }
    return false;
}

/// The base as the other side sees it: derivative and tangent of a point aside that has another word.
bool seen_from(const ShootingMap& map, const CurvePoint& last, Eigen::Index coordinate, double shift, CurvePoint& base) {
    Eigen::VectorXd z = stacked(last.points);
    const bool along_parameter = coordinate == z.size();
    if (!along_parameter) z[coordinate] += shift;
    const double p = along_parameter ? last.p + shift : last.p;
    CurvePoint aside;
    const CyclePoints points = unstacked(z, map.dimension);
    const Closing closing = close_cycle(map, points, p);
    if (!closing.alive || word_of(closing) == word_of(last.closing)) return false;
    if (!begin_curve(map, points, p, {}, aside)) return false;
    base = last;
    base.closing = aside.closing;
    base.tangent = aside.tangent;
    return true;
}

}  // namespace

bool find_behind(const ShootingMap& map, const CurvePoint& last, std::vector<std::int64_t>& word_after,
                 CurvePoint& behind) {
    const auto word = word_of(last.closing);
    word_after.clear();
    if (step_behind(map, last, word, 1, behind)) {
        word_after = word_of(behind.closing);
        return true;
    }
    const Eigen::Index unknowns = last.closing.gap.size() + (map.has_parameter ? 1 : 0);
    for (const double shift : {1e-9, 1e-7, 1e-5}) {
        for (Eigen::Index j = 0; j < unknowns; ++j) {
            for (const double sign : {1.0, -1.0}) {
                CurvePoint base;
                if (!seen_from(map, last, j, sign * shift, base)) continue;
                if (word_after.empty()) word_after = word_of(base.closing);
                for (const double way : {1.0, -1.0})
                    if (step_behind(map, base, word, way, behind)) {
                        word_after = word_of(behind.closing);
                        return true;
                    }
            }
        }
    }
    return false;
}

}  // namespace swirl::analysis
