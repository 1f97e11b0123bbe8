// Sustained contact: pendulum oracles, forces against geometry, energy, and that every orbit ends with a name.
#include "map/orbit.hpp"
#include "map/sustained/motion_choice.hpp"
#include "tests/map/contact_scenes.hpp"
#include "tests/sample_count.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/tools/roots.hpp>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <tuple>

namespace swirl {
namespace {

using tests::contact_of;

Scene<double> scene_of(int sides, double alpha, double beta, double mu, double e, Law law = Law::poisson) {
    return tests::uniform_scene(sides, alpha, beta, mu, e, law);
}

// ---- the disk is a pendulum

/// ψ at time t of ψ″ = −ω² sin ψ from ψ = 0 with ψ′ = 2ωk, k < 1 (libration) or > 1 (circulation).
double pendulum(double omega, double k, double t) {
    double cn, dn;
    if (k < 1) return 2 * std::asin(k * boost::math::jacobi_elliptic(k, omega * t, &cn, &dn));
    // sin(ψ/2) = sn(ωk t, 1/k); the number of half turns from the period.
    const double quarter = boost::math::ellint_1(1 / k) / (omega * k);  // ψ: 0 → π
    const double turns = std::floor((t + quarter) / (2 * quarter));
    const double rest = t - 2 * quarter * turns;
    return 2 * pi<double>() * turns + 2 * std::asin(boost::math::jacobi_elliptic(1 / k, omega * k * rest, &cn, &dn));
}

TEST(DiskInContact, IsAPendulumForAHundredPeriods) {
    for (const double mu : {0.0, 5.0})
        for (const double k : {0.1, 0.7, 0.99, 1.2}) {
            const auto scene = contact_of(scene_of(disk_sides, 0.4, 0.05, mu, 0.5));
            const double rho = 0.6, kappa = 0.5;
            const double omega = std::sqrt(0.05 / (rho * (mu > 0 ? 1 + kappa : 1)));
            // Going round with ψ′ > 0 the wall presses all the time.
            ContactState z{0, 0, 0, mu > 0 ? 0 : 0.7};
            const double rate = 2 * omega * k;
            if (mu > 0) z.spin = -rho * (1 + rate) / 0.4;
            else z.ut = rho * (1 + rate) + 0.4 * z.spin;
            const auto motion = mu > 0 ? ContactMotion::sticking : ContactMotion::sliding_forward;
            const double period = 4 * boost::math::ellint_1(k < 1 ? k : 1 / k) / (omega * std::max(1.0, k));
            double largest = 0;
            const auto end = run_contact(scene, Support::rim, motion, z, 100 * period,
                                         [&](const ContactSums& sums, Support, ContactMotion, const ContactState& at) {
                                             largest =
                                                 std::max(largest, std::abs(at.psi - pendulum(omega, k, sums.time)));
                                         });
            EXPECT_EQ(end.event, ContactEvent::horizon) << name_of(end.event);
            std::printf("disk, mu = %g, k = %g: largest error of psi over 100 periods %.1e\n", mu, k, largest);
            // Near the separatrix (k = 0.99) a rounding of the start grows with time like the period's derivative does.
            EXPECT_LE(largest, 1e-10);
            if (mu > 0)
                EXPECT_NEAR(end.state.spin, -rho * (1 + (normal_rate(scene, Support::rim, end.state) - 1)) / 0.4,
                            1e-12);
            else EXPECT_EQ(end.state.spin, 0.7);
        }
}

TEST(DiskInContact, LibratesWithTheExactMeanSpin) {
    const auto scene = contact_of(scene_of(disk_sides, 0.4, 0.3, 5, 0.5));
    const double omega = std::sqrt(0.3 / 0.9), k = 0.6;
    const double period = 4 * boost::math::ellint_1(k) / omega;
    const auto end =
        run_contact(scene, Support::rim, ContactMotion::sticking, {0, 0, 0, -1.5 * (1 + 2 * omega * k)}, 50 * period);
    EXPECT_NEAR(end.sums.turned / end.sums.time, -1.5, 1e-12);
}

TEST(DiskInContact, IsReleasedWhereTheNormalForceVanishes) {
    // λ = β cos ψ + ρ(1 + ψ′)² with ψ′² = 2(H + ω² cos ψ), ψ′ < 0 on the way: both roots in closed form but for one
    // solve.
    for (const double mu : {0.0, 50.0}) {
        const double beta = 2, rho = 0.6, omega2 = beta / (rho * (mu > 0 ? 1.5 : 1));
        const auto scene = contact_of(scene_of(disk_sides, 0.4, beta, mu, 0.5));
        const double start_rate = -1.7 * std::sqrt(omega2);
        const double energy = 0.5 * start_rate * start_rate - omega2;
        const auto rate_at = [&](double psi) { return -std::sqrt(2 * (energy + omega2 * std::cos(psi))); };
        const auto lambda = [&](double psi) { return beta * std::cos(psi) + rho * std::pow(1 + rate_at(psi), 2); };
        std::uintmax_t iterations = 100;
        const auto [a, b] = boost::math::tools::toms748_solve(
            lambda, -1.87, -0.5, boost::math::tools::eps_tolerance<double>(52), iterations);
        ContactState z{0, 0, 0, mu > 0 ? -rho * (1 + start_rate) / 0.4 : 0};
        if (mu == 0) z.ut = rho * (1 + start_rate);
        const auto motion = mu > 0 ? ContactMotion::sticking : ContactMotion::sliding_forward;
        const auto end = run_contact(scene, Support::rim, motion, z, 100);
        if (mu > 0) {  // friction lets go just before: μλ = |f|
            EXPECT_EQ(end.event, ContactEvent::slip);
            continue;
        }
        ASSERT_EQ(end.event, ContactEvent::release);
        EXPECT_NEAR(end.state.psi, 0.5 * (a + b), 1e-11);
        // t = ∫ dψ/ψ′ = F(φ, k)/ω with sin φ = sin(ψ/2)/k
        const double k = std::abs(start_rate) / (2 * std::sqrt(omega2));
        const double time = boost::math::ellint_1(k, std::asin(std::sin(-end.state.psi / 2) / k)) / std::sqrt(omega2);
        EXPECT_NEAR(end.sums.time, time, 1e-10);
        std::printf("release at psi = %.12f, t = %.12f\n", end.state.psi, end.sums.time);
    }
}

// ---- forces against geometry: the lab position's second difference is the force

struct Place {
    Vec2<double> centre;  ///< in the laboratory
    double angle;         ///< of the body
    Vec2<double> n, n2;   ///< contact normals
};

Place place_of(const ContactScene& scene, Support support, const ContactState& z, double t) {
    const double nu = z.psi + t;
    Place place;
    place.n = cis(nu);
    place.n2 = cis(nu + 2 * scene.half_chord);
    const double arm = nu + z.chi;
    place.centre = scene.body.beta * cis(t) + (support == Support::rim ? scene.body.inner * cis(nu)
                                                                       : cis(nu) - scene.body.alpha * cis(arm));
    place.angle = arm;
    return place;
}

TEST(Reaction, IsWhatTheGeometryNeeds) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> u(-1, 1);
    const double h = 1e-3;
    long checked = 0;
    double worst = 0;
    for (const Support support : {Support::rim, Support::vertex, Support::edge})
        for (const ContactMotion motion :
             {ContactMotion::sliding_forward, ContactMotion::sliding_backward, ContactMotion::sticking})
            for (int i = 0; i < 200; ++i) {
                const int sides = support == Support::rim ? disk_sides : 3 + i % 4;
                const auto scene = contact_of(scene_of(sides, 0.35 + 0.3 * u(random), 0.5 + 0.4 * u(random), 0.3, 0.5));
                ContactState z{3 * u(random), 0, 0, u(random)};
                if (support == Support::vertex) z.chi = 0.5 * scene.widest_chi * u(random);
                if (support == Support::edge) z.chi = -scene.widest_chi;
                if (motion == ContactMotion::sliding_forward) z.ut = 0.5 + 0.3 * u(random);
                if (motion == ContactMotion::sliding_backward) z.ut = -0.5 + 0.3 * u(random);
                if (support == Support::edge) z.spin = z.ut;
                const auto now = run_contact(scene, support, motion, z, h),
                           later = run_contact(scene, support, motion, z, 2 * h);
                if (now.event != ContactEvent::horizon || later.event != ContactEvent::horizon) continue;
                const Reaction r = reaction_of(scene, support, motion, now.state);
                if (r.stiffness < 0.05) continue;
                const Place p0 = place_of(scene, support, z, 0), p1 = place_of(scene, support, now.state, h),
                            p2 = place_of(scene, support, later.state, 2 * h);
                const Vec2<double> acceleration = (1 / (h * h)) * (p0.centre - p1.centre + (p2.centre - p1.centre));
                // A disk's orientation is what its spin has turned.
                const double turning = support == Support::rim ? (later.sums.turned - 2 * now.sums.turned) / (h * h) :
                    (wrapped_angle(p2.angle - p1.angle) - wrapped_angle(p1.angle - p0.angle)) / (h * h);
                Vec2<double> force = r.friction * quarter_turned(p1.n) - r.normal * p1.n;
                if (support == Support::edge) {
                    const double smu = motion == ContactMotion::sticking          ? 0
                                       : motion == ContactMotion::sliding_forward ? 0.3
                                                                                  : -0.3;
                    const double f1 = motion == ContactMotion::sticking ? 0.5 * r.friction : -smu * r.normal;
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
            const ContactState z{3 * u(random), i % 2 ? scene.widest_chi : -scene.widest_chi, u(random), 2 * u(random)};
            const Launch<double> standing = launch_from(scene, z);
            const Launch<double> before = seen_from_neighbour(scene, standing);
            if (!(approach_of(scene.body, before).un > 1e-3)) continue;
            const Strike strike = strike_while_standing(scene, standing, false);
            ASSERT_TRUE(strike.resolved);
            ++resolved;
            // The container is heavy and moves: energy is counted in its frame.
            const auto energy = [&](const Launch<double>& l) {
                const Vec2<double> v{l.vn - scene.body.beta * l.psi.y, l.vt - scene.body.beta * l.psi.x};
                return 0.5 * dot(v, v) + 0.5 * scene.body.inertia * l.spin * l.spin;
            };
            EXPECT_LE(energy(strike.after), energy(before) + 1e-14);
            EXPECT_LE(approach_of(scene.body, strike.after).un, 1e-13);
            EXPECT_LE(approach_of(scene.body, seen_from_neighbour(scene, strike.after)).un, 1e-13);
            EXPECT_NEAR(jacobi_of(scene.body, strike.after) - jacobi_of(scene.body, before),
                        strike.jacobi_restitution + strike.jacobi_friction, 1e-12);
        }
    std::printf("%ld strikes\n", resolved);
    EXPECT_GE(resolved, 10'000);
}

// ---- whole orbits

struct Tally {
    Outcome outcome = Outcome::completed;
    long impacts = 0, pieces = 0;
    double time = 0;
    double balance = 0;    ///< |ΔJ − what contacts and impacts say|
    double exchanged = 0;  ///< Σ |parts|
    long moments = 0;      ///< looked at by the searches for contact
    long steps = 0;        ///< of contact motions
    double outside = 0;    ///< the farthest that a vertex was outside, at impacts and along contacts
};

/// Follows an orbit until a time; contact that goes on counts as completed.
Tally follow(const Scene<double>& scene, const LabStart<double>& start, double until, long most = 1'000'000'000) {
    return with_collision_map(scene, [&](const auto& map) {
        Tally tally;
        const ContactScene contact = contact_of(scene);
        const auto& body = map.body();
        const auto look = [&](const ContactSums&, Support support, ContactMotion, const ContactState& z) {
            if (support == Support::vertex)
                tally.outside = std::max(tally.outside, std::abs(z.chi) - contact.widest_chi);
        };
        Orbit orbit(map, start);
        double jacobi = 0;
        bool known = false;
        while (tally.time < until && orbit.impacts() < most) {
            const bool went_on = orbit.advance(until - tally.time, look);
            tally.pieces += static_cast<long>(orbit.contacts().size());
            for (const ContactSegment& segment : orbit.contacts()) tally.steps += segment.steps;
            if (!went_on) {
                tally.outcome = orbit.outcome();
                if (tally.outcome == Outcome::in_contact) tally.time = until;
                break;
            }
            tally.time = orbit.frame().time.unwound();
            const double now = jacobi_of(body, orbit.launch());
            const auto& c = orbit.collision();
            tally.moments += c.steps;
            const double change = c.jacobi_restitution + c.jacobi_friction + orbit.passage().contact_work;
            if (known) tally.balance += now - jacobi - change;
            tally.exchanged +=
                std::abs(c.jacobi_restitution) + std::abs(c.jacobi_friction) + std::abs(orbit.passage().contact_work);
            jacobi = now;
            known = true;
            if (body.sides == disk_sides) continue;
            const Flight<double> flight = flight_from(body, orbit.launch());
            detail::NearestTwo<double> pair;
            detail::look_around(body, flight, instant_at_start(flight), pair);
            tally.outside = std::max({tally.outside, pair.first.gap.value, pair.second.gap.value});
        }
        tally.impacts = orbit.impacts();
        return tally;
    });
}

void check_plastic_polygons(double until, int starts) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> u(-1, 1);
    for (const int sides : {3, 4, 6, 12}) {
        long impacts = 0, pieces = 0;
        double outside = 0, balance = 0;
        for (int i = 0; i < starts; ++i) {
            const double mu = 0.2 * (i % 5);
            const auto tally = follow(scene_of(sides, 0.5, 0.4, mu, 0),
                                      {0.4, 0, 0.4 * u(random), 0.4 * u(random), u(random), u(random)}, until);
            EXPECT_TRUE(tally.outcome == Outcome::completed || tally.outcome == Outcome::in_contact)
                << sides << " sides, mu = " << mu << ", start " << i << ": " << name_of(tally.outcome)
                << " at t = " << tally.time;
            EXPECT_LE(tally.outside, 1e-12) << sides << " sides, start " << i;
            if (tally.exchanged > 0) balance = std::max(balance, std::abs(tally.balance) / tally.exchanged);
            outside = std::max(outside, tally.outside);
            impacts += tally.impacts;
            pieces += tally.pieces;
        }
        std::printf("e = 0, %2d sides: %ld impacts, %ld pieces of contact, outside by %.1e, balance of J %.1e\n", sides,
                    impacts, pieces, outside, balance);
        EXPECT_LE(balance, 1e-9);
        EXPECT_GT(pieces, 0);
    }
}

TEST(PlasticPolygons, GoOnWithoutAStall) { check_plastic_polygons(200, 5); }
TEST(PlasticPolygonsNightly, GoOnWithoutAStallForAHundredThousandTimeUnits) { check_plastic_polygons(1e5, 20); }

/// How an orbit ends, and what its contacts ended with on the way.
Tally follow_scene(const Scene<double>& scene, double vx, double vy, double angle, double until) {
    return follow(scene, {scene.beta, 0, vx, vy, angle, 0}, until, 1'000'000);
}

TEST(Neighbours, ReboundsBelowTheRoundingOfChiComeToAnEnd) {
    // The neighbour's rebounds shrink by 0.7 % and 3.4 % only: at 1e-8 their height is below the rounding of chi, and
    // they must go on shrinking.
    for (const auto& [scene, vx, vy, angle] :
         {std::tuple{scene_of(4, 0.41712226908475114, 0.43283562139156206, 0, 0.99294724955325364, Law::stronge),
                     -0.14268421102509951, 0.0070270327629084481, 4.2893516925134403},
          std::tuple{scene_of(3, 0.79128475430725587, 0.3056057361677636, 0, 0.96642109975151236, Law::newton),
                     0.10290581510475638, 0.099088629433108102, 1.9993280238152451}}) {
        const Tally tally = follow_scene(scene, vx, vy, angle, 1000);
        EXPECT_LE(tally.impacts, 20'000);
        EXPECT_EQ(tally.time, 1000);
    }
}

TEST(Release, CloseToAStrikeOfTheNeighbourIsResolved) {
    // A vertex is released 1e-4 before its neighbour strikes: its gap is below 1e-16 all the way.
    const auto scene =
        scene_of(8, 0.36454827658835726, 0.866862777474248, 1.8310345267194184, 0.043470744687158516);
    const Tally tally = follow_scene(scene, 0.023506691470764139, -0.14090989575400453, 1.005305731755205, 300);
    EXPECT_EQ(tally.outcome, Outcome::completed) << name_of(tally.outcome) << " at t = " << tally.time;
}

TEST(Rocking, ThatFrictionStopsEndsAtRest) {
    // On this edge no sliding is consistent: what rocking leaves of slip must not end the contact.
    const auto scene =
        scene_of(4, 0.13418721697544064, 0.28448658488686412, 1.9592219650602412, 0, Law::newton);
    const Tally tally = follow_scene(scene, -0.11763498469767016, -0.081056607630007757, 5.9218009112310632, 300);
    EXPECT_TRUE(tally.outcome == Outcome::completed || tally.outcome == Outcome::in_contact)
        << name_of(tally.outcome) << " at t = " << tally.time;
}

TEST(Jam, WhereTheNormalForceIsNotUniqueStopsTheSlip) {
    // Slides to the point where the numerator and the denominator of the normal force vanish together.
    const auto scene = contact_of(scene_of(3, 0.048062199662670724, 0.81137724721839988, 1.3105431873092972,
                                           0.12970732048356093, Law::newton));
    const Standing standing{true, Support::vertex, {-1.792332, 0.874762935, 0.5870, -0.00356}, 0, 0, 0};
    const ContactPhase phase = follow_contact(scene, standing, 10);
    ASSERT_EQ(phase.finish, ContactEvent::jam) << name_of(phase.finish);
    EXPECT_TRUE(phase.resolved);
    const Approach<double> after = approach_of(scene.body, phase.strike.after);
    EXPECT_NEAR(after.ut, 0, 1e-15);
    EXPECT_LE(after.un, 0);
    EXPECT_GE(after.un, -1e-8);  // Newton's law: nothing approached; the border is taken 1e-9 early
}

/// The first `shapes` of the list; the last one, N = 1000, rolls on its vertices with thousands of impacts per unit of
/// time.
void check_random_scenes(int count, int shapes) {
    std::mt19937_64 random(2026);
    std::uniform_real_distribution<double> unit(0, 1);
    std::map<std::string, long> outcomes;
    std::vector<double> cost, work;
    double busiest = 0, outside = 0, balance = 0;
    for (int i = 0; i < count; ++i) {
        const int sides[] = {disk_sides, 3, 4, 5, 6, 8, 12, 20, 50, 1000};
        const auto scene = scene_of(sides[i % shapes], 0.02 + 0.96 * unit(random), 2 * unit(random) * unit(random),
                                    i % 7 == 0 ? 0 : 2 * unit(random),
                                    i % 11 == 0   ? 0
                                    : i % 11 == 1 ? 1
                                                  : unit(random),
                                    static_cast<Law>(i % 3));
        const double direction = 2 * pi<double>() * unit(random);
        const LabStart<double> start{scene.beta,       0, std::cos(direction) / 7, std::sin(direction) / 7,
                                     6 * unit(random), 0};
        const auto began = std::chrono::steady_clock::now();
        const auto tally = follow(scene, start, 1000, 5'000'000);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        std::string name(name_of(tally.outcome));
        if (tally.outcome == Outcome::completed && tally.time < 1000) name = "too many impacts";
        ++outcomes[name];
        EXPECT_TRUE(name != "too many impacts" && (name != "diverged" || scene.law == Law::newton))
            << name << ": N = " << scene.sides << " alpha " << scene.alpha << " beta " << scene.beta << " mu " << scene.mu
            << " e " << scene.restitution << " law " << name_of(scene.law) << " after " << tally.impacts << " impacts, t = "
            << tally.time << ", start vx = " << start.vx << " vy = " << start.vy << " angle = " << start.angle;
        const double events = static_cast<double>(tally.impacts + tally.pieces);
        busiest = std::max(busiest, events / 1000);
        cost.push_back(seconds / (events + 1000));
        work.push_back(static_cast<double>(tally.moments + tally.steps) / (events + 1000));
        outside = std::max(outside, tally.outside);
        if (tally.exchanged > 0 && scene.beta > 0)
            balance = std::max(balance, std::abs(tally.balance) / (tally.exchanged + 1));
    }
    for (const auto& [name, n] : outcomes) std::printf("%-18s %ld\n", name.c_str(), n);
    EXPECT_EQ(outcomes["unresolved"], 0);
    std::sort(cost.begin(), cost.end());
    std::printf(
        "most events per unit time %.0f; seconds per event (and unit of time): median %.1e, largest %.1e (%.1f "
        "medians); outside by %.1e; balance %.1e\n",
        busiest, cost[cost.size() / 2], cost.back(), cost.back() / cost[cost.size() / 2], outside, balance);
    std::sort(work.begin(), work.end());
    std::printf("moments and steps per event (and unit of time): median %.2f, largest %.1f (%.1f medians)\n",
                work[work.size() / 2], work.back(), work.back() / work[work.size() / 2]);
    EXPECT_LE(work.back(), 20 * work[work.size() / 2]);
    // By the clock a fast disk's pendulum, 20 series of 1 us per unit of time, costs 35 medians of 0.6 us; and others
    // use the machine.
    EXPECT_LE(cost.back(), 60 * cost[cost.size() / 2]);
    EXPECT_LE(outside, 1e-12);
}

TEST(RandomScenes, EveryOneEndsWithAName) { check_random_scenes(static_cast<int>(tests::sample_count(200)), 9); }
TEST(RandomScenesNightly, EveryOneOfTwentyThousandEndsWithAName) { check_random_scenes(20'000, 10); }

}  // namespace
}  // namespace swirl
