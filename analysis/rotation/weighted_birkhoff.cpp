#include "analysis/rotation/weighted_birkhoff.hpp"

#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace swirl::analysis {

namespace {

double plain_weighted_mean(std::span<const double> samples) {
    const double intervals = static_cast<double>(samples.size()) + 1;
    double sum = 0;
    double weights = 0;
    for (std::size_t j = 0; j < samples.size(); ++j) {
        const double weight = birkhoff_weight(static_cast<double>(j + 1) / intervals);
        sum += weight * samples[j];
        weights += weight;
    }
    return sum / weights;
}

}  // namespace

double birkhoff_weight(double t) {
    return t > 0 && t < 1 ? std::exp(-1 / (t * (1 - t))) : 0;
}

WeightedAverage weighted_birkhoff_average(std::span<const double> samples) {
    if (samples.empty()) return {nan, nan, 0};
    WeightedAverage result{plain_weighted_mean(samples), nan, 0};
    const std::size_t half = samples.size() / 2;
    if (half == 0) return result;
    result.half_difference =
        std::abs(plain_weighted_mean(samples.first(half)) - plain_weighted_mean(samples.last(half)));
    const double relative = result.half_difference / std::max(1.0, std::abs(result.average));
    result.digits = std::clamp(-std::log10(relative), 0.0, 16.0);
    return result;
}

}  // namespace swirl::analysis
