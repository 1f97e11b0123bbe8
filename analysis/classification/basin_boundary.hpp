// The boundary of a basin of attraction, followed to where it leads.
//
// Of two states that come to different attractors the boundary lies in between. They are halved until they are `narrow`
// apart, take steps until these have parted them to `wide`, and are halved again: what lies between them is an orbit on
// the boundary to `wide`. It comes to what attracts there, an unstable cycle or torus, whose stable set the boundary
// is. Where the map jumps (a border) a step parts states however close, and the boundary ends there.
// Sources: P. M. Battelino, C. Grebogi, E. Ott, J. A. Yorke, E. D. Yorke, Physica D 32 (1988) 296 (bisection and
// straddle orbits); J. D. Skufca, J. A. Yorke, B. Eckhardt, Phys. Rev. Lett. 96 (2006) 174101 (edge states).
#pragma once

#include "analysis/classification/tail.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace swirl::analysis {

struct StraddleOptions {
    std::int64_t most_steps = 40'000, most_questions = 4000;  ///< along one boundary
    double narrow = 1e-12, wide = 1e-8;                       ///< largest differences of coordinates
    double jump = 1e-3;  ///< so far a step takes only states on either side of a border
};

enum class StraddleEnd {
    found,      ///< who looked at the orbit had seen enough
    border,     ///< a step parted the two: the map jumps there
    rounding,   ///< the verdict on a state is another after a step: its basins are mixed down to rounding
    undecided,  ///< of a state in between nobody knows the attractor
    ended,      ///< the map has no next step
    not_found,  ///< most_steps or most_questions, or stopped
};

/// The state half way between two that are close.
template <SectionMap M>
State<M> state_between(const M& map, const State<M>& a, const State<M>& b) {
    const Vector<M::dimension> begin = coordinates(map, a);
    return state_at(map, Vector<M::dimension>(begin + difference(map, coordinates(map, b), begin) / 2));
}

/// Two states of which the first comes to the attractor and the second does not, and how often it was asked.
template <SectionMap M>
struct Straddle {
    State<M> in, out;
    std::int64_t asked = 0;

    double width(const M& map) const { return distance(map, coordinates(map, in), coordinates(map, out)); }
};

/// Halves the way between them until they are `narrow` apart, or as near as rounding lets them be. Nothing: they are;
/// else why not.
template <SectionMap M, class IsInside>
std::optional<StraddleEnd> narrowed(const M& map, Straddle<M>& two, const IsInside& is_inside,
                                    const StraddleOptions& options, const Stop& stop) {
    bool in_is_new = false, out_is_new = false;
    for (double width = two.width(map); width > options.narrow;) {
        if ((stop && stop()) || two.asked++ == options.most_questions) return StraddleEnd::not_found;
        const State<M> middle = state_between(map, two.in, two.out);
        const std::optional<bool> inside = is_inside(middle);
        if (!inside) return StraddleEnd::undecided;
        (*inside ? two.in : two.out) = middle;
        (*inside ? in_is_new : out_is_new) = true;
        const double left = two.width(map);
        if (!(left < width)) break;
        width = left;
    }
    // An end that no middle has replaced may have lost its side on its last steps.
    for (const bool inside : {true, false}) {
        if (inside ? in_is_new : out_is_new) continue;
        ++two.asked;
        const std::optional<bool> found = is_inside(inside ? two.in : two.out);
        if (found != inside) return found ? StraddleEnd::rounding : StraddleEnd::undecided;
    }
    return {};
}

/// Follows the boundary from between two states.
///   is_inside  of a state: std::optional<bool>, whether it comes to the attractor; nothing where that is not known
///   is_enough  asked of the orbit's points (those of `in`) each time the two have been halved: true to end
/// Cost: a step of each, and some 13 questions `is_inside` for each 10⁴ that steps part the two.
template <SectionMap M, class IsInside, class IsEnough>
StraddleEnd follow_basin_boundary(const M& map, const State<M>& in, const State<M>& out, const IsInside& is_inside,
                                  const IsEnough& is_enough, const StraddleOptions& options = {},
                                  const Stop& stop = {}) {
    Straddle<M> two{in, out};
    std::vector<Vector<M::dimension>> orbit{coordinates(map, in)};
    while (static_cast<std::int64_t>(orbit.size()) <= options.most_steps) {
        if (const auto why = narrowed(map, two, is_inside, options, stop)) return *why;
        if (is_enough(orbit)) return StraddleEnd::found;
        do {
            const auto next_in = map.advance(two.in), next_out = map.advance(two.out);
            if (!goes_on(map, next_in) || !goes_on(map, next_out)) return StraddleEnd::ended;
            two.in = next_in.state;
            two.out = next_out.state;
            orbit.push_back(coordinates(map, two.in));
            if (two.width(map) > options.jump) return StraddleEnd::border;
        } while (two.width(map) < options.wide && static_cast<std::int64_t>(orbit.size()) <= options.most_steps);
    }
    return StraddleEnd::not_found;
}

}  // namespace swirl::analysis
