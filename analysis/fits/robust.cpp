#include "analysis/fits/robust.hpp"

#include "analysis/random_draws.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace swirl::analysis {

double weighted_median(std::vector<double> values, std::vector<double> weights) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    const double half = 0.5 * std::accumulate(weights.begin(), weights.end(), 0.0);
    double sum = 0;
    for (const std::size_t i : order) {
        sum += weights[i];
        if (sum > 0 && sum >= half) return values[i];
    }
    return nan;
}

double quantile(std::vector<double> values, double p) {
    if (values.empty()) return nan;
    const auto last = static_cast<double>(values.size() - 1);
    const double place = std::clamp(p * (last + 2) - 1, 0.0, last);
    const auto below = std::min(static_cast<std::size_t>(place), values.size() - 1);
    const auto lower = values.begin() + static_cast<std::ptrdiff_t>(below);
    std::nth_element(values.begin(), lower, values.end());
    const double upper = lower + 1 == values.end() ? *lower : *std::min_element(lower + 1, values.end());
    return *lower + (place - static_cast<double>(below)) * (upper - *lower);
}

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
