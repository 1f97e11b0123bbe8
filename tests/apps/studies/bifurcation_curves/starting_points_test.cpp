// Where curves begin: cycles that runs of a map came to.
#include "apps/studies/bifurcation_curves/starting_points.hpp"
#include "apps/studies/diagrams/attractor.hpp"
#include "tests/apps/studies/scene_map/scene_of.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace swirl::studies {
namespace {

constexpr bifurcation_curves::MapStarts usual{1, paper_speed, 10'000, 10'000};

Scene<double> hexagon_at(const Eigen::Vector2d& p) {
    return tests::scene_of(6, p[0], p[1], 0.5, 0.95);
}

diagrams::Attractor settled_on(const Eigen::Vector2d& p, std::uint64_t run) {
    const Scene<double> scene = hexagon_at(p);
    return diagrams::settle(scene, random_start(scene.beta, usual.speed, usual.seed + run, 0),
                            {usual.transient, usual.collisions});
}

/// A run at p whose chaos ends so late that it stays undecided, though a period is found.
std::optional<std::uint64_t> undecided_run(const Eigen::Vector2d& p, std::uint64_t runs) {
    for (std::uint64_t run = 0; run < runs; ++run) {
        const auto attractor = settled_on(p, run);
        if (attractor.mode == analysis::Mode::undecided && attractor.period > 0) return run;
    }
    return std::nullopt;
}

std::vector<bifurcation_curves::StartingPoint> starting_points_from(const Eigen::Vector2d& p, std::uint64_t run) {
    const bifurcation_curves::Plane plane{
        {ParameterRange{"alpha", Parameter::alpha, 0.1, 0.9}, ParameterRange{"beta", Parameter::beta, 0.05, 1.05}}};
    return bifurcation_curves::starting_points_of_runs(hexagon_at(p), plane, {{p, run}}, usual, {});
}

TEST(StartingPointsOfRuns, AnUndecidedRunHasAllItsSamplesButNoCycle) {
    const Eigen::Vector2d p{0.38140703517587937, 0.82889447236180902};
    const auto run = undecided_run(p, 200);  // some one in thirty
    ASSERT_TRUE(run) << "no run to ask";
    const auto attractor = settled_on(p, *run);
    EXPECT_GT(attractor.states.cols(), 1000);
    EXPECT_FALSE(diagrams::is_on_cycle(attractor));
    EXPECT_TRUE(starting_points_from(p, *run).empty());  // a system of so many points would not fit into memory
}

TEST(StartingPointsOfRuns, ARunOnACycleLeadsToTheEndsOfItsBranches) {
    const Eigen::Vector2d p{0.4, 0.5};
    const auto attractor = settled_on(p, 0);
    ASSERT_TRUE(diagrams::is_on_cycle(attractor));
    EXPECT_EQ(attractor.states.cols(), attractor.period);
    EXPECT_FALSE(starting_points_from(p, 0).empty());
}

}  // namespace
}  // namespace swirl::studies
