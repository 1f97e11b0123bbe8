#include "analysis/boundaries/follow_boundary.hpp"

#include "analysis/boundaries/boundary_walk.hpp"
#include "analysis/continuation/put_before.hpp"

#include <cmath>
#include <utility>

namespace swirl::analysis {

namespace {

/// Where the guess lies along the tangent of a known curve's point, corrected: the same cycle?
bool is_beside(const AugmentedSystem& like, const ArcPoint& on_curve, const Eigen::VectorXd& y) {
    AugmentedSystem system = like;
    const PlaneShooting shooting = system.shooting(on_curve.y);
    if (!shooting.alive) return false;
    system.borders = borders_at(shooting, system.multiplier(on_curve.y));
    const ArcSystem arc = equations_of(system);
    ArcPoint at;
    const double along = arc.product(on_curve.tangent, y - on_curve.y);
    if (correct(arc, on_curve, along, at) != Correction::converged) return false;
    constexpr double same = 1e-6;
    return std::sqrt(arc.product(at.y - y, at.y - y)) < same;
}

/// The point of the curve near a rough cycle, and its equations; false if there is none within the plane.
bool begin(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points, const Eigen::Vector2d& p,
           std::complex<double> multiplier, const BoundaryOptions& options, AugmentedSystem& system, ArcPoint& start) {
    Eigen::VectorXd y;
    if (outside_plane(options.low, options.high, p) > 0 ||
        !augmented_system_at(map, kind, points, p, multiplier, options.high - options.low, system, y))
        return false;
    Eigen::VectorXd along = Eigen::VectorXd::Zero(y.size());
    along[system.coordinates()] = 1;   // the first parameter grows
    constexpr double farthest = 0.02;  // a rough cycle
    if (!begin_arc(equations_of(system), y, along, farthest, start) ||
        outside_plane(options.low, options.high, start.y.segment<2>(system.coordinates())) > 0)
        return false;
    return kind != BoundaryKind::neimark_sacker || std::abs(start.y[system.coordinates() + 2]) < 1;
}

}  // namespace

std::optional<CriticalCycle> critical_cycle_near(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points,
                                                 const Eigen::Vector2d& p, std::complex<double> multiplier,
                                                 const BoundaryOptions& options) {
    AugmentedSystem system;
    ArcPoint start;
    if (!begin(map, kind, points, p, multiplier, options, system, start)) return std::nullopt;
    const Eigen::Index n = system.coordinates();
    return CriticalCycle{unstacked(start.y.head(n), map.dimension), start.y.segment<2>(n), system.multiplier(start.y)};
}

bool follow_boundary(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points, const Eigen::Vector2d& p,
                     std::complex<double> multiplier, const BoundaryOptions& options, Boundary& boundary) {
    AugmentedSystem system;
    ArcPoint start;
    if (!begin(map, kind, points, p, multiplier, options, system, start)) return false;
    start.y.head(system.coordinates()) = normalised(system, start.y).head(system.coordinates());
    renew_borders(system, start.y);
    boundary = {};
    walk_boundary(system, start, options, boundary);
    if (boundary.end.why == BoundaryEnd::closed || boundary.end.why == BoundaryEnd::stopped) {
        boundary.begin = boundary.end;
        return true;
    }
    Boundary back;
    start.tangent *= -1;
    walk_boundary(std::move(system), start, options, back);
    put_before(
        std::move(back), boundary, [](BoundaryPoint& point) { point.at.tangent *= -1; },
        [](BoundarySpecial& special) { special.cycle.at.tangent *= -1; });
    return true;
}

bool is_on_boundary(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points, const Eigen::Vector2d& p,
                    std::complex<double> multiplier, const BoundaryOptions& options, std::span<const Boundary> known) {
    AugmentedSystem system{kind, map, points.size(), options.high - options.low, {}};
    const Eigen::Index n = system.coordinates();
    Eigen::VectorXd y = Eigen::VectorXd::Zero(n + (kind == BoundaryKind::neimark_sacker ? 3 : 2));
    y.head(n) = stacked(points);
    y.segment<2>(n) = p;
    if (kind == BoundaryKind::neimark_sacker) y[n + 2] = multiplier.real() / std::abs(multiplier);
    for (const Boundary& boundary : known) {
        if (boundary.kind != kind || boundary.period != points.size()) continue;
        for (const BoundaryPoint& point : boundary.points) {
            Eigen::VectorXd turned;
            if (distance_between(system, point.at.y, y, &turned) > 2 * options.longest_step) continue;
            if (is_beside(system, point.at, turned)) return true;
        }
    }
    return false;
}

}  // namespace swirl::analysis
