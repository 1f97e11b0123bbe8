#include "analysis/spectrum/lines.hpp"

#include "analysis/spectrum/bin_average.hpp"
#include "tests/analysis/maps/angle.hpp"
#include "tests/analysis/maps/logistic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

namespace {

using namespace swirl::analysis;
using maps::golden_mean;
using maps::two_pi;

constexpr Window all_windows[] = {Window::rectangular, Window::hann, Window::hamming, Window::blackman_harris,
                                  Window::flat_top};

std::vector<double> sine(std::size_t n, double frequency, double amplitude) {
    std::vector<double> series(n);
    for (std::size_t j = 0; j < n; ++j) {
        series[j] = amplitude * std::cos(two_pi * frequency * static_cast<double>(j) + 0.7);
    }
    return series;
}

SpectrumOptions one_segment(Window window) {
    SpectrumOptions options;
    options.window = window;
    options.segment_length = 4096;
    options.cycle_time = 1;
    return options;
}

std::vector<double> held_logistic(double r, int iterates) {
    const maps::Logistic map{r};
    Vector<1> z{0.3};
    for (int i = 0; i < 1000; ++i) z = map.advance(z).state;
    BinAverager<double> averager(0, 0.25);
    for (int i = 1; i <= iterates; ++i) {
        averager.add_constant(i, z[0]);
        z = map.advance(z).state;
    }
    return averager.averages();
}

// A pure sine of irrational frequency: 1e-4 bin and 1e-3 of the amplitude. The rectangular window is the exception: its
// side lobes fall as 1/x only, and the mirror image, 2 · 870 bins away, shifts the line by up to 1/(2 · 870) bins.
TEST(Lines, AnIrrationalSineIsFoundBetweenTheBins) {
    for (const Window window : all_windows) {
        for (const double detune : {0.0, 0.1, golden_mean - 0.5, 0.3, 0.4999}) {
            const double frequency = (870 + detune + std::sqrt(2.0) * 1e-3) / 4096;
            const auto spectrum = power_spectrum(sine(4096, frequency, 1.7), 1, one_segment(window));
            const auto peaks = find_peaks(spectrum);
            ASSERT_FALSE(peaks.empty()) << name_of(window);
            const double bins = window == Window::rectangular ? 1e-3 : 1e-4;
            EXPECT_NEAR(peaks[0].frequency * 4096, frequency * 4096, bins) << name_of(window) << " " << detune;
            EXPECT_NEAR(peaks[0].amplitude, 1.7, 1.7e-3) << name_of(window) << " " << detune;
            EXPECT_NEAR(peaks[0].power, 1.7 * 1.7 / 2, 2 * 1.7e-3 * 1.7);
        }
    }
}

TEST(Lines, CompensationGivesTheAmplitudeBeforeAveraging) {
    // cos ωt averaged over unit bins is cos ω(t + ½) sinc: at f = 0.4 cycles per bin sinc² = 0.57.
    const double frequency = 0.4 + 1e-4 * golden_mean;
    BinAverager<double> averager(0, 1);
    averager.add(4096, [&](double a, double b) {
        return (std::sin(two_pi * frequency * b) - std::sin(two_pi * frequency * a)) / (two_pi * frequency);
    });
    SpectrumOptions options = one_segment(Window::blackman_harris);
    const auto seen = find_peaks(power_spectrum(averager.averages(), 1, options));
    options.compensate_bin_average = true;
    const auto restored = find_peaks(power_spectrum(averager.averages(), 1, options));
    ASSERT_FALSE(seen.empty());
    ASSERT_FALSE(restored.empty());
    EXPECT_NEAR(seen[0].amplitude, std::sqrt(bin_average_gain(frequency)), 1e-3);
    EXPECT_NEAR(restored[0].amplitude, 1, 1e-3);
    EXPECT_NEAR(restored[0].frequency, frequency, 1e-4 / 4096);
}

TEST(Lines, AComplexLineHasASign) {
    std::vector<std::complex<double>> series;
    for (int j = 0; j < 4096; ++j) {
        series.push_back(3.0 * std::polar(1.0, -two_pi * 0.1234567 * j) + 0.5 * std::polar(1.0, two_pi * 0.31 * j));
    }
    const auto peaks = find_peaks(power_spectrum(series, 1, one_segment(Window::blackman_harris)));
    ASSERT_GE(peaks.size(), 2U);
    EXPECT_NEAR(peaks[0].frequency, -0.1234567, 1e-4 / 4096);
    EXPECT_NEAR(peaks[0].amplitude, 3, 3e-3);
    EXPECT_NEAR(peaks[0].power, 9, 2e-2);
    EXPECT_NEAR(peaks[1].frequency, 0.31, 1e-4 / 4096);
    EXPECT_NEAR(peaks[1].amplitude, 0.5, 5e-4);
}

TEST(Lines, FixedIsConstant) {
    EXPECT_EQ(line_share(power_spectrum(std::vector<double>(2000, -1.6), 1)).verdict, SpectrumVerdict::constant);
}

TEST(Lines, PeriodicIsLines) {
    // ±1 held for 5 each, 40 bins per period: odd harmonics of 1/10. Twenty equal bins of +1 and of −1 sum to
    // A_k = 4/(40 sin(πk/40)), which is 4/(πk) with what folds back from above the Nyquist frequency.
    BinAverager<double> averager(0, 0.25);
    for (int i = 1; i <= 1640; ++i) averager.add_constant(5 * i, i % 2 == 0 ? 1 : -1);
    SpectrumOptions options;
    options.cycle_time = 1;
    options.window = Window::blackman_harris;
    const PowerSpectrum spectrum = power_spectrum(averager.averages(), 0.25, options);
    const auto peaks = find_peaks(spectrum);
    ASSERT_EQ(peaks.size(), 10U);
    for (int i = 0; i < 10; ++i) {
        const int k = 2 * i + 1;
        EXPECT_NEAR(peaks[i].frequency, 0.1 * k, 1e-4 * spectrum.frequency_step) << k;
        // −92 dB of the strongest line is what leaks.
        EXPECT_NEAR(peaks[i].amplitude, 0.1 / std::sin(std::numbers::pi * k / 40), 1.3 * 2.5e-5) << k;
    }
    const LineShare share = line_share(power_spectrum(averager.averages(), 0.25));
    EXPECT_EQ(share.verdict, SpectrumVerdict::lines);
    EXPECT_GT(share.line_fraction, 0.99);
    EXPECT_TRUE(share.steadiness_tested);
}

TEST(Lines, QuasiPeriodicIsLines) {
    std::vector<double> series;
    for (int j = 0; j < 20000; ++j) {
        const double a = two_pi * golden_mean * j;
        const double b = two_pi * (std::sqrt(2.0) - 1) * j;
        series.push_back(std::cos(a) + 0.5 * std::cos(b) + 0.1 * std::cos(a + b));
    }
    const LineShare share = line_share(power_spectrum(series, 1));
    EXPECT_EQ(share.verdict, SpectrumVerdict::lines);
    EXPECT_EQ(share.lines, 3U);
}

TEST(Lines, ChaoticIsContinuum) {
    const LineShare share = line_share(power_spectrum(held_logistic(4, 8000), 0.25));
    EXPECT_EQ(share.verdict, SpectrumVerdict::continuum);
    EXPECT_LT(share.line_fraction, 0.02);
}

TEST(Lines, BandedChaosIsMixed) {
    // At r = 3.6 the logistic attractor is two bands visited in turn: a line at ½ on a continuum.
    const LineShare share = line_share(power_spectrum(held_logistic(3.6, 8000), 0.25));
    EXPECT_GT(share.line_fraction, 0.5);
    EXPECT_EQ(share.verdict, SpectrumVerdict::mixed) << share.line_fraction;
}

TEST(Lines, TransientIsNonstationary) {
    std::vector<double> series = sine(8000, 0.05, 1);
    for (std::size_t j = 0; j < series.size(); ++j) series[j] *= std::exp(-static_cast<double>(j) / 1500);
    EXPECT_EQ(line_share(power_spectrum(series, 1)).verdict, SpectrumVerdict::nonstationary);
}

TEST(Lines, MeasuredWithOnePerCentNoise) {
    const double frequency = 0.1 * golden_mean;
    std::vector<double> series = sine(4096, frequency, 1);
    std::mt19937_64 random(17);
    std::normal_distribution<double> noise(0, 0.01);
    for (double& x : series) x += noise(random);
    EXPECT_EQ(line_share(power_spectrum(series, 1)).verdict, SpectrumVerdict::lines);
    const auto peaks = find_peaks(power_spectrum(series, 1, one_segment(Window::hann)));
    ASSERT_FALSE(peaks.empty());
    // Cramér–Rao: √6/π · (σ/A)/√n bins and σ√(2/n); interpolation under a Hann window costs less than a factor 2.
    EXPECT_NEAR(peaks[0].frequency * 4096, frequency * 4096, 5 * 2 * 0.78 * 0.01 / 64);
    EXPECT_NEAR(peaks[0].amplitude, 1, 5 * 2 * 0.01 * std::sqrt(2.0 / 4096));
}

TEST(Lines, WhiteNoiseHasNoneMoreOftenThanSaid) {
    // 200 series, false_alarm 0.001 each: 0.2 expected; 4 or more has probability 6e-5.
    std::mt19937_64 random(23);
    std::normal_distribution<double> normal;
    int with_lines = 0;
    for (int i = 0; i < 200; ++i) {
        std::vector<double> series(2048);
        for (double& x : series) x = normal(random);
        with_lines += find_peaks(power_spectrum(series, 1)).empty() ? 0 : 1;
    }
    EXPECT_LT(with_lines, 4);
}

// Its image and its mirror image fall together: the whole variance A² is in the line, in every window.
TEST(Lines, APeriodOfTwoSamplesIsALineAtHalfTheSamplingFrequency) {
    std::vector<double> series(5000);
    for (std::size_t j = 0; j < series.size(); ++j) series[j] = j % 2 == 0 ? 0.9 : -0.5;
    for (const Window window : all_windows) {
        SpectrumOptions options;
        options.window = window;
        options.cycle_time = 1;
        const auto spectrum = power_spectrum(series, 1, options);
        ASSERT_EQ(spectrum.segment_length % 2, 0u);
        const auto peaks = find_peaks(spectrum);
        ASSERT_EQ(peaks.size(), 1u) << name_of(window);
        EXPECT_EQ(peaks[0].frequency, 0.5);
        EXPECT_NEAR(peaks[0].power, 0.49, 1e-12);
        EXPECT_EQ(line_share(spectrum).verdict, SpectrumVerdict::lines);
    }
}

}  // namespace
