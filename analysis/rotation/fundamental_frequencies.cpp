#include "analysis/rotation/fourier_sum.hpp"
#include "analysis/rotation/rotation_number.hpp"
#include "analysis/rotation/weighted_birkhoff.hpp"
#include "analysis/spectrum/fft.hpp"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <stdexcept>
#include <vector>

namespace swirl::analysis {

namespace {

using rotation_detail::FourierSum, rotation_detail::fourier_sum, rotation_detail::unit_phasor;
using Complex = std::complex<double>;

std::vector<double> bump_weights(std::size_t n) {
    std::vector<double> weights(n);
    for (std::size_t j = 0; j < n; ++j) {
        weights[j] = birkhoff_weight(static_cast<double>(j + 1) / (static_cast<double>(n) + 1));
    }
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// The frequency within `reach` of `guess` at which the weighted Fourier sum is largest.
double refine(std::span<const double> weighted, double guess, double reach) {
    // A maximum can be located to half of double's 53 bits only, for it is flat; from there on the root of the slope
    // d|A|²/df ∝ Im(A* slope) is followed to full precision. Searched in units of `reach`.
    constexpr int half_precision = 20;
    constexpr double margin = 1e-4;
    // Half an ulp of the frequency, or what the rounding of the sums (64 ε) leaves of the slope's root.
    const double known = std::max(0x1p-53 * guess, 0x1p-47 * reach);
    std::uintmax_t iterations = 100;
    const auto at = [&](double u) { return fourier_sum(weighted, guess + u * reach); };
    const double coarse = boost::math::tools::brent_find_minima([&](double u) { return -std::abs(at(u).value); }, -1.0,
                                                                1.0, half_precision, iterations)
                              .first;
    const auto slope = [&](double u) {
        const FourierSum sum = at(u);
        return (std::conj(sum.value) * sum.slope).imag();
    };
    const double low = slope(coarse - margin);
    const double high = slope(coarse + margin);
    if (low * high >= 0) return guess + coarse * reach;
    iterations = 100;
    // Not relative to u, which is near 0 where the guess is good: the slope would be followed far below its rounding.
    const auto is_known = [&](double a, double b) { return (b - a) * reach <= known; };
    const auto bracket =
        boost::math::tools::toms748_solve(slope, coarse - margin, coarse + margin, low, high, is_known, iterations);
    return guess + (bracket.first + bracket.second) / 2 * reach;
}

std::vector<double> product(std::span<const double> a, std::span<const double> b) {
    std::vector<double> result(a.size());
    std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::multiplies<>());
    return result;
}

double strongest_bin(std::span<const double> weighted, RealFft& fft) {
    std::copy(weighted.begin(), weighted.end(), fft.input().begin());
    const std::span<const Complex> bins = fft.transform();
    std::size_t best = 1;
    for (std::size_t k = 1; k < bins.size(); ++k) {
        if (std::norm(bins[k]) > std::norm(bins[best])) best = k;
    }
    return static_cast<double>(best);
}

}  // namespace

std::vector<FrequencyLine> fundamental_frequencies(std::span<const double> samples, const RotationOptions& options,
                                                   const std::function<bool(const FrequencyLine&)>& goes_on) {
    for (const double x : samples) {
        if (!std::isfinite(x)) throw std::invalid_argument("samples: every value must be finite");
    }
    std::vector<FrequencyLine> lines;
    const std::size_t n = samples.size();
    if (n < std::max<std::size_t>(options.min_samples, 8)) return lines;
    const std::vector<double> weights = bump_weights(n);
    const std::vector<double> half_weights = bump_weights(n / 2);
    std::vector<double> rest(samples.begin(), samples.end());
    const double mean = weighted_birkhoff_average(samples).average;
    for (double& x : rest) x -= mean;
    const double variance = std::inner_product(rest.begin(), rest.end(), rest.begin(), 0.0) / static_cast<double>(n);
    if (!(variance > 0)) return lines;

    RealFft fft(n);
    const double bin = 1 / static_cast<double>(n);
    for (int count = 0; count < options.max_lines; ++count) {
        const std::vector<double> weighted = product(rest, weights);
        FrequencyLine line;
        line.frequency = std::clamp(refine(weighted, strongest_bin(weighted, fft) * bin, bin), 0.0, 0.5);
        const Complex amplitude = fourier_sum(weighted, line.frequency).value;
        // At the Nyquist frequency the line and its mirror image coincide.
        const bool nyquist = 0.5 - line.frequency < 1e-3 * bin;
        if (nyquist) line.frequency = 0.5;
        line.amplitude = (nyquist ? 1 : 2) * std::abs(amplitude);
        line.phase = std::arg(amplitude);
        line.share = line.amplitude * line.amplitude * (nyquist ? 1 : 0.5) / variance;
        if (!(line.share >= options.min_line_share)) break;
        const std::span<const double> all(rest);
        const double first = refine(product(all.first(n / 2), half_weights), line.frequency, 2 * bin);
        const double last = refine(product(all.last(n / 2), half_weights), line.frequency, 2 * bin);
        line.half_difference = std::abs(first - last);
        lines.push_back(line);
        if (goes_on && !goes_on(line)) break;
        const Complex begin = std::polar(1.0, line.phase);
        for (std::size_t j = 0; j < n; ++j) {
            const Complex phasor = unit_phasor(line.frequency * static_cast<double>(j));
            rest[j] -= line.amplitude * (phasor * begin).real();
        }
    }
    return lines;
}

}  // namespace swirl::analysis
