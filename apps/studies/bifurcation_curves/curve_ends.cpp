#include "apps/studies/bifurcation_curves/curve_ends.hpp"

#include "analysis/cycles/cycle.hpp"
#include "apps/studies/bifurcation_curves/born_curves.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
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
    name_flights(start, shooting.steps);
    ends.push_back(std::move(start));
}

/// Where a curve meets one of another kind. At 1:1 and 1:2 a Neimark–Sacker curve begins, which branches through
/// the curve's points beside them cross; at the others it is the cycle itself that has both multipliers.
void add_crossing(const SearchEquations& use, const Curve& curve, const CurveSpecial& special,
                  std::vector<StartingPoint>& ends) {
    if (special.kind == "1:1" || special.kind == "1:2") {
        LineOptions lines;
        lines.control.stop = use.follow.control.stop;
        lines.max_period = static_cast<int>(std::max(use.follow.longest_period, curve.period));
        for (const std::size_t i : {special.after, special.after + 1}) {
            if (i >= curve.points.size()) continue;
            const CurveCycle& beside = curve.points[i];
            for (StartingPoint& start :
                 starting_points_about(use.scene, use.plane, beside.points, beside.parameters, lines))
                ends.push_back(std::move(start));
        }
        return;
    }
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

std::size_t parts_of_ends(const Followed& followed) {
    return followed.border ? 1 : 1 + followed.curve->special.size();
}

CurveEnds ends_of(const SearchEquations& equations, const Followed& followed, std::size_t part) {
    const Curve& curve = *followed.curve;
    if (followed.border) {
        BornPoints born = points_born_on(equations.words, equations.map, equations.plane, equations.smooth,
                                         equations.follow.longest_period, *followed.border);
        return {std::move(born.starting_points), born.not_found};
    }
    CurveEnds ends;
    if (part > 0) {
        add_crossing(equations, curve, curve.special[part - 1], ends.starting_points);
        return ends;
    }
    add_end(equations, curve.points.front(), curve.begins, ends.starting_points);
    add_end(equations, curve.points.back(), curve.ends, ends.starting_points);
    return ends;
}

}  // namespace swirl::studies::bifurcation_curves
