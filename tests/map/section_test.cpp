// Section coordinates both ways, and the laboratory's frame along an orbit.
#include "map/derivative/saltation.hpp"
#include "map/orbit/laboratory.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <type_traits>

namespace swirl {
namespace {

using tests::Random;

TEST(Section, PointsGoToPostImpactStatesAndBack) {
    Random random(41);
    for (long i = 0; i < tests::sample_count(100'000); ++i) {
        const SectionPoint<double> z{random.angle(), random.angle(), random.between(-3, 3), random.between(-3, 3),
                                     random.between(-9, 9)};
        const SectionPoint<double> back = section_point(post_impact_state(z));
        EXPECT_NEAR(back.psi, z.psi, 1e-15);
        EXPECT_NEAR(back.chi, z.chi, 1e-15);
        EXPECT_EQ(back.vn, z.vn);
        EXPECT_EQ(back.vt, z.vt);
        EXPECT_EQ(back.spin, z.spin);
        const SectionPoint<double> polygon = section_point<Shape::polygon>(coordinates<Shape::polygon>(z));
        EXPECT_EQ(polygon.psi, z.psi);
        EXPECT_EQ(polygon.chi, z.chi);
        EXPECT_EQ(polygon.spin, z.spin);
        const SectionPoint<double> disk = section_point<Shape::disk>(coordinates<Shape::disk>(z));
        EXPECT_EQ(disk.chi, 0);
        EXPECT_EQ(disk.vn, z.vn);
        EXPECT_EQ(disk.spin, z.spin);
    }
}

TEST(Section, AnglesWrapToMinusPiExclusiveToPi) {
    EXPECT_EQ(wrapped_angle(M_PI), M_PI);
    EXPECT_EQ(wrapped_angle(-M_PI), M_PI);
    EXPECT_EQ(wrapped_angle(0.0), 0.0);
    EXPECT_NEAR(wrapped_angle(3 * M_PI - 0.1), M_PI - 0.1, 1e-15);
    EXPECT_NEAR(wrapped_angle(-3 * M_PI + 0.1), -M_PI + 0.1, 1e-15);
    Random random(42);
    for (int i = 0; i < 10000; ++i) {
        const double angle = random.between(-100, 100), wrapped = wrapped_angle(angle);
        EXPECT_GT(wrapped, -M_PI);
        EXPECT_LE(wrapped, M_PI);
        EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-13);
        EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-13);
    }
}

TEST(Section, SlipVelocityIsThatOfThePointThatTouches) {
    const Scene<double> scene{5, 0.4, 0.3, 0.2, 0.8, Law::poisson, 0.4};
    const SectionPoint<double> z{0.7, -0.2, -0.5, 0.6, 1.5};
    const auto approach = contact_kinematics(make_body(scene), post_impact_state(z));
    EXPECT_NEAR(approach.un, z.vn - 0.4 * z.spin * std::sin(z.chi) - 0.3 * std::sin(z.psi), 1e-15);
    EXPECT_NEAR(approach.ut, z.vt + 0.4 * z.spin * std::cos(z.chi) - 0.3 * std::cos(z.psi), 1e-15);
}

/// The largest difference between an angle and the sum of the same changes in 113 bits, in ε·2π. The changes are of a
/// size up to `largest`, of either sign where `turns_back`.
template <class T>
double off_by(long count, double largest, bool turns_back) {
    std::mt19937_64 draw(7);
    std::uniform_real_distribution<double> change(turns_back ? -largest : 0, largest);
    WoundAngle<T> angle;
    Quad sum = 0;
    const Quad turn = 2 * pi<Quad>();
    Quad off = 0;
    for (long i = 0; i < count; ++i) {
        const double step = change(draw);
        angle.add(T(step));
        sum += Quad(step);
        if (i % 1000 != 0) continue;
        const Quad apart = Quad(angle.phase) - (sum - turn * floor(sum / turn));
        off = std::max(off, Quad(fabs(apart - turn * round(apart / turn))));  // a rounding below a whole turn is zero
        EXPECT_GE(angle.phase, T(0));
        EXPECT_LT(angle.phase, 2 * pi<T>());
    }
    return static_cast<double>(off / (Quad(epsilon<T>()) * turn));
}

TEST(WoundAngle, IsOffByOneRoundingHoweverManyTurns) {
    for (const double largest : {1e-3, 2.0, 40.0, 1000.0})
        for (const bool turns_back : {false, true}) {
            // Half a rounding of a number below 8; the sum in 113 bits is off by 10⁶ of its own at most.
            EXPECT_LE(off_by<double>(1'000'000, largest, turns_back), 0.5) << largest;
            EXPECT_LE(off_by<long double>(100'000, largest, turns_back), 0.5) << largest;
        }
    std::printf("a million flights of up to 2: off by %.2f of epsilon 2 pi\n", off_by<double>(1'000'000, 2, false));
}

TEST(WoundAngle, StaysBelowAWholeTurn) {
    WoundAngle<double> angle;
    for (int i = 0; i < 1'000'000; ++i) angle.add(i % 3 == 2 ? -0.7 : 1.1);
    const Quad expected = 666667 * Quad(1.1) - 333333 * Quad(0.7);
    EXPECT_NEAR(angle.unwound(), static_cast<double>(expected), 6e-11);  // below 2¹⁹: two roundings of half an ulp
    angle.add(-angle.phase - 1e-20);
    EXPECT_GE(angle.phase, 0);
    EXPECT_LT(angle.phase, 2 * M_PI);
}

TEST(WoundAngle, CountsTurnsBeyondThoseThatADoubleHolds) {
    WoundAngle<double> angle;
    angle.add(2e17);
    double before = angle.unwound();
    const double start = before;
    for (int i = 0; i < 1'000'000; ++i) {
        angle.add(1.7);
        ASSERT_GE(angle.unwound(), before) << i;
        before = angle.unwound();
    }
    EXPECT_NEAR(before - start, 1.7e6, 64);  // two roundings of 2·10¹⁷
}

/// The laboratory's state half-way through a flight, turned so that the swirl's arm lies along x again.
LabStart<double> half_way(const LabState<double>& s, const LabFrame<double>& frame, double half) {
    const double turn = -(frame.time.phase + half);
    const double co = std::cos(turn), si = std::sin(turn);
    const double x = s.x + s.vx * half, y = s.y + s.vy * half;
    return {
        co * x - si * y, si * x + co * y, co * s.vx - si * s.vy, si * s.vx + co * s.vy, s.angle + s.spin * half + turn,
        s.spin};
}

/// Along orbits: the laboratory's state, taken half a flight on and started afresh there, leads to the same
/// impact as the section does; and vertex 0, the vertex that strikes and the wall are where they should be.
template <class Map>
void check_orbit(const Map& map, const SectionPoint<double>& z, long& impacts) {
    auto frame = LabFrame<double>::at_section(z);
    PostImpactState<double> post_impact = post_impact_state(z);
    for (int k = 0; k < 8; ++k) {
        const auto step = map.advance(post_impact);
        if (step.outcome != FirstContactOutcome::contact || step.simultaneous) return;
        const double norm = linearise_by_saltation(map, section_point(post_impact)).derivative.norm();
        if (norm > 1e3) return;  // the restart's rounding is multiplied by it
        const LabState<double> state = lab_state(map.body(), frame, post_impact);
        const LabStart<double> start = half_way(state, frame, step.flight_time / 2);
        const auto again = map.advance(flight_from(map.body(), start));
        ASSERT_EQ(again.outcome, FirstContactOutcome::contact);
        const double allowed =
            1e-14 * (10 + norm) * (10 + std::fabs(state.angle) + std::fabs(state.vx) + std::fabs(state.vy));
        EXPECT_NEAR(again.flight_time, step.flight_time / 2, allowed);
        const SectionPoint<double> a = section_point(again.after), b = section_point(step.after);
        EXPECT_NEAR(wrapped_angle(a.psi - b.psi), 0, allowed);
        EXPECT_NEAR(wrapped_angle(a.chi - b.chi), 0, allowed);
        EXPECT_NEAR(a.vn, b.vn, allowed);
        EXPECT_NEAR(a.vt, b.vt, allowed);
        EXPECT_NEAR(a.spin, b.spin, allowed * (1 + std::fabs(b.spin)));
        const double spin = post_impact.spin;
        frame.follow(map, step, spin * step.flight_time);
        post_impact = step.after;
        if constexpr (Map::shape == Shape::polygon) {
            EXPECT_EQ(again.vertex_step, frame.vertex);  // counted from vertex 0, where LabStart counts from
            const LabState<double> after = lab_state(map.body(), frame, post_impact);
            const double direction = after.angle + map.body().spacing * frame.vertex;
            const double cx = map.body().beta * std::cos(after.t), cy = map.body().beta * std::sin(after.t);
            EXPECT_NEAR(std::hypot(after.x + map.body().alpha * std::cos(direction) - cx,
                                   after.y + map.body().alpha * std::sin(direction) - cy),
                        1, allowed);
        }
        ++impacts;
    }
}

TEST(LabFrame, FollowsTheSectionThroughTheLaboratory) {
    Random random(43);
    long impacts = 0;
    const long orbits = tests::sample_count(5000);
    for (long i = 0; i < orbits; ++i) {
        const int sides = random.one_of({disk_sides, 3, 4, 5, 6, 12, 100});
        const double restitution = random.between(0.6, 1), mu = random.chance(0.5) ? 0 : 0.4;
        const Scene<double> scene = tests::random_scene(random, sides, mu, restitution, Law::stronge);
        const auto z = tests::random_point(random, scene, random.between(0.2, 2));
        with_collision_map(scene, [&](const auto& map) { check_orbit(map, z, impacts); });
    }
    std::printf("%ld orbits, %ld impacts compared\n", orbits, impacts);
    EXPECT_GE(impacts, 3 * orbits);
}

}  // namespace
}  // namespace swirl
