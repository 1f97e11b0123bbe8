#include "analysis/spectrum/lomb_scargle.hpp"

#include "analysis/spectrum/nonuniform_transform.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swirl::analysis {

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
