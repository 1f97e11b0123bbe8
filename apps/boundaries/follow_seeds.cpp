#include "analysis/boundaries/follow_boundary.hpp"
#include "apps/boundaries/curves.hpp"
#include "apps/branches/branches.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/system/shooting_map.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace swirl::apps::boundaries {

namespace {

using analysis::Boundary;
using analysis::BoundaryKind;

std::optional<BoundaryKind> smooth_kind(const std::string& name) {
    for (const BoundaryKind kind : {BoundaryKind::fold, BoundaryKind::flip, BoundaryKind::neimark_sacker})
        if (name == analysis::name_of(kind)) return kind;
    return std::nullopt;
}

std::string border_behind(const Scene<double>& scene, const analysis::CyclePoints& points,
                          const std::vector<std::int64_t>& word_behind) {
    analysis::CurvePoint last;
    last.points = points;
    last.shooting = analysis::shooting_residual(shooting_map_of(scene), points, 0);
    const std::string name = border_name(scene, last, word_behind, false);
    return name == analysis::nameless_border ? "" : name;
}

analysis::BoundaryOptions options_of(const Scene<double>& scene, const Plane& plane, const FollowOptions& follow) {
    analysis::BoundaryOptions options;
    options.low = plane.low();
    options.high = plane.high();
    options.longest_step = follow.longest_step;
    options.first_step = std::min(options.first_step, follow.longest_step);
    options.stop = is_interrupted;
    options.forms = [scene, plane](const analysis::CyclePoints& points, const Eigen::Vector2d& p) {
        return scene_forms(scene_at(scene, plane, p), plane.parameter(0), points, p[0]);
    };
    options.name_border = [scene, plane](const analysis::CyclePoints& points, const Eigen::Vector2d& p,
                                         const std::vector<std::int64_t>& word_behind) {
        return border_behind(scene_at(scene, plane, p), points, word_behind);
    };
    return options;
}

double angle_of(const Boundary& boundary, const analysis::BoundaryPoint& point) {
    if (boundary.kind == BoundaryKind::fold) return 0;
    if (boundary.kind == BoundaryKind::flip) return pi<double>();
    return std::acos(std::clamp(point.at.y.tail(1)[0], -1.0, 1.0));
}

CurveCycle cycle_of(const Boundary& boundary, const analysis::BoundaryPoint& point, const analysis::ShootingMap& map) {
    CurveCycle cycle{analysis::parameters_of(boundary, point.at.y), analysis::points_of(boundary, point.at.y),
                     point.multipliers, angle_of(boundary, point), point.coefficient};
    for (auto& z : cycle.points) z = map.normalised(z);
    return cycle;
}

std::string ending_of(const analysis::BoundaryEnding& ending) {
    if (ending.why == analysis::BoundaryEnd::border && !ending.border.empty()) return ending.border;
    return std::string(analysis::name_of(ending.why));
}

Curve curve_of(const Boundary& boundary, const analysis::ShootingMap& map) {
    Curve curve{std::string(analysis::name_of(boundary.kind)),
                boundary.period,
                {},
                {},
                ending_of(boundary.begin),
                ending_of(boundary.end)};
    for (const auto& point : boundary.points) curve.points.push_back(cycle_of(boundary, point, map));
    for (const auto& special : boundary.special)
        curve.special.push_back(
            {std::string(analysis::name_of(special.kind)), cycle_of(boundary, special.cycle, map), special.after});
    return curve;
}

}  // namespace

PlaneCurves follow_seeds(const Scene<double>& scene, const Plane& plane, const std::vector<Seed>& seeds,
                         const FollowOptions& follow) {
    const analysis::PlaneMap map = plane_map_of(scene, plane.parameter(0), plane.parameter(1));
    const analysis::ShootingMap coordinates = analysis::on_line(map, 0, plane.low());
    const analysis::BoundaryOptions options = options_of(scene, plane, follow);
    PlaneCurves result;
    std::vector<Boundary> known;
    Progress progress("curves", static_cast<double>(seeds.size()), follow.quiet);
    for (const Seed& seed : seeds) {
        if (is_interrupted()) break;
        const auto kind = smooth_kind(seed.kind);
        progress.at(static_cast<double>(++result.seeds));
        if (!kind) {
            if (std::find(result.left_out.begin(), result.left_out.end(), seed.kind) == result.left_out.end())
                result.left_out.push_back(seed.kind);
            continue;
        }
        if (analysis::is_on_boundary(map, *kind, seed.points, seed.p, seed.multiplier, options, known)) continue;
        Boundary boundary;
        if (!analysis::follow_boundary(map, *kind, seed.points, seed.p, seed.multiplier, options, boundary)) {
            ++result.without;
            continue;
        }
        if (is_interrupted()) break;  // cut short: not finished
        result.curves.push_back(curve_of(boundary, coordinates));
        known.push_back(std::move(boundary));
    }
    return result;
}

}  // namespace swirl::apps::boundaries
