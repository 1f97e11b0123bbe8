// The motion along the wall of chatter that sticks, against the sequence of impacts in 113 bits.
#include "map/sustained/sticking_chatter.hpp"
#include "tests/map/chatter_sequences.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace swirl {
namespace {

using tests::Accumulation, tests::difference_from, tests::impact_by_impact;

/// Just after an impact that stopped the slip and leaves at v.
PostImpactState<Quad> stopped_at(const ContactScene<Quad>& scene, const SectionPoint<double>& z, double v) {
    PostImpactState<Quad> post_impact = post_impact_state(SectionPoint<Quad>{z.psi, z.chi, z.vn, z.vt, z.spin});
    const ContactKinematics<Quad> u = contact_kinematics(scene.body, post_impact);
    post_impact.vn -= u.un + Quad(v);
    post_impact.vt -= u.ut;
    return post_impact;
}

/// The error of chatter's sum at v and at v/10; negative where impacts do not stick or the body does not stay.
struct Fall {
    double at_v, at_tenth;
};

Fall fall_of(const Scene<double>& s, const SectionPoint<double>& z, double v) {
    const ContactScene<Quad> scene = tests::contact_of(tests::scene_in<Quad>(s));
    const auto error = [&](double leaving) {
        const PostImpactState<Quad> from = stopped_at(scene, z, leaving);
        if (!(chatter_error(scene, from).moved <= Quad(0.01 * leaving))) return -1.0;
        const Accumulation end = impact_by_impact(s, from, Quad(1e-29));
        return end.found && end.sticks ? difference_from(scene, from, end) : -1.0;
    };
    return {error(v), error(0.1 * v)};
}

/// What error(v/10)/error(v) is in drawn scenes of N sides, ascending.
std::vector<double> falls(int sides, Law law, int count, std::uint64_t seed) {
    tests::Random random(seed);
    std::vector<double> ratios;
    for (int i = 0; i < count; ++i) {
        const double restitution = random.between(0.1, 0.7), mu = random.between(0.2, 1);
        const Scene<double> s = tests::random_scene(random, sides, mu, restitution, law);
        const SectionPoint<double> z = tests::random_point(random, s, 0);
        if (std::abs(z.chi) > 0.9 * tests::largest_chi(s) && sides != disk_sides) continue;
        const Fall fall = fall_of(s, z, 1e-5);
        if (fall.at_v > 0 && fall.at_tenth >= 0) ratios.push_back(fall.at_tenth / fall.at_v);
    }
    std::sort(ratios.begin(), ratios.end());
    return ratios;
}

// T falls by 10 with v. Without the motion along the wall the error is of second order, and falls by 100.
TEST(StickingChatter, LeavesAnErrorOfThirdOrder) {
    for (const int sides : {disk_sides, 3, 4, 12})
        for (const Law law : {Law::poisson, Law::newton, Law::stronge}) {
            if (sides == disk_sides && law != Law::poisson) continue;  // the disk's laws coincide
            const auto ratios = falls(sides, law, sides == disk_sides ? 40 : 400, 7);
            EXPECT_GE(ratios.size(), 5U) << sides;
            std::printf("%2d sides, %s: %zu sequences, error(v/10)/error(v) median %.3g, largest %.3g\n", sides,
                        std::string(name_of(law)).c_str(), ratios.size(), ratios[ratios.size() / 2], ratios.back());
            EXPECT_NEAR(ratios[ratios.size() / 2], 1e-3, 1e-4) << sides;
            EXPECT_LE(ratios.back(), 2e-3) << sides;
        }
}

}  // namespace
}  // namespace swirl
