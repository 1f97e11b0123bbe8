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

/// A fold, flip or Neimark–Sacker point (map/intervals/bifurcation_point.hpp says what of), whose unknowns lie within
/// `within` of `middle`, on the branch in one of the boxes first … last − 1.
struct StatedSpecial {
    std::string kind;  ///< fold, flip, neimark-sacker
    std::vector<double> middle;
    double within = 0;
    double low = 0, high = 0;              ///< of the parameter
    double angle_low = 0, angle_high = 0;  ///< θ of a Neimark–Sacker point
    std::size_t first = 0, last = 0;
};

struct StatedBranch {
    StatedCycle cycle;                   ///< the scene and the word; boxes and multipliers are not read
    std::string parameter;               ///< alpha, beta, mu, restitution, inertia-factor
    double from = 0, to = 0;             ///< the cycles' parameters reach from one to the other
    std::vector<StatedBox> boxes;        ///< each with the next of one curve
    std::vector<StatedSpecial> special;  ///< those that are stated as proven
};

/// Proves all of it again; empty if it holds, else what does not. The pieces of curves are enclosed by the same search
/// (map/intervals/solution_curve.hpp), special points by the same extended system; the equations, the inequalities of
/// flight and impact, the derivative and the count of multipliers are this folder's.
///   stop  true: end, with words that say so
std::string what_fails(const StatedBranch& branch, const std::function<bool()>& stop);

}  // namespace swirl::proof_check
