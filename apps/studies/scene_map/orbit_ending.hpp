// Where an orbit meets the section first, and how it ends if it does.
#pragma once

#include "apps/studies/scene_map/scene_map.hpp"
#include "apps/studies/scene_map/start.hpp"

namespace swirl::studies {

struct OrbitBegin {
    Outcome outcome = Outcome::completed;  ///< completed: the orbit goes on from `state`
    long long impacts = 0;                 ///< 1 after the flight of a start in the laboratory, if it met the wall
    PostImpactState<double> state{};       ///< the first on the section
};

/// @throws std::invalid_argument if the start is not inside the container, or a point of the section does not leave the
/// wall
template <int D>
OrbitBegin begin_orbit(const SceneMap<D>& map, const Start<double>& start);

/// How an orbit ends whose last state on the section has no next one (`alive` false), bit for bit: the orbit from
/// coordinates that were rounded may end elsewhere. One more impact if it dies away or diverges.
template <int D>
Outcome ending_at(const SceneMap<D>& map, const PostImpactState<double>& last, long long& impacts);

}  // namespace swirl::studies
