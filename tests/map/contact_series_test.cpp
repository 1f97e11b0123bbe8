// The power series of contact motions against the forces themselves, stepped by GSL's Runge–Kutta.
#include "map/contact/contact_series.hpp"
#include "map/contact/reaction.hpp"
#include "tests/map/contact_scenes.hpp"
#include "tests/map/random_scenes.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace swirl {
namespace {

using enum ContactMotion;

struct Case {
    ContactScene<double> scene;
    Support support;
    ContactMotion motion;
    ContactState<double> start;
};

Case random_case(tests::Random& random, Support support, ContactMotion motion) {
    const int sides = support == Support::rim ? disk_sides : random.one_of({3, 4, 5, 12});
    const double mu = motion != sliding_forward || random.chance(0.7) ? random.between(0.1, 0.6) : 0;
    Case c{tests::contact_of(tests::uniform_scene(sides, random.between(0.1, 0.9), random.between(0.05, 1), mu, 0.5)),
           support,
           motion,
           {}};
    c.start.psi = random.angle();
    c.start.spin = random.between(-2, 2);
    if (support == Support::vertex) c.start.chi = 0.9 * c.scene.widest_chi * random.between(-1, 1);
    if (support == Support::edge) c.start.chi = -c.scene.widest_chi;
    if (motion == sliding_forward) c.start.ut = random.between(0.2, 1);
    if (motion == sliding_backward) c.start.ut = -random.between(0.2, 1);
    if (support == Support::edge) c.start.spin = c.start.ut;
    return c;
}

int rates(double, const double y[], double out[], void* parameters) {
    const auto& c = *static_cast<const Case*>(parameters);
    const ContactState<double> z{y[0], y[1], y[2], y[3]};
    const Reaction<double> r = reaction_of(c.scene, c.support, c.motion, z);
    const double turning = normal_rate(c.scene, c.support, z);
    out[0] = turning - 1;
    out[1] = c.support == Support::vertex ? z.spin - turning : 0;
    out[2] = r.ut_rate;
    out[3] = r.spin_rate;
    out[4] = z.spin;
    out[5] = r.friction * (z.ut - 1);
    return GSL_SUCCESS;
}

/// The motion a time later, in forty steps of order eight.
std::array<double, 6> by_runge_kutta(Case& c, double time) {
    constexpr int steps = 40;
    gsl_odeiv2_system system{&rates, nullptr, 6, &c};
    gsl_odeiv2_step* step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 6);
    std::array<double, 6> y{c.start.psi, c.start.chi, c.start.ut, c.start.spin, 0, 0}, error{};
    for (int i = 0; i < steps; ++i)
        gsl_odeiv2_step_apply(step, 0, time / steps, y.data(), error.data(), nullptr, nullptr, &system);
    gsl_odeiv2_step_free(step);
    return y;
}

TEST(ContactSeries, IsWhatRungeKuttaFindsByTheForces) {
    tests::Random random(3);
    double worst = 0;
    long checked = 0;
    for (const Support support : {Support::rim, Support::vertex, Support::edge})
        for (const ContactMotion motion : {sliding_forward, sliding_backward, sticking})
            for (int i = 0; i < 300; ++i) {
                Case c = random_case(random, support, motion);
                if (reaction_of(c.scene, support, motion, c.start).stiffness < 0.2) continue;
                const ContactSeries<double> series = contact_series(c.scene, support, motion, c.start);
                const double h = std::min(step_of(series, 1e-16), 0.5);
                const auto y = by_runge_kutta(c, h);
                const Series<double>* parts[] = {&series.psi,  &series.chi,    &series.ut,
                                                 &series.spin, &series.turned, &series.work};
                for (std::size_t k = 0; k < 6; ++k)
                    worst = std::max(worst,
                                     std::abs((*parts[k])[0] + change_at(*parts[k], h) - y[k]) / (1 + std::abs(y[k])));
                ++checked;
            }
    std::printf("%ld motions: largest difference after a step %.1e\n", checked, worst);
    EXPECT_GE(checked, 2000);
    EXPECT_LE(worst, 2e-14);  // rounding of 40 steps
}

TEST(ContactSeries, HasTheForcesOfEveryMomentOfAStep) {
    tests::Random random(4);
    double worst = 0;
    for (const Support support : {Support::rim, Support::vertex, Support::edge})
        for (const ContactMotion motion : {sliding_forward, sliding_backward, sticking})
            for (int i = 0; i < 300; ++i) {
                const Case c = random_case(random, support, motion);
                if (reaction_of(c.scene, support, motion, c.start).stiffness < 0.2) continue;
                if (support == Support::edge && motion == sticking) continue;  // not unique: no series
                const ContactSeries<double> s = contact_series(c.scene, support, motion, c.start);
                const double t = 0.9 * std::min(step_of(s, 1e-16), 0.5);
                const auto at = [&](const Series<double>& series) { return series[0] + change_at(series, t); };
                const Reaction<double> r =
                    reaction_of(c.scene, support, motion, {at(s.psi), at(s.chi), at(s.ut), at(s.spin)});
                const double size = 1 + std::abs(r.normal) + std::abs(r.second) + std::abs(r.friction);
                worst =
                    std::max({worst, std::abs(at(s.normal) - r.normal) / size, std::abs(at(s.second) - r.second) / size,
                              std::abs(at(s.friction) - r.friction) / size});
                if (support == Support::vertex && motion != sticking)
                    worst = std::max(worst, std::abs(at(s.stiffness) - r.stiffness));
                EXPECT_LE(std::abs(at(s.normal) - s.normal[0]), reach_of(s.normal, t) * (1 + 1e-12) + 1e-300);
            }
    std::printf("largest difference of a force %.1e\n", worst);
    EXPECT_LE(worst, 1e-14);  // its series ends an order earlier than the motion's; measured 9e-16
}

}  // namespace
}  // namespace swirl
