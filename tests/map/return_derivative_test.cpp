// DF through sustained contact: its differences in closed form, and the whole against the return map itself.
#include "map/orbit/return_derivative.hpp"
#include "tests/map/contact_scenes.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <optional>

namespace swirl {
namespace {

using tests::Random;
using State = PostImpactState<double>;

/// A curve through the section's point z = (0.3, 0.2, −1, 0.5, 2) whose coordinates are of degree two in s.
State on_curve(double s) {
    return post_impact_state(
        SectionPoint<double>{0.3 + s + 3 * s * s, 0.2 - 2 * s, -1 + s * s, 0.5 + 4 * s - s * s, 2 - s});
}

const Eigen::Matrix<double, 5, 1> slope_of_curve{1, -2, 0, 4, -1};

/// The column where `end` knows the curve from `low` to `high` alone.
auto column_between(double low, double high) {
    const auto end = [&](double s) { return s >= low && s <= high ? std::optional<State>(on_curve(s)) : std::nullopt; };
    return detail::column_of<Shape::polygon>(on_curve(0), end, 1e-3);
}

TEST(ReturnDerivative, DifferencesOnOneSideAreOfSecondOrderToo) {
    // Exact for degree two but for rounding, ε/h.
    EXPECT_LT((column_between(-1, 1) - slope_of_curve).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_LT((column_between(0, 1) - slope_of_curve).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_LT((column_between(-1, 0) - slope_of_curve).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_EQ(column_between(0, 0).norm(), 0);
    // From one neighbour alone: the second derivative times h/2.
    const Eigen::Matrix<double, 5, 1> half_bend{3, 0, 1, -1, 0};
    EXPECT_LT((column_between(0, 1.5e-3) - slope_of_curve - 1e-3 * half_bend).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_LT((column_between(-1.5e-3, 0) - slope_of_curve + 1e-3 * half_bend).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(ReturnDerivative, AnglesAreSubtractedTheShortWayRound) {
    const State a = post_impact_state(SectionPoint<double>{3.1, -3.1, 1, 2, 3});
    const State b = post_impact_state(SectionPoint<double>{-3.1, 3.1, 0, 5, 7});
    const double apart = 2 * pi<double>() - 6.2;
    const auto polygon = detail::section_difference<Shape::polygon>(a, b);
    EXPECT_NEAR(polygon[0], -apart, 1e-14);
    EXPECT_NEAR(polygon[1], apart, 1e-14);
    EXPECT_EQ(polygon[2], 1);
    EXPECT_EQ(polygon[4], -4);
    const auto disk = detail::section_difference<Shape::disk>(a, b);
    EXPECT_NEAR(disk[0], -apart, 1e-14);
    EXPECT_EQ(disk[1], 1);
    EXPECT_EQ(disk[3], -4);
}

TEST(ReturnDerivative, SingularValuesWithinRoundingAreRemoved) {
    Eigen::MatrixXd kept(2, 2), removed(2, 2);
    kept << 3, 0, 0, 1e-7;
    removed << 3, 0, 0, 1e-9;
    EXPECT_LT((detail::without_rounding(kept) - kept).norm(), 1e-15);
    EXPECT_EQ(detail::without_rounding(removed)(1, 1), 0);
    EXPECT_NEAR(detail::without_rounding(removed)(0, 0), 3, 1e-15);
}

/// DF · d along curves in the section on which u_n stays 0, where every state lands at once (e = 0), against central
/// differences of the return map. Neighbours that leave or land otherwise are left out.
template <class Map>
void compare_along_landings(int sides, double mu, std::uint64_t seed) {
    constexpr Shape shape = Map::shape;
    constexpr int dimension = section_dimension<shape>;
    constexpr double h = 1e-4;
    Random random(seed);
    int compared = 0;
    double worst = 0;
    for (int i = 0; i < 400 && compared < 60; ++i) {
        Scene<double> scene = tests::random_scene(random, sides, mu, 0, Law::poisson);
        const Map map(scene);
        const ReturnMap<Map> return_map(map);
        SectionPoint<double> z = tests::random_point(random, scene, 0);
        if (return_map.advance(post_impact_state(z)).contacts.empty()) continue;
        const ReturnStep<double> known = return_map.advance(post_impact_state(z));
        if (known.outcome != Outcome::completed || known.collision.simultaneous) continue;
        long series = 0;
        const auto derivative = derivative_through_contact(return_map, z, known, &series);
        EXPECT_GT(series, 0);
        if (!derivative.allFinite() || derivative.cwiseAbs().maxCoeff() > 30) continue;  // h is no small step there
        for (int j = 0; j < dimension; ++j) {
            if (j == dimension - 3) continue;  // v_n follows
            const auto near = [&](double step) {
                auto c = coordinates<shape>(z);
                c[static_cast<std::size_t>(j)] += step;
                SectionPoint<double> point = section_point<shape>(c);
                point.vn -= contact_kinematics(map.body(), post_impact_state(point)).un;
                return point;
            };
            const SectionPoint<double> above = near(h), below = near(-h);
            const ReturnStep<double> up = return_map.advance(post_impact_state(above));
            const ReturnStep<double> down = return_map.advance(post_impact_state(below));
            if (!detail::same_way(up, known) || !detail::same_way(down, known)) continue;
            const auto moved = detail::section_difference<shape>(post_impact_state(above), post_impact_state(below));
            const auto change = detail::section_difference<shape>(up.collision.after, down.collision.after);
            const double error = (derivative * moved - change).cwiseAbs().maxCoeff() / (2 * h);
            worst = std::max(worst, error);
            // h² = 10⁻⁸ times third derivatives, which near grazing are of the order of DF³; a wrong term is of order
            // 0.1
            EXPECT_LT(error, 1e-2) << "N = " << sides << ", coordinate " << j;
            ++compared;
        }
    }
    std::printf("N = %d: %d directions, largest difference %.2e\n", sides, compared, worst);
    EXPECT_GE(compared, 20);
}

TEST(ReturnDerivative, IsTheReturnMapsAlongStatesThatLandAtOnce) {
    compare_along_landings<CollisionMap<double, Shape::disk, ImpactRule::poisson>>(disk_sides, 0.3, 1);
    compare_along_landings<CollisionMap<double, Shape::disk, ImpactRule::frictionless>>(disk_sides, 0, 2);
    compare_along_landings<CollisionMap<double, Shape::polygon, ImpactRule::poisson>>(6, 0.3, 3);
    compare_along_landings<CollisionMap<double, Shape::polygon, ImpactRule::frictionless>>(4, 0, 4);
}

}  // namespace
}  // namespace swirl
