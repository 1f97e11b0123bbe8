// F in the coordinates of a proof of chaos, in double: for the search of what is then proven.
#pragma once

#include "analysis/curves/shooting_map.hpp"
#include "apps/studies/scene_map/itinerary_map.hpp"
#include "map/model/scene.hpp"
#include "map/model/section.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace swirl::studies::certify {

/// One application of F.
struct ChartStep {
    bool alive = false;  ///< false: the orbit ends, or leads through sustained contact
    Eigen::VectorXd state;
    Eigen::MatrixXd by_state;
    std::int64_t letter = 0;
    double duration = 0;
};

/// The coordinates are those of `proof::section_chart`.
class ChartMap {
public:
    /// The level of J is that of `z` where the chart needs one.
    ChartMap(const Scene<double>& scene, const SectionPoint<double>& z);

    int dimension() const { return static_cast<int>(chart_.size()); }
    std::optional<double> jacobi() const { return jacobi_; }
    Eigen::VectorXd chart_of(const SectionPoint<double>& z) const;
    SectionPoint<double> point_of(const Eigen::VectorXd& x) const;
    ChartStep step(const Eigen::VectorXd& x) const;
    /// a − b, angles as angles.
    Eigen::VectorXd difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;

private:
    double normal_velocity(double psi, double vt) const;

    Scene<double> scene_;
    analysis::ShootingMap map_;
    std::vector<std::size_t> chart_;
    std::optional<double> jacobi_;
};

/// The largest Lyapunov exponent per impact of the orbit from x, over so many impacts after a thousandth of them; NaN
/// where it ends before: a number without proof.
double largest_exponent(const ChartMap& map, Eigen::VectorXd x, int impacts);

}  // namespace swirl::studies::certify
