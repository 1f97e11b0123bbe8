// Places on the wall of a dish whose motion is known.
#include "apps/studies/fits/dish_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace swirl::studies {
namespace {

constexpr double pi_ = 3.141592653589793;

Eigen::Vector2d direction(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

/// Kinks at which a vertex is on the wall, in a dish that moves as `dish`.
std::vector<analysis::Kink> kinks_on(const FilmedScene& scene, const DishMotion& dish, std::size_t count,
                                     double noise) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> even(0, 1);
    std::normal_distribution<double> normal(0, 1);
    const double most = scene.sides == 0 ? 0 : pi_ / scene.sides - std::asin(scene.alpha * std::sin(pi_ / scene.sides));
    std::vector<analysis::Kink> kinks;
    double time = 3;
    for (std::size_t i = 0; i < count; ++i) {
        time += 0.2 + 2 * even(random);
        const double outwards = 2 * pi_ * even(random), beside = 0.9 * most * (2 * even(random) - 1);
        analysis::Kink kink;
        kink.time = time;
        const Eigen::Vector2d place =
            dish.centre(scene, time) + direction(outwards) - scene.alpha * direction(outwards + beside);
        const double turns = scene.sides == 0 ? 0 : 2 * pi_ * std::floor(scene.sides * even(random)) / scene.sides;
        kink.place << place[0] + noise * normal(random), place[1] + noise * normal(random),
            outwards + beside - dish.mark + turns;
        // An impulse across the wall and along it, and the spin that it gives.
        const Eigen::Vector2d to_wall = direction(outwards), offset = scene.alpha * direction(outwards + beside);
        const Eigen::Vector2d impulse = -1.2 * to_wall + 0.3 * Eigen::Vector2d(-to_wall[1], to_wall[0]);
        kink.change << impulse[0], impulse[1], (offset[0] * impulse[1] - offset[1] * impulse[0]) / scene.inertia;
        kink.drift.setZero();
        kink.error = 0;
        kink.share = kink.change_share = 1;
        kinks.push_back(kink);
    }
    return kinks;
}

DishMotion known_dish() {
    DishMotion dish;
    dish.origin = {0.03, -0.05};
    dish.phase = 2.1;
    dish.rate = 1.002;
    dish.mark = 0.2;
    return dish;
}

TEST(DishMotion, TheContactIsTheVertexThatReachesFarthestOfAll) {
    const FilmedScene scene{5, 0.5, 0.4, 0.1, {}};
    const DishMotion dish = known_dish();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> even(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d place(even(random), even(random), 10 * even(random));
        const double time = 20 * even(random);
        std::vector<double> gaps;
        for (int j = 0; j < 5; ++j)
            gaps.push_back(
                (place.head<2>() + 0.5 * direction(place[2] + 0.2 + 2 * pi_ * j / 5) - dish.centre(scene, time))
                    .norm() -
                1);
        std::sort(gaps.begin(), gaps.end());
        const Contact contact = contact_at(scene, dish, time, place);
        EXPECT_NEAR(contact.gap, gaps[4], 1e-12);
        EXPECT_NEAR(contact.next_gap, gaps[3], 1e-12);
        EXPECT_NEAR((place.head<2>() + contact.offset - dish.centre(scene, time)).normalized().dot(contact.normal), 1,
                    1e-12);
    }
}

TEST(DishMotion, TheWallsVelocityIsTheRateOfItsPlace) {
    const FilmedScene scene{5, 0.5, 0.4, 0.1, {}};
    const DishMotion dish = known_dish();
    const double h = 1e-5;  // of central differences: h² of third derivatives, and rounding over h
    const Eigen::Vector2d rate = (dish.centre(scene, 3 + h) - dish.centre(scene, 3 - h)) / (2 * h);
    EXPECT_LT((rate - contact_at(scene, dish, 3, Eigen::Vector3d::Ones()).wall).norm(), 1e-9);
}

TEST(DishMotion, PhaseRateOriginAndMarkAreFoundFromTheImpacts) {
    for (const int sides : {0, 3, 6}) {
        const FilmedScene scene{sides, 0.4, 0.5, 0.1, {}};
        DishMotion truth = known_dish();
        if (sides == 0) truth.mark = 0;
        const auto found = fit_dish(kinks_on(scene, truth, 400, 0), {1e-6, 1e-6}, scene, Eigen::Vector2d::Zero());
        ASSERT_TRUE(found);
        EXPECT_LT((found->origin - truth.origin).norm(), 1e-6) << sides;
        EXPECT_NEAR(found->rate, truth.rate, 1e-8) << sides;
        EXPECT_NEAR(found->phase, truth.phase, 1e-6) << sides;
        EXPECT_NEAR(found->mark, truth.mark, 1e-6) << sides;
        EXPECT_LT(found->off_wall, 1e-6) << sides;
    }
}

TEST(DishMotion, NoiseIsWhatIsLeft) {
    const FilmedScene scene{4, 0.4, 0.5, 0.1, {}};
    const auto found = fit_dish(kinks_on(scene, known_dish(), 400, 0.01), {0.01, 0.01}, scene, Eigen::Vector2d::Zero());
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->off_wall, 0.01, 0.0015);  // a robust scale of 400
    EXPECT_NEAR(found->phase, known_dish().phase, 0.01);
}

TEST(DishMotion, TheSizeWithWhichImpactsLieOnTheWallIsFound) {
    for (const int sides : {0, 4})
        for (const double given : {0.4, 0.37}) {
            const FilmedScene truth{sides, 0.4, 0.5, 0.08, {}}, scene{sides, given, 0.5, 0.5 * given * given, {}};
            DishMotion dish = known_dish();
            if (sides == 0) dish.mark = 0;
            const auto kinks = kinks_on(truth, dish, 400, 0.003);
            const auto near = fit_dish(kinks, {0.003, 0.003}, scene, Eigen::Vector2d::Zero());
            ASSERT_TRUE(near);
            const auto found = size_on_wall(kinks, {0.003, 0.003}, scene, *near);
            ASSERT_TRUE(found) << sides << " " << given;
            EXPECT_NEAR(found->alpha, 0.4, 4 * found->error) << sides << " " << given;
            EXPECT_LT(found->error, 0.001);
        }
}

TEST(DishMotion, AScaleThatIsWrongIsTold) {
    const FilmedScene scene{6, 0.4, 0.5, 0.1, {}}, wrong{6, 0.4, 0.1, 0.1, {}};
    const auto found =
        fit_dish(kinks_on(scene, known_dish(), 400, 0.001), {0.001, 0.001}, wrong, Eigen::Vector2d::Zero());
    ASSERT_TRUE(found);
    EXPECT_GT(found->off_wall, 0.1);
    EXPECT_FALSE(fit_dish(std::vector<analysis::Kink>(5), {0.001, 0.001}, scene, Eigen::Vector2d::Zero()));
}

}  // namespace
}  // namespace swirl::studies
