// As e → 1 the statistics of orbits without chattering tend to those at e = 1.
#include "analysis/recurrence/rates.hpp"
#include "map/orbit/orbit.hpp"
#include "tests/map/contact_scenes.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace swirl {
namespace {

constexpr std::size_t kinds = 6;
constexpr std::array<const char*, kinds> names{"mean S",        "rms of vn", "mean flight time",
                                               "mean of |chi|", "RC(1e-2)",  "RC(1e-6)"};
using Means = std::array<double, kinds>;

struct Statistics {
    Means mean{}, error{};  ///< over independent orbits, with the standard error of their mean
    long contacts = 0;
};

Means statistics_of(const Scene<double>& scene, tests::Random& random, long impacts, long& contacts) {
    return with_collision_map(scene, [&](const auto& map) {
        const double angle = random.angle();
        Orbit orbit(map, LabStart<double>{scene.beta, 0, std::cos(angle) / 7, std::sin(angle) / 7, random.angle(), 0});
        double turned = 0, time = 0, square = 0, chi = 0;
        const long transient = impacts / 10;
        std::vector<double> spins;
        for (long i = 0; i < transient + impacts; ++i) {
            if (!orbit.advance()) {
                ADD_FAILURE() << name_of(orbit.outcome()) << " after " << i << " impacts";
                return Means{};
            }
            contacts += static_cast<long>(orbit.contacts().size());
            if (i < transient) continue;
            spins.push_back(orbit.post_impact().spin);
            turned += orbit.return_step().turned;
            time += orbit.collision().flight_time;
            square += orbit.post_impact().vn * orbit.post_impact().vn;
            chi += std::abs(std::atan2(orbit.post_impact().chi.y, orbit.post_impact().chi.x));
        }
        const double n = static_cast<double>(impacts);
        // Of S just after impacts, at Sun 2019's threshold and a wide one, without the diagonal, which adds 1/n for
        // every orbit.
        const auto rates =
            analysis::recurrence::recurrence_rates(analysis::recurrence::embed_series(spins), std::array{1e-2, 1e-6});
        return Means{turned / time, std::sqrt(square / n),       time / n,
                     chi / n,       rates[0].without_diagonal(), rates[1].without_diagonal()};
    });
}

Statistics statistics_at(double e, int orbits, long impacts) {
    tests::Random random(99);
    Statistics s;
    Means squares{};
    for (int i = 0; i < orbits; ++i) {
        const Means m =
            statistics_of(tests::uniform_scene(3, 0.5, 0.5, 0.2, e, Law::stronge), random, impacts, s.contacts);
        for (std::size_t k = 0; k < kinds; ++k) {
            s.mean[k] += m[k] / orbits;
            squares[k] += m[k] * m[k] / orbits;
        }
    }
    for (std::size_t k = 0; k < kinds; ++k) s.error[k] = std::sqrt((squares[k] - s.mean[k] * s.mean[k]) / (orbits - 1));
    return s;
}

/// A triangle that turns with the swirl: friction and the container's motion balance, and e = 0.99 does not chatter
/// either (e = 0.9 does).
TEST(ElasticLimit, IsJoinedContinuouslyByTheStatistics) {
    const int orbits = 24;
    const long impacts = tests::sample_count(40'000);
    constexpr double widest = 1e-2;
    const Statistics elastic = statistics_at(1, orbits, impacts), far = statistics_at(1 - widest, orbits, impacts);
    for (const double loss : {widest, 1e-3, 1e-4, 1e-5, 1e-6, 0.0}) {
        const Statistics s = loss == widest ? far : loss > 0 ? statistics_at(1 - loss, orbits, impacts) : elastic;
        EXPECT_EQ(s.contacts, 0);
        std::printf("1 - e = %g:", loss);
        for (std::size_t k = 0; k < kinds; ++k) {
            std::printf("  %s %.5g (%.2g)", names[k], s.mean[k], s.error[k]);
            if (loss == 0 || loss == widest) continue;  // the two that the line is drawn through
            // Four standard errors, and what is linear in 1 - e.
            const double slope = std::abs(far.mean[k] - elastic.mean[k]) / widest;
            const double allowed = 4 * std::hypot(s.error[k], elastic.error[k]) + slope * loss;
            EXPECT_LE(std::abs(s.mean[k] - elastic.mean[k]), allowed) << names[k] << " at 1 - e = " << loss;
        }
        std::printf("\n");
    }
    // The limit is the same branch: at 0.99 speeds and times differ by at most a few per cent and four standard errors
    // (the larger part in a sanitizer's build, whose sample is shorter).
    for (const std::size_t k : {0, 1, 2})
        EXPECT_NEAR(far.mean[k], elastic.mean[k],
                    0.05 * std::abs(elastic.mean[k]) + 4 * std::hypot(far.error[k], elastic.error[k]))
            << names[k];
}

}  // namespace
}  // namespace swirl
