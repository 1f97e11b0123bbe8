// Runs over a grid: the scene, start and verdict of each.
#include "apps/studies/grids/run_cells.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "tests/apps/studies/scene_map/scene_of.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace swirl::studies::grids {
namespace {

/// Two by two cells, two runs each.
GridStudy small_study() {
    GridStudy study;
    study.grid = {{.name = "alpha", .points = {0.3, 0.4}}, {.name = "sides", .points = {3, 6}}};
    study.scene = tests::scene_of(6, 0.4, 0.5, 0.5, 0.9);
    study.runs = 2;
    study.seed = 7;
    study.settings.transient = study.settings.collisions = 200;
    return study;
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(GridStudy, ACellsSceneHasItsPointAndTheLaminaOfItsSides) {
    const GridStudy study = small_study();
    const Scene<double> first = cell_scene(study, 0), last = cell_scene(study, 3);
    EXPECT_EQ(first.sides, 3);
    EXPECT_EQ(first.alpha, 0.3);
    EXPECT_EQ(first.inertia_factor, uniform_inertia_factor<double>(3));
    EXPECT_EQ(last.sides, 6);
    EXPECT_EQ(last.alpha, 0.4);
    EXPECT_EQ(last.inertia_factor, uniform_inertia_factor<double>(6));
    EXPECT_EQ(last.restitution, 0.9);
    GridStudy given = study;
    given.uniform = false;
    given.scene.inertia_factor = 0.3;
    EXPECT_EQ(cell_scene(given, 0).inertia_factor, 0.3);
    given.grid[0].points[1] = 1.5;
    EXPECT_THROW(cell_scene(given, 3), std::invalid_argument);
}

TEST(GridStudy, PlacedStartsTakeTheCellsNumbersAndElseTheCentre) {
    GridStudy study = small_study();
    study.grid = {{.name = "beta", .points = {0.2, 0.6}}, {.name = "vx", .points = {-1, 1}}};
    const Scene<double> scene = cell_scene(study, 2);
    const LabStart<double> start = cell_start(study, scene, 2, 0);
    EXPECT_EQ(start.x, 0.6);
    EXPECT_EQ(start.vx, -1);
    EXPECT_EQ(start.vy, 0);
    study.at_centre = false;
    study.placed.x = 0.1;
    EXPECT_EQ(cell_start(study, scene, 2, 0).x, 0.1);
}

TEST(SweepGrid, EveryRunHasTheVerdictOfItsOwnSceneAndSeedWhateverTheThreads) {
    const GridStudy study = small_study();
    RunControl control;
    control.threads = 2;
    const auto results = sweep_grid(study, control);
    ASSERT_TRUE(results.has_value());
    ASSERT_EQ(results->size(), 8U);
    for (std::size_t i = 0; i < results->size(); ++i) {
        SCOPED_TRACE(i);
        const Scene<double> scene = cell_scene(study, i / 2);
        const auto start = random_start(scene.beta, paper_speed, 7 + i % 2, 0);
        const RunResult alone = result_of(name_mode(scene, start, study.settings));
        const RunResult& run = (*results)[i];
        EXPECT_EQ(run.mode, alone.mode);
        EXPECT_EQ(run.kind, alone.kind);
        EXPECT_EQ(run.impacts, alone.impacts);
        EXPECT_TRUE(same_bits(run.mean_spin, alone.mean_spin));
        EXPECT_TRUE(same_bits(run.largest_exponent, alone.largest_exponent));
    }
}

// 8 x 16 runs of hexagons, most of them chaotic, of which a sample of 22 tells.
TEST(SweepGrid, AtARiskChaosIsCalledEarlyAndNothingElseChanges) {
    GridStudy study = small_study();
    study.grid = {{.name = "alpha", .points = {0.1, 0.12, 0.15, 0.6}}, {.name = "beta", .points = {0.4, 0.6}}};
    study.scene = tests::scene_of(6, 0.4, 0.5, 0.5, 0.95);
    study.runs = 16;
    study.settings.transient = study.settings.collisions = 1000;
    const auto all = sweep_grid(study);
    study.risk = 0.3;
    RunControl one_thread;
    one_thread.threads = 1;
    const auto few = sweep_grid(study), again = sweep_grid(study, one_thread);
    ASSERT_TRUE(all && few && again);
    int early = 0;
    for (std::size_t i = 0; i < all->size(); ++i) {
        SCOPED_TRACE(i);
        const RunResult &limit = (*all)[i], &run = (*few)[i];
        EXPECT_TRUE(same_bits(run.mean_spin, (*again)[i].mean_spin));
        const bool is_early = kind_of(run) == analysis::Kind::chaotic && run.impacts < 440;
        early += is_early ? 1 : 0;
        EXPECT_TRUE(is_early || (same_bits(run.mean_spin, limit.mean_spin) && run.impacts == limit.impacts));
    }
    EXPECT_GE(early, 30);
}

TEST(SweepGrid, AStopLeavesNothingAndATaskIsNamedWithItsTotal) {
    std::atomic<int> reports = 0;
    std::string task;
    RunControl control;
    control.begin_task = [&](const std::string& name, double total) -> ReportDone {
        task = name;
        EXPECT_GE(total, 1);
        return [&reports](double) { ++reports; };
    };
    EXPECT_TRUE(sweep_grid(small_study(), control).has_value());
    EXPECT_EQ(task, "sweep");
    EXPECT_GE(reports, 1);
    control.stop = [] { return true; };
    EXPECT_FALSE(sweep_grid(small_study(), control).has_value());
}

}  // namespace
}  // namespace swirl::studies::grids
