#include "analysis/means/mean_error.hpp"

#include "analysis/argument_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace swirl::analysis {

namespace {

constexpr std::size_t blocks_at_most = 63;   // from here on more of them make the error hardly better known
constexpr std::size_t blocks_at_least = 16;  // 15 degrees of freedom: ± 2 s cover 93.6 % instead of 95.4
constexpr double most_correlated = 0.99;     // neighbouring blocks: a limit that 16 of them never reach but by chance

/// A sum in four parts, so that no addition waits for the one before.
template <class Term>
double sum_over(std::size_t count, const Term& term) {
    std::array<double, 4> parts{};
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4)
        for (std::size_t k = 0; k < 4; ++k) parts[k] += term(i + k);
    for (; i < count; ++i) parts[0] += term(i);
    return (parts[0] + parts[1]) + (parts[2] + parts[3]);
}

double sum_of(std::span<const double> values) {
    return sum_over(values.size(), [&](std::size_t i) { return values[i]; });
}

/// Sums over blocks: the variance of one, by its length. The deviations' sum is 0, which takes the share of a block.
double variance_rate(std::span<const double> sums, std::size_t length, std::size_t values) {
    const double squares = sum_over(sums.size(), [&](std::size_t i) { return sums[i] * sums[i]; });
    const double share = static_cast<double>(length) / static_cast<double>(values);
    return squares / (static_cast<double>(sums.size() * length) * (1 - share));
}

void merge_pairs(std::vector<double>& sums) {
    const std::size_t pairs = sums.size() / 2;
    for (std::size_t i = 0; i < pairs; ++i) sums[i] = sums[2 * i] + sums[2 * i + 1];
    sums.resize(pairs);
}

/// Of the mean of values whose deviations from it these are.
MeanError error_from(std::vector<double> sums) {
    const std::size_t n = sums.size();
    const auto count = static_cast<double>(n);
    MeanError found;
    if (n < 2 * blocks_at_least) return found;
    const double of_one = variance_rate(sums, 1, n);
    if (of_one == 0) return {SamplingOutcome::sampled, 0, 1, static_cast<std::int64_t>(n), 1};
    double memory = 1;
    for (std::size_t length = 1; sums.size() >= blocks_at_least; length *= 2) {
        const double rate = variance_rate(sums, length, n);
        memory = std::max({memory, rate / of_one, of_one / rate});
        const bool long_enough = std::pow(static_cast<double>(length), 3) >= 2 * count * memory * memory;
        const std::size_t blocks = sums.size();
        merge_pairs(sums);
        if (!long_enough || blocks > blocks_at_most) continue;
        const double r = std::clamp(variance_rate(sums, 2 * length, n) / rate - 1, 0.0, most_correlated);
        const double variance = rate * (1 + r) / (1 - r);
        return {SamplingOutcome::sampled, std::sqrt(variance / count), static_cast<std::int64_t>(length),
                static_cast<std::int64_t>(blocks), variance / of_one};
    }
    return found;
}

/// Σ a_i / Σ b_i, and the sum below it.
struct Ratio {
    double value, below;
};

Ratio ratio_of(std::span<const double> a, std::span<const double> b) {
    if (a.size() != b.size())
        refuse("number of denominators", static_cast<double>(b.size()),
               "that of numerators, " + digits_of(static_cast<double>(a.size())));
    const double below = sum_of(b);
    if (!(below > 0)) refuse("sum of denominators", below, "positive");
    return {sum_of(a) / below, below};
}

}  // namespace

std::string_view name_of(SamplingOutcome outcome) {
    static constexpr std::string_view names[] = {"sampled", "too-short"};
    return names[static_cast<std::size_t>(outcome)];
}

MeanError error_of_mean(std::span<const double> values) {
    const double mean = sum_of(values) / static_cast<double>(values.size());
    std::vector<double> deviations(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) deviations[i] = values[i] - mean;
    return error_from(std::move(deviations));
}

MeanError error_of_ratio(std::span<const double> a, std::span<const double> b) {
    const Ratio ratio = ratio_of(a, b);
    std::vector<double> deviations(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) deviations[i] = a[i] - ratio.value * b[i];
    MeanError found = error_from(std::move(deviations));
    found.standard_error *= static_cast<double>(a.size()) / ratio.below;
    return found;
}

double bound_of_ratio(std::span<const double> a, std::span<const double> b) {
    const Ratio ratio = ratio_of(a, b);
    double sum = 0, least = 0, largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += a[i] - ratio.value * b[i];
        least = std::min(least, sum);
        largest = std::max(largest, sum);
    }
    return (largest - least) / ratio.below;
}

}  // namespace swirl::analysis
