#include "apps/studies/bifurcation_curves/curve_ends.hpp"

#include "analysis/cycles/cycle.hpp"
#include "apps/studies/bifurcation_curves/born_curves.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::studies::bifurcation_curves {

namespace {

/// A smooth curve that ends on a border is a place to begin at on that border.
void add_end(const SearchEquations& use, const CurveCycle& last, const std::string& why,
             std::vector<StartingPoint>& ends) {
    if (!is_on_border(why)) return;
    StartingPoint start{why, last.points, last.parameters, 1};
    const auto shooting =
        analysis::shooting_residual(shooting_map_of(scene_at(use.scene, use.plane, last.parameters)), last.points, 0);
    if (!shooting.alive) return;
    if (use.follow.to_vanishing_impacts && has_vanishing_impact(shooting)) return;
    name_flights(start, shooting.steps);
    ends.push_back(std::move(start));
}

/// At 1:1 and 1:2 a Neimark–Sacker curve begins, which branches through the curve's points beside them cross.
bool begins_a_pair(const CurveSpecial& special) {
    return special.kind == "1:1" || special.kind == "1:2";
}

std::vector<StartingPoint> on_branches(const SearchEquations& use, const Curve& curve, const EndPart& part) {
    LineOptions lines;
    lines.control.stop = use.follow.control.stop;
    lines.max_period = static_cast<int>(std::max(use.follow.longest_period, curve.period));
    const CurveCycle& beside = curve.points[*part.beside];
    return starting_points_about(use.scene, use.plane, beside.points, beside.parameters, part.axis, lines);
}

/// Where a curve meets one of another kind, and it is the cycle itself that has both multipliers.
void add_crossing(const Curve& curve, const CurveSpecial& special, std::vector<StartingPoint>& ends) {
    const auto meets = [&](const std::string& kind, std::complex<double> multiplier) {
        if (kind != curve.kind) ends.push_back({kind, special.cycle.points, special.cycle.parameters, multiplier});
    };
    const bool fold_flip = special.kind == "fold-flip", fold_pair = special.kind == "fold-neimark-sacker",
               flip_pair = special.kind == "flip-neimark-sacker";
    if (fold_flip || fold_pair) meets("fold", 1);
    if (fold_flip || flip_pair) meets("flip", -1);
    if (fold_pair || flip_pair) meets("neimark-sacker", critical_pair(special.cycle.multipliers));
}

}  // namespace

std::vector<EndPart> parts_of_ends(const Followed& followed) {
    std::vector<EndPart> parts{{}};
    if (followed.border) return parts;
    const Curve& curve = *followed.curve;
    for (std::size_t s = 0; s < curve.special.size(); ++s) {
        if (!begins_a_pair(curve.special[s])) {
            parts.push_back({s, std::nullopt, 0});
            continue;
        }
        const std::size_t after = curve.special[s].after;
        for (std::size_t i = after; i < std::min(after + 2, curve.points.size()); ++i)
            for (const int axis : {0, 1}) parts.push_back({s, i, axis});
    }
    return parts;
}

CurveEnds ends_of(const SearchEquations& equations, const Followed& followed, const EndPart& part) {
    const Curve& curve = *followed.curve;
    if (followed.border) {
        BornPoints born = points_born_on(equations.words, equations.map, equations.plane, equations.smooth,
                                         equations.follow.longest_period, *followed.border);
        return {std::move(born.starting_points), born.not_found};
    }
    if (part.beside) return {on_branches(equations, curve, part), 0};
    CurveEnds ends;
    if (part.special) {
        add_crossing(curve, curve.special[*part.special], ends.starting_points);
        return ends;
    }
    add_end(equations, curve.points.front(), curve.begins, ends.starting_points);
    add_end(equations, curve.points.back(), curve.ends, ends.starting_points);
    return ends;
}

}  // namespace swirl::studies::bifurcation_curves
