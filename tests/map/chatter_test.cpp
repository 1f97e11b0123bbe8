// The chatter completion against the sequence of impacts, followed one by one in 113 bits.
#include "map/orbit/orbit.hpp"
#include "map/sustained/chatter_completion.hpp"
#include "map/sustained/motion_choice.hpp"
#include "tests/map/contact_scenes.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace swirl {
namespace {

/// The limit of a sequence of impacts, followed until its remainder is below 10⁻²⁰.
struct Accumulation {
    bool found = false;
    double time = 0, psi = 0, chi = 0, ut = 0, spin = 0;
};

Accumulation impact_by_impact(const Scene<double>& s, const SectionPoint<double>& z) {
    const Scene<Quad> scene{s.sides, s.alpha, s.beta, s.mu, s.restitution, s.law, s.inertia_factor};
    return with_collision_map(scene, [&](const auto& map) {
        PostImpactState<Quad> post_impact = post_impact_state(SectionPoint<Quad>{z.psi, z.chi, z.vn, z.vt, z.spin});
        Quad time = 0;
        for (int i = 0; i < 1000; ++i) {
            if (-contact_kinematics(map.body(), post_impact).un < Quad(1e-20)) {
                const SectionPoint<Quad> end = section_point(post_impact);
                return Accumulation{true,
                                    static_cast<double>(time),
                                    static_cast<double>(end.psi),
                                    static_cast<double>(end.chi),
                                    static_cast<double>(contact_kinematics(map.body(), post_impact).ut),
                                    static_cast<double>(post_impact.spin)};
            }
            const Collision<Quad> next = map.advance(post_impact);
            if (next.outcome != FirstContactOutcome::contact || next.vertex_step != 0) return Accumulation{};
            time += next.flight_time;
            post_impact = next.after;
        }
        return Accumulation{};
    });
}

/// The largest difference of place and velocities from `end` if chatter is replaced by contact at once; negative if the
/// contact changes its kind on the way.
double difference_from(const ContactScene& scene, const PostImpactState<double>& post_impact, const Accumulation& end) {
    const Support support = scene.is_disk() ? Support::rim : Support::vertex;
    const ChatterCompletion completion{true, support, {}, 0, 0, 0};
    const ContactState landed = landed_like(scene, post_impact, completion, post_impact);
    const MotionChoice choice = choose_motion(scene, support, landed, 0);
    if (!choice.stays) return -1;
    const ContactEnd contact = run_contact(scene, support, choice.motion, landed, end.time);
    if (contact.event != ContactEvent::horizon) return -1;
    const Vec2<double> n = cis(contact.state.psi), exact = cis(end.psi);
    const double velocity =
        std::max(std::abs(contact.state.ut - end.ut), scene.body.alpha * std::abs(contact.state.spin - end.spin));
    if (scene.is_disk()) return std::max(velocity, scene.body.inner * detail::magnitude(n - exact));
    const Vec2<double> arm = cis(contact.state.psi + contact.state.chi) - cis(end.psi + end.chi);
    return std::max(velocity, detail::magnitude(n - exact - scene.body.alpha * arm));
}

std::vector<double> shares_of_estimate(int sides, Law law, double v) {
    tests::Random random(17 + sides + 100 * static_cast<int>(law));
    std::vector<double> shares;
    for (int i = 0; i < 400; ++i) {
        // Named, as the order in which a call's arguments are drawn is the compiler's.
        const double restitution = random.between(0, 0.9);
        const double mu = random.chance(0.3) ? 0 : random.between(0, 1);
        const Scene<double> s = tests::random_scene(random, sides, mu, restitution, law);
        SectionPoint<double> z = tests::random_point(random, s, v);
        const ContactScene scene = tests::contact_of(s);
        if (std::abs(z.chi) > 0.9 * scene.widest_chi && sides != disk_sides) continue;
        const PostImpactState<double> post_impact = post_impact_state(z);
        const ChatterError error = chatter_error(scene, post_impact);
        // Left out: chatter that is not short against the swirl, and slips that stop during it (not smooth).
        if (!(error.moved <= 0.01 * v) || std::abs(contact_kinematics(scene.body, post_impact).ut) < 0.05) continue;
        const Accumulation end = impact_by_impact(s, z);
        if (!end.found) continue;
        constexpr double rounding = 1e-15;
        const double distance = difference_from(scene, post_impact, end);
        if (distance >= 0) shares.push_back(std::max(distance - rounding, 0.0) / error.estimate);
    }
    std::sort(shares.begin(), shares.end());
    return shares;
}

TEST(ChatterEnd, IsReportedWithTheLanding) {
    const Scene<double> s = tests::uniform_scene(disk_sides, 0.4, 0.23, 0.4, 0.5);
    const CollisionMap<double, Shape::disk, ImpactRule::poisson> map(s);
    Orbit orbit(map, LabStart<double>{s.beta, 0, 0.1, 0.05, 0, 0});
    while (orbit.advance()) {
    }
    ASSERT_EQ(orbit.outcome(), Outcome::in_contact);
    ASSERT_FALSE(orbit.contacts().empty());
    const ContactSegment& landing = orbit.contacts().front();
    EXPECT_EQ(landing.begin, ContactEvent::landing);
    EXPECT_GT(landing.error, 0);
    EXPECT_LE(landing.error, 16 * std::numeric_limits<double>::epsilon());
}

TEST(ChatterEnd, IsMisplacedByNoMoreThanItsEstimate) {
    for (const int sides : {disk_sides, 3, 6})
        for (const Law law : {Law::poisson, Law::newton, Law::stronge})
            for (const double v : {1e-3, 1e-4}) {
                const auto shares = shares_of_estimate(sides, law, v);
                ASSERT_GE(shares.size(), 50u);
                std::printf("%2d sides, %s, v = %g: %zu sequences, error by estimate: median %.2g, largest %.2g\n",
                            sides, std::string(name_of(law)).c_str(), v, shares.size(), shares[shares.size() / 2],
                            shares.back());
                EXPECT_LE(shares.back(), 1);
                EXPECT_GE(shares[shares.size() / 2], 1e-3);  // not absurdly larger
            }
}

}  // namespace
}  // namespace swirl
