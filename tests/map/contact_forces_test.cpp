// Forces of contact against the geometry of the motion, strikes of a neighbour in contact, and jams.
#include "map/contact/contact_phase.hpp"
#include "map/contact/contact_run.hpp"
#include "tests/map/contact_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace swirl {
namespace {

using tests::contact_of;

Scene<double> scene_of(int sides, double alpha, double beta, double mu, double e, Law law = Law::poisson) {
    return tests::uniform_scene(sides, alpha, beta, mu, e, law);
}

// The lab position's second difference is the force.

struct Place {
    Vec2<double> centre;  ///< in the laboratory
    double angle;         ///< of the body
    Vec2<double> n, n2;   ///< contact normals
};

Place place_of(const ContactScene<double>& scene, Support support, const ContactState<double>& z, double t) {
    const double nu = z.psi + t;
    Place place;
    place.n = cis(nu);
    place.n2 = cis(nu + 2 * scene.half_chord);
    const double arm = nu + z.chi;
    place.centre = scene.body.beta * cis(t) +
                   (support == Support::rim ? scene.body.inner * cis(nu) : cis(nu) - scene.body.alpha * cis(arm));
    place.angle = arm;
    return place;
}

TEST(Reaction, IsWhatTheGeometryNeeds) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> u(-1, 1);
    const double h = 1e-3;
    long checked = 0, held = 0;
    double worst = 0;
    for (const Support support : {Support::rim, Support::vertex, Support::edge})
        for (const ContactMotion motion :
             {ContactMotion::sliding_forward, ContactMotion::sliding_backward, ContactMotion::sticking})
            for (int i = 0; i < 200; ++i) {
                const int sides = support == Support::rim ? disk_sides : 3 + i % 4;
                const auto scene = contact_of(scene_of(sides, 0.35 + 0.3 * u(random), 0.5 + 0.4 * u(random), 0.3, 0.5));
                ContactState<double> z{3 * u(random), 0, 0, u(random)};
                if (support == Support::vertex) z.chi = 0.5 * scene.widest_chi * u(random);
                if (support == Support::edge) z.chi = -scene.widest_chi;
                if (motion == ContactMotion::sliding_forward) z.ut = 0.5 + 0.3 * u(random);
                if (motion == ContactMotion::sliding_backward) z.ut = -0.5 + 0.3 * u(random);
                if (support == Support::edge) z.spin = z.ut;
                const auto now = run_contact(scene, support, motion, z, h),
                           later = run_contact(scene, support, motion, z, 2 * h);
                if (now.event != ContactEvent::horizon || later.event != ContactEvent::horizon) continue;
                const Reaction<double> r = reaction_of(scene, support, motion, now.state);
                if (r.stiffness < 0.05) continue;
                const Place p0 = place_of(scene, support, z, 0), p1 = place_of(scene, support, now.state, h),
                            p2 = place_of(scene, support, later.state, 2 * h);
                const Vec2<double> acceleration = (1 / (h * h)) * (p0.centre - p1.centre + (p2.centre - p1.centre));
                // A disk's orientation is what its spin has turned.
                const double turning =
                    support == Support::rim
                        ? (later.sums.turned - 2 * now.sums.turned) / (h * h)
                        : (wrapped_angle(p2.angle - p1.angle) - wrapped_angle(p1.angle - p0.angle)) / (h * h);
                Vec2<double> force = r.friction * quarter_turned(p1.n) - r.normal * p1.n;
                if (support == Support::edge) {
                    const double smu = motion == ContactMotion::sticking          ? 0
                                       : motion == ContactMotion::sliding_forward ? 0.3
                                                                                  : -0.3;
                    // Of an edge at rest f₁ − f₂ = (Λ c − w)/s along the edge's middle.
                    const double wn = scene.body.beta * std::cos(now.state.psi + scene.half_chord);
                    const double apart =
                        ((r.normal + r.second) * std::cos(scene.half_chord) - wn) / std::sin(scene.half_chord);
                    const double f1 = motion == ContactMotion::sticking ? 0.5 * (r.friction + apart) : -smu * r.normal;
                    if (motion == ContactMotion::sticking && r.reserve >= 0) {  // a pair that is possible
                        EXPECT_LE(std::abs(f1), 0.3 * r.normal + 1e-12);
                        EXPECT_LE(std::abs(r.friction - f1), 0.3 * r.second + 1e-12);
                        ++held;
                    }
                    force = f1 * quarter_turned(p1.n) - r.normal * p1.n;
                    force = force + ((r.friction - f1) * quarter_turned(p1.n2) - r.second * p1.n2);
                }
                const double size = 1 + std::abs(force.x) + std::abs(force.y);
                worst = std::max({worst, std::abs(acceleration.x - force.x) / size,
                                  std::abs(acceleration.y - force.y) / size,
                                  std::abs(turning - r.spin_rate) / (1 + std::abs(r.spin_rate))});
                ++checked;
            }
    std::printf("%ld states: largest difference of force and mass times acceleration %.1e\n", checked, worst);
    EXPECT_GE(checked, 500);
    EXPECT_GE(held, 20);
    EXPECT_LE(worst, 3e-5);  // h² and the fourth derivative; rounding of the differences is 1e-10
}

