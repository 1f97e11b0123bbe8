// [cycles.json, steady_e1.json of tests/references] Every cycle is found, from its period alone and from nearby.
#include "analysis/cycles/multi_shooting.hpp"
#include "tests/apps/studies/cycles/scene_cycles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace swirl {
namespace {

/// A copy: a loop over a member of a temporary would see nothing.
nlohmann::json listed(const std::string& file) {
    nlohmann::json cycles = tests::read_reference(file)["cycles"];
    EXPECT_GE(cycles.size(), 10U);
    return cycles;
}

void expect_found(const nlohmann::json& c) {
    const auto scene = tests::scene_from<double>(c);
    const auto map = studies::shooting_map_of(scene);
    const Eigen::VectorXd z = studies::coordinates_of(tests::point_from<double>(c["point"]), false);
    const analysis::Cycle* nearest = nullptr;
    const auto cycles = tests::cycles_of(scene, c["period"]);
    for (const auto& cycle : cycles)
        if (nearest == nullptr || tests::distance_to(map, cycle, z) < tests::distance_to(map, *nearest, z))
            nearest = &cycle;
    ASSERT_NE(nearest, nullptr);
    EXPECT_LE(tests::distance_to(map, *nearest, z), 1e-10);  // S among the coordinates
    EXPECT_LE(tests::multiplier_error(*nearest, c["multipliers"]), 1e-8);
    EXPECT_NEAR(nearest->return_time, tests::number<double>(c["return_time"]), 1e-10);
    EXPECT_LE(nearest->residual, 1e-12);
}

/// A search each, of seconds: two of each file by day.
TEST(ReferenceCycles, TheFirstAreFoundFromTheirPeriodAlone) {
    for (const auto& cycles : {listed("steady_e1.json"), listed("cycles.json")})
        for (std::size_t i = 0; i < 2; ++i) expect_found(cycles[i]);
}

TEST(ReferenceCyclesNightly, AllAreFoundFromTheirPeriodAlone) {
    for (const auto& cycles : {listed("steady_e1.json"), listed("cycles.json")})
        for (const auto& c : cycles) expect_found(c);
}

TEST(ReferenceCycles, AllAreReachedFromNearbyWithinTwentyIterations) {
    int most = 0;
    for (const char* file : {"cycles.json", "steady_e1.json"}) {
        for (const auto& c : listed(file)) {
            const auto map = studies::shooting_map_of(tests::scene_from<double>(c));
            const Eigen::VectorXd z = studies::coordinates_of(tests::point_from<double>(c["point"]), false);
            Eigen::VectorXd near = z;
            const double signs[] = {1, 0, -1, 1, 1};  // away from the wall: the point must leave it
            for (int i = 0; i < 5; ++i) near[i] += 1e-3 * signs[i];
            const auto shot = analysis::solve_shooting(map, analysis::orbit_from(map, near, 0, c["period"]), 0, 1e-11);
            EXPECT_TRUE(shot.converged) << file;
            EXPECT_LE(shot.iterations, 20) << file;
            most = std::max(most, shot.iterations);
            double nearest = 1;
            for (const auto& point : shot.points) nearest = std::min(nearest, map.distance(point, z));
            EXPECT_LE(nearest, 1e-10) << file;
        }
    }
    std::printf("at most %d iterations\n", most);
}

}  // namespace
}  // namespace swirl
