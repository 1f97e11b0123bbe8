// A body on one vertex whose neighbour, which has just left the wall, comes back, or does not: against 113 bits.
#include "map/contact/reaction.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "tests/map/landings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace swirl {
namespace {

/// On a vertex at ψ and χ with a slip u_t.
template <class T>
PostImpactState<T> on_vertex(const Body<T>& body, const SectionPoint<T>& at, const T& slip) {
    PostImpactState<T> z = post_impact_state(at);
    const ContactKinematics<T> u = contact_kinematics(body, z);
    z.vn -= u.un;
    z.vt -= u.ut - slip;
    return z;
}

/// After so many impacts of a body that begins at rest on a vertex.
template <class T>
std::vector<double> rolled(const Scene<double>& s, int impacts) {
    return with_collision_map(tests::scene_in<T>(s), [&](const auto& map) {
        const ReturnMap returns(map);
        const SectionPoint<T> at{T(-1.5), -tests::contact_of(map.scene()).widest_chi / 2, T(0), T(0), T(-3e-5)};
        ReturnStep<T> step;
        step.collision.after = on_vertex(map.body(), at, T(0));
        for (int i = 0; i < impacts; ++i) {
            const Outcome outcome = returns.advance(step);
            EXPECT_EQ(outcome, Outcome::completed) << s.sides << " sides, impact " << i + 1;
            if (outcome != Outcome::completed) break;
        }
        const SectionPoint<T> z = section_point(step.collision.after);
        return std::vector<double>{static_cast<double>(z.psi), static_cast<double>(z.vn), static_cast<double>(z.vt),
                                   static_cast<double>(z.spin)};
    });
}

// Rolling from vertex to vertex of many: what strikes bring to the neighbour is below rounding in place, vT < 16 ε with
// T by free flight, but of the order of S, and does not come back.
TEST(Rocking, OfManySidedBodiesIsNoRestOnAnEdge) {
    for (const auto& [sides, alpha] :
         {std::pair{10'000, 0.999}, {100'000, 0.999}, {100'000, 0.9999}, {1'000'000, 0.9999}})
        for (const double mu : {0.5, 1e6}) {
            const Scene<double> scene = tests::uniform_scene(sides, alpha, 0.5, mu, 0);
            const auto found = rolled<double>(scene, 60), exact = rolled<Quad>(scene, 60);
            double worst = 0;
            for (std::size_t i = 0; i < found.size(); ++i) worst = std::max(worst, std::abs(found[i] - exact[i]));
            std::printf("%7d sides, alpha %g, mu %g: S = %.12g, off by %.1e\n", sides, alpha, mu, exact[3], worst);
            EXPECT_LE(worst, 1e-13) << sides << " sides, mu " << mu;  // 60 impacts of one to ten ε each; measured 5e-15
        }
}

/// An edge's first slip and when it begins, from a state on one of its vertices.
struct EdgeLanding {
    double time = 0, ut = 0;
};

template <class Map>
std::optional<EdgeLanding> edge_landing(const Map& map, const PostImpactState<Quad>& from) {
    const ReturnMap returns(map);
    PostImpactState<Quad> at = from;
    Quad time(0);
    for (int i = 0; i < 500 && time < Quad(1e-4); ++i) {
        const ReturnStep<Quad> step = returns.advance(at, 50);
        for (const ContactSegment& piece : step.contacts)
            if (piece.support == Support::edge)
                return EdgeLanding{static_cast<double>(time) + piece.start, piece.from.ut};
        if (step.outcome != Outcome::completed) return {};
        time += step.collision.flight_time;
        at = step.collision.after;
    }
    return {};
}

/// How far double's slip of an edge is off, where both vertices leave at about v; nothing where 113 bits find no edge.
template <class Map>
std::optional<double> error_of_landing(const Map& map, const Scene<double>& scene, tests::Random& random, double v) {
    const ReturnMap returns(map);
    const ContactScene<double> contact = tests::contact_of(scene);
    const SectionPoint<double> at{random.between(-0.3, 0.3), -contact.widest_chi, 0, 0, 0};
    const double slip = random.between(-0.5, 0.5);
    const double lever = rocking_of(contact, ContactMotion::sliding_forward, {at.psi, at.chi, slip, slip}).lever;
    PostImpactState<double> from = post_impact_state(at);
    from.spin = slip + v * random.between(-1, 0) / lever;
    const ContactKinematics<double> u = contact_kinematics(map.body(), from);
    from.vn -= u.un + v * random.between(0, 1);
    from.vt -= u.ut - slip;
    const auto found = chatter_completion(contact, from);
    if (!found.in_contact || found.support != Support::edge) return {};
    const CollisionMap<Quad, Map::shape, Map::rule> wide(tests::scene_in<Quad>(scene));
    const auto exact = edge_landing(wide, tests::widened(wide.body(), from));
    if (!exact) return {};
    const ContactMotion motion = slip > 0 ? ContactMotion::sliding_forward : ContactMotion::sliding_backward;
    const double rate = reaction_of(contact, Support::edge, motion, found.state).ut_rate;
    return std::abs(found.state.ut + rate * exact->time - exact->ut);
}

TEST(Rocking, LeavesAnEdgeTheSlipThatItsImpulsesDo) {
    tests::Random random(5);
    for (const int sides : {3, 4, 6}) {
        std::vector<double> errors;
        for (int i = 0; i < 400 && errors.size() < 20; ++i) {
            const double mu = random.between(0.05, 0.3), restitution = random.between(0.05, 0.5);
            const Law law = static_cast<Law>(random.one_of({0, 1, 2}));
            const Scene<double> scene = tests::random_scene(random, sides, mu, restitution, law);
            with_collision_map(scene, [&](const auto& map) {
                if constexpr (std::decay_t<decltype(map)>::shape == Shape::polygon)
                    if (const auto error = error_of_landing(map, scene, random, 1e-9)) errors.push_back(*error);
            });
        }
        std::sort(errors.begin(), errors.end());
        ASSERT_GE(errors.size(), 10U) << sides;
        std::printf("%d sides: %zu edges, slip off by %.1e in the median, %.1e at most\n", sides, errors.size(),
                    errors[errors.size() / 2], errors.back());
        // Of second order in the time until the edge lies, some 10⁻⁷; its slip taken for a vertex' is off by 0.3 v.
        EXPECT_LE(errors.back(), 1e-11) << sides;
    }
}

/// The first impact later than 10⁻⁶ after a start with both vertices of an edge on the wall, and S then.
template <class T>
std::vector<double> first_later_impact(const Scene<double>& s, const SectionPoint<double>& z) {
    return with_collision_map(tests::scene_in<T>(s), [&](const auto& map) {
        const ReturnMap returns(map);
        ReturnStep<T> step;
        step.collision.after = post_impact_state(SectionPoint<T>{T(z.psi), T(z.chi), T(z.vn), T(z.vt), T(z.spin)});
        T time(0);
        for (int i = 0; i < 500 && time < T(1e-6); ++i) {
            if (returns.advance(step) != Outcome::completed) return std::vector<double>{};
            time += step.collision.flight_time;
        }
        return std::vector<double>{static_cast<double>(time), static_cast<double>(step.collision.after.spin)};
    });
}

// An edge lies only where rocking about either vertex brings the other back: one that does not stay, or about which the
// body rolls on, and a slip beyond Painlevé's border, leave a vertex in contact.
TEST(Rocking, ThatDoesNotBringAVertexBackIsNoEdge) {
    struct Case {
        int sides;
        double alpha, beta, mu, restitution;
        Law law;
        SectionPoint<double> z;
    };
    const Case cases[] = {{12,
                           0.67299013137808994,
                           0.3340436735175813,
                           0.17241749681640403,
                           0.15222529225488002,
                           Law::newton,
                           {0.090870914161295169, -0.086723705801302037, 0.030313095141306107, 0.33266543434640183,
                            1.7336924624765763e-09}},
                          {4,
                           0.47727675332113673,
                           0.02712302905854666,
                           0,
                           0.49743601298915208,
                           Law::newton,
                           {-0.15408991581312761, -0.44115363101448252, -0.0041628659728482342, 0.026801664908995514,
                            4.8087533128862971e-10}},
                          {5,
                           0.83603434649558506,
                           0.31475816269057189,
                           3.4863377680053933,
                           0,
                           Law::newton,
                           {0.87240028046744689, -0.1146120931722688, 0.24106524887096475, 0.20238637915263358,
                            -1.0077226604663934e-09}}};
    for (const Case& c : cases) {
        Scene<double> scene = tests::uniform_scene(c.sides, c.alpha, c.beta, c.mu, c.restitution);
        scene.law = c.law;
        const auto found = first_later_impact<double>(scene, c.z), exact = first_later_impact<Quad>(scene, c.z);
        ASSERT_EQ(found.size(), 2U) << c.sides;
        ASSERT_EQ(exact.size(), 2U) << c.sides;
        std::printf("%d sides: t = %.13g, off by %.1e, S = %.13g, off by %.1e\n", c.sides, exact[0],
                    found[0] - exact[0], exact[1], found[1] - exact[1]);
        EXPECT_NEAR(found[0], exact[0], 1e-8 * exact[0]) << c.sides;
        EXPECT_NEAR(found[1], exact[1], 1e-9) << c.sides;
    }
}

}  // namespace
}  // namespace swirl
