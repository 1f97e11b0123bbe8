#include "analysis/spectrum/lomb_scargle.hpp"

#include "analysis/spectrum/resample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace swirl::analysis;

constexpr double turn = 2 * std::numbers::pi;

std::vector<double> jittered_times(std::size_t n, double jitter, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-jitter, jitter);
    std::vector<double> times(n);
    for (std::size_t i = 0; i < n; ++i) times[i] = 5 + static_cast<double>(i) + uniform(random);
    return times;
}

std::vector<double> exponential_times(std::size_t n, unsigned seed) {
    std::mt19937_64 random(seed);
    std::exponential_distribution<double> distance(1);
    std::vector<double> times{0};
    while (times.size() < n) times.push_back(times.back() + distance(random));
    return times;
}

std::vector<double> at(const std::vector<double>& times, const std::function<double(double)>& signal) {
    std::vector<double> values(times.size());
    std::transform(times.begin(), times.end(), values.begin(), signal);
    return values;
}

std::vector<double> noise_of(std::size_t n, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> noise(n);
    for (double& x : noise) x = normal(random);
    return noise;
}

SpectrumOptions in_cycles() {
    SpectrumOptions options;
    options.cycle_time = 1;
    return options;
}

/// Scargle's formula as it stands, with long double sums.
double plain_lomb_scargle(const std::vector<double>& times, const std::vector<double>& values, double frequency) {
    const long double w = 2 * std::numbers::pi_v<long double> * frequency;
    long double s2 = 0, c2 = 0;
    for (const double t : times) s2 += std::sin(2 * w * (t - times[0])), c2 += std::cos(2 * w * (t - times[0]));
    const long double tau = std::atan2(s2, c2) / (2 * w);
    long double xc = 0, xs = 0, cc = 0, ss = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const long double c = std::cos(w * (times[i] - times[0] - tau)), s = std::sin(w * (times[i] - times[0] - tau));
        xc += values[i] * c, xs += values[i] * s, cc += c * c, ss += s * s;
    }
    return static_cast<double>((xc * xc / cc + xs * xs / ss) / 2);
}

TEST(NonuniformTransform, EqualsThePlainSum) {
    for (const std::size_t count : {3, 50, 700}) {
        const auto times = exponential_times(400, 1);
        const auto values = noise_of(400, 2);
        const double step = 0.7 / times.back();
        const auto found = nonuniform_transform(times, values, times[7], step, count);
        ASSERT_EQ(found.size(), count + 1);
        double size = 0;
        for (const double x : values) size += std::abs(x);
        for (std::size_t k = 0; k <= count; ++k) {
            std::complex<long double> sum = 0;
            for (std::size_t j = 0; j < times.size(); ++j)
                sum += std::polar<long double>(1, -2 * std::numbers::pi_v<long double> * static_cast<long double>(k) *
                                                      static_cast<long double>(step) * (times[j] - times[7])) *
                       static_cast<long double>(values[j]);
            // Rounding of t step loses ε count turns of a phase.
            EXPECT_LT(std::abs(std::complex<long double>(found[k]) - sum), 1e-12 * size) << k;
        }
    }
}

TEST(LombScargle, EqualsScarglesFormula) {
    for (const bool clustered : {false, true}) {
        const auto times = clustered ? exponential_times(500, 3) : jittered_times(500, 0.4, 3);
        const auto values = noise_of(500, 4);
        const double step = 1 / (times.back() - times.front());
        const auto power = lomb_scargle(times, values, step, 300);
        for (std::size_t k = 1; k <= 300; ++k) {
            const double plain = plain_lomb_scargle(times, values, static_cast<double>(k) * step);
            EXPECT_NEAR(power[k - 1], plain, 1e-10 * (1 + plain)) << k;
        }
    }
}