TEST(Strike, CreatesNoEnergyAndLeavesNothingApproaching) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> u(-1, 1);
    long resolved = 0;
    for (const Law law : {Law::poisson, Law::stronge})
        for (int i = 0; i < 20'000; ++i) {
            const double mu = i % 4 == 0 ? 0 : 0.5 + 0.5 * u(random);
            const auto scene =
                contact_of(scene_of(3 + i % 5, 0.5 + 0.4 * u(random), 0.5, mu, 0.5 + 0.49 * u(random), law));
            const ContactState<double> z{3 * u(random), i % 2 ? scene.widest_chi : -scene.widest_chi, u(random),
                                         2 * u(random)};
            const PostImpactState<double> completion = post_impact_state(scene, z);
            const PostImpactState<double> before = seen_from_neighbour(scene, completion);
            if (!(contact_kinematics(scene.body, before).un > 1e-3)) continue;
            const Strike<double> strike = strike_in_contact(scene, completion, false);
            ASSERT_TRUE(strike.resolved);
            ++resolved;
            // The container is heavy and moves: energy is counted in its frame.
            const auto energy = [&](const PostImpactState<double>& l) {
                const Vec2<double> v{l.vn - scene.body.beta * l.psi.y, l.vt - scene.body.beta * l.psi.x};
                return 0.5 * dot(v, v) + 0.5 * scene.body.inertia * l.spin * l.spin;
            };
            EXPECT_LE(energy(strike.after), energy(before) + 1e-14);
            EXPECT_LE(contact_kinematics(scene.body, strike.after).un, 1e-13);
            EXPECT_LE(contact_kinematics(scene.body, seen_from_neighbour(scene, strike.after)).un, 1e-13);
            EXPECT_NEAR(jacobi_of(scene.body, strike.after) - jacobi_of(scene.body, before),
                        strike.jacobi_restitution + strike.jacobi_friction, 1e-12);
        }
    std::printf("%ld strikes\n", resolved);
    EXPECT_GE(resolved, 10'000);
}

TEST(Jam, WhereTheNormalForceIsNotUniqueStopsTheSlip) {
    // Slides to the point where the numerator and the denominator of the normal force vanish together.
    const auto scene = contact_of(
        scene_of(3, 0.048062199662670724, 0.81137724721839988, 1.3105431873092972, 0.12970732048356093, Law::newton));
    const ChatterCompletion<double> completion{true, Support::vertex, {-1.792332, 0.874762935, 0.5870, -0.00356}, 0, 0,
                                               0};
    const ContactPhase<double> phase = follow_contact(scene, completion, 10);
    ASSERT_EQ(phase.finish, ContactEvent::jam) << name_of(phase.finish);
    EXPECT_TRUE(phase.resolved);
    const ContactKinematics<double> after = contact_kinematics(scene.body, phase.strike.after);
    EXPECT_NEAR(after.ut, 0, 1e-15);
    EXPECT_NEAR(after.un, 0, 1e-15);  // u_n was 0, so that Newton's law gives 0
}

TEST(Slip, IsShownAtFourPlacesOfEachStep) {
    const auto scene = contact_of(scene_of(disk_sides, 0.4, 0.5, 0.2, 0.5));
    long shown = 0;
    double last = 0;
    const ContactSink sink = [&](const ContactSums<double>& sums, Support, ContactMotion, const ContactState<double>&) {
        ++shown;
        last = sums.time;
    };
    const auto end = run_contact(scene, Support::rim, ContactMotion::sliding_forward, {0.2, 0, 1, 1}, 10.0, sink);
    EXPECT_GE(end.steps, 3);
    EXPECT_EQ(shown, 4 * end.steps);
    EXPECT_EQ(last, end.sums.time);
}

TEST(Slip, ThatTurnsAgainstItsOwnDirectionEndsAtOnce) {
    // A slip set against the direction in which the forces drive it: found on the first part of a step, not at its end.
    const auto scene = contact_of(scene_of(disk_sides, 0.4, 0.5, 0.2, 0.5));
    for (const double side : {1.0, -1.0}) {
        const auto motion = side > 0 ? ContactMotion::sliding_forward : ContactMotion::sliding_backward;
        const ContactState<double> z{side * 1.2, 0, 0, -1};  // the centrifugal force along the wall: −β sin ψ
        ASSERT_LT(side * reaction_of(scene, Support::rim, motion, z).ut_rate, 0);
        const auto end = run_contact(scene, Support::rim, motion, z, 10);
        EXPECT_EQ(end.event, ContactEvent::stick) << name_of(end.event);
        EXPECT_LE(end.sums.time, 1e-3);
    }
}

}  // namespace
}  // namespace swirl
