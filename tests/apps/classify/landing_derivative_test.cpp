// The derivative where a cycle lands on the wall and leaves it again: against the orbit's own neighbours.
#include "analysis/classification/tail.hpp"
#include "apps/system/orbit_ending.hpp"
#include "apps/system/section_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstdio>

namespace swirl::apps {
namespace {

/// Along one period from the impact after a release: all directions of F^k by differences and by the chain of
/// DF.
template <class System>
void compare(const System& system, const typename System::State& start, int period, double tolerance) {
    constexpr int dimension = System::dimension;
    constexpr double h = 1e-7;
    analysis::Matrix<dimension> product = analysis::Matrix<dimension>::Identity(), differences;
    auto z = start;
    for (int i = 0; i < period; ++i) {
        const auto step = system.linearise(z);
        product = (step.derivative * product).eval();
        z = step.state;
    }
    ASSERT_LT(analysis::distance(system, z, start), 1e-9);
    const auto image = [&](typename System::State from) {
        for (int i = 0; i < period; ++i) from = system.advance(from).state;
        return from;
    };
    for (int j = 0; j < dimension; ++j) {
        auto up = start, down = start;
        up[j] += h;
        down[j] -= h;
        differences.col(j) = analysis::difference(system, image(up), image(down)) / (2 * h);
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
        with_collision_map(scene, [&](const auto& map) {
            const SectionSystem system(map);
            SectionPoint<double> first{};
            long long impacts = 0;
            const Start<double> start = random_start(scene.beta, paper_speed, l.seed, 0);
            ending_of(map, start, 1, first, impacts);
            const auto tail = analysis::follow_tail(system, system.state_of(first), 5000, 2 * l.period);
            ASSERT_FALSE(tail.ended);
            // The impact that follows a release, from where a small step stays small against the flights to the next
            // landing.
            std::size_t after = 0;
            while (after < tail.states.size() && system.advance(tail.states[after]).letter >= 0) ++after;
            ASSERT_LT(after + 1, tail.states.size()) << "no landing";
            compare(system, tail.states[after + 1], l.period, 1e-4);
        });
    }
}

}  // namespace
}  // namespace swirl::apps
