#include "apps/studies/modes/settled_cycle.hpp"

#include "apps/studies/scene_map/section_coordinates.hpp"

#include <Eigen/Core>

namespace swirl::studies {

SettledCycle settled_cycle(const Scene<double>& scene, const Start<double>& start, Accuracy accuracy,
                           const analysis::Stop& stop) {
    SettledCycle settled;
    settled.named = name_mode(scene, start, {}, accuracy, stop);
    const std::vector<double>& point = settled.named.verdict.point;
    if (!settled.named.finished || point.empty()) return settled;
    settled.point = section_point_of(Eigen::Map<const Eigen::VectorXd>(point.data(), std::ssize(point)));
    settled.period = static_cast<int>(settled.named.verdict.period);
    return settled;
}

}  // namespace swirl::studies
