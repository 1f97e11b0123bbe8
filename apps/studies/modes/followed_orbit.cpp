#include "apps/studies/modes/followed_orbit.hpp"

#include "apps/studies/scene_map/section_coordinates.hpp"

#include <Eigen/Core>

#include <iterator>
#include <vector>

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

template <int D>
FollowedScene<D> followed(const SceneMap<D>& map, const PostImpactState<double>& first, std::int64_t before,
                          const analysis::ClassifyOptions& settings, bool dissipative, const analysis::Stop& stop) {
    if (settings.exhaustive || dissipative)
        return {analysis::follow_tail(map, first, before, settings.collisions, stop), {}};
    return analysis::follow_to_end(settling<D>(first, before, settings), map, stop);
}

template FollowedScene<disk_dimension> followed(const SceneMap<disk_dimension>&, const PostImpactState<double>&,
                                                std::int64_t, const analysis::ClassifyOptions&, bool,
                                                const analysis::Stop&);
template FollowedScene<polygon_dimension> followed(const SceneMap<polygon_dimension>&, const PostImpactState<double>&,
                                                   std::int64_t, const analysis::ClassifyOptions&, bool,
                                                   const analysis::Stop&);

template <int D>
analysis::Classification judge(const SceneMap<D>& map, FollowedScene<D>& orbit,
                               const analysis::ClassifyOptions& settings, bool dissipative) {
    if (dissipative) return analysis::measure_tail(map, orbit.tail, map.integrated, settings.recurrence_threshold);
    if (settings.exhaustive) return analysis::classify_tail(map, orbit.tail, map.integrated, settings);
    return analysis::classify_followed(map, orbit, map.integrated, settings);
}

template analysis::Classification judge(const SceneMap<disk_dimension>&, FollowedScene<disk_dimension>&,
                                        const analysis::ClassifyOptions&, bool);
template analysis::Classification judge(const SceneMap<polygon_dimension>&, FollowedScene<polygon_dimension>&,
                                        const analysis::ClassifyOptions&, bool);

}  // namespace swirl::studies
