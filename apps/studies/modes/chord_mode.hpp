// Does an orbit run along a chord or a diameter (map/chords/README.md), and where does that lead it?
#pragma once

#include "analysis/classification/tail.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "map/chords/chords.hpp"

#include <optional>

namespace swirl::studies {

/// What is asked of an orbit that is called one on a chord. None of these is critical: of 6,758 looks at orbits of
/// 1,000 random scenes near a chord (`ChordThresholdsNightly`; 5,336 stayed on it for 200,000 impacts more) none was
/// mistaken with 64 impacts or more and any factor from 1.25 to 10, two with 4 impacts and a factor of 5.
///   chord_impacts  that it is watched for
///   chord_excess   what it may deviate by, over what the swirl forces
///   most_bent      what the swirl may force for the response to be linear, in radians: 1,397 that stay are not named
///                  with 0.05, 751 with 0.25, 589 with 0.5, and none is mistaken
inline constexpr int chord_impacts = 256;
inline constexpr double chord_excess = 2;
inline constexpr double most_bent = 0.25;

/// A limit v* is of leading order in β: by 20 bend² (bend: what the swirl forces there, in radians) or less it is off
/// in orbits (`ChordLimitsNightly`), and 1 % is as near as an orbit is waited for.
inline constexpr double limit_tolerance(double bend) {
    return 0.01 + 20 * bend * bend;
}
/// Up to this bend the limit is named: to 6 %.
inline constexpr double most_bent_at_limit = 0.05;

/// The body in the container's frame, just after an impact. The direction of its velocity and χ are in radians.
struct ContainerState {
    double chi, speed, direction, energy;
};
ContainerState in_container(const Scene<double>& scene, const PostImpactState<double>& z);

/// The chord whose direction is nearest to that of a body, of those that attract or are neutral; none beyond
/// `most_bent`. Cost: that of `chords_of`.
std::optional<Chord> chord_near(const Scene<double>& scene, const ContainerState& now);

/// The largest |multiplier| of the pair differs from 1 by 10⁻⁶ at most: to first order a deviation neither grows nor
/// decays.
bool is_neutral(const Chord& chord);

/// Amplitudes that the swirl forces on a body on a chord, in radians; infinite up to the resonance.
struct ForcedBend {
    double chi, direction;
    double largest() const;
};
ForcedBend forced_bend(const Scene<double>& scene, const Chord& chord, double v);

/// The largest deviation from the chord over some impacts from z on, over what is forced. Infinite where one of them
/// slips, ends contact, or goes on by another number of vertices than the chord's.
double excess_over(const SceneMap<polygon_dimension>& map, const Scene<double>& scene, const Chord& chord,
                   const ForcedBend& forced, PostImpactState<double> z, int impacts = chord_impacts);

/// Names what its tail's kind does not tell: `chord`, with the S* that it is led to, or `accelerated`. Of an orbit that
/// has not settled on a cycle, e = 1, friction and swirl: its next impacts all stick, go on by the chord's j, and
/// deviate from it little more than the swirl forces. A chord that is neutral to first order leaves
/// it undecided, for that reason. Newton's law: a fast body's energy grows geometrically along the tail and 20,000
/// impacts more. Otherwise nothing is changed.
/// Cost: a look at the last state; where that is near a chord 256 impacts, fast under Newton's law 20,000.
void look_for_growth(const SceneMap<polygon_dimension>& map, const Scene<double>& scene,
                     const analysis::Tail<SceneMap<polygon_dimension>>& tail, NamedMode& named);

/// An orbit whose speeds have left the numbers.
void name_divergence(NamedMode& named);

}  // namespace swirl::studies
