// Measures estimated from random pairs against the exact counts of all pairs.
#include "analysis/recurrence/sampled_pairs.hpp"
#include "analysis/recurrence/lines.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace swirl::analysis::recurrence {
namespace {

struct Case {
    std::string name;
    Points points;
    double threshold;
    Settings settings;
};

// Noise (short lines), a random walk (squares of recurrence), two turns of different periods in an embedding (long
// lines along diagonals), and a sine whose diagonals are longer than a line is followed.
std::vector<Case> cases() {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> noise, walk{0}, turns, sine;
    for (int i = 0; i < 900; ++i) noise.push_back(uniform(random));
    for (int i = 0; i < 900; ++i) walk.push_back(walk.back() + 0.1 * uniform(random));
    for (int i = 0; i < 1200; ++i) turns.push_back(std::sin(0.21 * i) + std::sin(0.131 * i + 1));
    for (int i = 0; i < 4000; ++i) sine.push_back(std::sin(2 * 3.14159265358979 * i / 40.0));
    Settings wide;
    wide.theiler = 12;
    wide.min_diagonal = 5;
    wide.min_vertical = 3;
    Settings manhattan;
    manhattan.norm = Norm::manhattan;
    manhattan.strict = true;
    return {{"noise", embed_series(noise), 0.1, {}},
            {"walk", embed_series(walk), 0.15, wide},
            {"turns", embed_series(turns, 3, 6), 0.4, manhattan},
            {"sine", embed_series(sine), 0.05, {}}};
}

constexpr std::array<double Measures::*, 5> estimated{&Measures::RR, &Measures::DET, &Measures::L, &Measures::LAM,
                                                      &Measures::TT};

// 4 cases of 5 measures with 40 seeds. Of 800 normal deviates 95 % lie within 1.96 errors, give or take 0.8 %; five
// measures of one sample move together, so that 3 % are allowed; that one is beyond 4.5 has a chance of 0.5 %.
TEST(SampledPairs, AreWithinTheirErrorsOfTheExactMeasures) {
    int within = 0, all = 0;
    for (const Case& c : cases()) {
        const Measures exact = measures(count_lines(c.points, c.threshold, c.settings), c.settings);
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const SampledPairs found = sample_pairs(c.points, c.threshold, 10'000, seed, c.settings);
            for (const auto member : estimated) {
                const double off = found.measures.*member - exact.*member, error = found.errors.*member;
                ASSERT_GT(error, 0) << c.name;
                EXPECT_LT(std::abs(off), 4.5 * error) << c.name << " seed " << seed << " exact " << exact.*member;
                within += std::abs(off) < 1.96 * error ? 1 : 0;
                ++all;
            }
        }
    }
    EXPECT_GT(within, 0.92 * all);
    EXPECT_LT(within, 0.985 * all);
}

// Errors fall as the root of the pairs, and are small where there are many.
TEST(SampledPairs, MorePairsTellMore) {
    const Case c = cases().front();
    const Measures exact = measures(count_lines(c.points, c.threshold, c.settings), c.settings);
    const SampledPairs few = sample_pairs(c.points, c.threshold, 20'000, 1),
                       many = sample_pairs(c.points, c.threshold, 320'000, 1);
    for (const auto member : estimated) EXPECT_NEAR(few.errors.*member / many.errors.*member, 4, 0.8);
    EXPECT_NEAR(many.measures.RR / exact.RR, 1, 0.02);
    EXPECT_NEAR(many.measures.L / exact.L, 1, 0.02);
}

TEST(SampledPairs, WhatNeedsAllPairsIsNotSaid) {
    const Case c = cases().front();
    const SampledPairs found = sample_pairs(c.points, c.threshold, 1000, 1);
    for (const auto member : {&Measures::Lmax, &Measures::DIV, &Measures::ENTR, &Measures::Vmax, &Measures::VENTR,
                              &Measures::MRT, &Measures::RTE, &Measures::TREND})
        EXPECT_TRUE(std::isnan(found.measures.*member));
    const SampledPairs none = sample_pairs(c.points, 0, 1000, 1);
    EXPECT_EQ(none.recurrent, 0U);
    EXPECT_EQ(none.measures.RR, 0);
    EXPECT_GT(none.errors.RR, 1e-3);  // 0 of 1000: below 3e-3 at 95 %
    EXPECT_TRUE(std::isnan(none.measures.L));
}

TEST(SampledPairs, ThreadsChangeNoBit) {
    const Case c = cases()[2];
    std::array<SampledPairs, 2> found;
    for (const int threads : {1, 3})
        tbb::task_arena(threads).execute(
            [&] { found[threads == 1 ? 0 : 1] = sample_pairs(c.points, c.threshold, 30'000, 7, c.settings); });
    for (const auto member : estimated) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(found[0].measures.*member),
                  std::bit_cast<std::uint64_t>(found[1].measures.*member));
        EXPECT_EQ(std::bit_cast<std::uint64_t>(found[0].errors.*member),
                  std::bit_cast<std::uint64_t>(found[1].errors.*member));
    }
}

TEST(SampledPairs, WhatCannotBeSampledIsRefused) {
    const Case c = cases().front();
    Settings window = c.settings, border = c.settings;
    window.theiler = 0;
    border.border_lines = BorderLines::discarded;
    for (const Settings& wrong : {window, border, preset("pyunicorn")})
        EXPECT_THROW(sample_pairs(c.points, 0.1, 100, 1, wrong), std::invalid_argument);
    EXPECT_THROW(sample_pairs(c.points, 0.1, 0, 1), std::invalid_argument);
    window.theiler = 900;
    EXPECT_THROW(sample_pairs(c.points, 0.1, 100, 1, window), std::invalid_argument);
    const std::vector<std::size_t> rows{0, 1, 5};
    EXPECT_THROW(sample_pairs(at_rows(embed_series(std::vector<double>{1, 2, 3}), rows), 0.1, 100, 1),
                 std::invalid_argument);
}

}  // namespace
}  // namespace swirl::analysis::recurrence
