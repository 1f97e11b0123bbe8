#include "analysis/continuation/locate.hpp"

#include "analysis/continuation/multipliers.hpp"
#include "analysis/special_values.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace swirl::analysis {

namespace {

/// A(z_1) = D(Fᵏ), ∂(Fᵏ)/∂p and dz_1/dp.
CriticalPoint critical_point(const ShootingMap& map, const CurvePoint& at) {
    CriticalPoint critical;
    critical.derivative = monodromy(at.shooting);
    critical.by_parameter = Eigen::VectorXd::Zero(map.dimension);
    for (const auto& step : at.shooting.steps)
        critical.by_parameter = step.by_state * critical.by_parameter + step.by_parameter;
    critical.branch_slope = at.tangent.head(map.dimension) / at.parameter_slope();
    return critical;
}

std::optional<NormalForm> form_of(const ShootingMap& map, const SpecialPoint& special,
                                  const ContinuationOptions& options) {
    if (!options.forms || !map.has_parameter) return std::nullopt;
    const CurvePoint& at = special.cycle.at;
    CriticalPoint critical = critical_point(map, at);
    critical.forms = options.forms(at.points, at.p);
    if (special.kind == SpecialKind::fold) return fold_form(critical);
    if (special.kind == SpecialKind::flip) return flip_form(critical);
    if (special.kind != SpecialKind::neimark_sacker) return std::nullopt;
    for (const auto& m : special.cycle.multipliers)
        if (m.imag() > 0 && std::abs(std::abs(m) - 1) < 1e-6) return neimark_sacker_form(critical, m);
    return std::nullopt;
}

/// How far from the unit circle the complex multipliers are, at most.
double off_circle(const BranchPoint& point) {
    double largest = 0;
    for (const auto& m : point.multipliers)
        if (m.imag() > 0) largest = std::max(largest, std::abs(std::abs(m) - 1));
    return largest;
}

std::ptrdiff_t count_outside(const BranchPoint& point) {
    return std::count_if(point.multipliers.begin(), point.multipliers.end(),
                         [](const auto& m) { return std::abs(m) > 1; });
}

bool has_pair_near_circle(const BranchPoint& point) {
    return std::any_of(point.multipliers.begin(), point.multipliers.end(),
                       [](const auto& m) { return m.imag() > 0 && std::abs(m) > 0.5 && std::abs(m) < 2; });
}

/// May a pair have crossed the unit circle between two points at which the pairs' function has different signs? Where
/// none did, either two real ones passed the product 1 (a neutral saddle), or the function is rounding alone. It is
/// that on maps that keep their pairs on the circle, reversible and conservative ones, and where one multiplier is so
/// large that its product with the rounding of another is no small part of 1.
bool pair_may_cross(const BranchPoint& base, const BranchPoint& next) {
    if (std::max(off_circle(base), off_circle(next)) < neutral_margin) return false;
    return count_outside(base) != count_outside(next) || has_pair_near_circle(base) || has_pair_near_circle(next);
}

/// A zero that can't be located stands where the multipliers at both ends tell of it.
bool is_seen_at_ends(SpecialKind kind, const BranchPoint& base, const BranchPoint& next) {
    return kind != SpecialKind::neimark_sacker || count_outside(base) != count_outside(next);
}

/// A zero of the pairs' function is a Neimark–Sacker point only if the pair is complex.
bool is_what_it_seems(const SpecialPoint& special) {
    if (special.kind != SpecialKind::neimark_sacker) return true;
    return std::any_of(special.cycle.multipliers.begin(), special.cycle.multipliers.end(),
                       [](const auto& m) { return m.imag() > 1e-6 && std::abs(std::abs(m) - 1) < 1e-6; });
}

}  // namespace

bool locate(const ShootingMap& map, const CurvePoint& base, double h, double f0, double f1,
            const std::function<double(const CurvePoint&)>& value, CurvePoint& found) {
    const auto at = [&](double s) {
        return correct(map, base, s, found) == Correction::converged ? value(found) : nan;
    };
    double low = 0, high = h;
    if (f0 == 0 || f1 == 0) return std::isfinite(at(f0 == 0 ? 0.0 : h));
    if (!(f0 * f1 < 0)) return false;
    std::uintmax_t most = 100;
    bool failed = false;
    const auto guarded = [&](double s) {
        const double f = at(s);
        failed = failed || !std::isfinite(f);
        return failed ? 0.0 : f;  // 0 ends the search; `failed` is checked after it
    };
    std::tie(low, high) =
        boost::math::tools::toms748_solve(guarded, 0.0, h, f0, f1, boost::math::tools::eps_tolerance<double>(52), most);
    return !failed && std::isfinite(at(0.5 * (low + high)));
}

std::vector<SpecialPoint> special_points_between(const ShootingMap& map, const BranchPoint& base, double h,
                                                 const BranchPoint& next, const ContinuationOptions& options) {
    struct Test {
        SpecialKind kind;
        std::function<double(const CurvePoint&)> value;
    };
    std::vector<Test> tests = {
        {SpecialKind::flip, [](const CurvePoint& c) { return flip_function(multipliers_at(c)); }},
        {SpecialKind::neimark_sacker, [](const CurvePoint& c) { return neimark_sacker_function(multipliers_at(c)); }}};
    if (map.has_parameter) {
        tests.push_back({SpecialKind::fold, [](const CurvePoint& c) { return c.parameter_slope(); }});
        tests.push_back({SpecialKind::branch_point, [&](const CurvePoint& c) { return crossing_function(map, c); }});
    }
    std::vector<std::pair<double, SpecialPoint>> found;
    for (const Test& test : tests) {
        const double f0 = test.value(base.at), f1 = test.value(next.at);
        if (!(f0 * f1 < 0)) continue;
        if (test.kind == SpecialKind::neimark_sacker && !pair_may_cross(base, next)) continue;
        SpecialPoint special;
        special.kind = test.kind;
        CurvePoint at;
        special.located = locate(map, base.at, h, f0, f1, test.value, at);
        if (test.kind == SpecialKind::branch_point) {  // there the equations have two tangents: that of this branch
            at.tangent = base.at.tangent + next.at.tangent;
            at.tangent /= std::sqrt(curve_product(at.tangent, at.tangent, true, at.points.size()));
        }
        special.cycle = special.located ? branch_point_at(at) : next;
        if (!special.located) {
            if (is_seen_at_ends(test.kind, base, next)) found.emplace_back(h, special);
            continue;
        }
        if (!is_what_it_seems(special)) continue;
        special.normal_form = form_of(map, special, options);
        Eigen::VectorXd across = stacked(at.points) - stacked(base.at.points);
        if (map.has_parameter) {
            across.conservativeResize(across.size() + 1);
            across[across.size() - 1] = at.p - base.at.p;
        }
        found.emplace_back(curve_product(base.at.tangent, across, map.has_parameter, at.points.size()), special);
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<SpecialPoint> result;
    result.reserve(found.size());
    for (auto& [s, special] : found) result.push_back(std::move(special));
    return result;
}

}  // namespace swirl::analysis
