// The classification on scenes drawn at random, against what much longer orbits show, beside the paper's rule.
#include "apps/classify/classify_command.hpp"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cstdio>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace swirl::apps {
namespace {

using analysis::Mode;

Scene<double> random_scene(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    constexpr int sides[] = {disk_sides, 3, 4, 5, 6, 8, 12};
    Scene<double> scene;
    scene.sides = sides[random() % 7];
    scene.alpha = 0.1 + 0.8 * unit(random);
    scene.beta = 0.02 + 1.2 * unit(random);
    scene.mu = unit(random) < 0.2 ? 0 : 1.5 * unit(random);
    scene.restitution = unit(random) < 0.3 ? 1 : unit(random);
    scene.inertia_factor = uniform_inertia_factor<double>(scene.sides);
    return scene;
}

/// What the paper's rule says from RC alone (without the main diagonal): one value, few values, none.
Mode by_recurrence_rate(double rate) {
    if (rate < 1e-4) return Mode::chaotic;
    return rate > 0.99 ? Mode::steady : Mode::quasi_steady;
}

struct Case {
    Scene<double> scene;
    NamedMode found;
    Mode truth = Mode::undecided;
    bool in_contact = false;
};

/// The truth from an orbit ten times as long and a tail five times as long: a period found to 10⁻⁹, an exponent over 5
/// standard errors from zero, or a rotation number. What shows none of these stays undecided and is not counted.
void survey(int count, std::int64_t longer) {
    std::mt19937_64 random(20261121);
    std::vector<Case> cases(static_cast<std::size_t>(count));
    for (auto& c : cases) c.scene = random_scene(random);
    tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
        Case& c = cases[i];
        const LabStart<double> start = random_start(c.scene.beta, paper_speed, i + 1, 0);
        c.found = name_mode(c.scene, start, {});
        c.in_contact = c.found.outcome != Outcome::completed;
        if (c.in_contact) return;
        analysis::ClassifyOptions truth;
        truth.transient = 10 * longer;
        truth.collisions = 5 * longer;
        truth.period.max_period = 2048;
        c.truth = name_mode(c.scene, start, truth).verdict.mode;
    });
    std::map<std::pair<Mode, Mode>, int> ours, papers;
    std::map<std::string, int> contact;
    int decided = 0, undecided = 0, wrong = 0, paper_wrong = 0, unknown = 0, apart = 0;
    for (const auto& c : cases) {
        if (c.in_contact) {
            ++apart;
            ++contact[std::string(name_of(c.found.outcome)) + ", " + std::string(name_of(c.found.verdict.mode)) + " " +
                      std::string(name_of(c.found.verdict.kind))];
            continue;
        }
        const Mode mode = c.found.verdict.mode, paper = by_recurrence_rate(c.found.verdict.recurrence_rate_without_diagonal);
        ++ours[{c.truth, mode}];
        ++papers[{c.truth, paper}];
        undecided += mode == Mode::undecided;
        decided += mode != Mode::undecided;
        if (c.truth == Mode::undecided) {
            ++unknown;
            continue;
        }
        paper_wrong += paper != c.truth;
        if (mode == c.truth || mode == Mode::undecided) continue;
        ++wrong;
        std::printf("wrong: %s for %s: N = %d alpha %.17g beta %.17g mu %.17g e %.17g\n", std::string(name_of(mode)).c_str(),
                    std::string(name_of(c.truth)).c_str(), c.scene.sides, c.scene.alpha, c.scene.beta, c.scene.mu, c.scene.restitution);
    }
    const std::array<Mode, 4> modes = {Mode::steady, Mode::quasi_steady, Mode::chaotic, Mode::undecided};
    for (const auto* table : {&ours, &papers}) {
        std::printf("%s\n%-14s", table == &ours ? "this classification (rows: truth)" : "the paper's rule, RC alone (rows: truth)", "");
        for (const Mode m : modes) std::printf("%14s", std::string(name_of(m)).c_str());
        for (const Mode t : modes) {
            std::printf("\n%-14s", std::string(name_of(t)).c_str());
            for (const Mode m : modes) std::printf("%14d", table->count({t, m}) ? table->at({t, m}) : 0);
        }
        std::printf("\n");
    }
    for (const auto& [name, n] : contact) std::printf("%5d end as %s\n", n, name.c_str());
    std::printf("%d scenes: %d end early or in contact; of the rest %d undecided (%.1f %%), %d wrong, the paper's rule %d wrong; no truth for %d\n",
                count, apart, undecided, 100.0 * undecided / std::max(1, decided + undecided), wrong, paper_wrong, unknown);
    EXPECT_EQ(wrong, 0);
    EXPECT_LE(undecided, 0.03 * (decided + undecided));
}

TEST(ModeSurveyNightly, OfTwoThousandScenes) { survey(2000, 10'000); }

}  // namespace
}  // namespace swirl::apps
