// The centre's gap along a flight as a scalar function of time, for searches on the critical path.
//
// In the laboratory the centre is at P(τ) = P₀ + Vτ from the swirl's centre, and X = P − w. So
//     |X|² − |X₀|² = 2τ V·X₀ + τ²|V|² − 2 (A c + B s),   E(τ) = (c, s),
// with A = P·w₀ and B = P·(i w₀) linear in τ: six numbers per flight, and every derivative from the same products. B
// begins as X₀·(i w₀), since w₀·(i w₀) = 0: formed from P₀ = X₀ + w₀ it would lose X₀ where that is small against β.
// For the disk this is the gap, for a polygon the centre's distance against that at the start.
//
// One evaluation of its Taylor polynomial of tenth degree, a few hundredths of a radian d away from the contact, gives
// the contact's time to rounding: the truncation error is below M d¹¹/11!, |g⁽¹¹⁾| ≤ M. Two corrections, of fifth and
// of third order, solve the polynomial; only their two divisions are on the critical path.
#pragma once

#include "map/model/flight.hpp"
#include "map/numbers/turn_table.hpp"

#include <cmath>
#include <cstddef>
#include <type_traits>

namespace swirl::detail {

template <class T>
inline T cube_root_of_epsilon() {
    if constexpr (std::is_same_v<T, double>) {
        return 0x1p-17;
    } else {
        using std::cbrt;
        return cbrt(epsilon<T>());
    }
}

#include "map/first_contact/circle_path_formulas.hpp"

/// A guess without the start's derivatives, for long or curved flights of double: the gap is sampled at tabled moments,
/// first 1/32, from ¼ on four times per radian, and the line through the two samples between which g changes its sign
/// gives the time. −1 if g stays negative.
template <class T>
[[gnu::noinline]] inline T sampled_guess(const CirclePath<T>& path) {
    if constexpr (std::is_same_v<T, double>) {
        double before = 0;
        std::size_t step = 2;
        for (std::size_t k = step; k < sixty_fourths; k += step) {
            const double time = static_cast<double>(k) / 64;
            const Vec2<double>& turn = turns_of_sixty_fourths[k].value;
            const double gap = gap_along(path, time, turn);
            if (gap > 0) return time - static_cast<double>(step) / 64 * gap / (gap - before);
            before = gap;
            if (step < 16) step = k;
        }
    }
    return T(-1);
}

}  // namespace swirl::detail
