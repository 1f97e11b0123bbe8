// Is an elastic disk over a floor that drags on its way to rolling or sliding? map/dragged/README.md, "Rolling"
#pragma once

#include "analysis/classification/tail.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/scene_map/scene_map.hpp"

namespace swirl::studies {

/// What is asked of bounces that are called ones about rolling. The rate of v³/λ is Γ of `LockedRolling` up to terms in
/// the time τ of a bounce: orbits of a disk with α = 0.3 were off by 4 % at τ = 0.15 and by 0.1 % at 0.006.
///   rolling_bounces      that are watched
///   longest_bounce       in 1/ω_s
///   bounce_rate_margin   by which the rate that is measured may differ from Γ, relative
inline constexpr int rolling_bounces = 512;
inline constexpr double longest_bounce = 0.25;
inline constexpr double bounce_rate_margin = 0.1;

/// Names an orbit that its tail leaves undecided: `rolling`, with S = −ρ/α, the limit that it tends to. Of e = 1, a
/// floor that drags, and locked rolling whose bounces die away: its next impacts all stick, stay as near to the rolling
/// motion as low bounces do, and v³/λ falls at the rate Γ. Without friction likewise `sliding`, with S → 0 where the
/// floor drags the spin. Otherwise nothing is changed. Cost: 512 impacts where the last state is near that motion.
void look_for_rolling(const SceneMap<disk_dimension>& map, const Scene<double>& scene,
                      const analysis::Tail<SceneMap<disk_dimension>>& tail, NamedMode& named);

}  // namespace swirl::studies
