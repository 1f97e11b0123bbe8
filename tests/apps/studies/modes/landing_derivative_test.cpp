// The derivative where a cycle lands on the wall and leaves it again: against the orbit's own neighbours.
#include "analysis/classification/tail.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace swirl::studies {
namespace {

/// Along one period from the impact after a release: all directions of F^k by differences and by the chain of
/// DF.
template <int dimension>
void compare(const SceneMap<dimension>& map, const analysis::Vector<dimension>& start, int period, double tolerance) {
    constexpr double h = 1e-7;
    analysis::Matrix<dimension> product = analysis::Matrix<dimension>::Identity(), differences;
    auto z = map.state_at(start);
    for (int i = 0; i < period; ++i) {
        const auto step = map.linearise(z);
        product = (step.derivative * product).eval();
        z = step.state;
    }
    ASSERT_LT(analysis::distance(map, map.coordinates(z), start), 1e-9);
    const auto image = [&](const analysis::Vector<dimension>& from) {
        auto state = map.state_at(from);
        analysis::follow(map, state, period);
        return map.coordinates(state);
    };
    for (int j = 0; j < dimension; ++j) {
        auto up = start, down = start;
        up[j] += h;
        down[j] -= h;
        differences.col(j) = analysis::difference(map, image(up), image(down)) / (2 * h);
    }
    const double error = (product - differences).cwiseAbs().maxCoeff();
    std::printf("period %d: largest entry %.3g, error %.1e\n", period, product.cwiseAbs().maxCoeff(), error);
    EXPECT_LT(error, tolerance);
}

struct Landing {
    int sides;
    double alpha, beta, mu, restitution;
    std::uint64_t seed;
    int period;
};

TEST(LandingDerivative, IsThatOfTheOrbitsNeighbours) {
    const Landing landings[] = {
        {4, 0.66622562865356649, 0.92373515718371002, 1.0045737103341972, 0.025209295816361485, 1310, 5},
        {4, 0.30471557935466553, 0.98210557381738317, 0.46022909509736248, 0.021792063821477175, 1440, 5}};
    for (const auto& l : landings) {
        Scene<double> scene{l.sides, l.alpha, l.beta, l.mu, l.restitution};
        scene.inertia_factor = uniform_inertia_factor<double>(l.sides);
        with_scene_map(scene, [&](const auto& map) {
            const auto begin = begin_orbit(map, random_start(scene.beta, paper_speed, l.seed, 0));
            const auto tail = analysis::follow_tail(map, begin.state, 5000, 2 * l.period);
            ASSERT_FALSE(tail.ended);
            // The impact that follows a release, from where a small step stays small against the flights to the next
            // landing.
            std::size_t after = 0;
            const auto lands = [&](const auto& point) { return map.advance(map.state_at(point)).letter < 0; };
            while (after < tail.points.size() && !lands(tail.points[after])) ++after;
            ASSERT_LT(after + 1, tail.points.size()) << "no landing";
            compare(map, tail.points[after + 1], l.period, 1e-4);
        });
    }
}

}  // namespace
}  // namespace swirl::studies
