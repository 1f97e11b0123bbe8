// Clouds of impacts that differ by their errors alone, among others.
#include "analysis/fits/alike_impacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace swirl::analysis {
namespace {

constexpr double error = 0.01;

MeasuredImpact impact_at(const Eigen::Vector3d& before, const Eigen::Vector3d& after, std::mt19937_64& engine) {
    std::normal_distribution<double> normal(0, error);
    MeasuredImpact impact;
    impact.before = before, impact.after = after;
    for (Eigen::Index j = 0; j < 3; ++j) impact.before[j] += normal(engine), impact.after[j] += normal(engine);
    impact.offset << 0, -1;
    impact.error_before.setConstant(error), impact.error_after.setConstant(error);
    return impact;
}

/// Impacts 0, 1 … of `others` far apart, each after so many alike ones.
std::vector<MeasuredImpact> with_cloud(std::size_t alike, std::size_t others, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> even(-1, 1);
    std::vector<MeasuredImpact> impacts;
    for (std::size_t i = 0; i < alike; ++i) impacts.push_back(impact_at({0.4, -0.5, 1}, {0.3, 0.45, 0.8}, engine));
    for (std::size_t i = 0; i < others; ++i)
        impacts.push_back(impact_at({even(engine), -1 + 0.5 * even(engine), even(engine)},
                                    {even(engine), 1 + 0.5 * even(engine), even(engine)}, engine));
    std::shuffle(impacts.begin(), impacts.end(), engine);
    return impacts;
}

std::size_t members_of(const std::vector<AlikeImpacts>& groups) {
    std::set<std::size_t> all;
    for (const AlikeImpacts& group : groups) all.insert(group.members.begin(), group.members.end());
    return all.size();
}

TEST(AlikeImpacts, ACloudAmongOthersIsOneGroupAndEachOtherItsOwn) {
    const auto impacts = with_cloud(300, 30, 1);
    const auto groups = alike_impacts(impacts);
    EXPECT_EQ(members_of(groups), 330U);
    std::size_t merged = 0, largest = 0;
    for (const AlikeImpacts& group : groups)
        merged += group.merged(), largest = std::max(largest, group.members.size());
    EXPECT_EQ(merged, 1U);
    EXPECT_GE(largest, 298U);  // χ²(6) is beyond the reach, 30, once in 25,000
    EXPECT_LE(largest, 300U);
    EXPECT_TRUE(std::is_sorted(groups.begin(), groups.end(),
                               [](const auto& a, const auto& b) { return a.members.front() < b.members.front(); }));
}

TEST(AlikeImpacts, ImpactsThatDifferByMoreThanTheirErrorsAreNotMerged) {
    // Evenly in 20 errors of three components: closer to each other than a cloud's reach, and no cloud.
    std::mt19937_64 engine(2);
    std::uniform_real_distribution<double> even(-10 * error, 10 * error);
    std::vector<MeasuredImpact> impacts;
    for (int i = 0; i < 300; ++i)
        impacts.push_back(impact_at({even(engine), -0.5, 1}, {0.3, 0.45 + even(engine), 0.8 + even(engine)}, engine));
    for (const AlikeImpacts& group : alike_impacts(impacts)) EXPECT_FALSE(group.merged());
}

TEST(AlikeImpacts, AFewOthersLeaveTheCloudInPartsOfOneKind) {
    const auto groups = alike_impacts(with_cloud(400, 4, 3));
    EXPECT_GE(groups.size(), enough_groups);
    EXPECT_EQ(members_of(groups), 404U);
    std::set<std::size_t> kinds;
    std::size_t parts = 0, least = 400, most = 0;
    for (const AlikeImpacts& group : groups) {
        if (!group.merged()) continue;
        kinds.insert(group.kind), ++parts;
        least = std::min(least, group.members.size()), most = std::max(most, group.members.size());
        EXPECT_EQ(group.parts, 16U);
    }
    EXPECT_EQ(kinds.size(), 1U);
    EXPECT_EQ(parts, 16U);
    EXPECT_LE(most - least, 1U);
}

TEST(AlikeImpacts, TheirMeanIsTheCloudsMiddleAndKeepsWhatIsCommonInItsErrors) {
    const auto impacts = with_cloud(300, 30, 4);
    const auto groups = alike_impacts(impacts);
    std::vector<double> weights(impacts.size(), 1.0);
    const WeighedImpacts merged = merged_impacts(impacts, weights, groups);
    ASSERT_EQ(merged.impacts.size(), groups.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
        EXPECT_EQ(merged.weights[g], 1);
        const MeasuredImpact &mean = merged.impacts[g], &first = impacts[groups[g].members.front()];
        if (!groups[g].merged()) {
            EXPECT_EQ(mean.before, first.before);
            continue;
        }
        const double count = static_cast<double>(groups[g].members.size());
        EXPECT_NEAR(mean.before[1], -0.5, 4 * error / std::sqrt(count));
        EXPECT_NEAR(mean.after[2], 0.8, 4 * error / std::sqrt(count));
        EXPECT_NEAR(mean.error_after[0], error * std::sqrt(1 / count + 0.04), 1e-12);
    }
    // Weights count: of one member alone the mean is that, and a group that is not drawn is left at 0.
    const auto cloud = std::find_if(groups.begin(), groups.end(), [](const auto& group) { return group.merged(); });
    std::fill(weights.begin(), weights.end(), 0);
    weights[cloud->members[5]] = 3;
    const WeighedImpacts drawn = merged_impacts(impacts, weights, groups);
    for (std::size_t g = 0; g < groups.size(); ++g) EXPECT_EQ(drawn.weights[g], groups[g].merged() ? 1 : 0);
    const auto place = static_cast<std::size_t>(cloud - groups.begin());
    EXPECT_LT((drawn.impacts[place].before - impacts[cloud->members[5]].before).norm(), 1e-15);
}

TEST(AlikeImpacts, ResamplesMoveAllPartsOfACloudByTheSameCommonErrors) {
    const auto impacts = with_cloud(400, 4, 5);
    const auto groups = alike_impacts(impacts);
    const std::vector<double> once(impacts.size(), 1.0);
    const WeighedImpacts still = merged_impacts(impacts, once, groups);
    double squares = 0;
    constexpr int draws = 400;
    for (int draw = 0; draw < draws; ++draw) {
        WeighedImpacts moved = still;
        move_clouds(moved, groups, 1, static_cast<std::uint64_t>(draw));
        std::vector<double> moves;
        for (std::size_t g = 0; g < groups.size(); ++g) {
            const double move = moved.impacts[g].after[1] - still.impacts[g].after[1];
            if (groups[g].merged())
                moves.push_back(move);
            else
                EXPECT_EQ(move, 0);
        }
        for (const double move : moves)
            EXPECT_NEAR(move, moves.front(), 1e-3 * error);  // their mean errors differ little
        squares += moves.front() * moves.front() / draws;
    }
    // A variance of 400 normal draws is known to 7 %.
    EXPECT_NEAR(std::sqrt(squares), common_error * error, 0.15 * common_error * error);
}

}  // namespace
}  // namespace swirl::analysis
