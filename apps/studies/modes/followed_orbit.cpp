#include "apps/studies/modes/followed_orbit.hpp"

namespace swirl::studies {

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

}  // namespace swirl::studies