TEST(LombScargle, OfEvenTimesIsThePeriodogram) {
    const auto values = noise_of(256, 5);
    const auto times = jittered_times(256, 0, 6);
    const auto power = lomb_scargle(times, values, 1.0 / 256, 128);
    for (std::size_t k = 1; k <= 128; ++k) {
        std::complex<double> sum = 0;
        for (std::size_t j = 0; j < 256; ++j)
            sum += values[j] * std::polar(1.0, -turn * static_cast<double>(k * j % 256) / 256);
        // At half the sampling frequency all of Σ cos² is there and nothing of Σ sin².
        EXPECT_NEAR(power[k - 1], std::norm(sum) / 256 / (k == 128 ? 2 : 1), 1e-11 * 256) << k;
    }
}

TEST(UnevenSpectrum, OfAToneIsALineOfItsAmplitude) {
    for (const double jitter : {0.05, 0.2, 0.45})
        for (const double frequency : {0.01, 0.13, 0.4, 0.47}) {
            const auto times = jittered_times(1000, jitter, 7);
            const auto found = uneven_spectrum(
                times, at(times, [&](double t) { return 3 + std::sin(turn * frequency * t); }), in_cycles());
            const std::string what = std::to_string(jitter) + " " + std::to_string(frequency);
            EXPECT_EQ(found.share.verdict, SpectrumVerdict::lines) << what;
            ASSERT_GE(found.peaks.size(), 1U) << what;
            EXPECT_NEAR(found.peaks[0].frequency, frequency, 1e-6) << what;
            EXPECT_NEAR(found.peaks[0].amplitude, 1, 1e-4) << what;
            EXPECT_NEAR(found.spectrum.variance, 0.5, 0.01) << what;  // of 1000 samples
            EXPECT_LE(found.spectrum.frequency.back(), 0.501) << what;
        }
}

TEST(UnevenSpectrum, TellsLinesThatAreNearAndFaint) {
    const auto times = exponential_times(4000, 8);
    const double step = 1 / times.back();
    const auto signal = [&](double t) {
        return std::sin(turn * 0.13 * t) + 0.5 * std::cos(turn * 0.31 * t) + 0.02 * std::sin(turn * 0.2 * t) +
               0.3 * std::sin(turn * (0.13 + 4 * step) * t);
    };
    const auto found = uneven_spectrum(times, at(times, signal), in_cycles());
    ASSERT_EQ(found.peaks.size(), 4U);
    const std::vector<double> frequencies{0.13, 0.31, 0.13 + 4 * step, 0.2}, amplitudes{1, 0.5, 0.3, 0.02};
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(found.peaks[k].frequency, frequencies[k], 0.01 * step);
        EXPECT_NEAR(found.peaks[k].amplitude, amplitudes[k], 0.01 * amplitudes[k]);
    }
}

TEST(UnevenSpectrum, OfNoiseAndChaosIsAContinuum) {
    constexpr unsigned draws = 40;
    unsigned lines = 0;
    for (unsigned seed = 0; seed < draws; ++seed) {
        const auto times = seed % 2 == 0 ? jittered_times(1500, 0.3, seed) : exponential_times(1500, seed);
        std::vector<double> values = noise_of(1500, 100 + seed);
        if (seed % 4 == 3) {
            double x = 0.3 + 0.01 * seed;
            for (double& v : values) v = x = 4 * x * (1 - x);
        } else if (seed % 4 == 2) {  // red noise
            for (std::size_t i = 1; i < values.size(); ++i) values[i] += 0.9 * values[i - 1];
        }
        const auto found = uneven_spectrum(times, values, in_cycles());
        lines += found.share.verdict == SpectrumVerdict::continuum ? 0 : 1;
    }
    EXPECT_LE(lines, 2U);  // the false alarm of one line is 1e-3, of red noise at its steepest more
}

