#include "analysis/fits/robust.hpp"

#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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

}  // namespace swirl::analysis
