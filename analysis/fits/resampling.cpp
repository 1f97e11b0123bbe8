#include "analysis/fits/resampling.hpp"

#include "analysis/random_draws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace swirl::analysis {

namespace {

/// Uniform in (0, 1], number `i` of stream `stream`.
double uniform_draw(std::uint64_t seed, std::uint64_t stream, std::size_t i) {
    return uniform_of(random_bits({i / 4, stream, 0, 0x666974}, {seed, 1})[i % 4]);
}

/// A place among `count`.
std::size_t drawn_place(double uniform, std::size_t count) {
    return std::min(static_cast<std::size_t>(uniform * static_cast<double>(count)), count - 1);
}

}  // namespace

std::vector<double> bootstrap_weights(std::size_t count, std::uint64_t seed, std::uint64_t index) {
    std::vector<double> weights(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) weights[drawn_place(uniform_draw(seed, index + 1, i), count)] += 1;
    return weights;
}

Eigen::Vector3d normal_draws(std::uint64_t seed, std::uint64_t draw, std::size_t i) {
    constexpr std::uint64_t normal_streams = 1ULL << 32;  // beyond those of the bootstrap
    const std::array<double, 4> uniform = uniform_draws({i, normal_streams + draw, 0, 0x666974}, {seed, 1});
    std::array<double, 4> normal{};
    for (std::size_t pair = 0; pair < 2; ++pair) {  // Box & Muller
        const double length = std::sqrt(-2 * std::log(uniform[2 * pair]));
        const double turn = 6.283185307179586 * uniform[2 * pair + 1];
        normal[2 * pair] = length * std::cos(turn), normal[2 * pair + 1] = length * std::sin(turn);
    }
    return {normal[0], normal[1], normal[2]};
}

std::vector<std::size_t> random_parts(std::size_t count, std::size_t parts, std::uint64_t seed) {
    std::vector<std::size_t> part(count);
    for (std::size_t i = 0; i < count; ++i) part[i] = i % parts;
    for (std::size_t i = count; i > 1; --i) std::swap(part[i - 1], part[drawn_place(uniform_draw(seed, 0, i), i)]);
    return part;
}

}  // namespace swirl::analysis
