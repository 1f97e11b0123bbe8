#include "analysis/spectrum/power_spectrum.hpp"
#include "analysis/spectrum/spectral_entropy.hpp"

#include "analysis/spectrum/bin_average.hpp"
#include "analysis/spectrum/fft.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using namespace swirl::analysis;
using Complex = std::complex<double>;

constexpr double two_pi = 2 * std::numbers::pi;

double integral(const PowerSpectrum& spectrum) {
    return std::accumulate(spectrum.power.begin(), spectrum.power.end(), 0.0) * spectrum.frequency_step;
}

std::vector<double> white_noise(std::size_t n, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> series(n);
    for (double& x : series) x = normal(random);
    return series;
}

TEST(Fft, IsTheDefinition) {
    for (const std::size_t n : {1UL, 2UL, 15UL, 16UL}) {
        RealFft real(n);
        ComplexFft complex(n);
        for (std::size_t j = 0; j < n; ++j) {
            real.input()[j] = std::sin(1.0 + static_cast<double>(j * j));
            complex.input()[j] = real.input()[j];
        }
        const auto real_bins = real.transform();
        const auto complex_bins = complex.transform();
        for (std::size_t k = 0; k < n; ++k) {
            Complex sum = 0;
            for (std::size_t j = 0; j < n; ++j) {
                sum += real.input()[j] * std::polar(1.0, -two_pi * static_cast<double>(j * k) / static_cast<double>(n));
            }
            EXPECT_LT(std::abs(complex_bins[k] - sum), 1e-13);
            if (k < real_bins.size()) {
                EXPECT_LT(std::abs(real_bins[k] - sum), 1e-13);
            }
        }
    }
    EXPECT_THROW(RealFft(0), std::invalid_argument);
}

TEST(PowerSpectrum, ItsIntegralIsTheVariance) {
    const std::vector<double> noise = white_noise(5000, 3);
    const double mean = std::accumulate(noise.begin(), noise.end(), 0.0) / 5000;
    double variance = 0;
    for (const double x : noise) variance += (x - mean) * (x - mean) / 5000;
    for (const Window window : {Window::rectangular, Window::hann, Window::flat_top}) {
        for (const std::size_t length : {0UL, 512UL, 513UL, 5000UL}) {
            SpectrumOptions options;
            options.window = window;
            options.segment_length = length;
            const PowerSpectrum spectrum = power_spectrum(noise, 0.1, options);
            EXPECT_NEAR(integral(spectrum), variance, 1e-12 * variance);
            // The variance of a window's effective n/3.8 (flat top) samples is known to √(2 · 3.8/n) = 0.04.
            EXPECT_NEAR(spectrum.variance_scale, 1, 0.12);
        }
    }
    // One rectangular segment needs no scale: Parseval.
    SpectrumOptions plain;
    plain.window = Window::rectangular;
    plain.segment_length = 5000;
    EXPECT_NEAR(power_spectrum(noise, 0.1, plain).variance_scale, 1, 1e-13);
}

TEST(PowerSpectrum, FrequencyOneIsTheSwirl) {
    std::vector<double> series;
    for (int j = 0; j < 4000; ++j) series.push_back(std::cos(0.05 * j));
    SpectrumOptions options;
    options.segment_length = 4000;
    const PowerSpectrum spectrum = power_spectrum(series, 0.05, options);
    const auto largest = std::max_element(spectrum.power.begin(), spectrum.power.end()) - spectrum.power.begin();
    EXPECT_NEAR(spectrum.frequency[largest], 1.0, spectrum.frequency_step / 2);
    EXPECT_NEAR(spectrum.frequency_step, two_pi / 200, 1e-15);
}

TEST(PowerSpectrum, WhiteNoiseIsFlat) {
    // Power density of unit white noise over frequency in [0, ½]: 2, with relative scatter 1/√K per bin.
    SpectrumOptions options;
    options.segment_length = 128;
    options.cycle_time = 1;
    const PowerSpectrum spectrum = power_spectrum(white_noise(1 << 16, 5), 1, options);
    const double scatter = 2 / std::sqrt(spectrum.effective_segments);
    for (std::size_t k = 2; k + 2 < spectrum.power.size(); ++k) EXPECT_NEAR(spectrum.power[k], 2, 5 * scatter);
    // Half-overlapping Hann segments: ρ₁ = 1/36, so K_eff = K/(1 + 2/36) for many.
    EXPECT_NEAR(spectrum.effective_segments / static_cast<double>(spectrum.segments), 1 / (1 + 2.0 / 36), 1e-3);
    EXPECT_GT(spectral_entropy(spectrum), 0.999);
}

TEST(PowerSpectrum, TheHeldLogisticMapHasItsKnownContinuum) {
    // At r = 4 the orbit is uncorrelated with variance 1/8; held for a time T = 2π each, its density is
    // 2 · ⅛ · sinc²(f) over frequency f ≥ 0 in units of 1/T. Bins of T/8 attenuate by sinc²(f/8).
    BinAverager<double> averager(0, two_pi / 8);
    double x = 0.3141592;
    for (int i = 1; i <= 40000; ++i) {
        averager.add_constant(two_pi * i, x);
        x = 4 * x * (1 - x);
    }
    SpectrumOptions options;
    options.segment_length = 512;
    options.compensate_bin_average = true;
    const PowerSpectrum spectrum = power_spectrum(averager.averages(), two_pi / 8, options);
    const double relative = 1 / std::sqrt(spectrum.effective_segments);
    for (std::size_t k = 2; spectrum.frequency[k] < 0.9; ++k) {
        const double exact = 0.25 * bin_average_gain(spectrum.frequency[k]);
        EXPECT_NEAR(spectrum.power[k], exact, (5 * relative + 0.02) * exact) << spectrum.frequency[k];
    }
}

