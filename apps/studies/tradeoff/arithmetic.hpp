// An arithmetic: one way to compute the collision map, under a name. All arithmetics answer in the digits of the top
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

/// One step of an arithmetic.
struct ArithmeticStep {
    Outcome outcome = Outcome::unresolved;  ///< completed: an impact followed
    PostImpactState<Quad> after;            ///< bit for bit the arithmetic's own
    ReturnStep<double> rounded;             ///< the whole step in double; what derivatives are taken at
    double jacobi_drift = 0;                ///< J after − J before − what the impact and contact say they added
};

/// An arithmetic's map of one scene.
struct ArithmeticMap {
    /// From just after an impact to just after the next: through contact too, where the arithmetic knows of contact.
    std::function<ArithmeticStep(const PostImpactState<Quad>&)> advance;
    /// To be timed: follows `steps` impacts from each of so many of the starts that the map was made with, from number
    /// `first` on (counted round), and does nothing else. Returns the impacts.
    std::function<std::int64_t(std::size_t first, std::size_t chains, int steps)> run;
};

struct Arithmetic {
    std::string_view name;
    std::string_view what;  ///< in a line
    /// Its contacts are proven, and it can be recommended; else it is there to be compared with.
    bool is_exact;
    double epsilon;  ///< spacing of its numbers at 1
    ArithmeticMap (*make)(const Scene<double>& scene, std::span<const PostImpactState<double>> starts);
    /// The state from which the arithmetic goes on where double's is given: directions to its own digits, and leaving.
    PostImpactState<Quad> (*begin)(const Scene<double>& scene, const PostImpactState<double>& state);
};

/// All arithmetics, the cheapest that is exact first; the last one, quad, is what the others are compared with.
std::span<const Arithmetic> all_arithmetics();

}  // namespace swirl::studies::tradeoff
