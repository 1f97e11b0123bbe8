// When chaos is called before the limits: the sample and its bound on populations whose truth is known, and what orbits
// show at a look.
#include "apps/studies/modes/early_chaos.hpp"
#include "tests/apps/studies/scene_map/scene_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace swirl::studies {
namespace {

constexpr std::int64_t look = 648;  // impacts
constexpr double limits = 20'000;

/// Runs, four of a cell, by the impact at which each leaves chaos; 0: it never is in it.
struct Population {
    std::vector<double> leaves, exponents;
    std::vector<int> kept = {};      ///< how often a run's verdict at the look was kept
    std::vector<int> followed = {};  ///< how often a run was followed to the limits
    std::vector<int> looked = {};    ///< how often it was followed to a look

    RunsAtRisk at_risk() {
        kept.assign(leaves.size(), 0);
        followed.assign(leaves.size(), 0);
        looked.assign(leaves.size(), 0);
        return {[this](std::span<const std::size_t> runs, std::int64_t to) -> std::optional<std::vector<SeenRun>> {
                    std::vector<SeenRun> seen;
                    for (const std::size_t run : runs) {
                        ++(to == 0 ? followed : looked)[run];
                        const bool chaotic = leaves[run] > (to > 0 ? static_cast<double>(to) : limits);
                        seen.push_back({!chaotic, chaotic, exponents[run]});
                    }
                    return seen;
                },
                [this](std::size_t run) { ++kept[run]; }};
    }
    /// Runs that were called chaotic, and those of them that the limits do not.
    std::pair<int, int> called() const {
        std::pair<int, int> counts;
        for (std::size_t run = 0; run < leaves.size(); ++run) {
            const bool is_called = kept[run] > 0 && leaves[run] > static_cast<double>(look);
            counts.first += is_called ? 1 : 0;
            counts.second += is_called && leaves[run] <= limits ? 1 : 0;
        }
        return counts;
    }
};

/// A third of the cells is never in chaos; in a share of the others runs leave, at a rate between 1e-6 and 1e-3 that is
/// the cell's own. The exponent is the larger the smaller the rate, but for scatter.
Population population_of(std::mt19937_64& engine, std::size_t cells, double transient_share) {
    std::uniform_real_distribution<double> uniform(0, 1);
    Population population;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const bool leaves = uniform(engine) < transient_share;
        const double rate = std::pow(10, -6 + 3 * uniform(engine));
        for (int run = 0; run < 4; ++run) {
            const double life = leaves ? std::exponential_distribution<double>(rate)(engine) : 1e9;
            population.leaves.push_back(cell % 3 == 0 ? 0 : life);
            population.exponents.push_back(uniform(engine) + (leaves ? -std::log10(rate) / 6 : 1));
        }
    }
    return population;
}

RiskQuestion question_of(const Population& population, double risk, std::uint64_t seed = 1) {
    return {population.leaves.size(), 4, risk, seed, look};
}

