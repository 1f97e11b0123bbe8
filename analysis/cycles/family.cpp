#include "analysis/cycles/family.hpp"

#include "analysis/special_values.hpp"
#include "analysis/within_period.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>

namespace swirl::analysis {

namespace {

/// Steps from `start` in direction `sign`, start excluded.
std::vector<CurvePoint> walk(const ShootingMap& map, const CurvePoint& start, double sign, const FamilyOptions& options,
                             bool& closed) {
    std::vector<CurvePoint> members;
    CurvePoint here = start;
    here.tangent *= sign;
    double h = options.step;
    closed = false;
    bool has_left = false;
    while (static_cast<int>(members.size()) < options.most_steps) {  // ends: too many, too short a step, or closed
        CurvePoint next;
        CorrectorOptions corrector;
        corrector.keep_word = false;  // a family goes on where sticking becomes sliding, with a kink at most
        if (correct(map, here, h, next, corrector) != Correction::converged ||
            curve_product(here.tangent, next.tangent, false, here.points.size()) < 0.98) {
            h *= 0.5;
            if (h < options.shortest) return members;
            continue;
        }
        here = next;
        for (auto& point : here.points) point = map.normalised(point);
        members.push_back(here);
        h = std::min(1.5 * h, options.step);
        const double away = distance_between(map, here.points, start.points);
        has_left = has_left || away > 3 * options.step;
        closed = has_left && away < options.step &&
                 curve_product(here.tangent, start.tangent, false, here.points.size()) * sign > 0.9;
        if (closed) return members;
    }
    return members;
}

}  // namespace

FamilyCurve walk_family(const ShootingMap& map, double p, const Cycle& cycle, const FamilyOptions& options) {
    FamilyCurve family;
    CurvePoint start;
    if (!begin_curve(map, cycle.points, p, {}, start)) return family;
    std::vector<CurvePoint> back = walk(map, start, -1, options, family.closed);
    for (auto& member : back) member.tangent *= -1;
    std::reverse(back.begin(), back.end());
    family.members = std::move(back);
    family.origin = family.members.size();
    family.members.push_back(start);
    if (family.closed) return family;
    bool ignored = false;
    const std::vector<CurvePoint> forth = walk(map, start, 1, options, ignored);
    family.members.insert(family.members.end(), forth.begin(), forth.end());
    return family;
}

std::vector<CyclePoints> pinned_members(const ShootingMap& map, const FamilyCurve& family,
                                        const std::function<double(const CurvePoint&)>& value, double goal) {
    std::vector<CyclePoints> found;
    for (std::size_t i = 0; i + 1 < family.members.size(); ++i) {
        const CurvePoint& a = family.members[i];
        const CurvePoint& b = family.members[i + 1];
        const double low = value(a) - goal, high = value(b) - goal;
        if (low == 0) found.push_back(a.points);
        if (!(low * high < 0)) continue;
        Eigen::VectorXd across = stacked(b.points) - stacked(a.points);
        for (Eigen::Index j = 0; j < across.size(); ++j)
            across[j] = within_period(across[j], map.angle_periods[static_cast<std::size_t>(j % map.dimension)]);
        const double length = curve_product(a.tangent, across, false, a.points.size());
        CurvePoint member;
        const auto gap = [&](double h) {
            CorrectorOptions corrector;
            corrector.keep_word = false;
            return correct(map, a, h, member, corrector) == Correction::converged ? value(member) - goal : nan;
        };
        std::uintmax_t most = 100;
        const auto root = boost::math::tools::toms748_solve(gap, 0.0, length, low, high,
                                                            boost::math::tools::eps_tolerance<double>(52), most);
        if (std::isfinite(gap(root.first))) found.push_back(member.points);
    }
    return found;
}

bool belongs_to(const ShootingMap& map, const FamilyCurve& curve, const CyclePoints& b) {
    for (const CurvePoint& member : curve.members) {
        if (distance_between(map, member.points, b) > 0.02) continue;
        // From the member along its tangent to where b should be: the curve is there exactly, or b is not on it.
        CyclePoints shifted = b;
        for (std::size_t shift = 0; shift < b.size(); ++shift) {
            Eigen::VectorXd across(member.tangent.size());
            for (std::size_t i = 0; i < shifted.size(); ++i)
                across.segment(static_cast<Eigen::Index>(i) * map.dimension, map.dimension) =
                    map.difference(shifted[i], member.points[i]);
            CurvePoint there;
            const double h = curve_product(member.tangent, across, false, shifted.size());
            CorrectorOptions options;
            options.keep_word = false;
            options.farthest = infinity;  // how far from b is asked next
            if (std::abs(h) < 0.03 && correct(map, member, h, there, options) == Correction::converged &&
                distance_between(map, there.points, b) < same_cycle)
                return true;
            std::rotate(shifted.begin(), shifted.begin() + 1, shifted.end());
        }
    }
    return false;
}

bool is_reachable(const ShootingMap& map, double p, const CyclePoints& a, const CyclePoints& b) {
    constexpr double longest = 0.1;
    CyclePoints here = a;
    double left = infinity;
    for (int step = 0; step < 200; ++step) {
        Eigen::VectorXd across(static_cast<Eigen::Index>(here.size()) * map.dimension);
        for (std::size_t i = 0; i < here.size(); ++i)
            across.segment(static_cast<Eigen::Index>(i) * map.dimension, map.dimension) = map.difference(b[i], here[i]);
        const double distance = across.lpNorm<Eigen::Infinity>();
        if (distance < same_cycle) return true;
        if (!(distance < left - 0.1 * std::min(left, longest))) return false;  // it leads away
        left = distance;
        if (distance > longest) across *= longest / distance;
        for (std::size_t i = 0; i < here.size(); ++i)
            here[i] += across.segment(static_cast<Eigen::Index>(i) * map.dimension, map.dimension);
        if (!(polish_cycle(map, here, p, 1e-10) <= 1e-9)) return false;
    }
    return false;
}

}  // namespace swirl::analysis
