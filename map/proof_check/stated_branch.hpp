// A branch of cycles along a parameter as a certificate states it, and its check by other equations.
#pragma once

#include "map/proof_check/stated_cycle.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace swirl::proof_check {

/// For every value of unknown number `running` in [low, high] there is a cycle whose other unknowns lie within `within`
/// of `middle`. Unknowns are, step by step, ψ, χ, v_n, v_t, S (of a disk without χ) and the flight's time, then the
/// parameter. If `decided`, so many multipliers lie outside the unit circle and so many inside, for all of the box.
struct StatedBox {
    std::size_t running = 0;
    double low = 0, high = 0;
    std::vector<double> middle;
    double within = 0;
    bool decided = false;
    int outside = 0, inside = 0;
};

struct StatedBranch {
    StatedCycle cycle;             ///< the scene and the word; boxes and multipliers are not read
    std::string parameter;         ///< alpha, beta, mu, restitution, inertia-factor
    double from = 0, to = 0;       ///< the cycles' parameters reach from one to the other
    std::vector<StatedBox> boxes;  ///< each with the next of one curve
};

/// Proves all of it again; empty if it holds, else what does not. The pieces of curves are enclosed by the same search
/// (map/intervals/solution_curve.hpp); the equations, the inequalities of flight and impact, the derivative and the
/// count of multipliers are this folder's.
///   stop  true: end, with words that say so
std::string what_fails(const StatedBranch& branch, const std::function<bool()>& stop);

}  // namespace swirl::proof_check
