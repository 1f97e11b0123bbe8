// The two ends of naming an orbit's mode, with its following in between.
#pragma once

#include "apps/studies/modes/followed_orbit.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"

namespace swirl::studies {

/// How many steps of the return map come before those that are judged. A point of the section is no impact of the
/// orbit: its first is one step on. So the tail begins after as many impacts as were to be left out, whatever
/// the start.
inline std::int64_t steps_before(const OrbitBegin& begin, const analysis::ClassifyOptions& settings) {
    return settings.transient + 1 - begin.impacts;
}

/// The settings as a scene wants them.
analysis::ClassifyOptions settings_for(const Scene<double>& scene, analysis::ClassifyOptions settings);

/// What is said of a start that has no orbit on the section.
NamedMode named_without_orbit(const OrbitBegin& begin);

/// What is said of an orbit that was followed.
template <int D>
NamedMode named_from(const SceneMap<D>& map, const Scene<double>& scene, const OrbitBegin& begin,
                     FollowedScene<D>& orbit, const analysis::ClassifyOptions& settings,
                     OrbitSamples* samples = nullptr);

}  // namespace swirl::studies
