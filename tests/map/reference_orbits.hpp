// The orbits of a file of tests/references, followed impact by impact in any precision.
#pragma once

#include "map/collision_map.hpp"
#include "map/orbit/laboratory.hpp"
#include "tests/map/reference_error.hpp"
#include "tests/references/references.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace swirl::tests {

struct Reproduced {
    int orbits = 0, impacts = 0;
    double worst = 0;  ///< error in units of what is allowed
};

/// One orbit, up to the last impact whose amplification is within reach.
///   also  what else is asked of such an impact: Collision, its row of the file, its number
template <class Map, class Also>
void follow_reference(const Map& map, const nlohmann::json& orbit, const Tolerance& tolerance, Reproduced& tally,
                      const Also& also) {
    using T = typename Map::Number;
    const nlohmann::json& i = orbit["initial"];
    const LabStart<T> start{number<T>(i["x"]),  number<T>(i["y"]),     number<T>(i["vx"]),
                            number<T>(i["vy"]), number<T>(i["angle"]), number<T>(i["spin"])};
    auto frame = LabFrame<T>::at_start(start.angle);
    Collision<T> collision = map.advance(flight_from(map.body(), start));
    T spin = start.spin;
    int k = 0;
    for (const nlohmann::json& row : orbit["collisions"]) {
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
        also(collision, row, k);
        tally.worst = std::max(tally.worst, error / allowed);
        ++tally.impacts;
    }
}

/// All orbits of a file: so many, with at least so many impacts within reach.
template <class T, class Also>
void reproduce(const char* file, const Tolerance& tolerance, int orbits, int fewest_impacts, const Also& also) {
    const nlohmann::json references = read_reference(file);
    Reproduced tally;
    for (const nlohmann::json& orbit : references["cases"]) {
        SCOPED_TRACE("orbit " + std::to_string(tally.orbits));
        with_collision_map(scene_from<T>(orbit),
                           [&](const auto& map) { follow_reference(map, orbit, tolerance, tally, also); });
        ++tally.orbits;
    }
    std::printf("%d orbits, %d impacts, largest error %.3f of what is allowed\n", tally.orbits, tally.impacts,
                tally.worst);
    EXPECT_EQ(tally.orbits, orbits);
    EXPECT_GE(tally.impacts, fewest_impacts);
}

template <class T>
void reproduce(const char* file, const Tolerance& tolerance, int orbits, int fewest_impacts) {
    reproduce<T>(file, tolerance, orbits, fewest_impacts, [](const auto&, const auto&, int) {});
}

}  // namespace swirl::tests
