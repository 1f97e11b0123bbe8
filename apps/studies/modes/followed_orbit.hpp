// The orbit behind a verdict, the verdict on it, and the cycle that it settles on, for the maps of scenes.
#pragma once

#include "analysis/classification/classify_followed.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/scene_map/scene_map.hpp"

#include <cstdint>
#include <optional>

namespace swirl::studies {

// The cycle that an orbit settles on.

struct SettledCycle {
    std::optional<SectionPoint<double>> point;  ///< of the cycle; none: the orbit settles on no cycle, or was stopped
    int period = 1;
    NamedMode named;  ///< what it settles on; `finished` false: stopped
};

/// Follows a start as `name_mode` does by default. @throws std::invalid_argument for a scene or start out of range
SettledCycle settled_cycle(const Scene<double>& scene, const Start<double>& start, Accuracy accuracy,
                           const analysis::Stop& stop);

// The orbit behind a verdict and the verdict on it, for the maps of scenes; each is compiled in a file of its own, for
// they are what takes long.

template <int D>
using FollowedScene = analysis::FollowedOrbit<SceneMap<D>>;

/// The orbit, as far as its verdict needs it. One that can only lose is followed to the full length: where its verdict
/// is known beforehand, what is asked is where it comes to.
template <int D>
FollowedScene<D> followed(const SceneMap<D>& map, const PostImpactState<double>& first, std::int64_t before,
                          const analysis::ClassifyOptions& settings, bool dissipative, const analysis::Stop& stop);

/// The orbit in pieces, if it is neither followed exhaustively nor dissipative.
template <int D>
analysis::SettlingOrbit<SceneMap<D>> settling(const PostImpactState<double>& first, std::int64_t before,
                                              const analysis::ClassifyOptions& settings) {
    // In 100 digits the eigenvalues of one cycle take as long as the orbit; double's are taken where they decide.
    analysis::PeriodOptions period = settings.period;
    period.exact_multipliers = false;
    return {first, before, settings.collisions, period, !settings.conserves};
}

/// Its verdict. Where that is known beforehand, derivatives and periods would cost much and tell nothing.
template <int D>
analysis::Classification judge(const SceneMap<D>& map, FollowedScene<D>& orbit,
                               const analysis::ClassifyOptions& settings, bool dissipative);

extern template FollowedScene<disk_dimension> followed(const SceneMap<disk_dimension>&, const PostImpactState<double>&,
                                                       std::int64_t, const analysis::ClassifyOptions&, bool,
                                                       const analysis::Stop&);
extern template FollowedScene<polygon_dimension> followed(const SceneMap<polygon_dimension>&,
                                                          const PostImpactState<double>&, std::int64_t,
                                                          const analysis::ClassifyOptions&, bool,
                                                          const analysis::Stop&);
extern template analysis::Classification judge(const SceneMap<disk_dimension>&, FollowedScene<disk_dimension>&,
                                               const analysis::ClassifyOptions&, bool);
extern template analysis::Classification judge(const SceneMap<polygon_dimension>&, FollowedScene<polygon_dimension>&,
                                               const analysis::ClassifyOptions&, bool);

}  // namespace swirl::studies
