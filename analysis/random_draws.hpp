// Random numbers in any order: a pure function of a counter and a key, by Random123's Philox 4×64 (Salmon et al. 2011).
#pragma once

#include <Random123/philox.h>
#include <Random123/uniform.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace swirl::analysis {

/// Four words of 64 random bits.
///   counter  which of the stream's numbers
///   key      the seed, and the stream
inline std::array<std::uint64_t, 4> random_bits(const std::array<std::uint64_t, 4>& counter,
                                                const std::array<std::uint64_t, 2>& key) {
    const auto bits = r123::Philox4x64()({{counter[0], counter[1], counter[2], counter[3]}}, {{key[0], key[1]}});
    return {bits[0], bits[1], bits[2], bits[3]};
}

/// Uniform in (0, 1].
inline double uniform_of(std::uint64_t bits) {
    return r123::u01<double>(bits);
}

/// Four numbers, uniform in (0, 1], of these bits.
inline std::array<double, 4> uniform_draws(const std::array<std::uint64_t, 4>& counter,
                                           const std::array<std::uint64_t, 2>& key) {
    const auto bits = random_bits(counter, key);
    return {uniform_of(bits[0]), uniform_of(bits[1]), uniform_of(bits[2]), uniform_of(bits[3])};
}

}  // namespace swirl::analysis
