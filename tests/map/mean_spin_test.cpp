// Without friction at e = 1, J = … + ½I(S − 1)²: an ergodic polygon turns with the swirl, time-mean S = 1 exactly.
#include "map/collision_map.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

namespace swirl {
namespace {

struct Mean {
    double value = 0, standard_error = 0, per_impact = 0;
};

/// Time mean of S, ∫S dt / T over all blocks, and its standard error from the blocks (a ratio's), which are long
/// against the memory of the orbit. (The mean of the blocks' own means would favour fast spins: their blocks are the
/// shortest.)
template <class Map>
Mean mean_spin(const Map& map, PostImpactState<double> post_impact, int blocks, long impacts) {
    std::vector<double> times, integrals;
    double per_impact = 0;
    for (int b = 0; b < blocks; ++b) {
        double time = 0, integral = 0;
        for (long k = 0; k < impacts; ++k) {
            const double spin = post_impact.spin;
            const auto step = map.advance(post_impact);
            if (step.outcome != FirstContactOutcome::contact) {
                ADD_FAILURE() << "outcome " << static_cast<int>(step.outcome);
                return {};
            }
            post_impact = step.after;
            time += step.flight_time;
            integral += spin * step.flight_time;
            per_impact += spin / static_cast<double>(impacts * blocks);
        }
        times.push_back(time);
        integrals.push_back(integral);
    }
    Mean mean;
    const double time = std::accumulate(times.begin(), times.end(), 0.0);
    mean.value = std::accumulate(integrals.begin(), integrals.end(), 0.0) / time;
    double square = 0;
    for (std::size_t b = 0; b < times.size(); ++b) square += std::pow(integrals[b] - mean.value * times[b], 2);
    mean.standard_error = std::sqrt(square * blocks / (blocks - 1.0)) / time;
    mean.per_impact = per_impact;
    return mean;
}

void check_mean(int sides, double alpha, double beta, const SectionPoint<double>& z) {
    const Scene<double> scene{sides, alpha, beta, 0, 1, Law::poisson, uniform_inertia_factor<double>(sides)};
    const CollisionMap<double, Shape::polygon, ImpactRule::frictionless> map(scene);
    constexpr long full = 20000;
    const long impacts = tests::sample_count(full);
    const Mean mean = mean_spin(map, post_impact_state(z), 100, impacts);
    std::printf("N %d: time-mean S = %.5f +- %.5f (mean per impact %.5f)\n", sides, mean.value, mean.standard_error,
                mean.per_impact);
    EXPECT_NEAR(mean.value, 1, 3 * mean.standard_error);
    // The standard error must be small enough for a meaningful test; it falls as (length)^(−1/2).
    EXPECT_LE(mean.standard_error, 0.05 * std::sqrt(static_cast<double>(full) / static_cast<double>(impacts)));
}

TEST(MeanSpin, OfAFrictionlessChaoticTriangleIsTheSwirls) {
    check_mean(3, 0.5, 0.5, {0.3, 0.1, -0.9, 0.4, 0.2});
}
TEST(MeanSpin, OfAFrictionlessChaoticSquareIsTheSwirls) {
    check_mean(4, 0.6, 0.8, {0.3, 0.1, -1.2, 0.4, -0.5});
}
TEST(MeanSpin, OfAFrictionlessChaoticHexagonIsTheSwirls) {
    check_mean(6, 0.5, 0.5, {0.3, 0.05, -1.1, 0.4, 0.2});
}

}  // namespace
}  // namespace swirl
