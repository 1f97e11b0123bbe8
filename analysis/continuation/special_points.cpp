#include "analysis/continuation/special_points.hpp"

#include "analysis/continuation/normal_form.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::analysis {

namespace {

/// A(z_1) = D(Fᵏ), ∂(Fᵏ)/∂p and dz_1/dp.
CriticalPoint critical_point(const CurvePoint& at) {
    CriticalPoint critical;
    critical.derivative = monodromy(at.shooting);
    critical.by_parameter = Eigen::VectorXd::Zero(at.shooting.dimension);
    for (const auto& step : at.shooting.steps)
        critical.by_parameter = step.by_state * critical.by_parameter + step.by_parameter.col(0);
    critical.branch_slope = at.tangent.head(at.shooting.dimension) / at.parameter_slope();
    return critical;
}

std::optional<NormalForm> form_of(const SpecialPoint& special, const ContinuationOptions& options) {
    const CurvePoint& at = special.cycle.at;
    if (!options.forms || !at.has_parameter()) return std::nullopt;
    CriticalPoint critical = critical_point(at);
    critical.forms = options.forms(at.points(), at.p());
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

std::vector<SpecialPoint> special_points_between(const CurveProblem& problem, const BranchPoint& base, double h,
                                                 const BranchPoint& next, const ContinuationOptions& options) {
    struct Test {
        SpecialKind kind;
        std::function<double(const CurvePoint&)> value;
    };
    std::vector<Test> tests = {
        {SpecialKind::flip, [](const CurvePoint& c) { return flip_function(multipliers_at(c)); }},
        {SpecialKind::neimark_sacker, [](const CurvePoint& c) { return neimark_sacker_function(multipliers_at(c)); }}};
    if (base.at.has_parameter()) {
        tests.push_back({SpecialKind::fold, [](const CurvePoint& c) { return c.parameter_slope(); }});
        tests.push_back(
            {SpecialKind::branch_point, [&](const CurvePoint& c) { return crossing_function(problem, c); }});
    }
    std::vector<std::pair<double, SpecialPoint>> found;
    for (const Test& test : tests) {
        const double f0 = test.value(base.at), f1 = test.value(next.at);
        if (!(f0 * f1 < 0)) continue;
        if (test.kind == SpecialKind::neimark_sacker && !pair_may_cross(base, next)) continue;
        SpecialPoint special;
        special.kind = test.kind;
        CurvePoint at;
        special.located = locate(problem, base.at, h, f0, f1, test.value, at);
        if (test.kind == SpecialKind::branch_point) {  // there the equations have two tangents: that of this branch
            at.tangent = base.at.tangent + next.at.tangent;
            at.tangent /= problem.length(at.tangent);
        }
        special.cycle = special.located ? branch_point_at(at) : next;
        if (!special.located) {
            if (is_seen_at_ends(test.kind, base, next)) found.emplace_back(h, special);
            continue;
        }
        if (!is_what_it_seems(special)) continue;
        special.normal_form = form_of(special, options);
        found.emplace_back(problem.product(base.at.tangent, at.y - base.at.y), special);
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<SpecialPoint> result;
    result.reserve(found.size());
    for (auto& [s, special] : found) result.push_back(std::move(special));
    return result;
}

}  // namespace swirl::analysis
