// Equal bits on every instruction set that this machine can run, from the plainest on.
#include "analysis/recurrence/lines.hpp"
#include "analysis/recurrence/rates.hpp"
#include "tests/analysis/only_targets.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace swirl::analysis::recurrence {
namespace {

struct Result {
    std::vector<LineHistograms> lines;
    std::vector<std::uint64_t> points;
    double threshold = 0;
};

Result result_of(const Points& points) {
    Result result;
    for (const Norm norm : {Norm::euclidean, Norm::maximum, Norm::manhattan}) {
        Settings s;
        s.norm = norm;
        for (const double threshold : {0.02, 0.3}) {
            result.lines.push_back(count_lines(points, threshold, s));
            result.points.push_back(recurrence_rate(points, threshold, s).points);
        }
        result.threshold += threshold_of_rate(points, 0.1, s);
    }
    return result;
}

TEST(InstructionSets, AllGiveTheSameCounts) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> series(700);
    for (double& v : series) v = uniform(random);
    for (const int dimension : {1, 2, 3, 6})
        for (const double period : {0.0, 2.0}) {
            const Points points = embed_series(series, dimension, 1, period);
            const Result best = result_of(points);
            for (const std::int64_t target : tests::all_targets()) {
                const tests::OnlyTargets only(target);
                const Result other = result_of(points);
                for (std::size_t k = 0; k < best.lines.size(); ++k) {
                    EXPECT_EQ(best.lines[k].diagonal, other.lines[k].diagonal) << hwy::TargetName(target);
                    EXPECT_EQ(best.lines[k].vertical, other.lines[k].vertical) << hwy::TargetName(target);
                    EXPECT_EQ(best.lines[k].recurrence_time, other.lines[k].recurrence_time) << hwy::TargetName(target);
                    EXPECT_EQ(best.lines[k].diagonal_points, other.lines[k].diagonal_points) << hwy::TargetName(target);
                }
                EXPECT_EQ(best.points, other.points) << hwy::TargetName(target);
                EXPECT_EQ(best.threshold, other.threshold) << hwy::TargetName(target);
            }
        }
}

}  // namespace
}  // namespace swirl::analysis::recurrence
