#include "analysis/classification/growth.hpp"

#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace swirl::analysis {

std::vector<double> block_means(std::span<const double> series, int blocks) {
    std::vector<double> means;
    const std::size_t length = series.size() / static_cast<std::size_t>(blocks);
    for (std::size_t b = 0; b < static_cast<std::size_t>(blocks); ++b) {
        double sum = 0;
        for (std::size_t i = b * length; i < (b + 1) * length; ++i) sum += series[i];
        means.push_back(sum / static_cast<double>(length));
    }
    return means;
}

GrowthExponent growth_exponent(std::span<const double> series, double first) {
    constexpr int blocks = 32;
    constexpr double student = 2.042;  // 97.5 % of 30 degrees of freedom
    constexpr std::size_t fewest = 320;
    if (series.size() < fewest) return {};
    std::vector<double> x, y;
    const double length = std::floor(static_cast<double>(series.size()) / blocks);
    for (const double mean : block_means(series, blocks)) {
        if (!(mean > 0) || std::isinf(mean)) return {};
        x.push_back(std::log(first + (static_cast<double>(x.size()) + 0.5) * length));
        y.push_back(std::log(mean));
    }
    double intercept = 0, slope = 0, variance = 0, covariance = 0, slope_variance = 0, sum = 0;
    gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &intercept, &slope, &variance, &covariance, &slope_variance,
                   &sum);
    const double half = student * std::sqrt(slope_variance);
    return {slope, slope - half, slope + half};
}

bool grows_geometrically(std::span<const double> series) {
    constexpr int blocks = 8;
    constexpr double least_growth = 100;
    if (series.size() < 8 * blocks) return false;
    const std::vector<double> means = block_means(series, blocks);
    return std::adjacent_find(means.begin(), means.end(), [](double a, double b) { return !(b > a); }) == means.end() &&
           means.back() >= least_growth * means.front();
}

}  // namespace swirl::analysis
