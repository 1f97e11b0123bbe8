// Uniform numbers of one candidate, by a generator that is keyed by its place: the same whatever came before.
#pragma once

#include <Random123/philox.h>
#include <Random123/uniform.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace swirl::studies::cycles {

struct Draws {
    std::array<double, 8> u;  ///< in (0, 1]

    Draws(std::uint64_t seed, std::uint64_t period, std::uint64_t index) {
        const r123::Philox4x64 generator;
        for (std::uint64_t half = 0; half < 2; ++half) {
            const auto bits = generator({{index, period, half, 0x6f72626974}}, {{seed, 1}});
            for (std::size_t i = 0; i < 4; ++i) u[4 * half + i] = r123::u01<double>(bits[i]);
        }
    }
    double between(std::size_t i, double low, double high) const { return low + (high - low) * u[i]; }
};

}  // namespace swirl::studies::cycles
