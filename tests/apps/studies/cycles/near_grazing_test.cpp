// Cycles whose impacts all but graze: solved with the impacts' times as unknowns, where DF grows without bound.
#include "analysis/cycles/multi_shooting.hpp"
#include "tests/apps/studies/cycles/scene_cycles.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace swirl {
namespace {

// Elimination of the time: DF = ∂z′/∂z − ∂z′/∂τ (∂g/∂z)/(∂g/∂τ).
TEST(TimedCollision, GivesTheMapsDerivativeOnceTheTimeIsEliminated) {
    const auto references = tests::read_reference("cycles.json");
    for (const auto& c : references["cycles"]) {
        const auto scene = tests::scene_from<double>(c);
        const auto map = studies::shooting_map_of(scene), timed = studies::timed_map_of(scene).map;
        const auto z = studies::coordinates_of(tests::point_from<double>(c["point"]), scene.is_disk());
        const auto step = map.step(z, 0);
        Eigen::VectorXd y(timed.dimension);
        y << z, step.duration;
        const auto extended = timed.step(y, 0);
        ASSERT_TRUE(step.alive && extended.alive);
        const Eigen::Index d = z.size();
        const Eigen::MatrixXd& e = extended.by_state;
        const Eigen::MatrixXd eliminated =
            e.topLeftCorner(d, d) - e.topRightCorner(d, 1) * e.bottomLeftCorner(1, d) / e(d, d);
        EXPECT_LE((eliminated - step.by_state).norm(), 1e-12 * step.by_state.norm());
        EXPECT_LE(map.distance(extended.state.head(d), step.state), 1e-13);
        EXPECT_LE(std::abs(extended.state[d]), 1e-14);  // the contact's gap, to rounding
        EXPECT_EQ(extended.letter, step.letter);
    }
}

TEST(NearGrazing, CyclesAreReachedFromWhereTheMapsOwnSolverFails) {
    const Scene<double> scene{6, 0.4, 0.5, 0.5, 0.9, Law::poisson, uniform_inertia_factor<double>(6)};
    const auto map = studies::shooting_map_of(scene);
    const auto timed = studies::timed_map_of(scene);
    Eigen::VectorXd z(5);  // a 3-cycle with an impact at u_n = 0.02 and a multiplier of 8·10⁴
    z << -3.140464623458104, 0.0008869223756284513, -0.018611351111013124, 0.09296616479760035, -1.4824151997686588;
    auto points = analysis::orbit_from(map, z, 0, 3);
    ASSERT_LE(analysis::polish_cycle(map, points, 0), 1e-10);
    tests::Random random(3);
    int alone = 0, together = 0;
    constexpr int trials = 200;
    for (int i = 0; i < trials; ++i) {
        auto guess = points;
        for (auto& point : guess)
            for (auto& x : point) x += random.between(-1e-3, 1e-3);
        const auto leads_back = [&](const analysis::ShootingResult& shot) {
            return shot.converged && analysis::distance_between(map, shot.points, points) < 1e-8;
        };
        const bool first = leads_back(analysis::solve_shooting(map, guess, 0, 1e-10));
        alone += first ? 1 : 0;
        together += first || leads_back(analysis::solve_near_grazing(map, timed, guess, 0, 1e-10)) ? 1 : 0;
    }
    std::printf("from 1e-3 away %d of %d find it by the map alone, %d with times as unknowns too\n", alone, trials,
                together);
    EXPECT_GE(together, 0.95 * trials);  // 89 and 200 of 200 when written
    EXPECT_LE(alone, 0.75 * trials);     // else this cycle shows nothing
}

}  // namespace
}  // namespace swirl
