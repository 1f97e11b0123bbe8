#include "analysis/classification/growth.hpp"

#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

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

namespace {

constexpr int fitted_blocks = 32;
constexpr double least_in_block = 10;     // values
constexpr double student_factor = 2.042;  // 97.5 % of 30 degrees of freedom

/// The step from which on `fitted_blocks` blocks of equal length in ln n have `least_in_block` values each; none if
/// none has.
std::optional<double> first_fitted(double first, double last) {
    for (double from = std::max(first, 1.0); from < last; from *= 1.25)
        if (from * std::expm1(std::log(last / from) / fitted_blocks) >= least_in_block) return from;
    return {};
}

}  // namespace

GrowthExponent growth_exponent(std::span<const double> series, double first) {
    const double last = first + static_cast<double>(series.size());
    const std::optional<double> from = first_fitted(first, last);
    if (!from) return {};
    const double width = std::log(last / *from) / fitted_blocks;
    std::vector<double> x, y;
    auto begin = static_cast<std::size_t>(*from - first);
    for (int b = 1; b <= fitted_blocks; ++b) {
        const double edge = *from * std::exp(b * width) - first;
        const std::size_t end = b == fitted_blocks ? series.size() : static_cast<std::size_t>(edge);
        const double mean = block_means(series.subspan(begin, end - begin), 1).front();
        if (!(mean > 0) || std::isinf(mean)) return {};
        const double low = first + static_cast<double>(begin), high = first + static_cast<double>(end);
        x.push_back(0.5 * (std::log(low) + std::log(high)));
        y.push_back(std::log(mean));
        begin = end;
    }
    double intercept = 0, slope = 0, variance = 0, covariance = 0, slope_variance = 0, sum = 0;
    gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &intercept, &slope, &variance, &covariance, &slope_variance,
                   &sum);
    const double half = student_factor * std::sqrt(slope_variance);
    return {slope, slope - half, slope + half};
}

bool grows_geometrically(std::span<const double> series) {
    if (series.size() < growth_parts * growth_parts) return false;
    const std::vector<double> means = block_means(series, growth_parts);
    return std::adjacent_find(means.begin(), means.end(), [](double a, double b) { return !(b > a); }) == means.end() &&
           means.back() >= least_growth * means.front();
}

}  // namespace swirl::analysis
