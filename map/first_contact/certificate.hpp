// Proof that nothing touches between two moments, from what is known at the two moments alone.
//
// On [0, h] let H be the quintic that shares g, g′, g″ with a gap at both ends. With |g⁽⁶⁾| ≤ M,
// |g − H| ≤ M s³(h − s)³/720, and s³(h − s)³ ≤ h⁶ (B₂ + B₃)/20 with B₂, B₃ the middle Bernstein polynomials of degree
// five on [0, h]. Hence g ≤ Σ cₖ Bₖ with H's Bernstein coefficients and M h⁶/14400 added to c₂ and c₃: if no
// coefficient is positive, no contact is between. No square root, no search; no later operation waits for the result. M
// holds on all of [0, h] and not only while nothing is outside: it rests on |P| ≤ outer + β, and P, the centre seen
// from the swirl's, is linear in time and within that at both ends.
#pragma once

#include "map/model/flight.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace swirl::detail {

template <class T>
inline T fourth_root_of_epsilon() {
    if constexpr (std::is_same_v<T, double>) {
        return 0x1p-13;
    } else {
        using std::sqrt;
        return sqrt(sqrt(epsilon<T>()));
    }
}

#include "map/first_contact/certificate_formulas.hpp"

/// A search for a root ahead that has no guarantees (those come from `clear_between` afterwards) gives up beyond these.
inline constexpr int correction_limit = 8;
inline constexpr int most_pieces = 32;       // looks of a proof in pieces
inline constexpr double longest_guess = 16;  // radians of swirl
inline constexpr double longest_correction = 0.5;

}  // namespace swirl::detail
