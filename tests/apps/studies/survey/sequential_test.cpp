// No more evidence than a verdict needs, against all of it: the same verdicts, from the same orbits.
#include "apps/studies/modes/name_mode.hpp"
#include "tests/apps/studies/survey/random_scene.hpp"
#include "tests/sample_count.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace swirl::studies {
namespace {

struct Pair {
    Scene<double> scene;
    NamedMode few, all;

    bool is_equal() const {
        const auto &a = few.verdict, &b = all.verdict;
        return a.mode == b.mode && a.kind == b.kind && a.period == b.period && few.outcome == all.outcome;
    }
    std::string words() const {
        const auto say = [](const NamedMode& named) {
            const auto& v = named.verdict;
            return fmt::format("{} {} period {} S {:.12g} exponent {:.4g} after {} ({})", name_of(v.mode),
                               name_of(v.kind), v.period, v.mean, v.largest_exponent, named.impacts,
                               name_of(named.outcome));
        };
        return fmt::format("N = {} alpha {:.17g} beta {:.17g} mu {:.17g} e {:.17g} kappa {:.17g}: {}; all: {}",
                           scene.sides, scene.alpha, scene.beta, scene.mu, scene.restitution, scene.inertia_factor,
                           say(few), say(all));
    }
};

struct Comparison {
    long scenes = 0, different = 0;
    long long few = 0, all = 0;
};

/// Mean S of a cycle comes from the polished one in both; of a family from where the orbit came to; of all else from
/// the same impacts.
void check_mean(const Pair& p) {
    const double few = p.few.verdict.mean, all = p.all.verdict.mean;
    if (std::isnan(few) || std::isnan(all)) {
        EXPECT_EQ(std::isnan(few), std::isnan(all)) << p.words();
        return;
    }
    const double within = p.few.verdict.kind == analysis::Kind::family ? 1e-7 : p.few.verdict.period > 0 ? 1e-9 : 0;
    EXPECT_LE(std::abs(few - all), within * std::max(1.0, std::abs(all))) << p.words();
}

/// Also without restitution (landings), on disks, without loss (families, tori).
Comparison compare(long count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<Pair> pairs(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        pairs[i].scene = random_scene(random);
        if (i % 10 == 9) pairs[i].scene.restitution = 0;
        // What only loses is followed in ever longer contact, and in the same way by both.
        if (is_dissipative_without_drive(pairs[i].scene)) pairs[i].scene.mu = 0.5;
    }
    tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
        const LabStart<double> start = random_start(pairs[i].scene.beta, paper_speed, i + 1, 0);
        analysis::ClassifyOptions settings;
        pairs[i].few = name_mode(pairs[i].scene, start, settings);
        settings.exhaustive = true;
        pairs[i].all = name_mode(pairs[i].scene, start, settings);
    });
    Comparison found;
    for (const Pair& p : pairs) {
        ++found.scenes;
        found.few += p.few.impacts;
        found.all += p.all.impacts;
        if (!p.is_equal()) {
            ++found.different;
            std::printf("different: %s\n", p.words().c_str());
        } else {
            check_mean(p);
        }
    }
    std::printf("%ld scenes: %ld verdicts differ; %lld of %lld impacts\n", found.scenes, found.different, found.few,
                found.all);
    return found;
}

TEST(Sequential, VerdictsAreThoseOfAllImpacts) {
    const Comparison found = compare(tests::sample_count(16), 20261122);
    EXPECT_EQ(found.different, 0);
    EXPECT_LT(found.few, found.all);
}

/// At e = 1 friction may take the normal velocity of a vertex that it holds: impacts accumulate, from the 230th to the
/// 294th, and the states converge as if to a steady mode; then the orbit leaves, and is chaotic.
TEST(Sequential, ImpactsThatAccumulateWithoutLossAreNoSteadyMode) {
    const Scene<double> scene{4,
                              0.71931492973447608,
                              1.2080156001517186,
                              0.77965240952592096,
                              1,
                              Law::poisson,
                              uniform_inertia_factor<double>(4)};
    const LabStart<double> start = random_start(scene.beta, paper_speed, 1158, 0);
    const NamedMode few = name_mode(scene, start, {});
    EXPECT_EQ(few.verdict.kind, analysis::Kind::chaotic);
    EXPECT_EQ(few.impacts, 20'001);
}

TEST(SequentialNightly, VerdictsAreThoseOfAllImpactsInFourThousandScenes) {
    const Comparison found = compare(4000, 20261123);
    EXPECT_LE(found.different, found.scenes / 1000);
}

}  // namespace
}  // namespace swirl::studies
