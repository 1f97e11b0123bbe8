// Whether a contact that the search claims is the first, decided in interval arithmetic.
#pragma once

#include "map/first_contact/first_contact.hpp"
#include "tests/map/certainty/flight_in_balls.hpp"

namespace swirl::tests {

enum class Seen {
    proven,   ///< every gap is negative until `rounding` before the claimed time, where the vertex' one root is
    tie,      ///< another vertex strikes within the same rounding, and is later
    swapped,  ///< the same, and is earlier: right if it was flagged as simultaneous
    graze,    ///< a gap is positive before, by no more than `rounding_depth`: below what a double can say of it
    coarse,  ///< right to (1 + β) times the rounding of its place, but not of its way: a hop found from far beyond it,
             ///< or a gap formed from P·w on a wide swirl
    tangent,   ///< the vertex that strikes has no root of its own within rounding: it comes to the wall and turns
    refuted,   ///< a vertex is outside before, by more than that; or the one that strikes is not at the wall
    undecided  ///< the subdivision did not end within its limits
};
inline constexpr int seen_kinds = 8;
constexpr const char* name_of(Seen seen) {
    constexpr const char* names[seen_kinds] = {"proven", "tie",     "swapped", "graze",
                                               "coarse", "tangent", "refuted", "undecided"};
    return names[static_cast<int>(seen)];
}

/// Gaps are known to some ε of what the flight has moved: 16 are allowed.
inline double rounding_depth(double way) {
    return 16 * 0x1p-52 * way;
}

struct Check {
    Seen seen = Seen::undecided;
    int vertex = -1;   ///< the one that is outside, ties, or could not be decided
    double depth = 0;  ///< how far outside one was seen at least (a gap)
    double late = 0;   ///< |claimed − exact| time in ε (way/g′ + time); of proven, tie and swapped
    double apart = 0;  ///< time from the exact contact to the other's, of tie and swapped
    long pieces = 0;   ///< of time
    double where = 0;  ///< the time at which one is outside, or could not be decided
};

/// Of a contact that was found. `scene` is the one that `flight` belongs to.
Check check_contact(const Scene<double>& scene, const Flight<double>& flight, const FirstContact<double>& contact);

/// Of the claim that nothing touches on [0, end].
Check check_none(const Scene<double>& scene, const Flight<double>& flight, double end);

}  // namespace swirl::tests
