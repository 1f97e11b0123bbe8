// The 48 orbits of tests/references/trajectories.json, in three precisions.
#include "map/orbit/maps_in_quad.hpp"
#include "tests/map/reference_orbits.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swirl {
namespace {

template <class T>
void reproduce(const tests::Tolerance& tolerance, int impacts) {
    tests::reproduce<T>("trajectories.json", tolerance, 48, impacts);
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
