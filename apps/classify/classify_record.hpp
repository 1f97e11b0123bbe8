// The orbit that a record of `swirl simulate` holds, judged.
#pragma once

#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/input/orbit_columns.hpp"
#include "apps/studies/modes/name_mode.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace swirl::apps::classify {

/// A record's orbit, and which of its impacts a verdict rests on.
struct RecordedOrbit {
    OrbitColumns columns;         ///< psi, chi (not of a disk), vn, vt, S of the impacts that it lists
    std::int64_t first = 0;       ///< of the orbit's impacts, as many come before the tail
    std::int64_t collisions = 0;  ///< of the tail
};

/// Reads a record, and sets scene and start to its own.
///   transient   of the impacts that it lists so many are left out; none given: half of them if they begin with the
///               orbit's first, else (simulate --skip) none
///   collisions  of the tail; none given: all that are left
/// @throws BadInput if it holds no orbit, or fewer impacts than that, or than the 64 that a verdict needs (an orbit
/// that ended is judged by its end)
RecordedOrbit recorded_orbit(const std::string& file, std::optional<std::int64_t> transient,
                             std::optional<std::int64_t> collisions, SceneOptions& scene, StartOptions& start);

/// The verdict on it. The orbit is followed again from its start, which gives the record's own bits, and is compared
/// with them. Where they part (a record in another accuracy, of another version or instruction set: chaos makes other
/// orbits of that), it is followed from the state that the record holds at the tail's beginning; the evidence says so.
///   settings  with the orbit's `first` as transient and its `collisions`
///   seen      filled where it is given
NamedMode name_recorded(const Scene<double>& scene, const Start<double>& start, const RecordedOrbit& orbit,
                        analysis::ClassifyOptions settings, Accuracy accuracy, OrbitSamples* seen = nullptr);

}  // namespace swirl::apps::classify
