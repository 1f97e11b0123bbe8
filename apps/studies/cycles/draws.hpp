// Uniform numbers of one candidate, by a generator that is keyed by its place: the same whatever came before.
#pragma once

#include "analysis/random_draws.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace swirl::studies::cycles {

struct Draws {
    std::array<double, 8> u;  ///< in (0, 1]

    Draws(std::uint64_t seed, std::uint64_t period, std::uint64_t index) {
        for (std::uint64_t half = 0; half < 2; ++half) {
            const auto four = analysis::uniform_draws({index, period, half, 0x6f72626974}, {seed, 1});
            std::copy(four.begin(), four.end(), u.begin() + 4 * static_cast<std::ptrdiff_t>(half));
        }
    }
    double between(std::size_t i, double low, double high) const { return low + (high - low) * u[i]; }
};

}  // namespace swirl::studies::cycles
