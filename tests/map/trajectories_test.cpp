// The 48 orbits of tests/references/trajectories.json, in three precisions.
#include "map/numbers/quad.hpp"
#include "map/orbit/laboratory.hpp"
#include "tests/map/reference_error.hpp"
#include "tests/references/references.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace swirl {
namespace {

using nlohmann::json;
using tests::error_of;
using tests::number;
using tests::Tolerance;

struct Tally {
    int orbits = 0, impacts = 0;
    double worst = 0;  ///< error in units of what is allowed
};

template <class Map>
void follow(const Map& map, const json& orbit, const Tolerance& tolerance, Tally& tally) {
    using T = typename Map::Number;
    const json& i = orbit["initial"];
    const LabStart<T> start{number<T>(i["x"]),  number<T>(i["y"]),     number<T>(i["vx"]),
                            number<T>(i["vy"]), number<T>(i["angle"]), number<T>(i["spin"])};
    auto frame = LabFrame<T>::at_start(start.angle);
    Collision<T> collision = map.advance(flight_from(map.body(), start));
    T spin = start.spin;
    int k = 0;
    for (const json& row : orbit["collisions"]) {
        const double amplification = row["amplification"];
        if (k++ > 0) collision = map.advance(collision.after);
        ASSERT_EQ(collision.outcome, FirstContactOutcome::contact) << "impact " << k;
        frame.follow(map, collision, spin * collision.flight_time);
        spin = collision.after.spin;
        if (amplification > tolerance.reach) continue;
        EXPECT_EQ(frame.vertex, row["vertex"].get<int>()) << "impact " << k;
        const double error = error_of(lab_state(map.body(), frame, collision.after), collision, row);
        const double allowed = std::max(tolerance.floor, tolerance.relative * amplification);
        EXPECT_LE(error, allowed) << "impact " << k;
        tally.worst = std::max(tally.worst, error / allowed);
        ++tally.impacts;
    }
}

template <class T>
void reproduce(const Tolerance& tolerance, int impacts) {
    const json references = tests::read_reference("trajectories.json");
    Tally tally;
    for (const json& orbit : references["cases"]) {
        SCOPED_TRACE("orbit " + std::to_string(tally.orbits));
        with_collision_map(tests::scene_from<T>(orbit), [&](const auto& map) { follow(map, orbit, tolerance, tally); });
        ++tally.orbits;
    }
    std::printf("%d orbits, %d impacts, largest error %.3f of what is allowed\n", tally.orbits, tally.impacts,
                tally.worst);
    EXPECT_EQ(tally.orbits, 48);
    EXPECT_GE(tally.impacts, impacts);
}

TEST(Trajectories, ReferenceOrbitsAreReproducedInDouble) {
    reproduce<double>({1e-13, 1e-12, 1e10}, 500);
}

/// Tolerances are those in double in units of ε, which is 2¹¹ times smaller here.
TEST(Trajectories, ReferenceOrbitsAreReproducedInLongDouble) {
    reproduce<long double>({1e-13 / 2048, 1e-12 / 2048, 1e13}, 500);
}

TEST(Trajectories, ReferenceOrbitsAreReproducedInQuad) {
    reproduce<Quad>({1e-24, 1e-22, HUGE_VAL}, 48 * 12);
}

}  // namespace
}  // namespace swirl