TEST(PowerSpectrum, AComplexSignalIsTwoSided) {
    std::vector<Complex> clockwise;
    for (int j = 0; j < 1000; ++j) clockwise.push_back(2.0 * std::polar(1.0, -0.3 * j) + Complex(1, 1));
    SpectrumOptions options;
    options.segment_length = 1000;
    options.window = Window::blackman_harris;
    const PowerSpectrum spectrum = power_spectrum(clockwise, 0.3, options);
    ASSERT_TRUE(spectrum.two_sided);
    ASSERT_EQ(spectrum.power.size(), 1000U);
    EXPECT_TRUE(std::is_sorted(spectrum.frequency.begin(), spectrum.frequency.end()));
    EXPECT_EQ(spectrum.frequency[500], 0.0);
    EXPECT_NEAR(integral(spectrum), spectrum.variance, 1e-12);
    const auto largest = std::max_element(spectrum.power.begin(), spectrum.power.end()) - spectrum.power.begin();
    EXPECT_NEAR(spectrum.frequency[largest], -1.0, spectrum.frequency_step / 2);
    double positive = 0;
    for (std::size_t k = 520; k < 1000; ++k) positive += spectrum.power[k] * spectrum.frequency_step;
    EXPECT_LT(positive, 1e-7);
}

TEST(PowerSpectrum, ALineInTheSeriesIsTakenOutByLinearDetrending) {
    std::vector<double> drifting = white_noise(2000, 11);
    std::vector<double> still = drifting;
    for (std::size_t j = 0; j < drifting.size(); ++j) drifting[j] += 0.01 * static_cast<double>(j) - 3;
    SpectrumOptions options;
    options.detrend = Detrend::linear;
    EXPECT_NEAR(power_spectrum(drifting, 1, options).variance, power_spectrum(still, 1, options).variance, 1e-11);
    EXPECT_GT(power_spectrum(drifting, 1).variance, 30);
}

TEST(PowerSpectrum, AConstantSeriesHasNoPowerAndNoEntropy) {
    const PowerSpectrum spectrum = power_spectrum(std::vector<double>(1000, 0.7), 1);
    EXPECT_EQ(spectrum.outcome, SpectrumOutcome::constant);
    EXPECT_EQ(integral(spectrum), 0);
    EXPECT_TRUE(std::isnan(spectral_entropy(spectrum)));
    EXPECT_EQ(power_spectrum(std::vector<double>(5, 0.7), 1).outcome, SpectrumOutcome::too_short);
}

TEST(PowerSpectrum, EntropyOfOneLineIsNearZero) {
    std::vector<double> series;
    for (int j = 0; j < 1024; ++j) series.push_back(std::cos(two_pi * 100 * j / 1024));
    SpectrumOptions options;
    options.segment_length = 1024;
    options.window = Window::rectangular;
    EXPECT_LT(spectral_entropy(power_spectrum(series, 1, options)), 1e-12);
    // Hann spreads it over three bins with shares 1/6, 4/6, 1/6.
    options.window = Window::hann;
    const double three = -(2.0 / 6 * std::log(1.0 / 6) + 4.0 / 6 * std::log(4.0 / 6)) / std::log(512.0);
    EXPECT_NEAR(spectral_entropy(power_spectrum(series, 1, options)), three, 1e-12);
}

TEST(PowerSpectrum, TheSameBitsInEveryThread) {
    const std::vector<double> noise = white_noise(4096, 9);
    const PowerSpectrum alone = power_spectrum(noise, 1);
    std::vector<PowerSpectrum> results(4);
    std::vector<std::thread> threads;
    for (PowerSpectrum& result : results) threads.emplace_back([&] { result = power_spectrum(noise, 1); });
    for (std::thread& thread : threads) thread.join();
    for (const PowerSpectrum& result : results) EXPECT_EQ(result.power, alone.power);
}

TEST(PowerSpectrum, RefusesOptionsOutOfRange) {
    const std::vector<double> noise = white_noise(100, 1);
    EXPECT_THROW(power_spectrum(noise, 0), std::invalid_argument);
    EXPECT_THROW(power_spectrum(noise, NAN), std::invalid_argument);
    SpectrumOptions options;
    options.overlap = 1;
    EXPECT_THROW(power_spectrum(noise, 1, options), std::invalid_argument);
    options = {};
    options.segment_length = 3;
    EXPECT_THROW(power_spectrum(noise, 1, options), std::invalid_argument);
    options = {};
    options.cycle_time = -1;
    EXPECT_THROW(power_spectrum(noise, 1, options), std::invalid_argument);
    std::vector<double> infinite = noise;
    infinite[3] = INFINITY;
    EXPECT_THROW(power_spectrum(infinite, 1), std::invalid_argument);
}

TEST(PowerSpectrum, AutomaticSegmentsAreAboutSixteen) {
    for (const std::size_t n : {1000UL, 4096UL, 20000UL, 123457UL}) {
        const PowerSpectrum spectrum = power_spectrum(white_noise(n, 2), 1);
        EXPECT_GE(spectrum.segments, 16U);
        EXPECT_LE(spectrum.segments, 18U);
    }
}

}  // namespace
