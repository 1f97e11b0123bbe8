#include "analysis/spectrum/segments.hpp"

#include "analysis/spectrum/lines.hpp"
#include "analysis/spectrum/power_spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace {

using namespace swirl::analysis;

/// A tone of 0.3 radians a sample, of which a share is lost at random.
std::vector<double> holed_tone(std::size_t n, double lost, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<double> tone(n);
    for (std::size_t i = 0; i < n; ++i) {
        const bool is_lost = uniform(random) < lost;
        tone[i] = is_lost ? std::nan("") : std::sin(0.3 * static_cast<double>(i));
    }
    return tone;
}

TEST(Segments, LieWithinTheStretchesAndNoneTouchesAGap) {
    const auto series = holed_tone(3000, 0.01, 1);
    const auto stretches = stretches_of(series);
    for (const std::size_t length : {std::size_t{8}, std::size_t{31}, std::size_t{120}}) {
        const auto starts = segment_starts(stretches, length, 0.5);
        EXPECT_EQ(starts.size(), segments_within(stretches, length, 0.5));
        for (const std::size_t start : starts)
            for (std::size_t i = start; i < start + length; ++i) ASSERT_FALSE(std::isnan(series[i]));
    }
    EXPECT_EQ(segment_starts(stretches, 31, 0.5, 7).size(), 7U);
}

TEST(Segments, TheFittedLengthIsTheLongestOfWhichAsManyFit) {
    const auto series = holed_tone(2000, 0.02, 2);
    const auto stretches = stretches_of(series);
    for (const std::size_t segments : {1, 2, 5, 16, 40})
        for (const double overlap : {0.0, 0.5, 0.75}) {
            const std::size_t length = fitted_segment_length(stretches, segments, overlap, series.size());
            ASSERT_GT(length, 0U);
            EXPECT_GE(segments_within(stretches, length, overlap), segments);
            for (std::size_t longer = length + 1; longer <= 2000; ++longer)
                ASSERT_LT(segments_within(stretches, longer, overlap), segments) << longer;
        }
}

TEST(Segments, AsManyAreUsedAsWereAskedFor) {
    std::vector<double> series(1000);
    for (std::size_t i = 0; i < series.size(); ++i) series[i] = std::sin(0.3 * static_cast<double>(i));
    for (std::size_t segments = 1; segments <= 100; ++segments) {
        SpectrumOptions options;
        options.segments = segments;
        options.segment_length = fitted_segment_length(stretches_of(series), segments, 0.5, series.size());
        EXPECT_EQ(power_spectrum(series, 1, options).segments, segments);
    }
}

TEST(Segments, MoreDataGivesNoShorterOnes) {
    const auto series = holed_tone(20000, 0.002, 3);
    std::size_t before = 0;
    for (std::size_t n = 200; n <= series.size(); n += 100) {
        const auto stretches = stretches_of(std::span(series).first(n));
        const std::size_t length = automatic_segment_length(stretches, 0.5);
        EXPECT_GE(segments_within(stretches, length, 0.5), 15U) << n;
        EXPECT_GE(static_cast<double>(length), 0.8 * static_cast<double>(before))
            << n;  // rounded down to small factors
        before = std::max(before, length);
    }
}

TEST(Segments, AToneIsFoundHoweverManyRowsAreLost) {
    for (const std::size_t n : {1000, 4000, 20000})
        for (const double lost : {0.0, 0.002, 0.005, 0.02}) {
            const auto spectrum = power_spectrum(holed_tone(n, lost, 4), 1);
            ASSERT_EQ(spectrum.outcome, SpectrumOutcome::completed) << n << " " << lost;
            EXPECT_EQ(line_share(spectrum).verdict, SpectrumVerdict::lines) << n << " " << lost;
            const SpectralPeak peak = find_peaks(spectrum).front();
            EXPECT_NEAR(peak.frequency, 0.3, 0.01 * spectrum.frequency_step) << n << " " << lost;
            EXPECT_NEAR(peak.amplitude, 1, 0.01) << n << " " << lost;
        }
}

TEST(Segments, LostRowsAtEitherEndChangeNothing) {
    std::vector<double> series(300);
    for (std::size_t i = 0; i < series.size(); ++i) series[i] = std::sin(0.3 * static_cast<double>(i));
    const auto whole = power_spectrum(series, 1);
    series.insert(series.begin(), 5, std::nan(""));
    series.insert(series.end(), 40, std::nan(""));
    const auto holed = power_spectrum(series, 1);
    EXPECT_EQ(holed.segment_length, whole.segment_length);
    EXPECT_EQ(holed.power, whole.power);
}

}  // namespace