TEST(UnevenSpectrum, IntegratesToTheVarianceAndLinesToTheirShare) {
    const auto times = jittered_times(2000, 0.3, 9);
    std::vector<double> values = noise_of(2000, 10);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += std::sqrt(2.0) * std::sin(turn * 0.21 * times[i]);
    const auto found = uneven_spectrum(times, values, in_cycles());
    double integral = 0;
    for (const double p : found.spectrum.power) integral += p * found.spectrum.frequency_step;
    EXPECT_NEAR(integral, found.spectrum.variance, 1e-12 * integral);
    EXPECT_EQ(found.share.verdict, SpectrumVerdict::mixed);
    EXPECT_NEAR(found.share.line_fraction, 0.5, 0.05);  // a tone and noise of variance 1 each, 2000 samples
    ASSERT_EQ(found.peaks.size(), 1U);
    EXPECT_NEAR(found.peaks[0].power, 1, 0.1);
}

TEST(UnevenSpectrum, ALineMustBeSteady) {
    const auto times = jittered_times(2000, 0.3, 11);
    const auto found = uneven_spectrum(
        times, at(times, [](double t) { return (t < 700 ? 1 : 0.0) * std::sin(turn * 0.21 * t); }), in_cycles());
    EXPECT_NE(found.share.verdict, SpectrumVerdict::lines);
}

TEST(UnevenSpectrum, ConstantsShortSeriesAndGaps) {
    const auto times = exponential_times(100, 12);
    const auto constant = uneven_spectrum(times, std::vector<double>(100, 0.3), in_cycles());
    EXPECT_EQ(constant.spectrum.outcome, SpectrumOutcome::constant);
    EXPECT_EQ(constant.share.verdict, SpectrumVerdict::constant);
    const std::vector<double> few(times.begin(), times.begin() + 7);
    EXPECT_EQ(uneven_spectrum(few, few).spectrum.outcome, SpectrumOutcome::too_short);
    auto holed = at(times, [](double t) { return std::sin(t); });
    for (std::size_t i = 0; i < 100; i += 3) holed[i] = std::nan("");
    const auto found = uneven_spectrum(times, holed, in_cycles());
    EXPECT_EQ(found.spectrum.samples, 66U);
    EXPECT_NEAR(found.peaks.at(0).frequency, 1 / turn, 1e-5);
}

TEST(Resample, WithALowPassNothingFoldsBackAndNothingIsRepeated) {
    const auto times = jittered_times(8000, 0.2, 13);
    const auto values = at(times, [](double t) { return std::sin(turn * 0.05 * t) + std::sin(turn * 0.31 * t); });
    ResampleOptions options;
    options.low_pass = true;
    options.spacing = 2.5;  // whose Nyquist frequency is 0.2: 0.31 would fold to 0.09
    const Resampled coarse = resample(times, values, options);
    EXPECT_NEAR(coarse.low_pass, 0.2, 1e-15);
    const auto peaks = find_peaks(power_spectrum(coarse.series.values, 2.5, in_cycles()));
    EXPECT_NEAR(peaks.at(0).frequency, 0.05, 1e-4);
    EXPECT_NEAR(peaks[0].amplitude, 1, 0.03);  // straight lines take sinc²(0.05), 0.8 %, and more of uneven ones
    for (std::size_t k = 1; k < peaks.size(); ++k) EXPECT_LT(peaks[k].amplitude, 2e-3) << peaks[k].frequency;
    options.spacing = 0.25;  // straight lines would repeat 0.31 at 0.69
    const Resampled fine = resample(times, values, options);
    EXPECT_NEAR(fine.own_nyquist, 0.5, 1e-3);
    EXPECT_NEAR(fine.low_pass, 0.5, 1e-3);
    const PowerSpectrum spectrum = power_spectrum(fine.series.values, 0.25, in_cycles());
    double above = 0;
    for (std::size_t k = 0; k < spectrum.power.size(); ++k)
        if (spectrum.frequency[k] > 0.51) above += spectrum.power[k] * spectrum.frequency_step;
    EXPECT_LT(above, 1e-6 * spectrum.variance);
    options.spacing = 1;  // the samples' own
    EXPECT_EQ(resample(times, values, options).low_pass, 0);
}

}  // namespace
