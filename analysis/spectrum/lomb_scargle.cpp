#include "analysis/spectrum/lomb_scargle.hpp"

#include "analysis/spectrum/fft.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swirl::analysis {

namespace {

constexpr std::size_t width = 16;  // points of the grid
constexpr double sharpness = 2.3 * static_cast<double>(width);

/// Of z in [−1, 1], the place within half the width.
double spreading(double z) {
    return std::exp(sharpness * (std::sqrt(std::max(0.0, 1 - z * z)) - 1));
}

/// ∫ spreading(2p/width) cos(2π k p / points) dp over the points p within half a width.
std::vector<double> transform_of_spreading(std::size_t count, std::size_t points) {
    using Rule = boost::math::quadrature::gauss<double, 60>;
    const std::size_t half = Rule::abscissa().size();
    std::vector<double> weight(half);
    for (std::size_t q = 0; q < half; ++q)
        weight[q] = Rule::weights()[q] * spreading(Rule::abscissa()[q]) * static_cast<double>(width);
    std::vector<double> result(count + 1, 0.0);
    constexpr std::size_t stride = 256;  // cosines by rotation, anew before their rounding adds up
    for (std::size_t q = 0; q < half; ++q) {
        const double turn =
            std::numbers::pi * static_cast<double>(width) / static_cast<double>(points) * Rule::abscissa()[q];
        const std::complex<double> rotation = std::polar(1.0, turn);
        std::complex<double> at = 1;
        for (std::size_t k = 0; k <= count; ++k) {
            if (k % stride == 0) at = std::polar(1.0, turn * static_cast<double>(k));
            result[k] += weight[q] * at.real();
            at = {at.real() * rotation.real() - at.imag() * rotation.imag(),
                  at.real() * rotation.imag() + at.imag() * rotation.real()};
        }
    }
    return result;
}

/// The least number ≥ n of factors 2, 3 and 5.
std::size_t quick_grid(std::size_t n) {
    for (;; ++n) {
        std::size_t rest = n;
        for (const std::size_t prime : {2, 3, 5})
            while (rest % prime == 0) rest /= prime;
        if (rest == 1) return n;
    }
}

}  // namespace

std::vector<std::complex<double>> nonuniform_transform(std::span<const double> times, std::span<const double> values,
                                                       double start, double step, std::size_t count) {
    const std::size_t points = quick_grid(std::max(2 * (2 * count + 1), 2 * width));
    Fft<double> fft(points);
    const std::span<double> grid = fft.input();
    std::fill(grid.begin(), grid.end(), 0.0);
    for (std::size_t j = 0; j < times.size(); ++j) {
        const double turns = (times[j] - start) * step;
        const double place = (turns - std::floor(turns)) * static_cast<double>(points);
        const double first = std::ceil(place - 0.5 * static_cast<double>(width));
        auto at = static_cast<std::size_t>(first + static_cast<double>(points)) % points;
        for (std::size_t k = 0; k < width; ++k) {
            const double z = (first + static_cast<double>(k) - place) * 2 / static_cast<double>(width);
            grid[at] += values[j] * spreading(z);
            if (++at == points) at = 0;
        }
    }
    const std::span<const std::complex<double>> bins = fft.transform();
    const std::vector<double> kernel = transform_of_spreading(count, points);
    std::vector<std::complex<double>> result(count + 1);
    for (std::size_t k = 0; k <= count; ++k) result[k] = bins[k] / kernel[k];
    return result;
}

std::vector<double> lomb_scargle(std::span<const double> times, std::span<const double> values, double step,
                                 std::size_t count) {
    const double start = times.empty() ? 0 : times.front();
    const std::vector<double> ones(times.size(), 1.0);
    const auto sums = nonuniform_transform(times, values, start, step, count);
    const auto squares = nonuniform_transform(times, ones, start, 2 * step, count);
    const double n = static_cast<double>(times.size());
    std::vector<double> power(count);
    for (std::size_t k = 1; k <= count; ++k) {
        // e^{−2πi…}: cosines are real parts, sines minus the imaginary ones. Phases from the first time on cancel in P.
        const double twice = std::arg(std::conj(squares[k])), length = std::abs(squares[k]);
        const double c = std::cos(twice / 2), s = std::sin(twice / 2);
        const double with_cos = sums[k].real() * c - sums[k].imag() * s;
        const double with_sin = -sums[k].imag() * c - sums[k].real() * s;
        const double cos_squares = (n + length) / 2, sin_squares = (n - length) / 2;
        power[k - 1] = with_cos * with_cos / cos_squares / 2;
        // At half the sampling frequency of even times all sines are 0.
        if (sin_squares > 1e-9 * n) power[k - 1] += with_sin * with_sin / sin_squares / 2;
    }
    return power;
}

}  // namespace swirl::analysis
