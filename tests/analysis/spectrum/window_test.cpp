#include "analysis/spectrum/segments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace {

using namespace swirl::analysis;

constexpr Window all_windows[] = {Window::rectangular, Window::hann, Window::hamming, Window::blackman_harris,
                                  Window::flat_top};

TEST(Window, TheClosedFormTransformIsTheSum) {
    constexpr std::size_t n = 96;
    for (const Window window : all_windows) {
        const std::vector<double> w = window_values(window, n);
        for (const double x : {0.0, 0.3, 0.5, 1.0, 1.7, -2.4, 11.25, 47.0}) {
            std::complex<double> sum = 0;
            for (std::size_t j = 0; j < n; ++j) {
                sum += w[j] * std::polar(1.0, -2 * std::numbers::pi * x * static_cast<double>(j) / n);
            }
            EXPECT_NEAR(window_transform(window, n, x), std::abs(sum), 1e-12 * n) << name_of(window) << " at " << x;
        }
    }
}

TEST(Window, TheMainLobeEndsWhereItIsSaidTo) {
    constexpr std::size_t n = 512;
    for (const Window window : all_windows) {
        const double edge = main_lobe_half_width(window);
        EXPECT_LT(window_transform(window, n, edge), 1e-12 * n) << name_of(window);
        EXPECT_GT(window_transform(window, n, edge - 0.5), 1e-5 * n) << name_of(window);
    }
}

TEST(Window, EquivalentNoiseBandwidthsAreHarris) {
    // Harris, Proc. IEEE 66 (1978) 51, table I: n Σw²/(Σw)² in bins.
    const auto bandwidth = [](Window window) {
        double sum = 0;
        double squares = 0;
        for (const double w : window_values(window, 1024)) {
            sum += w;
            squares += w * w;
        }
        return 1024 * squares / (sum * sum);
    };
    EXPECT_NEAR(bandwidth(Window::rectangular), 1.00, 0.005);
    EXPECT_NEAR(bandwidth(Window::hann), 1.50, 0.005);
    EXPECT_NEAR(bandwidth(Window::hamming), 1.36, 0.005);
    EXPECT_NEAR(bandwidth(Window::blackman_harris), 2.00, 0.005);
}

TEST(Window, NamesComeBack) {
    for (const Window window : all_windows) EXPECT_EQ(window_from_name(name_of(window)), window);
    EXPECT_THROW(window_from_name("welch"), std::invalid_argument);
}

}  // namespace
