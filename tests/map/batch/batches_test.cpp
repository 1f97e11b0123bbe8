// What a batch promises besides equal bits: endings, any mixture of orbits, and that its lanes are used.
#include "map/orbit/laboratory.hpp"
#include "tests/map/batch/together.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace {

using namespace swirl;
using namespace swirl::tests;

using Disk = CollisionMap<double, Shape::disk, ImpactRule::poisson>;
using Hexagon = CollisionMap<double, Shape::polygon, ImpactRule::poisson>;
using FrictionlessDisk = CollisionMap<double, Shape::disk, ImpactRule::frictionless>;
using NewtonPolygon = CollisionMap<double, Shape::polygon, ImpactRule::newton>;

Scene<double> scene_of(int sides, double alpha, double beta, double mu, double restitution, Law law = Law::poisson) {
    return {sides, alpha, beta, mu, restitution, law, uniform_inertia_factor<double>(sides)};
}

/// Orbits of one scene from starts that differ slightly.
template <class Map>
Orbits<Map> orbits_of(const Scene<double>& scene, int count, long long impacts) {
    Orbits<Map> set;
    const Map map(scene);
    for (int k = 0; k < count; ++k) {
        const LabStart<double> start{scene.beta, 0, 0.1 + 0.001 * k, 0.2, 0.3, 0.1};
        set.add(scene, map.advance(flight_from(map.body(), start)).after, impacts);
    }
    return set;
}

TEST(BatchTest, LanesKeepSteadyOrbits) {
    // On its way to a steady mode nearly every impact is decided in its lane; 0.1 % are measured to leave.
    const Compared disk = compare(orbits_of<Disk>(scene_of(disk_sides, 0.3, 0.5, 0.5, 1), 32, 1000).orbits);
    EXPECT_EQ(disk.different, 0);
    EXPECT_LT(disk.use.share_left(), 0.01);
    const Compared hexagon = compare(orbits_of<Hexagon>(scene_of(6, 0.4, 0.5, 0.5, 0.9), 32, 1000).orbits);
    EXPECT_EQ(hexagon.different, 0);
    EXPECT_LT(hexagon.use.share_left(), 0.01);
    EXPECT_GT(hexagon.use.lanes_in_use(), 0.95);
}

TEST(BatchTest, LanesKeepMostOfChaos) {
    const Compared result = compare(orbits_of<Hexagon>(scene_of(6, 0.3, 0.5, 0.5, 1), 32, 2000).orbits);
    EXPECT_EQ(result.different, 0);
    EXPECT_LT(result.use.share_left(), 0.15);  // 0.07 measured
    EXPECT_GT(result.use.search_failed, result.use.left / 2);
}

TEST(BatchTest, LanesSeekLongFlightsOfDisksFromSamples) {
    const Scene<double> scene = scene_of(disk_sides, 0.3, 0.5, 0, 1);
    const Compared many = compare(orbits_of<FrictionlessDisk>(scene, 32, 1000).orbits);
    EXPECT_EQ(many.different, 0);
    EXPECT_GT(many.use.sampled, many.impacts / 10);  // 0.15 measured
    EXPECT_LT(many.use.share_left(), 0.05);          // 0.03 measured
    EXPECT_EQ(many.by_lanes + many.use.left, many.impacts);
    // Without others that could take its lane, a flight does not wait.
    const Compared few = compare(orbits_of<FrictionlessDisk>(scene, 8, 1000).orbits);
    EXPECT_EQ(few.different, 0);
    EXPECT_EQ(few.use.sampled, 0);
    EXPECT_GT(few.use.left, few.impacts / 10);
}

/// An observer that wants nothing of every other orbit.
struct EveryOther {
    const BatchedOrbit<Hexagon>* first;
    std::vector<long long>& shown;
    long long& shown_of_lanes;

    std::size_t place_of(const BatchedOrbit<Hexagon>& orbit) const { return static_cast<std::size_t>(&orbit - first); }
    bool wants(const BatchedOrbit<Hexagon>& orbit) const { return place_of(orbit) % 2 == 0; }
    void operator()(const BatchedOrbit<Hexagon>& orbit, const BatchedImpact& impact) const {
        const std::size_t i = place_of(orbit);
        ++shown[i];
        if (i % 2 != 0) shown_of_lanes += impact.alone == nullptr;
    }
};

