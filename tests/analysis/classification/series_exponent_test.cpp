// Exponents of series against known ones, and noise that is no chaos.
#include "analysis/classification/series_exponent.hpp"

#include "analysis/classification/classify_series.hpp"
#include "analysis/classification/surrogates.hpp"
#include "tests/analysis/classification/random_series.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <random>
#include <span>
#include <tuple>
#include <vector>

namespace {

using namespace swirl::analysis;
using swirl::tests::Chaos, swirl::tests::Noise;
using Series = std::vector<double>;

std::vector<int> lengths_of(const Chaos& chaos, bool all) {
    if (!all) return {1000};
    return chaos.flow ? std::vector{2000, 4000, 8000} : std::vector{500, 1000, 4000};
}

/// How many of the draws' errors cover the truth, twice taken; a line for each system and length.
void check_coverage(bool all, unsigned draws) {
    long resolved = 0, covered = 0;
    for (const Chaos& chaos : swirl::tests::chaoses()) {
        if (!all && chaos.flow) continue;
        for (const int count : lengths_of(chaos, all)) {
            long found = 0, inside = 0;
            double sum = 0, errors = 0;
            for (unsigned seed = 1; seed <= draws; ++seed) {
                const auto exponent = exponent_of_series(chaos.draw(count, seed), chaos.flow);
                if (!exponent.resolved) continue;
                ++found;
                inside += std::abs(exponent.exponent - chaos.exponent) <= 2 * exponent.error ? 1 : 0;
                sum += exponent.exponent / chaos.exponent;
                errors += exponent.error / chaos.exponent;
            }
            const double n = static_cast<double>(found);
            std::printf("%-9s %5d samples: %3ld of %3u resolved, mean %.3f of the truth, error %.3f, inside %3ld\n",
                        chaos.name.c_str(), count, found, draws, sum / n, errors / n, inside);
            EXPECT_GE(found, static_cast<long>(draws) * 3 / 4) << chaos.name << ", " << count;
            EXPECT_GE(inside, found * 85 / 100) << chaos.name << ", " << count;
            resolved += found, covered += inside;
        }
    }
    EXPECT_GE(covered, resolved * 9 / 10);
}

TEST(SeriesExponent, ItsErrorCoversTheExponentsOfMaps) {
    check_coverage(false, 12);
}

TEST(SeriesExponentNightly, ItsErrorCoversTheTruthInNineOfTen) {
    check_coverage(true, static_cast<unsigned>(swirl::tests::sample_count(100)));
}

TEST(SeriesExponent, OfAFlowItIsThatAcrossTheFlow) {
    const Chaos lorenz = swirl::tests::chaoses().at(3);
    const auto found = exponent_of_series(lorenz.draw(3000, 1), true);
    ASSERT_TRUE(found.resolved);
    EXPECT_NEAR(found.exponent, lorenz.exponent, 2 * found.error);
    EXPECT_LT(found.error, 0.25 * lorenz.exponent);
}

TEST(SeriesExponent, FewSamplesOrMuchNoiseLeaveItUnresolved) {
    const Chaos logistic = swirl::tests::chaoses().at(0);
    Series x = logistic.draw(1000, 1);
    EXPECT_TRUE(exponent_of_series(x, false).resolved);
    EXPECT_FALSE(exponent_of_series(std::span(x).first(64), false).resolved);
    std::mt19937_64 random(1);
    for (double& v : x) v += 0.03 * swirl::tests::normal(random);
    EXPECT_FALSE(exponent_of_series(x, false).resolved);
}

std::map<std::vector<double>, int> runs_of(const Series& x, std::size_t length) {
    std::map<std::vector<double>, int> runs;
    for (auto at = x.begin(); x.end() - at >= static_cast<std::ptrdiff_t>(length); ++at)
        ++runs[{at, at + static_cast<std::ptrdiff_t>(length)}];
    return runs;
}

TEST(Surrogates, OfAMarkovChainHaveItsTransitionsAndAreOthers) {
    for (const Noise& noise : swirl::tests::chains()) {
        const Series x = noise.draw(500, 1);
        for (const std::size_t order : {1, 2}) {
            const Series y = markov_surrogate(x, order, 3);
            EXPECT_EQ(runs_of(x, order + 1), runs_of(y, order + 1)) << noise.name;
            EXPECT_NE(x, y);
            EXPECT_EQ(y, markov_surrogate(x, order, 3));
        }
    }
}

TEST(Surrogates, OfATelegraphHaveItsStays) {
    const Series x = swirl::tests::telegraphs().at(3).draw(500, 1), y = dwell_surrogate(x, 1);
    const auto stays = [](const Series& s) {
        std::vector<std::pair<double, int>> found;
        for (const double v : s) {
            if (found.empty() || found.back().first != v) found.emplace_back(v, 0);
            ++found.back().second;
        }
        std::sort(found.begin(), found.end());
        return found;
    };
    EXPECT_EQ(stays(x), stays(y));
    EXPECT_NE(x, y);
}

TEST(Surrogates, OfLinearNoiseHaveItsValuesAndCorrelations) {
    std::mt19937_64 random(1);
    Series x;
    double last = 0;
    for (int i = 0; i < 500; ++i) x.push_back(std::tanh(last = 0.9 * last + swirl::tests::normal(random)));
    Series y = fourier_surrogate(x, 1);
    const auto neighbours = [](const Series& s) {
        double products = 0, squares = 0;
        for (std::size_t i = 1; i < s.size(); ++i) products += s[i] * s[i - 1], squares += s[i] * s[i];
        return products / squares;
    };
    EXPECT_NEAR(neighbours(x), neighbours(y), 0.03);
    EXPECT_NE(x, y);
    std::sort(x.begin(), x.end());
    std::sort(y.begin(), y.end());
    EXPECT_EQ(x, y);
}

/// At most 1 % of the draws of any kind may be called chaotic.
void check_noises(const std::vector<Noise>& noises, int count, unsigned draws) {
    for (const Noise& noise : noises) {
        unsigned chaotic = 0;
        for (unsigned seed = 1; seed <= draws; ++seed) {
            ClassifySeriesOptions options;
            options.sampled_flow = seed % 2 == 0;
            chaotic += classify_series(noise.draw(count, seed), options).mode == Mode::chaotic ? 1U : 0U;
        }
        std::printf("%-28s %u of %u called chaotic\n", noise.name.c_str(), chaotic, draws);
        EXPECT_LE(chaotic, draws / 100) << noise.name;
    }
}

TEST(ClassifySeries, ATelegraphIsNoChaos) {
    check_noises(swirl::tests::telegraphs(), 500, 2);
}

TEST(ClassifySeriesNightly, NoiseIsNoChaosInHundredDrawsOfFourteenKinds) {
    check_noises(swirl::tests::all_noises(), 1000, static_cast<unsigned>(swirl::tests::sample_count(100)));
}

}  // namespace
