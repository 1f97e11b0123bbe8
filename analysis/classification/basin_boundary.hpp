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

/// Follows the boundary from between two states.
///   in, out     states of which the first comes to the attractor and the second does not
///   is_inside   of a state: std::optional<bool>, whether it does; nothing where that is not known
///   is_enough   asked of the orbit's points (those of `in`) each time the two have been halved: true to end
/// Cost: a step of each, and some 13 questions `is_inside` for each 10⁴ that steps part the two.
template <SectionMap M, class IsInside, class IsEnough>
StraddleEnd follow_boundary(const M& map, State<M> in, State<M> out, const IsInside& is_inside,
                            const IsEnough& is_enough, const StraddleOptions& options = {}, const Stop& stop = {}) {
    const auto apart = [&] { return distance(map, coordinates(map, in), coordinates(map, out)); };
    std::vector<Vector<M::dimension>> orbit{coordinates(map, in)};
    for (std::int64_t n = 0, asked = 0; n < options.most_steps;) {
        for (double gap = apart(); gap > options.narrow;) {
            if ((stop && stop()) || asked++ == options.most_questions) return StraddleEnd::not_found;
            const State<M> middle = state_between(map, in, out);
            const std::optional<bool> inside = is_inside(middle);
            if (!inside) return StraddleEnd::undecided;
            (*inside ? in : out) = middle;
            const double left = apart();
            if (!(left < gap)) break;  // rounding
            gap = left;
        }
        if (is_enough(orbit)) return StraddleEnd::found;
        do {
            const auto next_in = map.advance(in), next_out = map.advance(out);
            if (!goes_on(map, next_in) || !goes_on(map, next_out)) return StraddleEnd::ended;
            in = next_in.state;
            out = next_out.state;
            orbit.push_back(coordinates(map, in));
            ++n;
            if (apart() > options.jump) return StraddleEnd::border;
        } while (apart() < options.wide && n < options.most_steps);
    }
    return StraddleEnd::not_found;
}

}  // namespace swirl::analysis
