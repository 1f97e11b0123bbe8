// A flight and an impact by an itinerary that is given, against the map's own, whose first contact is searched for.
#include "apps/studies/scene_map/itinerary_map.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace swirl::studies {
namespace {

const Scene<double> hexagon{6, 0.4, 0.5, 0.5, 0.9, Law::poisson, uniform_inertia_factor<double>(6)};
const Scene<double> disk{disk_sides, 0.4, 0.3, 0.2, 0.7, Law::poisson, 0.5};

/// The signs of what decides the mode say which it is.
void expect_margins_to_name(const ItineraryStep& itinerary) {
    using enum ContactMode;
    if (itinerary.mode == frictionless) return;
    if (itinerary.mode == sliding) {
        EXPECT_TRUE(!itinerary.stops || itinerary.slip.value > 0);
        return;
    }
    EXPECT_TRUE(itinerary.stops);
    EXPECT_LT(itinerary.slip.value, 0);
    const bool early = itinerary.mode == c_sticking || itinerary.mode == c_reversed;
    EXPECT_EQ(itinerary.late.value < 0, early);
    EXPECT_EQ(itinerary.held.value <= 0, itinerary.mode == c_sticking || itinerary.mode == r_sticking);
}

/// With the time eliminated, dτ = −dg/g′, its derivatives are DF and ∂F/∂p; without, they are what moves at a fixed
/// time.
void compare_with_map(const Scene<double>& scene, Eigen::VectorXd z, Parameter first, Parameter second) {
    const analysis::PlaneMap plane = plane_map_of(scene, first, second);
    const ItineraryMap words = itinerary_map_of(scene, first, second);
    Scene<double> copy = scene;
    const Eigen::Vector2d p(number_of(copy, first), number_of(copy, second));
    const Eigen::Index d = z.size();
    for (int impact = 0; impact < 20; ++impact) {
        const analysis::ShootingStep step = plane.step(z, p);
        ASSERT_TRUE(step.alive) << impact;
        const Letter letter = letter_from(step.letter);
        ASSERT_FALSE(letter.through_contact);
        const ItineraryStep itinerary = words.step(z, step.duration, p, letter.vertex_step);
        EXPECT_LT(std::abs(itinerary.touch.gap), 1e-13);  // rounding of a position of size 1, squared
        EXPECT_GT(itinerary.touch.rate, 0);
        EXPECT_EQ(itinerary.mode, letter.mode);
        expect_margins_to_name(itinerary);
        for (Eigen::Index i = 0; i < d; ++i)
            EXPECT_NEAR(itinerary.after[i], step.state[i], 1e-12 * (1 + std::abs(step.state[i])));
        Eigen::MatrixXd by(d, d + 2);
        const Eigen::VectorXd by_time = itinerary.after_by.col(d) / itinerary.touch.gap_by[d];
        by << itinerary.after_by.leftCols(d) - by_time * itinerary.touch.gap_by.head(d),
            itinerary.after_by.rightCols(2) - by_time * itinerary.touch.gap_by.tail(2);
        const double size = step.by_state.cwiseAbs().maxCoeff();
        EXPECT_LT((by.leftCols(d) - step.by_state).cwiseAbs().maxCoeff(), 1e-11 * size) << impact;
        EXPECT_LT((by.rightCols(2) - step.by_parameter).cwiseAbs().maxCoeff(), 1e-11 * (size + 1)) << impact;
        z = step.state;
    }
}

Eigen::VectorXd point(std::initializer_list<double> coordinates) {
    Eigen::VectorXd z(static_cast<Eigen::Index>(coordinates.size()));
    Eigen::Index i = 0;
    for (const double c : coordinates) z[i++] = c;
    return z;
}

TEST(ItineraryMap, IsTheMapWhereItsTimesAreThoseOfContacts) {
    const Eigen::VectorXd z = point({-0.0829, 0.05, -0.5552, 0.8908, -0.9});
    compare_with_map(hexagon, z, Parameter::alpha, Parameter::beta);
    compare_with_map(hexagon, z, Parameter::mu, Parameter::restitution);
    compare_with_map(hexagon, z, Parameter::inertia_factor, Parameter::beta);
}

TEST(ItineraryMap, OfADisk) {
    Scene<double> bouncing = disk;
    bouncing.restitution = 1;  // below 1 its impacts die out
    compare_with_map(bouncing, point({0.3, -0.5, 0.4, -0.2}), Parameter::alpha, Parameter::beta);
}

// g′ is dg/dt, and its derivatives those of g by the time and another unknown, in either order.
TEST(ItineraryMap, RateIsTheGapsDerivative) {
    const ItineraryMap words = itinerary_map_of(hexagon, Parameter::alpha, Parameter::beta);
    const Eigen::VectorXd z = point({-0.0829, 0.05, -0.5552, 0.8908, -0.9});
    const Eigen::Vector2d p(0.4, 0.5);
    constexpr double h = 1e-6;
    for (int vertex = 0; vertex < 6; ++vertex) {
        for (const double time : {0.3, 0.9}) {
            const ItineraryTouchRows at = words.touch(z, time, p, vertex);
            const ItineraryTouchRows above = words.touch(z, time + h, p, vertex),
                                     below = words.touch(z, time - h, p, vertex);
            EXPECT_NEAR(at.gap_by[5], at.rate, 1e-14 * (1 + std::abs(at.rate)));
            EXPECT_NEAR(at.rate, (above.gap - below.gap) / (2 * h), 1e-9);  // rounding/h, h² times g‴
            for (Eigen::Index i = 0; i < at.rate_by.size(); ++i)
                EXPECT_NEAR(at.rate_by[i], (above.gap_by[i] - below.gap_by[i]) / (2 * h), 1e-8) << vertex << ' ' << i;
        }
    }
}

}  // namespace
}  // namespace swirl::studies
