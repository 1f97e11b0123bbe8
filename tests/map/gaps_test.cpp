// Gaps and their derivatives along a flight, and what a certificate says of a gap between two moments.
#include "map/first_contact/bounds.hpp"
#include "map/first_contact/certificate.hpp"
#include "map/first_contact/vertex_proofs.hpp"
#include "map/first_contact/vertices.hpp"
#include "map/model/section.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "tests/map/contact_scenes.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace swirl {
namespace {

using tests::Random;
using tests::scene_in;

/// g(τ + h), h = −2 … 2 steps, in 113 bits.
template <class Value>
Gap<double> by_differences(Value value) {
    const Quad h = 1e-6;
    const Quad below2 = value(Quad(-2 * h)), below = value(Quad(-h)), here = value(Quad(0)), above = value(h),
               above2 = value(Quad(2 * h));
    return {static_cast<double>(here), static_cast<double>((above - below) / (2 * h)),
            static_cast<double>((above - 2 * here + below) / (h * h)),
            static_cast<double>((above2 - 2 * above + 2 * below - below2) / (2 * h * h * h))};
}

/// The differences err by h² times two derivatives more, some 10⁻¹² of a gap's derivatives by turns of order `fast`.
void expect_alike(const Gap<double>& gap, const Gap<double>& expected, double fast, const char* what) {
    EXPECT_NEAR(gap.value, expected.value, 1e-13) << what;
    EXPECT_NEAR(gap.rate, expected.rate, 1e-10 * fast) << what;
    EXPECT_NEAR(gap.curvature, expected.curvature, 1e-10 * fast * fast) << what;
    EXPECT_NEAR(gap.jerk, expected.jerk, 1e-10 * fast * fast * fast) << what;
}

/// |X|² − (1 − α)² and, of a vertex, |X + a|² − 1.
template <Shape shape>
Gap<double> gap_by_differences(const Body<Quad>& body, const Flight<Quad>& flight, double time, int vertex = 0) {
    return by_differences([&](const Quad& h) {
        const Instant<Quad> at = instant_at<shape>(flight, Quad(Quad(time) + h));
        if constexpr (shape == Shape::disk) return Quad(dot(at.centre, at.centre) - body.inner * body.inner);
        const Vec2<Quad> x = at.centre + body.turned_to_vertex(at.arm, vertex);
        return Quad(dot(x, x) - 1);
    });
}

/// A scene and a flight from its wall.
struct FromWall {
    Scene<double> scene;
    SectionPoint<double> z;
    Body<double> body = make_body(scene);
    Body<Quad> wide = make_body(scene_in<Quad>(scene));
    Flight<double> flight = flight_from(body, post_impact_state(z));
    Flight<Quad> in_quad = flight_from(wide, post_impact_state(SectionPoint<Quad>{z.psi, z.chi, z.vn, z.vt, z.spin}));
    double fast = 3 + std::fabs(z.spin) + std::fabs(z.vn) + std::fabs(z.vt);
};

FromWall draw(Random& random, int sides) {
    const Scene<double> scene = tests::uniform_scene(sides, random.between(0.1, 0.8), random.between(0, 2), 0.5, 0.9);
    return {scene, tests::random_point(random, scene, 0.5)};
}

TEST(Gaps, OfPolygonsAndTheirDerivativesAreThoseOfTheFlightIn113Bits) {
    Random random(5);
    for (int k = 0; k < 200; ++k) {
        const FromWall from = draw(random, random.one_of({3, 4, 6, 50}));
        const double time = random.between(0.1, 2);
        const Instant<double> at = instant_at<Shape::polygon>(from.flight, time);
        expect_alike(centre_gap(from.body, from.flight, at),
                     gap_by_differences<Shape::disk>(from.wide, from.in_quad, time), from.fast, "centre");
        const Gap<double> vertex = gap_by_differences<Shape::polygon>(from.wide, from.in_quad, time);
        expect_alike(vertex_gap(from.flight, at, at.arm), vertex, from.fast, "vertex");
        expect_alike(struck_gap(from.flight, at), vertex, from.fast, "the vertex that began the flight");
        expect_alike(struck_gap_at_start(from.flight), gap_by_differences<Shape::polygon>(from.wide, from.in_quad, 0),
                     from.fast, "that vertex at the start");
        const int other = 1 + k % (from.scene.sides - 1);
        const Vec2<double> arm = from.body.turned_to_vertex(at.arm, other);
        expect_alike(detail::gap_of(from.body, from.flight, at, {other, arm, {}}),
                     gap_by_differences<Shape::polygon>(from.wide, from.in_quad, time, other), from.fast, "another");
    }
}

/// On the side of the centre, and numbered from 0 to N − 1 past either end.
TEST(NeighbourOfAVertex, IsTheNextOneOnTheCentresSide) {
    Random random(6);
    for (int k = 0; k < 400; ++k) {
        const FromWall from = draw(random, random.one_of({3, 4, 6}));
        const int sides = from.scene.sides, vertex = k % sides;
        const Instant<double> at = instant_at<Shape::polygon>(from.flight, random.between(0.1, 2));
        const Vec2<double> arm = from.body.turned_to_vertex(at.arm, vertex);
        const auto found = detail::neighbour_of(from.body, from.flight, at, {vertex, arm, {}});
        const int ahead = (vertex + 1) % sides, behind = (vertex + sides - 1) % sides;
        EXPECT_EQ(found.vertex, cross(arm, at.centre) >= 0 ? ahead : behind);
        const Vec2<double> expected = from.body.turned_to_vertex(at.arm, found.vertex);
        EXPECT_EQ(found.arm.x, expected.x);
        EXPECT_EQ(found.arm.y, expected.y);
        EXPECT_EQ(found.gap.value, detail::gap_of(from.body, from.flight, at, found).value);
    }
}

TEST(Gaps, OfDisksAndTheirDerivativesAreThoseOfTheFlightIn113Bits) {
    Random random(7);
    for (int k = 0; k < 200; ++k) {
        const FromWall from = draw(random, disk_sides);
        const double time = random.between(0.1, 2);
        expect_alike(centre_gap(from.body, from.flight, instant_at<Shape::disk>(from.flight, time)),
                     gap_by_differences<Shape::disk>(from.wide, from.in_quad, time), from.fast, "disk");
    }
}

/// A gap whose sixth derivative is 720 c₆.
struct Sextic {
    std::array<double, 7> c;
    Gap<double> at(double t) const {
        Gap<double> g{0, 0, 0, 0};
        for (int k = 6; k >= 0; --k) {
            const double a = c[static_cast<std::size_t>(k)];
            g.value += a * std::pow(t, k);
            if (k > 0) g.rate += k * a * std::pow(t, k - 1);
            if (k > 1) g.curvature += k * (k - 1) * a * std::pow(t, k - 2);
        }
        return g;
    }
};

TEST(ClosedBetween, IsTrueOfTheGapsThatItProves) {
    Random random(6);
    long proven = 0, later = 0;
    for (int k = 0; k < 200'000; ++k) {
        const double h = random.between(0.2, 1.5);
        // Of both signs at the ends, mostly below 0 between them, and what the ends do not tell: b t³ (h − t)³.
        const double b = random.between(0, 60) / std::pow(h, 6), h2 = h * h;
        Sextic gap;
        gap.c = {random.chance(0.5) ? 0 : random.between(-0.1, 0.3),
                 random.between(-3, 1),
                 random.between(-2, 4),
                 random.between(-3, 3) + b * h2 * h,
                 random.between(-3, 3) - 3 * b * h2,
                 random.between(-3, 3) + 3 * b * h,
                 -b};
        const auto ring = detail::closed_between<double>(gap.at(0), gap.at(h), h, 720 * std::fabs(gap.c[6]));
        if (!ring.proven) continue;
        ++proven;
        later += ring.out > 0.01 * h;
        ASSERT_GE(ring.out, 0);
        ASSERT_GE(ring.in, 0);
        for (int i = 0; i <= 50; ++i) {
            const double t = ring.out + (h - ring.in - ring.out) * i / 50;
            if (t <= ring.out || t >= h - ring.in) continue;
            ASSERT_LE(gap.at(t).value, 1e-13) << "at " << t << " of " << h;
        }
    }
    std::printf("%ld proven, %ld of them from later than the first end on\n", proven, later);
    EXPECT_GE(proven, 10'000);
    EXPECT_GE(later, 1000);
}

/// At the wall by what the gap's rounding leaves open, 4 ε of its size, or the time's; never beyond 16 ε of the size.
TEST(IsAtWall, ByTheRoundingOfTheGapOrOfTheTime) {
    constexpr double eps = 0x1p-52;
    const double slow = 1e-12, fast = 10;
    EXPECT_TRUE(detail::is_at_wall<double>(-3 * eps, slow, 1, 1));
    EXPECT_FALSE(detail::is_at_wall<double>(-5 * eps, slow, 1, 1));
    EXPECT_TRUE(detail::is_at_wall<double>(-15 * eps, fast, 10, 1));
    EXPECT_FALSE(detail::is_at_wall<double>(-17 * eps, fast, 10, 1));
    EXPECT_TRUE(detail::is_at_wall<double>(-11 * eps, slow, 1, 3));
    EXPECT_FALSE(detail::is_at_wall<double>(-3 * eps, -slow, 1, 1)) << "it recedes";
}

}  // namespace
}  // namespace swirl
