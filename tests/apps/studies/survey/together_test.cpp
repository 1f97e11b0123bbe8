// Orbits that take their steps together against each of them alone: the same bits.
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"
#include "tests/apps/studies/scene_map/scene_of.hpp"
#include "tests/apps/studies/survey/random_scene.hpp"
#include "tests/map/same_bits.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace swirl::studies {
namespace {

using tests::same_bits;

std::vector<std::uint64_t> bits_of(const std::vector<double>& values) {
    std::vector<std::uint64_t> bits;
    bits.reserve(values.size());
    for (const double x : values) bits.push_back(std::bit_cast<std::uint64_t>(x));
    return bits;
}

std::vector<std::uint64_t> bits_of(const NamedMode& named) {
    const auto& v = named.verdict;
    std::vector<double> values{v.mean,
                               v.mean_per_step,
                               v.recurrence_rate,
                               v.largest_exponent,
                               v.largest_exponent_error,
                               static_cast<double>(v.mode),
                               static_cast<double>(v.kind),
                               static_cast<double>(v.period),
                               static_cast<double>(named.outcome),
                               static_cast<double>(named.impacts)};
    values.insert(values.end(), v.point.begin(), v.point.end());
    for (const auto& m : v.multipliers) values.insert(values.end(), {m.real(), m.imag()});
    return bits_of(values);
}

TEST(Together, NamesAreThoseOfOrbitsAlone) {
    std::mt19937_64 random(20261123);
    std::vector<SceneStart> starts;
    const auto scenes = static_cast<std::uint64_t>(tests::sample_count(8));
    for (std::uint64_t i = 0; i < scenes; ++i) {
        Scene<double> scene = random_scene(random);
        scene.law = static_cast<Law>(i % 3);
        for (std::uint64_t run = 0; run < 6; ++run)
            starts.push_back({scene, random_start(scene.beta, paper_speed, i + 1, run)});
    }
    analysis::ClassifyOptions settings;
    settings.transient = settings.collisions = 2000;
    std::vector<std::optional<NamedMode>> together(starts.size());
    const auto take = [&](std::size_t place, const NamedMode& named, const OrbitSamples&) {
        EXPECT_FALSE(together[place]) << "start " << place << " is given twice";
        together[place] = named;
    };
    NamingOptions options;
    options.settings = settings;
    name_modes(starts, options, take);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const NamedMode alone = name_mode(starts[i].scene, starts[i].start, settings);
        ASSERT_TRUE(together[i]) << "start " << i;
        EXPECT_EQ(bits_of(*together[i]), bits_of(alone)) << "start " << i << ", N = " << starts[i].scene.sides;
    }
}

TEST(Together, NothingIsGivenOfThoseThatAreStopped) {
    const Scene<double> scene = tests::scene_of(6, 0.3, 0.5, 0.5, 1);
    std::vector<SceneStart> starts;
    for (std::uint64_t run = 0; run < 8; ++run)
        starts.push_back({scene, random_start(scene.beta, paper_speed, 1, run)});
    const auto take = [](std::size_t place, const NamedMode&, const OrbitSamples&) {
        ADD_FAILURE() << "start " << place;
    };
    name_modes(starts, {{}, Accuracy::double_precision, [] { return true; }}, take);
}

/// What is known early is given early: of two orbits that settle within some 430 impacts and six that stay chaotic one
/// or both of the two, where all are stopped as soon as one is given.
TEST(Together, NamesComeAsTheyAreKnown) {
    std::vector<SceneStart> starts;
    for (std::uint64_t run = 0; run < 8; ++run) {
        const Scene<double> scene = tests::scene_of(6, run < 2 ? 0.2 : 0.3, 0.5, 0.5, 0.95);
        starts.push_back({scene, random_start(scene.beta, paper_speed, 1, run)});
    }
    int given = 0;
    const auto take = [&](std::size_t, const NamedMode&, const OrbitSamples&) { ++given; };
    name_modes(starts, {{}, Accuracy::double_precision, [&] { return given > 0; }}, take);
    EXPECT_GE(given, 1);
    EXPECT_LE(given, 2);
}

/// What lanes keep of an orbit's steps.
struct KeptVectors {
    std::vector<PostImpactState<double>> states;
    std::vector<double> durations, integrals;
    std::vector<std::int64_t> letters;

    KeptSteps as_steps() { return {states, durations, integrals, letters}; }
};

struct Taken {
    int through_contact = 0;  ///< steps
    int forgetful = 0;        ///< orbits with a step whose derivative is zero
};

