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
    std::sort(values.begin(), values.end());
    const auto last = static_cast<double>(values.size() - 1);
    const double place = std::clamp(p * (last + 2) - 1, 0.0, last);
    const auto below = std::min(static_cast<std::size_t>(place), values.size() - 1);
    const auto above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

}  // namespace swirl::analysis