TEST(BatchTest, AnObserverSeesTheLanesThatItWants) {
    const auto set = orbits_of<Hexagon>(scene_of(6, 0.3, 0.5, 0.5, 1), 12, 500);
    auto orbits = set.orbits;
    std::vector<long long> shown(orbits.size(), 0);
    long long shown_of_lanes = 0;
    const BatchUse use = follow_batch(std::span(orbits), EveryOther{orbits.data(), shown, shown_of_lanes});
    EXPECT_GT(use.left, 0);
    EXPECT_EQ(shown_of_lanes, 0);
    for (std::size_t i = 0; i < orbits.size(); ++i) {
        ASSERT_EQ(orbits[i].done, 500) << i;
        if (i % 2 == 0)
            EXPECT_EQ(shown[i], 500) << i;
        else
            EXPECT_LT(shown[i], 500) << i;
    }
}

TEST(BatchTest, OneOrbitOrManyTheSameBits) {
    const auto set = random_orbits<Shape::polygon, ImpactRule::poisson>(5, 19, 300);
    auto together = set.orbits;
    follow_batch(std::span(together));
    for (std::size_t i = 0; i < set.orbits.size(); ++i) {
        auto alone = set.orbits[i];
        follow_batch(std::span(&alone, 1));
        EXPECT_EQ(alone.done, together[i].done) << i;
        EXPECT_EQ(alone.outcome, together[i].outcome) << i;
        EXPECT_TRUE(same_bits(alone.state, together[i].state)) << i;
    }
}

TEST(BatchTest, GoesOnWhereItStopped) {
    const auto set = random_orbits<Shape::polygon, ImpactRule::stronge>(6, 11, 400);
    auto whole = set.orbits, parts = set.orbits;
    follow_batch(std::span(whole));
    for (auto& orbit : parts) orbit.wanted = 150 + (&orbit - parts.data());
    follow_batch(std::span(parts));
    for (auto& orbit : parts) orbit.wanted = 400;
    follow_batch(std::span(parts));
    for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_TRUE(same_bits(whole[i].state, parts[i].state)) << i;
}

TEST(BatchTest, OrbitsEndAsTheyEndAlone) {
    // Without friction and with e < 1 every disk comes to stay on the wall.
    const auto resting = orbits_of<FrictionlessDisk>(scene_of(disk_sides, 0.4, 0.3, 0, 0.7), 10, 100'000);
    auto orbits = resting.orbits;
    follow_batch(std::span(orbits));
    for (const auto& orbit : orbits) {
        EXPECT_LT(orbit.done, orbit.wanted);
        EXPECT_NE(orbit.outcome, Outcome::completed);
    }
    EXPECT_EQ(compare(resting.orbits).different, 0);
    // A container at rest: decays to speeds that the lanes leave to the scalar code.
    EXPECT_EQ(compare(orbits_of<Hexagon>(scene_of(6, 0.4, 0, 0.5, 0.5), 10, 5000).orbits).different, 0);
    // Newton's law creates energy here, without end.
    const auto growing = orbits_of<NewtonPolygon>(scene_of(3, 0.6, 0, 1, 1, Law::newton), 10, 5000);
    const Compared grown = compare(growing.orbits);
    EXPECT_EQ(grown.different, 0);
    EXPECT_GT(grown.by_lanes, 0);
    auto diverging = growing.orbits;
    follow_batch(std::span(diverging));
    for (const auto& orbit : diverging) EXPECT_EQ(orbit.outcome, Outcome::diverged);
}

TEST(BatchTest, VerticesBeyondTheTablesAreFollowedAlone) {
    Orbits<Hexagon> set = orbits_of<Hexagon>(scene_of(1025, 0.4, 0.5, 0.5, 0.9), 3, 50);
    const Hexagon map(scene_of(6, 0.4, 0.5, 0.5, 0.9));
    const LabStart<double> start{0.5, 0, 0.1, 0.2, 0.3, 0.1};
    set.add(map.scene(), map.advance(flight_from(map.body(), start)).after, 50);
    const Compared result = compare(set.orbits);
    EXPECT_EQ(result.different, 0);
    EXPECT_EQ(result.impacts, 200);
    EXPECT_GT(result.by_lanes, 0);
    EXPECT_LE(result.by_lanes, 50);
}

TEST(BatchTest, NothingToDo) {
    std::vector<BatchedOrbit<Disk>> none;
    EXPECT_EQ(follow_batch(std::span(none)).impacts, 0);
    auto set = orbits_of<Disk>(scene_of(disk_sides, 0.3, 0.5, 0.5, 1), 2, 0);
    EXPECT_EQ(follow_batch(std::span(set.orbits)).rounds, 0);
}

}  // namespace
