#include "apps/studies/bifurcation_curves/smooth_curve.hpp"

#include "apps/studies/branches/branches.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace swirl::studies::bifurcation_curves {

namespace {

using analysis::Boundary;
using analysis::BoundaryKind;

std::string border_behind(const Scene<double>& scene, const analysis::CyclePoints& points,
                          const std::vector<std::int64_t>& itinerary_behind) {
    analysis::CurvePoint last;
    last.y = analysis::stacked(points);
    last.shooting = analysis::shooting_residual(shooting_map_of(scene), points, 0);
    const std::string name = border_name(scene, last, itinerary_behind, false, Accuracy::double_precision);
    return name == analysis::nameless_border ? "" : name;
}

double angle_of(const Boundary& boundary, const analysis::BoundaryPoint& point) {
    if (boundary.kind == BoundaryKind::fold) return 0;
    if (boundary.kind == BoundaryKind::flip) return pi<double>();
    return std::acos(std::clamp(point.at.y.tail(1)[0], -1.0, 1.0));
}

CurveCycle cycle_of(const Boundary& boundary, const analysis::BoundaryPoint& point, const analysis::ShootingMap& map) {
    CurveCycle cycle{analysis::parameters_of(boundary, point.at.y), point.at.points(), point.multipliers,
                     angle_of(boundary, point), point.coefficient};
    for (auto& z : cycle.points) z = map.normalised(z);
    return cycle;
}

}  // namespace

std::optional<BoundaryKind> smooth_kind(const std::string& name) {
    for (const BoundaryKind kind : {BoundaryKind::fold, BoundaryKind::flip, BoundaryKind::neimark_sacker})
        if (name == analysis::name_of(kind)) return kind;
    return std::nullopt;
}

analysis::BoundaryOptions smooth_options(const Scene<double>& scene, const Plane& plane, double longest_step,
                                         const analysis::Stop& stop) {
    analysis::BoundaryOptions options;
    options.low = plane.low();
    options.high = plane.high();
    options.longest_step = longest_step;
    options.first_step = std::min(options.first_step, longest_step);
    options.stop = stop;
    options.forms = [scene, plane](const analysis::CyclePoints& points, const Eigen::Vector2d& p) {
        return scene_forms(scene_at(scene, plane, p), plane.parameter(0), points, p[0]);
    };
    options.name_border = [scene, plane](const analysis::CyclePoints& points, const Eigen::Vector2d& p,
                                         const std::vector<std::int64_t>& itinerary_behind) {
        return border_behind(scene_at(scene, plane, p), points, itinerary_behind);
    };
    return options;
}

Curve curve_of(const Boundary& boundary, const analysis::ShootingMap& map) {
    Curve curve{std::string(analysis::name_of(boundary.kind)),
                boundary.period,
                {},
                {},
                name_of(boundary.begin),
                name_of(boundary.end)};
    for (const auto& point : boundary.points) curve.points.push_back(cycle_of(boundary, point, map));
    for (const auto& special : boundary.special)
        curve.special.push_back(
            {std::string(analysis::name_of(special.kind)), cycle_of(boundary, special.cycle, map), special.after});
    return curve;
}

}  // namespace swirl::studies::bifurcation_curves
