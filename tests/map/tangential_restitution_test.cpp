// A disk whose sticking impacts return the slip (map/README.md, "Tangential restitution"): the impact, the no-slip
// billiard in closed form, its limit of rolling, DF and ∂F, reference orbits.
#include "map/derivative/itinerary_collision.hpp"
#include "map/derivative/parameter.hpp"
#include "map/derivative/saltation.hpp"
#include "map/dragged/dragged_derivative.hpp"
#include "map/orbit/laboratory.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "map/orbit/orbit.hpp"
#include "tests/map/differentiated_map.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/map/reference_orbits.hpp"
#include "tests/references/references.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>
#include <string>

namespace swirl {
namespace {

using tests::Random;

using DiskMap = CollisionMap<double, Shape::disk, ImpactRule::poisson>;

Scene<double> disk(double alpha, double beta, double mu, double restitution, double returned, double kappa = 0.5) {
    Scene<double> scene{disk_sides, alpha, beta, mu, restitution, Law::poisson, kappa};
    scene.tangential_restitution = returned;
    return scene;
}

Scene<double> random_disk(Random& random) {
    Scene<double> scene = disk(random.between(0.05, 0.95), random.between(0, 1), random.log_between(0.01, 100),
                               random.unit(), random.unit(), random.between(0.05, 2));
    if (random.chance(0.2)) scene.restitution = 1;
    if (random.chance(0.2)) scene.tangential_restitution = 1;
    return scene;
}

/// ½u² of the body against the container whose velocity it is seen from.
double energy(const Body<double>& body, const PostImpactState<double>& z) {
    const double vn = z.vn - body.beta * z.psi.y, vt = z.vt - body.beta * z.psi.x;
    return 0.5 * (vn * vn + vt * vt + body.inertia * z.spin * z.spin);
}

TEST(TangentialRestitution, ReturnsTheSlipWithinFrictionAndGainsNoEnergy) {
    Random random(3);
    long sticking = 0, sliding = 0, conserving = 0;
    double most_gain = -1, worst_return = 0, worst_conserved = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Scene<double> scene = random_disk(random);
        const DiskMap map(scene);
        Collision<double> collision;
        const double psi = random.angle();
        collision.after = {cis(psi), {1, 0}, 0, 0, random.between(-3, 3)};
        PostImpactState<double>& z = collision.after;
        z.vn = random.between(0, 3) + scene.beta * z.psi.y;
        z.vt = random.between(-3, 3) + scene.beta * z.psi.x;
        const double before = energy(map.body(), z);
        const ContactKinematics<double> u = contact_kinematics(map.body(), z);
        map.apply_impact(collision);
        const ContactKinematics<double> after = contact_kinematics(map.body(), z);
        const double p = collision.impulse.normal, q = collision.impulse.tangential;
        const double gain = (energy(map.body(), z) - before) / before;
        most_gain = std::max(most_gain, gain);
        EXPECT_LE(gain, 4e-15);
        EXPECT_LE(std::abs(q), scene.mu * p * (1 + 1e-15));
        EXPECT_NEAR(after.un, -scene.restitution * u.un, 2e-14);
        if (ends_in_stick(collision.impulse.mode)) {
            ++sticking;
            worst_return = std::max(worst_return, std::abs(after.ut + scene.tangential_restitution * u.ut));
            if (scene.restitution == 1 && scene.tangential_restitution == 1) {
                ++conserving;
                worst_conserved = std::max(worst_conserved, std::abs(gain));
            }
        } else {
            ++sliding;
            EXPECT_DOUBLE_EQ(q, u.ut > 0 ? -scene.mu * p : scene.mu * p);
            // Friction has not enough for all of the return, in the sense of the return.
            EXPECT_GT((after.ut + scene.tangential_restitution * u.ut) * u.ut, 0);
        }
    }
    EXPECT_GT(sticking, 30'000);
    EXPECT_GT(sliding, 20'000);
    EXPECT_GT(conserving, 1000);
    EXPECT_LE(worst_return, 2e-14);
    EXPECT_LE(worst_conserved, 4e-15);
    std::printf(
        "%ld stick, %ld slide; relative gain of energy at most %.2g, at e = e_t = 1 %.2g; u_t returned to %.2g\n",
        sticking, sliding, most_gain, worst_conserved, worst_return);
}

TEST(TangentialRestitution, ZeroIsTheImpactWithoutItToTheBit) {
    Random random(4);
    for (int i = 0; i < 10'000; ++i) {
        Scene<double> scene = random_disk(random);
        scene.tangential_restitution = 0;
        const Body<double> body = make_body(scene);
        EXPECT_EQ(body.disk_grip, body.inertia / (body.inertia + body.alpha * body.alpha));
    }
}

/// An impact's linear map of (v_t, αS): q = −(1 + e_t)u_t κ/(1 + κ), and αS changes by q/κ.
std::array<double, 2> returned(double vt, double rim, double kappa, double e_t) {
    const double q = -(1 + e_t) * (vt + rim) * kappa / (1 + kappa);
    return {vt + q, rim + q / kappa};
}

/// The no-slip billiard: at β = 0 a chord keeps v_t, so that (v_t, αS) alternates between two pairs for ever and chords
/// touch two circles in turn, of radii (1 − α)|v_t|/|v| (Cox & Feres, Contemp. Math. 698 (2017) 91).
TEST(TangentialRestitution, NoSlipBilliardsHaveTwoCaustics) {
    struct Case {
        double alpha, kappa, vn, vt, spin;
    };
    const Case cases[] = {{0.3, 0.5, -0.8, 0.9, -2.1}, {0.1, 0.25, -0.31, 0.55, 4.0}, {0.7, 0.9, -1.2, -0.2, 1.3}};
    for (const Case& c : cases) {
        const Scene<double> scene = disk(c.alpha, 0, 1e6, 1, 1, c.kappa);
        const DiskMap map(scene);
        const double rho = 1 - c.alpha;
        const std::array<double, 2> even{c.vt, c.alpha * c.spin};
        const std::array<double, 2> odd = returned(even[0], even[1], c.kappa, 1);
        const double radius[2] = {rho * std::abs(even[0]) / std::hypot(even[0], c.vn),
                                  rho * std::abs(odd[0]) / std::hypot(odd[0], c.vn)};
        Collision<double> step;
        step.after = {{1, 0}, {1, 0}, c.vn, c.vt, c.spin};
        double worst = 0, worst_chord = 0;
        const long impacts = 1'000'000;
        for (long i = 0; i < impacts; ++i) {
            const PostImpactState<double>& z = step.after;
            const double touched = rho * std::abs(z.vt) / std::hypot(z.vt, z.vn);
            worst = std::max(worst, std::abs(touched - radius[i % 2]));
            map.advance(step.after, step);
            ASSERT_EQ(step.outcome, FirstContactOutcome::contact);
            // The chord itself: its distance from the centre, by the directions of its ends.
            const double chord = rho * std::sqrt(0.5 * (1 + step.normal.x));
            worst_chord = std::max(worst_chord, std::abs(chord - radius[i % 2]));
        }
        std::printf("radii %.6f and %.6f: %ld impacts within %.2g, their chords within %.2g\n", radius[0], radius[1],
                    impacts, worst, worst_chord);
        EXPECT_GT(std::abs(radius[0] - radius[1]), 0.05);
        EXPECT_LE(worst, 1e-10);
        EXPECT_LE(worst_chord, 1e-10);
    }
}

/// At e_t < 1 slip falls by e_t an impact in turns of either sign, v_t − κ αS stays, and the orbit comes to one
/// caustic.
TEST(TangentialRestitution, SlipDiesOutGeometrically) {
    const double alpha = 0.3, kappa = 0.5;
    const DiskMap map(disk(alpha, 0, 1e6, 1, 0.9, kappa));
    Collision<double> step;
    step.after = {{1, 0}, {1, 0}, -0.8, 0.9, -2.1};
    const double u = 0.9 - alpha * 2.1, kept = 0.9 + kappa * alpha * 2.1;
    double slip = u;
    for (int i = 1; i <= 300; ++i) {
        map.advance(step.after, step);
        slip *= -0.9;
        EXPECT_NEAR(step.after.vt + alpha * step.after.spin, slip, 1e-13);
        EXPECT_NEAR(step.after.vt - kappa * alpha * step.after.spin, kept, 1e-13);
    }
    EXPECT_NEAR(step.after.vt, kept / (1 + kappa), 1e-13);
}

/// J + IS/α changes by −p ū_n + q ū_t ≤ 0 alone; at e = e_t = 1 without sliding it stays.
TEST(TangentialRestitution, EnergyInTheRotatingFrameIsBalanced) {
    Random random(5);
    for (int k = 0; k < 40; ++k) {
        Scene<double> scene = random_disk(random);
        if (k % 2 == 0) scene.mu = 1e6;
        if (k % 2 == 0) scene.restitution = scene.tangential_restitution = 1;
        const DiskMap map(scene);
        const double per_spin = map.body().inertia / map.body().alpha;
        Collision<double> step;
        step.after = post_impact_state(tests::random_point(random, scene, 0.7));
        const double start = jacobi_of(map.body(), step.after) + per_spin * step.after.spin;
        double before = jacobi_of(map.body(), step.after), spin = step.after.spin;
        for (int i = 0; i < 200; ++i) {
            map.advance(step.after, step);
            if (step.outcome != FirstContactOutcome::contact) break;
            const double now = jacobi_of(map.body(), step.after);
            const double scale = 1 + std::abs(now) + std::abs(before);
            EXPECT_NEAR(now - before, step.jacobi_restitution + step.jacobi_friction, 1e-14 * scale);
            EXPECT_LE(now - before + per_spin * (step.after.spin - spin), 1e-14 * scale);
            before = now;
            spin = step.after.spin;
        }
        if (k % 2 == 0) {
            EXPECT_NEAR(before + per_spin * spin, start, 1e-12 * (1 + std::abs(start)));
        }
    }
}

/// ψ of a disk that rolls, ψ″ = −k sin ψ, from rest at `psi`, after `time`: by the classical method of order 4.
double rolled(double strength, double psi, double time) {
    const int steps = 4000;
    const double h = time / steps;
    double rate = 0;
    const auto pull = [&](double at) { return -strength * std::sin(at); };
    for (int i = 0; i < steps; ++i) {
        const double k1 = rate, l1 = pull(psi), k2 = rate + h / 2 * l1, l2 = pull(psi + h / 2 * k1),
                     k3 = rate + h / 2 * l2, l3 = pull(psi + h / 2 * k2), k4 = rate + h * l3, l4 = pull(psi + h * k3);
        psi += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        rate += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
    }
    return psi;
}

/// Rolling is the limit of no-slip bouncing: as bounces along the wall of a swirled container become small, ψ tends to
/// the pendulum of a disk that rolls (after Cox, Feres & Zhao, rolling in a cylinder; there with gravity along it).
TEST(TangentialRestitution, SmallNoSlipBouncesRoll) {
    const double alpha = 0.4, beta = 0.5, start = 0.7, until = 5;
    for (const double e_t : {1.0, 0.6}) {
        const Scene<double> scene = disk(alpha, beta, 1e6, 1, e_t);
        const DiskMap map(scene);
        const double rho = 1 - alpha, strength = beta / (1.5 * rho);
        double last = 0;
        for (const double bounce : {1e-2, 1e-3, 1e-4}) {
            Collision<double> step;
            step.after = {cis(start),
                          {1, 0},
                          beta * std::sin(start) - bounce,
                          rho + beta * std::cos(start),
                          -rho / alpha};  // ν′ = 1, no slip
            double time = 0, worst = 0, slip = 0;
            while (time < until) {
                map.advance(step.after, step);
                ASSERT_EQ(step.outcome, FirstContactOutcome::contact);
                time += step.flight_time;
                slip = std::max(slip, std::abs(contact_kinematics(map.body(), step.after).ut));
            }
            const double psi = std::atan2(step.after.psi.y, step.after.psi.x);
            worst = std::abs(psi - rolled(strength, start, time));
            std::printf("e_t = %g, bounces of %g: psi off by %.2g after t = 5, slip up to %.2g\n", e_t, bounce, worst,
                        slip);
            EXPECT_LE(worst, 0.2 * bounce);
            EXPECT_LE(slip, 4 * bounce);
            if (bounce < 1e-2) {
                EXPECT_LE(worst, 0.3 * last);
            }
            last = worst;
        }
    }
}

TEST(TangentialRestitution, DerivativesAgree) {
    Random random(6);
    std::array<long, 6> count{};
    double worst = 0, worst_along = 0;
    for (int i = 0; i < 3000; ++i) {
        const Scene<double> scene = random_disk(random);
        const DiskMap map(scene);
        const SectionPoint<double> z = tests::random_point(random, scene, random.log_between(0.05, 2));
        const auto jets = tests::DifferentiatedMap(map).linearise(z);
        if (jets.collision.outcome != FirstContactOutcome::contact) continue;
        if (-contact_kinematics(map.body(), jets.collision.after).un < 1e-3) continue;
        const auto by_hand = linearise_by_saltation(map, z);
        const double scale = by_hand.derivative.cwiseAbs().maxCoeff();
        worst = std::max(worst, (jets.derivative - by_hand.derivative).cwiseAbs().maxCoeff() / scale);
        ++count[static_cast<std::size_t>(jets.collision.impulse.mode)];

        // Along e_t in closed form: ∂q = −u_t/B₁ where it sticks, u_t that before.
        const auto along =
            derivative_along(map, Parameter::tangential_restitution, post_impact_state(z), jets.collision);
        double dq = 0;
        if (ends_in_stick(jets.collision.impulse.mode))
            dq = jets.collision.impulse.tangential / (1 + scene.tangential_restitution);
        const std::array<double, 4> exact{0, 0, dq, scene.alpha * dq * map.body().inverse_inertia};
        for (int k = 0; k < 4; ++k)
            worst_along = std::max(worst_along, std::abs(along[k] - exact[static_cast<std::size_t>(k)]) /
                                                    (1 + std::abs(exact[static_cast<std::size_t>(k)])));
    }
    std::printf("DF by hand and by Jets within %.2g, along e_t within %.2g\n", worst, worst_along);
    EXPECT_LE(worst, 1e-11);
    EXPECT_LE(worst_along, 1e-13);
    for (const ContactMode mode : {ContactMode::sliding, ContactMode::c_sticking, ContactMode::r_sticking})
        EXPECT_GT(count[static_cast<std::size_t>(mode)], 100) << name_of(mode);
}

/// What decides the contact mode changes sign where the mode changes: (1 + e_t)|u_t| = μB₁(1 + e)u_n, and μB₁u_n.
TEST(TangentialRestitution, MarginsTellTheMode) {
    Random random(9);
    std::array<int, 6> count{};
    for (int i = 0; i < 1500; ++i) {
        const Scene<double> scene = random_disk(random);
        const DiskMap map(scene);
        const SectionPoint<double> z = tests::random_point(random, scene, random.log_between(0.05, 2));
        const Collision<double> collision = map.advance(post_impact_state(z));
        if (collision.outcome != FirstContactOutcome::contact) continue;
        const auto named = collide_by_itinerary<double, Shape::disk, ImpactRule::poisson>(
            scene, Parameter::mu, Parameter::tangential_restitution, z, collision.flight_time, 0);
        ASSERT_EQ(named.mode, collision.impulse.mode);
        EXPECT_EQ(named.margins.slip > 0, named.mode == ContactMode::sliding);
        if (named.mode != ContactMode::sliding) {
            EXPECT_EQ(named.margins.late < 0, named.mode == ContactMode::c_sticking);
        }
        ++count[static_cast<std::size_t>(named.mode)];
    }
    for (const ContactMode mode : {ContactMode::sliding, ContactMode::c_sticking, ContactMode::r_sticking})
        EXPECT_GT(count[static_cast<std::size_t>(mode)], 30) << name_of(mode);
}

/// At e = e_t = 1 without sliding F keeps volumes but for u_n, as without friction: |det DF| = u_n(z)/u_n(F(z)).
TEST(TangentialRestitution, KeepsVolumes) {
    Random random(7);
    int looked = 0;
    for (int i = 0; i < 500; ++i) {
        const Scene<double> scene =
            disk(random.between(0.05, 0.9), random.between(0, 1), 1e6, 1, 1, random.between(0.1, 1));
        const DiskMap map(scene);
        const SectionPoint<double> z = tests::random_point(random, scene, random.log_between(0.05, 2));
        const auto step = linearise_by_saltation(map, z);
        if (step.collision.outcome != FirstContactOutcome::contact) continue;
        const double before = contact_kinematics(map.body(), post_impact_state(z)).un,
                     after = contact_kinematics(map.body(), step.collision.after).un;
        if (after > -1e-3) continue;
        EXPECT_NEAR(std::abs(step.derivative.determinant()) * after / before, 1, 1e-9);
        ++looked;
    }
    EXPECT_GT(looked, 300);
}

/// Over a floor that drags the impact is the same, and γ → 0 joins.
TEST(TangentialRestitution, GoesWithAFloorThatDrags) {
    Random random(8);
    for (int i = 0; i < 200; ++i) {
        Scene<double> scene = disk(random.between(0.05, 0.9), random.between(0.1, 1), 1, 0.9, random.unit());
        const SectionPoint<double> z = tests::random_point(random, scene, 0.5);
        const Collision<double> plain = DiskMap(scene).advance(post_impact_state(z));
        if (plain.outcome != FirstContactOutcome::contact) continue;
        scene.drag = 1e-13;
        const DraggedMap<double, Shape::disk, ImpactRule::poisson> dragged(scene);
        const Collision<double> step = dragged.advance(post_impact_state(z));
        ASSERT_EQ(step.outcome, FirstContactOutcome::contact);
        EXPECT_EQ(step.impulse.mode, plain.impulse.mode);
        EXPECT_NEAR(step.impulse.tangential, plain.impulse.tangential, 1e-11);
        const auto with = derivative_by_saltation(dragged, post_impact_state(z), step);
        const auto without = derivative_by_saltation(DiskMap(scene_in<double>([&] {
                                                         Scene<double> still = scene;
                                                         still.drag = 0;
                                                         return still;
                                                     }())),
                                                     post_impact_state(z), plain);
        EXPECT_LE((with - without).cwiseAbs().maxCoeff(), 1e-10 * without.cwiseAbs().maxCoeff());
    }
}

/// A steady mode has no slip: those at e = 1 are the same for every e_t.
TEST(TangentialRestitution, SteadyModesAreThoseWithoutIt) {
    const double alpha = 0.3, beta = 0.1, tau = 1.4, inner = 1 - alpha + beta;
    const double spin = (beta - inner * std::sin(tau) / tau) / alpha, speed = 2 * inner * std::sin(tau / 2) / tau;
    for (const double e_t : {0.0, 0.4, 1.0}) {
        const DiskMap map(disk(alpha, beta, 0.5, 1, e_t));
        const SectionPoint<double> z{0, 0, -speed * std::sin(tau / 2), speed * std::cos(tau / 2), spin};
        const SectionPoint<double> next = section_point(map.advance(post_impact_state(z)).after);
        EXPECT_NEAR(next.psi, 0, 1e-14) << e_t;
        EXPECT_NEAR(next.vn, z.vn, 1e-14) << e_t;
        EXPECT_NEAR(next.vt, z.vt, 1e-14) << e_t;
        EXPECT_NEAR(next.spin, z.spin, 1e-14) << e_t;
    }
}

TEST(TangentialRestitution, IsRefusedForPolygons) {
    Scene<double> scene = disk(0.4, 0.5, 0.5, 0.9, 0.5);
    scene.sides = 6;
    try {
        validated(scene);
        FAIL() << "a hexagon was taken";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("tangential-restitution = 0.5"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("B_3"), std::string::npos);
    }
    for (const double wrong : {-0.1, 1.1, std::nan("")})
        EXPECT_THROW(validated(disk(0.4, 0.5, 0.5, 0.9, wrong)), std::invalid_argument) << wrong;
}

/// A disk at e < 1 comes to the wall and rolls there whatever e_t is: u_t = 0 stays 0.
TEST(TangentialRestitution, LastingContactRolls) {
    for (const double e_t : {0.3, 1.0}) {
        const DiskMap map(disk(0.35, 0.6, 0.5, 0.5, e_t));
        Orbit orbit(map, LabStart<double>{0.6, 0, 0.12, 0.07, 0, 0.4});
        while (orbit.advance() && orbit.impacts() < 10'000) {
        }
        ASSERT_EQ(orbit.outcome(), Outcome::in_contact) << e_t;
        ASSERT_FALSE(orbit.contacts().empty());
        const ContactSegment& last = orbit.contacts().back();
        EXPECT_EQ(last.motion, ContactMotion::sticking) << e_t;
        EXPECT_NEAR(last.to.ut, 0, 1e-15) << e_t;
    }
}

/// The 20 orbits of tests/references/tangential_trajectories.json.
template <class T>
void reproduce(const tests::Tolerance& tolerance, int least) {
    tests::reproduce<T>("tangential_trajectories.json", tolerance, 20, least,
                        [](const Collision<T>& collision, const nlohmann::json& row, int k) {
                            EXPECT_EQ(collision.impulse.mode == ContactMode::sliding, row["slides"].get<bool>())
                                << "impact " << k;
                        });
}

TEST(TangentialRestitution, ReferenceOrbitsAreReproducedInDouble) {
    reproduce<double>({1e-13, 1e-12, 1e10}, 200);
}
TEST(TangentialRestitution, ReferenceOrbitsAreReproducedInLongDouble) {
    reproduce<long double>({1e-13 / 2048, 1e-12 / 2048, 1e13}, 200);
}
TEST(TangentialRestitution, ReferenceOrbitsAreReproducedInQuad) {
    reproduce<Quad>({1e-24, 1e-22, HUGE_VAL}, 240);
}

}  // namespace
}  // namespace swirl
