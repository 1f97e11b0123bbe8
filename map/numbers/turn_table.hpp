// Moments at which the swirl's rotation is tabled: a search is free to choose where it evaluates the flight, and
// chooses these.
#pragma once

#include "map/numbers/turn.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace swirl::detail {

inline constexpr std::size_t sixty_fourths = 512;  ///< up to 8 radians, 16 kB

/// cis(k/64) − 1: multiples of ½ and of 1/64 composed, so that no entry has gone through more than 46 roundings.
constexpr std::array<TabledVector, sixty_fourths> sixty_fourths_table() {
    std::array<TabledVector, sixty_fourths> table{};
    Vec2<long double> coarse{0, 0};
    for (std::size_t k = 0; k < sixty_fourths; k += 32) {
        Vec2<long double> turn = coarse;
        for (std::size_t fine = 0; fine < 32; ++fine) {
            table[k + fine] = tabled(turn);
            turn = compose(turn, short_turn(1 / 64.0L));
        }
        coarse = compose(coarse, short_turn(0.5L));
    }
    return table;
}

inline constexpr auto turns_of_sixty_fourths = sixty_fourths_table();

/// A moment close to τ ≥ 0: τ itself, or for double the nearest multiple of 1/64, which needs no series.
template <class T>
[[gnu::always_inline]] inline TurnedMoment<T> moment_near(const T& time) {
    if constexpr (std::is_same_v<T, double>) {
        if (time >= 1.0 / 32 && time < 7.99) {
            // Adding 1.5·2⁴⁶ rounds to a multiple of 1/64, whose number is then in the last bits.
            const double shifted = time + 0x1.8p46;
            const TabledVector& entry = turns_of_sixty_fourths[std::bit_cast<std::uint64_t>(shifted) % sixty_fourths];
            // Number by number: vectors would be copied through memory.
            return {shifted - 0x1.8p46, {entry.value.x, entry.value.y}, {entry.rest.x, entry.rest.y}};
        }
    }
    return {time, cis_minus_one(time), {T(0), T(0)}};
}

/// E(τ + d).
template <class T>
[[gnu::always_inline]] inline Vec2<T> turn_after(const TurnedMoment<T>& moment, const T& d) {
    return compose(moment.turn, moment.rest, cis_minus_one(d));
}

}  // namespace swirl::detail
