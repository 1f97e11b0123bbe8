#include "apps/studies/bifurcation_curves/plane.hpp"

#include "analysis/boundaries/plane_curve.hpp"

namespace swirl::studies::bifurcation_curves {

bool is_in(const Plane& plane, const Eigen::Vector2d& p) {
    return analysis::outside_plane(plane.low(), plane.high(), p) <= analysis::on_edge;
}

Scene<double> scene_at(const Scene<double>& scene, const Plane& plane, const Eigen::Vector2d& p) {
    return with_parameter(with_parameter(scene, plane.parameter(0), p[0]), plane.parameter(1), p[1]);
}

}  // namespace swirl::studies::bifurcation_curves
