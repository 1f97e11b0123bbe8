// A rung of arithmetic: one way to compute the collision map, under a name. All rungs answer in the digits of the top
// one, so that they can be compared there.
#pragma once

#include "map/numbers/quad.hpp"
#include "map/orbit/return_map.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

namespace swirl::studies::tradeoff {

/// One step of a rung.
struct RungStep {
    Outcome outcome = Outcome::unresolved;  ///< completed: an impact followed
    PostImpactState<Quad> after;            ///< bit for bit the rung's own
    ReturnStep<double> rounded;             ///< the whole step in double; what derivatives are taken at
    double jacobi_drift = 0;                ///< J after − J before − what the impact and contact say they added
};

/// A rung's map of one scene.
struct RungMap {
    /// From just after an impact to just after the next: through contact too, where the rung knows of contact.
    std::function<RungStep(const PostImpactState<Quad>&)> advance;
    /// To be timed: follows `steps` impacts from each of so many of the starts that the map was made with, from number
    /// `first` on (counted round), and does nothing else. Returns the impacts.
    std::function<std::int64_t(std::size_t first, std::size_t chains, int steps)> run;
};

struct Rung {
    std::string_view name;
    std::string_view what;  ///< in a line
    /// Its contacts are proven, and it can be recommended; else it is there to be compared with.
    bool is_exact;
    double epsilon;  ///< spacing of its numbers at 1
    RungMap (*make)(const Scene<double>& scene, std::span<const PostImpactState<double>> starts);
    /// The state from which the rung goes on where double's is given: directions to its own digits, and leaving.
    PostImpactState<Quad> (*begin)(const Scene<double>& scene, const PostImpactState<double>& state);
};

/// All rungs, the cheapest that is exact first; the last one, quad, is what the others are compared with.
std::span<const Rung> all_rungs();

}  // namespace swirl::studies::tradeoff
