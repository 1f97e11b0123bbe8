// The two ends of naming an orbit's mode, with its following in between.
#pragma once

#include "apps/studies/modes/followed_orbit.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"
#include "map/model/scene.hpp"

#include <cstdint>

namespace swirl::studies {

/// How many steps of the return map come before those that are judged. A point of the section is no impact of the
/// orbit: its first is one step on. So the tail begins after as many impacts as were to be left out, whatever
/// the start.
inline std::int64_t steps_before(const OrbitBegin& begin, const analysis::ClassifyOptions& settings) {
    return settings.transient + 1 - begin.impacts;
}

/// The settings as a scene wants them.
analysis::ClassifyOptions settings_for(const Scene<double>& scene, analysis::ClassifyOptions settings);

/// Of how many steps the tail is that is judged at a look, and how many come before: those until the look before, so
/// that none is missed on the way. @throws std::invalid_argument unless it is a look
struct StepsToLook {
    std::int64_t before = 0, tail = 0;
};
StepsToLook steps_to(std::int64_t look);

/// Is there nothing to be seen at a look? An orbit that can only lose is none of chaos, and `exhaustive` is all steps.
inline bool is_for_limits_alone(const Scene<double>& scene, const analysis::ClassifyOptions& settings) {
    return settings.exhaustive || is_dissipative_without_drive(scene);
}

/// What is said of an orbit that was followed to a look.
template <int D>
NamedMode named_at_look(const SceneMap<D>& map, const Scene<double>& scene, const OrbitBegin& begin,
                        FollowedScene<D>& orbit, const analysis::ClassifyOptions& settings,
                        OrbitSamples* samples = nullptr);

/// What is said of a start that has no orbit on the section: it rides with the floor, or has no mode.
NamedMode named_without_orbit(const Body<double>& body, const SceneStart& from, const OrbitBegin& begin);

/// What is said of an orbit that was followed.
template <int D>
NamedMode name_from(const SceneMap<D>& map, const Scene<double>& scene, const OrbitBegin& begin,
                    FollowedScene<D>& orbit, const analysis::ClassifyOptions& settings,
                    OrbitSamples* samples = nullptr);

}  // namespace swirl::studies
