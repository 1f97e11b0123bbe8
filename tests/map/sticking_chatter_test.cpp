// The motion along the wall of chatter that sticks, against the sequence of impacts in 113 bits.
#include "map/contact/end_of_chatter.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "map/orbit/return_map.hpp"
#include "tests/map/chatter_sequences.hpp"
#include "tests/map/landings.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

namespace swirl {
namespace {

using tests::Accumulation, tests::difference_from, tests::impact_by_impact;

/// Just after an impact that leaves at v with a slip of u_t/v.
PostImpactState<Quad> leaving_at(const ContactScene<Quad>& scene, const SectionPoint<double>& z, double v,
                                 double slip) {
    PostImpactState<Quad> post_impact = post_impact_state(SectionPoint<Quad>{z.psi, z.chi, z.vn, z.vt, z.spin});
    const ContactKinematics<Quad> u = contact_kinematics(scene.body, post_impact);
    post_impact.vn -= u.un + Quad(v);
    post_impact.vt -= u.ut - Quad(slip) * Quad(v);
    return post_impact;
}

/// The error of chatter's sum at v and at v/10; negative where impacts do not stick or the body does not stay.
struct Fall {
    double at_v, at_tenth;
};

/// How chatter stops the slip.
enum class Stop {
    throughout,  ///< the slip is 0, and every impact sticks
    by_impact,   ///< impacts come to stick
    by_contact   ///< a flight turns the slip round, no impact sticks, and contact stops it
};

/// Once contact has stopped the slip with which chatter ends.
Accumulation stopped_by_contact(const ContactScene<Quad>& scene, Accumulation end) {
    const Support support = scene.is_disk() ? Support::rim : Support::vertex;
    const ContactState<Quad> state{end.psi, end.chi, end.ut, end.spin};
    const ContactMotion motion = choose_motion(scene, support, state, 0).motion;
    const ContactEnd<Quad> contact = run_contact(scene, support, motion, state, end.time);
    end.found = end.found && contact.event == ContactEvent::stick;
    end.rests = true;
    end.time += contact.sums.time;
    end.psi = contact.state.psi;
    end.chi = contact.state.chi;
    end.ut = 0;
    end.spin = contact.state.spin;
    return end;
}

Fall fall_of(const Scene<double>& s, const SectionPoint<double>& z, double v, double slip, Stop stop) {
    const ContactScene<Quad> scene = tests::contact_of(tests::scene_in<Quad>(s));
    const auto error = [&](double leaving) {
        const PostImpactState<Quad> from = leaving_at(scene, z, leaving, slip);
        if (!(chatter_error(scene, from).moved <= Quad(0.01 * leaving))) return -1.0;
        if (!can_stick(scene, from)) return -1.0;
        Accumulation end = impact_by_impact(s, from, Quad(1e-29));
        if (stop == Stop::by_contact) {
            if (!end.found || end.rests || end.ut * Quad(slip) > 0) return -1.0;
            end = stopped_by_contact(scene, end);
        }
        const bool stops = stop == Stop::throughout ? end.sticks : end.rests;
        return end.found && stops ? difference_from(scene, from, end) : -1.0;
    };
    return {error(v), error(0.1 * v)};
}

/// What error(v/10)/error(v) is in drawn scenes of N sides, ascending.
///   most_slip  of |u_t|/v, which is drawn
std::vector<double> falls(int sides, Law law, int count, std::uint64_t seed, double most_slip, Stop stop) {
    tests::Random random(seed);
    std::vector<double> ratios;
    for (int i = 0; i < count; ++i) {
        const double restitution = random.between(0.1, 0.7), mu = random.between(0.2, 1);
        const Scene<double> s = tests::random_scene(random, sides, mu, restitution, law);
        const SectionPoint<double> z = tests::random_point(random, s, 0);
        if (std::abs(z.chi) > 0.9 * tests::largest_chi(s) && sides != disk_sides) continue;
        const double slip = most_slip == 0 ? 0 : random.between(-most_slip, most_slip);
        const Fall fall = fall_of(s, z, 1e-5, slip, stop);
        if (fall.at_v > 0 && fall.at_tenth >= 0) ratios.push_back(fall.at_tenth / fall.at_v);
    }
    std::sort(ratios.begin(), ratios.end());
    return ratios;
}

/// Just after an impact that stopped the slip, of a triangle: e′ is 1 at this ψ and smaller, or larger, beside it.
SectionPoint<double> with_rebound_of_one(double beside) {
    const double psi = 0.8810859458072339 + beside;
    return {psi, -0.5, 0.5 * std::sin(psi) - 1e-8, 0.5 * std::cos(psi), 0};
}

/// e′ of chatter that sticks from there on.
double rebound_of(const ContactScene<double>& contact, const PostImpactState<double>& from) {
    const double acceleration = contact.body.beta * from.psi.x;  // S = 0, u_t = 0
    return *rebound_while_stuck(contact, remaining_chatter(contact, from, acceleration));
}

// Where impacts that stick rebound at e′ near 1 chatter lasts long, and at e′ ≥ 1 its flights grow: no landing, but a
// flight and an impact that leaves at e′v.
TEST(StickingChatter, IsNoLandingWhereItsReboundComesUpToOne) {
    const Scene<double> scene = tests::uniform_scene(3, 0.5, 0.5, 1, 0.5);
    const CollisionMap<double, Shape::polygon, ImpactRule::poisson> map(scene);
    const ReturnMap returns(map);
    int grow = 0, shrink = 0;
    for (const double beside : {-1e-3, -1e-4, -1e-6, -1e-10, -1e-14, 0.0, 1e-10, 1e-4, 1e-3, 1e-2}) {
        const PostImpactState<double> from = post_impact_state(with_rebound_of_one(beside));
        const double rebound = rebound_of(returns.contact(), from);
        EXPECT_NEAR(rebound, 1, 20 * std::abs(beside) + 1e-14) << beside;
        ASSERT_FALSE(chatter_completion(returns.contact(), from).in_contact) << beside;
        const ReturnStep<double> step = returns.advance(from);
        ASSERT_EQ(step.outcome, Outcome::completed) << beside;
        EXPECT_TRUE(step.contacts.empty()) << beside;
        const ContactKinematics<double> before = contact_kinematics(map.body(), from),
                                        after = contact_kinematics(map.body(), step.collision.after);
        // v is 10⁻⁸, known to ε; along a flight of T = 4·10⁻⁸ accelerations change by as much.
        EXPECT_NEAR(after.un / before.un, rebound, 1e-6) << beside;
        (rebound > 1 ? grow : shrink) += 1;
    }
    EXPECT_GE(grow, 3);
    EXPECT_GE(shrink, 3);
}

// Slower flights land where v T is below the tolerance by e′, too, and the sum that has no meaning does not move them.
TEST(StickingChatter, LandsWhereItLastsLongButIsSlow) {
    const Scene<double> scene = tests::uniform_scene(3, 0.5, 0.5, 1, 0.5);
    const ContactScene<double> contact = tests::contact_of(scene);
    int landings = 0;
    for (const double beside : {-1e-3, 1e-3}) {
        SectionPoint<double> z = with_rebound_of_one(beside);
        z.vn += 1e-8 - 1e-10;
        const PostImpactState<double> from = post_impact_state(z);
        const double rebound = rebound_of(contact, from);
        const auto landing = chatter_completion(contact, from);
        ASSERT_EQ(landing.in_contact, rebound < 1) << beside;
        if (!landing.in_contact) continue;
        ++landings;
        EXPECT_GT(1 - scene.restitution, most_longer * (1 - rebound)) << beside;
        EXPECT_NEAR(landing.state.psi, z.psi, 1e-15) << beside;
        EXPECT_NEAR(landing.state.chi, z.chi, 1e-15) << beside;
        EXPECT_NEAR(landing.jacobi, 0, 1e-10) << beside;  // of the order of v: u_n is removed
    }
    EXPECT_EQ(landings, 1);
}

// Where e′ is below 1 by enough the body lands, and stays where it landed.
TEST(StickingChatter, DoesNotMoveTheBodyFarWhereItsReboundComesUpToOne) {
    const Scene<double> scene = tests::uniform_scene(3, 0.5, 0.5, 1, 0.5);
    const SectionPoint<double> z = with_rebound_of_one(-1e-2);
    const auto landing = chatter_completion(tests::contact_of(scene), post_impact_state(z));
    ASSERT_TRUE(landing.in_contact);
    EXPECT_NEAR(landing.state.psi, z.psi, 1e-12);  // 64 tolerances, and a_t/a some 20
    EXPECT_NEAR(landing.state.chi, z.chi, 1e-12);
    EXPECT_NEAR(landing.jacobi, 0, 1e-8);  // of the order of v: u_n is removed
}

/// Starts at which e′ ≥ 1 while the neighbour rests on the wall: the body rocks, and its orbit goes on.
TEST(StickingChatter, GoesOnWhereTheNeighbourRestsOnTheWall) {
    struct Case {
        int sides;
        double alpha, beta, mu, restitution;
        Law law;
        SectionPoint<double> z;
    };
    const Case cases[] = {
        {8,
         0.217,
         0.2117,
         1.055,
         0.835,
         Law::stronge,
         {-0.7901622242455059, -0.30956103584571326, -0.1504059574207512, 0.14897965717143655, -6.679029334319729e-09}},
        {5,
         0.32,
         0.8665,
         1.401,
         0.819,
         Law::poisson,
         {-0.6090060535974147, 0.43910015324376844, -0.495683483503694, 0.7107180412668477, 0}},
        {5,
         0.23,
         0.4566,
         1.106,
         0.586,
         Law::poisson,
         {-0.9522652070255392, 0.49271269667837375, -0.3720061991560672, 0.26475450756747226, 0}}};
    for (const Case& c : cases) {
        Scene<double> scene = tests::uniform_scene(c.sides, c.alpha, c.beta, c.mu, c.restitution);
        scene.law = c.law;
        with_collision_map(scene, [&](const auto& map) {
            const ReturnMap returns(map);
            ReturnStep<double> step;
            step.collision.after = post_impact_state(c.z);
            for (int i = 0; i < 60; ++i)
                ASSERT_EQ(returns.advance(step), Outcome::completed) << c.sides << ", impact " << i + 1;
        });
    }
}

/// Beyond Painlevé's border for the slip that there is, c ≤ 0, an impact stops it, and e′ decides from there.
TEST(StickingChatter, IsStoppedAtOnceBeyondPainlevesBorder) {
    const Scene<double> scene = tests::uniform_scene(3, 0.4, 0.8, 1.6, 0.6);
    const ContactScene<double> contact = tests::contact_of(scene);
    for (const double slip : {-1e-9, 0.0, 1e-9}) {
        PostImpactState<double> from = post_impact_state(SectionPoint<double>{-1, 0.42, 0, 0, 0});
        const ContactKinematics<double> u = contact_kinematics(contact.body, from);
        from.vn -= u.un + 5e-9;
        from.vt -= u.ut - slip;
        EXPECT_FALSE(chatter_completion(contact, from).in_contact) << slip;
    }
}

/// However slow: a landing there would remove v by an impulse that no slip has.
TEST(StickingChatter, GoesOnBeyondPainlevesBorderAsIn113Bits) {
    const Scene<double> scene{3,
                              0.18212881920083007,
                              3.2463143439609081,
                              2.4875316860678849,
                              0.29697898342205065,
                              Law::newton,
                              uniform_inertia_factor<double>(3)};
    const SectionPoint<double> z{-0.90065403228450513, 0.4475301836818007, -2.4587214744861918, 1.8381091670604961,
                                 1.0851201327128079};
    const CollisionMap<double, Shape::polygon, ImpactRule::newton> map(scene);
    EXPECT_FALSE(chatter_completion(tests::contact_of(scene), post_impact_state(z)).in_contact);
    const auto found = tests::contact_return(map, post_impact_state(z));
    const CollisionMap<Quad, Shape::polygon, ImpactRule::newton> wide(tests::scene_in<Quad>(scene));
    const auto exact = tests::contact_return(wide, tests::widened(wide.body(), post_impact_state(z)));
    ASSERT_TRUE(found && exact);
    // Measured: 4e-12, of the rest of chatter and the condition of the way on; 3e-8 where it landed at once.
    EXPECT_NEAR(found->after.spin, static_cast<double>(exact->after.spin), 1e-10);
}

/// T falls by 10 with v. Without the motion along the wall the error is of second order, and falls by 100.
void expect_third_order(double most_slip, Stop stop, std::initializer_list<int> bodies) {
    const int disks = stop == Stop::by_contact ? 1000 : 40, polygons = stop == Stop::by_contact ? 1200 : 400;
    for (const int sides : bodies)
        for (const Law law : {Law::poisson, Law::newton, Law::stronge}) {
            if (sides == disk_sides && law != Law::poisson) continue;  // the disk's laws coincide
            const auto ratios = falls(sides, law, sides == disk_sides ? disks : polygons, 7, most_slip, stop);
            ASSERT_GE(ratios.size(), 5U) << sides;
            std::printf("%2d sides, %s: %zu sequences, error(v/10)/error(v) median %.3g, largest %.3g\n", sides,
                        std::string(name_of(law)).c_str(), ratios.size(), ratios[ratios.size() / 2], ratios.back());
            // 10⁻³ but for the fourth order, T < 10⁻³ of the third; of single sequences a third order may be small.
            EXPECT_NEAR(ratios[ratios.size() / 2], 1e-3, 1e-5) << sides;
            EXPECT_LE(ratios.back(), 2e-3) << sides;
        }
}

/// A disk whose impacts return the slip: u_t falls with v, whatever signs it takes, and chatter ends at rest.
Fall fall_of_returned(const Scene<double>& s, const SectionPoint<double>& z, double v, double slip) {
    const ContactScene<Quad> scene = tests::contact_of(tests::scene_in<Quad>(s));
    const auto error = [&](double leaving) {
        const PostImpactState<Quad> from = leaving_at(scene, z, leaving, slip);
        if (!(chatter_error(scene, from).moved <= Quad(0.01 * leaving)) || !can_stick(scene, from)) return -1.0;
        Accumulation end = impact_by_impact(s, from, Quad(1e-29));
        if (!end.found || abs(end.ut) > Quad(1e-27)) return -1.0;
        end.rests = true;
        return difference_from(scene, from, end);
    };
    return {error(v), error(0.1 * v)};
}

TEST(StickingChatter, LeavesAnErrorOfThirdOrderWhereImpactsReturnTheSlip) {
    tests::Random random(11);
    std::vector<double> ratios;
    for (int i = 0; i < 60; ++i) {
        const double restitution = random.between(0.1, 0.7), mu = random.between(0.2, 1);
        Scene<double> s = tests::random_scene(random, disk_sides, mu, restitution, Law::poisson);
        s.tangential_restitution = random.between(0.1, 1);
        const SectionPoint<double> z = tests::random_point(random, s, 0);
        const Fall fall = fall_of_returned(s, z, 1e-5, random.between(-2, 2));
        if (fall.at_v > 0 && fall.at_tenth >= 0) ratios.push_back(fall.at_tenth / fall.at_v);
    }
    std::sort(ratios.begin(), ratios.end());
    ASSERT_GE(ratios.size(), 10U);
    std::printf("%zu sequences, error(v/10)/error(v) median %.3g, largest %.3g\n", ratios.size(),
                ratios[ratios.size() / 2], ratios.back());
    EXPECT_NEAR(ratios[ratios.size() / 2], 1e-3, 1e-5);
    EXPECT_LE(ratios.back(), 2e-3);
}

TEST(StickingChatter, LeavesAnErrorOfThirdOrder) {
    expect_third_order(0, Stop::throughout, {disk_sides, 3});
}
TEST(StickingChatter, LeavesAnErrorOfThirdOrderWhereItStopsASlip) {
    expect_third_order(2, Stop::by_impact, {disk_sides, 3});
}
TEST(StickingChatter, LeavesAnErrorOfThirdOrderWhereContactStopsASlipThatAFlightHasTurned) {
    expect_third_order(2, Stop::by_contact, {disk_sides, 3});
}
TEST(StickingChatterNightly, LeavesAnErrorOfThirdOrderOfASquareAndATwelveGon) {
    expect_third_order(0, Stop::throughout, {4, 12});
    expect_third_order(2, Stop::by_impact, {4, 12});
    expect_third_order(2, Stop::by_contact, {4, 12});
}

}  // namespace
}  // namespace swirl
