#include "apps/studies/modes/followed_orbit.hpp"

namespace swirl::studies {

template <int D>
analysis::Classification judged(const SceneMap<D>& map, FollowedScene<D>& orbit,
                                const analysis::ClassifyOptions& settings, bool dissipative) {
    if (dissipative) return analysis::observed(map, orbit.tail, map.integrated, settings.recurrence_threshold);
    if (settings.exhaustive) return analysis::classify_tail(map, orbit.tail, map.integrated, settings);
    return analysis::classify_followed(map, orbit, map.integrated, settings);
}

template analysis::Classification judged(const SceneMap<disk_dimension>&, FollowedScene<disk_dimension>&,
                                         const analysis::ClassifyOptions&, bool);
template analysis::Classification judged(const SceneMap<polygon_dimension>&, FollowedScene<polygon_dimension>&,
                                         const analysis::ClassifyOptions&, bool);

}  // namespace swirl::studies