std::vector<std::size_t> all_of(const Population& population) {
    std::vector<std::size_t> all(population.leaves.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

TEST(RandomOrder, EachNumberComesOnceAndTheSeedDecidesWhen) {
    RandomOrder order(1000, 3), again(1000, 3), other(1000, 4);
    std::vector<std::size_t> all = order.take(10), same = again.take(400);
    for (const std::size_t i : order.take(390)) all.push_back(i);
    EXPECT_EQ(all, same);
    EXPECT_NE(other.take(400), same);
    for (const std::size_t i : order.take(10'000)) all.push_back(i);
    EXPECT_EQ(order.left(), 0U);
    EXPECT_EQ(std::set<std::size_t>(all.begin(), all.end()).size(), 1000U);
    EXPECT_LT(*std::max_element(all.begin(), all.end()), 1000U);
}

// Of 400 shuffles of 5 numbers each number comes first in 80 of them, ± 4 standard deviations of 8.
TEST(RandomOrder, EachNumberIsAsLikelyToComeFirst) {
    std::vector<int> first(5, 0);
    for (std::uint64_t seed = 0; seed < 400; ++seed) ++first[RandomOrder(5, seed).take(1).front()];
    for (const int count : first) EXPECT_NEAR(count, 80, 32);
}

TEST(RiskPieces, EveryRunHasANumberForTheLimitsAndForTheLook) {
    const RiskPieces pieces{7, look};
    std::set<std::size_t> all;
    for (const std::int64_t to : {std::int64_t{0}, look})
        for (std::size_t run = 0; run < 7; ++run) {
            EXPECT_EQ(pieces.run(pieces.number(run, to)), run);
            EXPECT_TRUE(all.insert(pieces.number(run, to)).second);
        }
    const auto groups = pieces.groups(std::vector<std::size_t>(all.begin(), all.end()));
    ASSERT_EQ(groups.size(), 2U);
    for (const auto& group : groups) EXPECT_EQ(group.runs, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(groups[0].look, 0);
    EXPECT_EQ(groups[1].look, look);
}

TEST(RiskPieces, RunsOfLaterLooksHaveNumbersToo) {
    const RiskPieces pieces{7, look};
    const auto groups =
        pieces.groups(std::vector<std::size_t>{pieces.number(3, 0), pieces.number(5, 972), pieces.number(6, 1458)});
    ASSERT_EQ(groups.size(), 3U);
    EXPECT_EQ(groups[1].look, 972);
    EXPECT_EQ(groups[1].runs, (std::vector<std::size_t>{5}));
    EXPECT_EQ(groups[2].look, 1458);
    EXPECT_EQ(groups[2].runs, (std::vector<std::size_t>{6}));
}

TEST(LastLook, IsTheLastWithinTheTransient) {
    analysis::ClassifyOptions options;
    EXPECT_EQ(last_look(options), 7380);  // the next one is 11,070, beyond 10,000
    options.transient = 100;
    EXPECT_EQ(last_look(options), 0);
}

TEST(EarlyLook, IsANinthOfTheLimitsAndALook) {
    analysis::ClassifyOptions options;
    EXPECT_EQ(early_look(options), 2187);  // of 20,000: 2222
    options.transient = 2500;
    options.collisions = 500;
    EXPECT_EQ(early_look(options), 432);
    options.transient = 400;
    EXPECT_EQ(early_look(options), 0);
    options.transient = options.collisions = 1'000'000;
    EXPECT_GT(early_look(options), 222'222 / 1.5);
    EXPECT_LE(early_look(options), 222'222);
}

TEST(AtRisk, WithoutARiskOrWithTooFewRunsAllGoToTheLimits) {
    std::mt19937_64 engine(1);
    Population few = population_of(engine, 100, 0.1);
    for (const double risk : {0.0, 0.005}) {
        const auto found = follow_at_risk(question_of(few, risk), all_of(few), few.at_risk());
        ASSERT_TRUE(found);
        EXPECT_EQ(found->evidence.impacts, 0);
        EXPECT_EQ(few.followed, std::vector<int>(400, 1));
        EXPECT_EQ(few.kept, std::vector<int>(400, 0));
    }
    for (const double wrong : {-0.1, 1.0, std::nan("")})
        EXPECT_THROW(follow_at_risk(question_of(few, wrong), all_of(few), few.at_risk()), std::invalid_argument);
}

TEST(AtRisk, AStopLeavesNothing) {
    std::mt19937_64 engine(1);
    Population many = population_of(engine, 1000, 0);
    for (int stop_at = 0; stop_at < 4; ++stop_at) {
        int asked = 0;
        RunsAtRisk runs = many.at_risk();
        runs.follow = [&, follow = runs.follow](std::span<const std::size_t> some, std::int64_t to) {
            return asked++ < stop_at ? follow(some, to) : std::nullopt;
        };
        EXPECT_FALSE(follow_at_risk(question_of(many, 0.05), all_of(many), runs)) << stop_at;
    }
}

// Where nothing leaves after the look all are called but the sample, and what is less sure than any of that; every run
// has one verdict.
TEST(AtRisk, ChaosThatStaysIsCalled) {
    std::mt19937_64 engine(2);
    Population population = population_of(engine, 3000, 0);
    const auto found = follow_at_risk(question_of(population, 0.01), all_of(population), population.at_risk());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->evidence.impacts, look);
    EXPECT_EQ(found->evidence.changed, 0);
    EXPECT_EQ(found->evidence.judged, found->evidence.followed);
    EXPECT_GE(found->evidence.followed, 750);  // a sixteenth
    for (std::size_t run = 0; run < population.leaves.size(); ++run)
        EXPECT_EQ(population.kept[run] + population.followed[run], 1) << run;
    const auto [called, changed] = population.called();
    EXPECT_GE(called, 7900 - found->evidence.followed);
    EXPECT_EQ(changed, 0);
}

int sum_of(const std::vector<int>& counts) {
    return std::accumulate(counts.begin(), counts.end(), 0);
}

void expect_one_verdict_each(const Population& population) {
    for (std::size_t run = 0; run < population.leaves.size(); ++run)
        EXPECT_EQ(population.kept[run] + population.followed[run], 1) << run;
}

// The first quarter of the sample tells: the others are not looked at before they are followed to the limits.
TEST(AtRisk, WhereMostLeaveTheOthersAreNotLookedAt) {
    std::mt19937_64 engine(6);
    for (const double risk : {0.01, 0.05}) {
        Population population = population_of(engine, 3000, 1);
        const auto found = follow_at_risk(question_of(population, risk), all_of(population), population.at_risk());
        ASSERT_TRUE(found);
        EXPECT_EQ(found->evidence.impacts, 0);
        EXPECT_GT(found->evidence.changed, 0);
        EXPECT_GT(found->evidence.bound, risk);
        EXPECT_LE(found->evidence.judged, found->evidence.followed);
        EXPECT_LT(found->evidence.drawn, 600);
        EXPECT_LT(sum_of(population.looked), 4 * 600);  // with those of their cells
        expect_one_verdict_each(population);
    }
}

TEST(AtRisk, WhereFewAreCandidatesTheOthersAreNotLookedAt) {
    std::mt19937_64 engine(7);
    Population population = population_of(engine, 3000, 0);
    for (std::size_t run = 0; run < population.leaves.size(); ++run)
        if (run / 4 % 20 != 1) population.leaves[run] = 0;
    const auto found = follow_at_risk(question_of(population, 0.05), all_of(population), population.at_risk());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->evidence.impacts, 0);
    EXPECT_EQ(found->evidence.judged, 0);
    EXPECT_LT(found->evidence.followed, 0.1 * static_cast<double>(found->evidence.drawn));
    EXPECT_LT(sum_of(population.looked), 4 * 600);
    expect_one_verdict_each(population);
}

// A risk that is met is not taken for one that is not: where one run in a hundred leaves, or in thirty.
TEST(AtRisk, ARiskThatIsMetIsNotGivenUp) {
    std::mt19937_64 engine(8);
    int met = 0;
    for (int i = 0; i < 200; ++i) {
        Population population = population_of(engine, 750, i % 2 == 0 ? 0.03 : 0.1);
        const auto found =
            follow_at_risk(question_of(population, 0.1, engine()), all_of(population), population.at_risk());
        ASSERT_TRUE(found);
        met += found->evidence.impacts > 0 ? 1 : 0;
    }
    EXPECT_GE(met, 195);
}

TEST(LeastRuns, AreThoseOfWhichATwiceAskedSampleIsAThird) {
    EXPECT_EQ(least_runs(0.1), 228);  // ln 0.025/ln 0.9 = 35.01: 36 twice and a twentieth more, 76, thrice
    EXPECT_EQ(least_runs(0), 0);
    EXPECT_THROW(least_runs(1), std::invalid_argument);
    std::mt19937_64 engine(9);
    for (const std::size_t runs : {std::size_t{224}, std::size_t{228}}) {
        Population population = population_of(engine, runs / 4, 0);
        for (double& life : population.leaves) life = 1e9;
        const auto found = follow_at_risk(question_of(population, 0.1), all_of(population), population.at_risk());
        ASSERT_TRUE(found);
        EXPECT_EQ(found->evidence.least_runs, 228);
        EXPECT_EQ(found->evidence.impacts, runs < 228 ? 0 : look);
    }
}

// Errors fall with the root of the impacts, by a factor that is the run's own: each called run is followed to the first
// look at which its mean is known, or to the limits. What is not called goes its way as without an error.
TEST(AtRisk, MeansOfCalledRunsAreFollowedUntilTheirErrorIsSmall) {
    constexpr std::int64_t last = 7380;
    std::mt19937_64 engine(4);
    Population without = population_of(engine, 1000, 0), with = without;
    RunsAtRisk runs = with.at_risk();
    const auto error_of = [](std::size_t run, std::int64_t impacts) {
        return static_cast<double>(1 + run % 40) / std::sqrt(static_cast<double>(impacts));
    };
    std::vector<std::int64_t> ended(with.leaves.size(), -1);
    runs.follow = [&, follow = runs.follow](std::span<const std::size_t> some, std::int64_t to) {
        auto seen = follow(some, to);
        for (std::size_t i = 0; i < some.size(); ++i) {
            (*seen)[i].mean_error = error_of(some[i], to > 0 ? to : 20'000);
            ended[some[i]] = to;
        }
        return seen;
    };
    constexpr double error = 0.2;
    RiskQuestion question = question_of(with, 0.05);
    ASSERT_TRUE(follow_at_risk(question, all_of(without), without.at_risk()));
    question.error = error;
    question.last_look = last;
    ASSERT_TRUE(follow_at_risk(question, all_of(with), runs));
    int at_first = 0, later = 0, at_limits = 0;
    for (std::size_t run = 0; run < ended.size(); ++run) {
        if (without.kept[run] == 0 || !(without.leaves[run] > look)) {
            EXPECT_EQ(with.kept[run], without.kept[run]) << run;
            continue;
        }
        std::int64_t first = look;  // the first at which the error is small enough
        while (first <= last && error_of(run, first) > error) first += first / 2;
        EXPECT_EQ(ended[run], first <= last ? first : 0) << run;
        EXPECT_EQ(with.kept[run] + with.followed[run], 1) << run;
        (ended[run] == look ? at_first : ended[run] > 0 ? later : at_limits) += 1;
    }
    EXPECT_GT(at_first, 100);
    EXPECT_GT(later, 100);
    EXPECT_GT(at_limits, 100);
}

// Part of the work is the same as in all of it.
TEST(AtRisk, AShardHasTheEvidenceOfAll) {
    std::mt19937_64 engine(2);
    Population population = population_of(engine, 1000, 0.1), shard = population;
    const auto whole = follow_at_risk(question_of(population, 0.05), all_of(population), population.at_risk());
    const std::vector<std::size_t> own{400, 401, 402, 403, 1200, 1201, 1202, 1203};
    const auto part = follow_at_risk(question_of(shard, 0.05), own, shard.at_risk());
    ASSERT_TRUE(whole && part);
    EXPECT_EQ(whole->evidence.impacts, look);
    EXPECT_EQ(part->evidence.least_exponent, whole->evidence.least_exponent);
    EXPECT_EQ(part->evidence.judged, whole->evidence.judged);
    EXPECT_EQ(part->sample, whole->sample);
    for (const std::size_t run : own) {
        EXPECT_EQ(shard.kept[run], population.kept[run]);
        EXPECT_EQ(shard.followed[run], population.followed[run]);
    }
}

// The promise: of the populations at most 5 % have a larger share of changed runs among the called than the risk, and
// the larger the risk the more are called.
TEST(AtRisk, TheRiskIsKeptInNineteenOfTwentyCases) {
    std::mt19937_64 engine(3);
    constexpr int trials = 300;
    double before = 0;
    for (const double risk : {0.02, 0.05}) {
        int broken = 0, some = 0;
        double called = 0;
        for (int i = 0; i < trials; ++i) {
            Population population = population_of(engine, 750, 0.5 * (i % 10) / 10.0);
            ASSERT_TRUE(
                follow_at_risk(question_of(population, risk, engine()), all_of(population), population.at_risk()));
            const auto counts = population.called();
            called += counts.first;
            some += counts.first > 0 ? 1 : 0;
            broken += counts.second >= risk * counts.first && counts.first > 0 ? 1 : 0;
        }
        EXPECT_GE(some, trials / 3) << risk;
        EXPECT_LE(broken, 0.05 * trials) << risk;
        EXPECT_GT(called, before);
        before = called;
    }
}

TEST(LookOfOne, OfOneRunTheChanceIsSmallNearTheLimitsOnly) {
    const analysis::ClassifyOptions settings;
    for (const double risk : {0.0, 0.01, 0.5, 0.9}) EXPECT_EQ(look_of_one(risk, settings), 0) << risk;
    EXPECT_EQ(look_of_one(0.92, settings), 11'070);  // 1 − e^{−3 · 8930/11070} = 0.911
    EXPECT_THROW(look_of_one(1, settings), std::invalid_argument);
}

std::uint64_t bits(double value) {
    return std::bit_cast<std::uint64_t>(value);
}

// What is known at a look is what is known at the limits, to the bit; what is chaotic there was judged on its impacts.
TEST(Look, WhatHasSettledHasTheVerdictOfTheLimits) {
    std::vector<SceneStart> starts;
    for (const double alpha : {0.15, 0.2, 0.6, 0.65, 0.7, 0.75})
        for (std::uint64_t seed = 1; seed < 6; ++seed) {
            const Scene<double> scene = tests::scene_of(6, alpha, 0.5, 0.5, 0.95);
            starts.push_back({scene, random_start(scene.beta, paper_speed, seed, 0)});
        }
    NamingOptions options;
    options.settings.transient = options.settings.collisions = 2000;
    std::vector<NamedMode> at_limits(starts.size()), at_look(starts.size());
    const auto into = [](std::vector<NamedMode>& all) {
        return [&all](std::size_t place, const NamedMode& named, const OrbitSamples&) { all[place] = named; };
    };
    name_modes(starts, options, into(at_limits));
    options.look = look;
    name_modes(starts, options, into(at_look));
    int chaotic = 0, known = 0;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        SCOPED_TRACE(i);
        const NamedMode &found = at_look[i], &limit = at_limits[i];
        const SeenRun seen =
            seen_of(found.verdict.kind, found.outcome, found.verdict.largest_exponent, found.mean_errors.per_time);
        chaotic += seen.chaotic ? 1 : 0;
        known += seen.known ? 1 : 0;
        EXPECT_FALSE(seen.chaotic && seen.known);
        EXPECT_LE(found.impacts, look + 2);
        EXPECT_EQ(bits(name_alone(starts[i], options).verdict.mean), bits(found.verdict.mean));
        if (seen.known) {
            EXPECT_EQ(found.verdict.kind, limit.verdict.kind);
            EXPECT_EQ(found.impacts, limit.impacts);
            EXPECT_EQ(found.verdict.period, limit.verdict.period);
            EXPECT_EQ(bits(found.verdict.mean), bits(limit.verdict.mean));
            EXPECT_EQ(bits(found.verdict.recurrence_rate_without_diagonal),
                      bits(limit.verdict.recurrence_rate_without_diagonal));
        } else {
            EXPECT_GE(limit.impacts, look);
        }
    }
    EXPECT_GE(chaotic, 5);
    EXPECT_GE(known, 5);
    options.look = 700;
    EXPECT_THROW(name_alone(starts[0], options), std::invalid_argument);
}

}  // namespace
}  // namespace swirl::studies