/// Orbits of a map, of which every other one keeps its steps, are taken, and are what steps alone give.
template <class Map>
Taken expect_taken(const Map& map, double beta, std::size_t orbits, std::int64_t count) {
    std::vector<KeptVectors> vectors(orbits);
    std::vector<KeptSteps> kept;
    std::vector<LaneOrbit<Map::dimension>> lanes;
    kept.reserve(orbits);
    for (KeptVectors& of_one : vectors) kept.push_back(of_one.as_steps());
    for (std::size_t i = 0; i < orbits; ++i) {
        const OrbitBegin begin = begin_orbit(map, Start<double>(random_start(beta, paper_speed, 3, i)));
        EXPECT_EQ(begin.outcome, Outcome::completed);
        lanes.push_back(map.lane_orbit(begin.state, count));
        if (i % 2 == 0) lanes.back().kept = &kept[i];
    }
    const std::vector<LaneOrbit<Map::dimension>> before = lanes;
    map.follow_together(lanes);
    Taken taken;
    for (std::size_t i = 0; i < orbits; ++i) {
        EXPECT_TRUE(lanes[i].taken) << i;
        const KeptVectors& of_one = vectors[i];
        const bool keeps = i % 2 == 0;
        EXPECT_EQ(of_one.states.size(), keeps ? static_cast<std::size_t>(count) : 0);
        PostImpactState<double> z = before[i].z;
        double cost = 0;
        bool derivative_is_zero = false;
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
            const auto step = map.advance(z);
            cost += step.cost;
            derivative_is_zero |= step.derivative_is_zero;
            taken.through_contact += step.letter < 0;
            if (keeps && k < of_one.states.size()) {
                EXPECT_TRUE(same_bits(of_one.states[k], z)) << k;
                EXPECT_EQ(of_one.durations[k], step.duration);
                EXPECT_EQ(of_one.integrals[k], step.integral);
                EXPECT_EQ(of_one.letters[k], step.letter);
            }
            z = step.state;
        }
        EXPECT_TRUE(same_bits(lanes[i].z, z)) << i;
        EXPECT_EQ(lanes[i].excess + static_cast<double>(count), cost);
        EXPECT_EQ(lanes[i].derivative_is_zero, derivative_is_zero);
        taken.forgetful += derivative_is_zero;
    }
    return taken;
}

/// Steps of a chaotic hexagon at e = 1, which are all flights.
TEST(Together, OrdinaryFlightsAreTaken) {
    if (!has_lanes()) GTEST_SKIP() << "a build without lanes";
    const SceneMap<polygon_dimension> map(tests::scene_of(6, 0.3, 0.5, 0.5, 1));
    EXPECT_EQ(expect_taken(map, 0.5, 12, 60).through_contact, 0);
}

/// Steps of squares that land and slip, and of triangles that come to rest and go on.
TEST(Together, StepsThroughContactAreTaken) {
    if (!has_lanes()) GTEST_SKIP() << "a build without lanes";
    const SceneMap<polygon_dimension> strongly_swirled(tests::scene_of(4, 0.3, 0.98, 0.46, 0.02));
    EXPECT_GT(expect_taken(strongly_swirled, 0.98, 6, 60).through_contact, 40);
    const SceneMap<polygon_dimension> weakly_swirled(tests::scene_of(4, 0.5, 0.4, 0.3, 0.1));
    EXPECT_GT(expect_taken(weakly_swirled, 0.4, 6, 60).through_contact, 10);
    const SceneMap<polygon_dimension> triangles(tests::scene_of(3, 0.65, 1.5, 0.5, 0));
    EXPECT_EQ(expect_taken(triangles, 1.5, 6, 60).forgetful, 6);
}

/// An orbit alone, which keeps its steps, is not taken, and nothing of it is kept.
///   most_excess  of its steps, if it is another than theirs
template <class Map>
void expect_left(const Map& map, double beta, std::int64_t count, std::optional<double> most_excess = {}) {
    KeptVectors vectors;
    KeptSteps kept = vectors.as_steps();
    const OrbitBegin begin = begin_orbit(map, Start<double>(random_start(beta, paper_speed, 1, 0)));
    LaneOrbit<Map::dimension> lane = map.lane_orbit(begin.state, count);
    lane.kept = &kept;
    lane.most_excess = most_excess.value_or(lane.most_excess);
    map.follow_together(std::span(&lane, 1));
    EXPECT_FALSE(lane.taken);
    EXPECT_TRUE(vectors.states.empty() && vectors.durations.empty() && vectors.integrals.empty());
    EXPECT_TRUE(vectors.letters.empty());
    EXPECT_TRUE(same_bits(lane.z, begin.state));
}

/// A disk that comes to the wall for good after 27 impacts.
TEST(Together, StepsThatEndAreLeft) {
    expect_left(SceneMap<disk_dimension>(tests::scene_of(disk_sides, 0.3, 0.5, 0.3, 0.5)), 0.5, 500);
}

/// Triangles that rest at nearly every step: too many of these, more than they may cost, and where they may cost
/// nothing.
TEST(Together, DearStepsAreLeft) {
    const SceneMap<polygon_dimension> triangles(tests::scene_of(3, 0.65, 1.5, 0.5, 0));
    expect_left(triangles, 1.5, 5000);
    expect_left(triangles, 1.5, 60, 100);
    expect_left(triangles, 1.5, 60, -1);
}

}  // namespace
}  // namespace swirl::studies
