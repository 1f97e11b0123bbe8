// What `chord_mode.hpp` asks of an orbit that is called one on a chord, against whether the orbit stays on it.
#include "apps/studies/modes/chord_mode.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"
#include "map/chords/chord_fate.hpp"
#include "tests/apps/studies/survey/long_run.hpp"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <random>
#include <vector>

namespace swirl::studies {
namespace {

constexpr int looks = 40;
constexpr std::int64_t between_looks = 500, followed_on = 200'000, averaged = 10'000;
constexpr std::array<int, 5> watched = {4, 16, 64, 256, 1024};
constexpr std::array<double, 6> factors = {1.25, 1.5, 2, 3, 5, 10};
constexpr std::array<double, 4> bends = {0.05, 0.1, 0.25, 0.5};

/// An orbit is looked at: it is near a chord that attracts and leads somewhere.
struct Look {
    std::int64_t at = 0;
    double forced = 0;
    std::array<double, watched.size()> excess{};
    bool stays = false;  ///< goes on by the same vertices, sticking, for 200,000 impacts and more
};

struct Looked {
    std::vector<Look> looks;
    double impacts_ratio = 0;  ///< impacts that theory asks for a gain in speed, over those that it took; 0: none
    double forced = 0;         ///< at the last look
};

std::optional<Look> look(const SceneMap<polygon_dimension>& map, const Scene<double>& scene,
                         const PostImpactState<double>& z, std::int64_t at) {
    const ContainerState now = in_container(scene, z);
    const auto chord = chord_near(scene, now);
    if (!chord || is_neutral(*chord)) return {};
    const ChordSpeeds speeds = chord_speeds(scene, *chord);
    const bool led = speeds.fate == ChordFate::accelerates || speeds.fate == ChordFate::limit;
    const ForcedBend forced = forced_bend(scene, *chord, now.speed);
    if (!led || now.speed <= speeds.fed_from || !(forced.largest() < 1)) return {};
    Look found{at, forced.largest()};
    for (std::size_t i = 0; i < watched.size(); ++i)
        found.excess[i] = excess_over(map, scene, *chord, forced, z, watched[i]);
    return found;
}

double speed_at(const Scene<double>& scene, const Chord& chord, double energy) {
    return std::sqrt(2 * energy / (1 + scene.inertia_factor * std::pow(std::sin(chord.angle), 2)));
}

void compare_gain(const SceneMap<polygon_dimension>& map, const Scene<double>& scene, PostImpactState<double> z,
                  Looked& looked) {
    const auto chord = chord_near(scene, in_container(scene, z));
    if (!chord) return;
    const auto mean_energy = [&] {
        double sum = 0;
        for (std::int64_t n = 0; n < averaged; ++n) {
            sum += energy_in_container(scene, z);
            z = map.advance(z).state;
        }
        return sum / averaged;
    };
    const double from = speed_at(scene, *chord, mean_energy());
    analysis::StepBudget budget;
    const std::int64_t between = followed_on / 2;
    map.follow(z, between - averaged, {}, budget);
    const double to = speed_at(scene, *chord, mean_energy());
    if (std::abs(to / from - 1) < 0.01) return;  // too little gain to be compared
    looked.impacts_ratio = impacts_between(scene, *chord, from, to) / static_cast<double>(between);
}

Looked look_at(const Scene<double>& scene, std::uint64_t seed) {
    Looked looked;
    const SceneMap<polygon_dimension> map(scene);
    const auto begin = begin_orbit(map, random_start(scene.beta, paper_speed, seed, 0));
    if (begin.outcome != Outcome::completed) return looked;
    auto z = begin.state;
    for (int i = 0; i < looks; ++i) {
        analysis::StepBudget budget;
        if (map.follow(z, between_looks, {}, budget) < between_looks) return {};
        if (const auto found = look(map, scene, z, (i + 1) * between_looks)) looked.looks.push_back(*found);
    }
    if (looked.looks.empty()) return looked;
    const auto last = z;
    // The itinerary's last break of all impacts, from the first on.
    z = begin.state;
    std::int64_t broken = 0, before = -1;
    for (std::int64_t n = 1; n <= looks * between_looks + followed_on; ++n) {
        const auto step = map.advance(z);
        if (!step.alive) broken = n;
        if (!step.alive) break;
        const Letter letter = letter_from(step.letter);
        if (letter.through_contact || !ends_in_stick(letter.mode) || letter.vertex_step != before) broken = n;
        before = letter.vertex_step;
        z = step.state;
    }
    for (Look& found : looked.looks) found.stays = found.at >= broken;
    looked.forced = looked.looks.back().forced;
    const bool on_it = looked.looks.back().stays && looked.looks.back().excess.back() <= chord_excess;
    if (on_it) compare_gain(map, scene, last, looked);
    return looked;
}

Scene<double> elastic_scene(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    constexpr int sides[] = {3, 4, 5, 6, 8, 12};
    Scene<double> scene;
    scene.sides = sides[random() % 6];
    scene.alpha = 0.1 + 0.8 * unit(random);
    scene.beta = 0.02 * std::pow(50, unit(random));
    scene.mu = 0.02 * std::pow(75, unit(random));
    scene.restitution = 1;
    scene.inertia_factor = uniform_inertia_factor<double>(scene.sides);
    return scene;
}

struct Counts {
    int mistaken = 0;  ///< called so, and left
    int missed = 0;    ///< not called so, and stayed
};

Counts count(const std::vector<Look>& all, std::size_t impacts, double factor, double bent) {
    Counts counts;
    for (const Look& l : all) {
        const bool called = l.forced < bent && l.excess[impacts] <= factor;
        counts.mistaken += called && !l.stays;
        counts.missed += !called && l.stays;
    }
    return counts;
}

std::vector<Looked> looked_at(int scenes) {
    std::mt19937_64 random(20261127);
    std::vector<Scene<double>> drawn;
    for (int i = 0; i < scenes; ++i) drawn.push_back(elastic_scene(random));
    std::vector<Looked> all(drawn.size());
    tbb::parallel_for(std::size_t{0}, drawn.size(), [&](std::size_t i) { all[i] = look_at(drawn[i], i + 1); });
    return all;
}

void print_tables(const std::vector<Look>& all) {
    const auto stay = std::count_if(all.begin(), all.end(), [](const Look& l) { return l.stays; });
    std::printf("%zu looks near a chord that attracts, %td of them stay\n", all.size(), stay);
    std::printf("mistaken/missed, forced bend < %g; impacts watched:", most_bent);
    for (const int impacts : watched) std::printf("%13d", impacts);
    for (const double factor : factors) {
        std::printf("\n%40s %9.3g", "within", factor);
        for (std::size_t i = 0; i < watched.size(); ++i) {
            const Counts c = count(all, i, factor, most_bent);
            std::printf("  %5d/%5d", c.mistaken, c.missed);
        }
    }
    std::printf("\n");
    for (const double bent : bends) {
        const auto at = std::find(watched.begin(), watched.end(), chord_impacts) - watched.begin();
        const Counts c = count(all, static_cast<std::size_t>(at), chord_excess, bent);
        std::printf("forced bend < %-5g: %d/%d\n", bent, c.mistaken, c.missed);
    }
}

/// Impacts that theory asks for a gain, over those that it took, by the bend that the swirl forces.
void check_gains(const std::vector<Looked>& all) {
    double below = 0, median_of_most = 0;
    for (const double bent : bends) {
        std::vector<double> ratios;
        for (const Looked& l : all)
            if (l.impacts_ratio != 0 && l.forced >= below && l.forced < bent) ratios.push_back(l.impacts_ratio);
        std::sort(ratios.begin(), ratios.end());
        if (!ratios.empty())
            std::printf("forced bend %.2f to %.2f: impacts predicted over taken %.3f to %.3f, median %.3f, of %zu\n",
                        below, bent, ratios.front(), ratios.back(), ratios[ratios.size() / 2], ratios.size());
        if (below == 0 && !ratios.empty()) median_of_most = ratios[ratios.size() / 2];
        below = bent;
    }
    EXPECT_NEAR(median_of_most, 1, 0.02);
}

TEST(ChordThresholdsNightly, WhatStaysIsToldFromWhatLeaves) {
    const std::vector<Looked> scenes = looked_at(1000);
    std::vector<Look> all;
    for (const Looked& l : scenes) all.insert(all.end(), l.looks.begin(), l.looks.end());
    print_tables(all);
    check_gains(scenes);
    const auto at = std::find(watched.begin(), watched.end(), chord_impacts) - watched.begin();
    ASSERT_LT(static_cast<std::size_t>(at), watched.size());
    const Counts c = count(all, static_cast<std::size_t>(at), chord_excess, most_bent);
    EXPECT_EQ(c.mistaken, 0);
}

}  // namespace
}  // namespace swirl::studies
