#include "analysis/spectrum/resample.hpp"

#include "analysis/spectrum/power_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace swirl::analysis;

TEST(Resample, LinearAndHoldByHand) {
    const std::vector<double> times = {0, 1, 3, 4};
    const std::vector<double> values = {0, 2, 6, 6};
    ResampleOptions options;
    options.spacing = 0.5;
    const Resampled linear = resample(times, values, options);
    EXPECT_EQ(linear.series.values, (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 6, 6}));
    options.interpolation = Interpolation::hold;
    const Resampled held = resample(times, values, options);
    EXPECT_EQ(held.series.values, (std::vector<double>{0, 0, 2, 2, 2, 2, 6, 6, 6}));
    EXPECT_EQ(linear.gaps, 0U);
}

TEST(Resample, AnEvenSeriesComesBackBitForBit) {
    std::vector<double> times;
    std::vector<double> values;
    for (int i = 0; i < 300; ++i) {
        times.push_back(0.1 * i);
        values.push_back(std::sin(0.37 * i));
    }
    ResampleOptions options;
    options.spacing = 0.1;
    EXPECT_EQ(resample(times, values, options).series.values, values);
}

TEST(Resample, AGapIsLeftOpenAndItsSegmentsAreSkipped) {
    std::vector<double> times;
    std::vector<double> values;
    for (int i = 0; i < 400; ++i) {
        if (i > 200 && i < 220) continue;
        times.push_back(i);
        values.push_back(std::sin(0.5 * i));
    }
    const Resampled result = resample(times, values);
    EXPECT_EQ(result.gaps, 1U);
    EXPECT_NEAR(result.missing_fraction, 20.0 / 399.0, 1e-15);
    ASSERT_EQ(result.series.values.size(), 400U);
    for (std::size_t i = 0; i < 400; ++i) EXPECT_EQ(std::isnan(result.series.values[i]), i > 200 && i < 220) << i;

    SpectrumOptions options;
    options.segment_length = 80;
    options.overlap = 0;
    const PowerSpectrum spectrum = power_spectrum(result.series.values, 1, options);
    EXPECT_EQ(spectrum.outcome, SpectrumOutcome::completed);
    EXPECT_EQ(spectrum.segments, 4U);
    EXPECT_EQ(spectrum.segments_skipped, 1U);
    options.segment_length = 400;
    EXPECT_EQ(power_spectrum(result.series.values, 1, options).outcome, SpectrumOutcome::no_complete_segment);
}

TEST(Resample, ASampleThatIsNotANumberIsNotThere) {
    const std::vector<double> times = {0, 1, 2, 3};
    const std::vector<double> values = {0, NAN, 2, 3};
    ResampleOptions options;
    options.spacing = 1;
    EXPECT_EQ(resample(times, values, options).series.values, (std::vector<double>{0, 1, 2, 3}));
}

TEST(Resample, RefusesWhatIsNotASeries) {
    const std::vector<double> three = {1, 2, 3};
    EXPECT_THROW(resample(std::vector<double>{0, 1}, three), std::invalid_argument);
    EXPECT_THROW(resample(std::vector<double>{0, 1, 1}, three), std::invalid_argument);
    EXPECT_THROW(resample(std::vector<double>{0, 2, 1}, three), std::invalid_argument);
    EXPECT_THROW(resample(three, std::vector<double>{1, NAN, NAN}), std::invalid_argument);
    ResampleOptions options;
    options.spacing = -1;
    EXPECT_THROW(resample(three, three, options), std::invalid_argument);
    options = {};
    options.gap_factor = 0.5;
    EXPECT_THROW(resample(three, three, options), std::invalid_argument);
    EXPECT_THROW(interpolation_from_name("cubic"), std::invalid_argument);
}

TEST(Resample, SaysTheSmallestSpacing) {
    const std::vector<double> times = {0, 0x1p-20};
    ResampleOptions options;
    options.spacing = 1e-20;
    try {
        resample(times, times, options);
        FAIL() << "nothing was refused";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(),
                     "spacing = 1e-20: must be at least 3.552713678800501e-15, the length of the series "
                     "over 2^28");
        EXPECT_EQ(std::stod("3.552713678800501e-15"), 0x1p-48);
    }
}

}  // namespace
