// Is an orbit on a chord or a diameter (map/chords/README.md), and where does that lead it?
#pragma once

#include "analysis/classification/tail.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/scene_map/scene_map.hpp"

namespace swirl::studies {

/// Names what its tail's kind does not tell: `chord`, with the S* that it is led to, or `accelerated`. Of an orbit that
/// has not settled on a cycle, e = 1, friction and swirl: its next impacts all stick, go on by the chord's j, and
/// deviate from it little more than the swirl forces (chord_orbit.hpp). A chord that is neutral to first order leaves
/// it undecided, for that reason. Newton's law: a fast body's energy grows geometrically along the tail and 20,000
/// impacts more. Otherwise nothing is changed.
/// Cost: a look at the last state; where that is near a chord 256 impacts, fast under Newton's law 20,000.
void look_for_growth(const SceneMap<polygon_dimension>& map, const Scene<double>& scene,
                     const analysis::Tail<SceneMap<polygon_dimension>>& tail, NamedMode& named);

/// An orbit whose speeds have left the numbers.
void name_divergence(NamedMode& named);

}  // namespace swirl::studies
