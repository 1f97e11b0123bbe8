// An orbit in continuous time: places and turns between impacts, in flight and in contact.
#include "map/orbit/trajectory_segment.hpp"
#include "tests/map/contact_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace swirl {
namespace {

struct Look {
    long trajectory = 0, contacts = 0;
    double gap = 0;      ///< in contact: | the farthest point's distance from the container's centre − 1 |
    double outside = 0;  ///< the same distance − 1, in flight
    double jump = 0;     ///< of the centre and the angle from segment to segment
    double turned = 0;   ///< | ∫S dt of the segments − that of the return step |
};

double farthest_point(const ContactScene<double>& scene, const Moment& now, double t) {
    const Vec2<double> x = now.centre - scene.body.beta * cis(t);
    if (scene.is_disk()) return std::hypot(x.x, x.y) + scene.body.alpha;
    double farthest = 0;
    for (int k = 0; k < scene.body.sides; ++k) {
        const Vec2<double> vertex = x + scene.body.alpha * cis(now.angle + k * scene.body.spacing);
        farthest = std::max(farthest, std::hypot(vertex.x, vertex.y));
    }
    return farthest;
}

void look_at(const TrajectorySegmenter& cutter, const TrajectorySegment& segment, Look& look) {
    ++look.trajectory;
    look.contacts += segment.in_contact;
    for (const double share : {0.0, 0.3, 0.7, 1.0}) {
        const double t = segment.start + share * (segment.end - segment.start);
        const double excess = farthest_point(cutter.scene(), moment_at(cutter.scene(), segment, t), t) - 1;
        if (segment.in_contact)
            look.gap = std::max(look.gap, std::abs(excess));
        else
            look.outside = std::max(look.outside, excess);
    }
}

Look follow(const Scene<double>& scene, const LabStart<double>& start, int impacts) {
    return with_collision_map(scene, [&](const auto& map) {
        Look look;
        Orbit orbit(map, start);
        TrajectorySegmenter cutter(scene, start);
        const ContactSink sink = cutter.sink();
        Moment last{{start.x, start.y}, start.angle, start.spin, 0};
        while (orbit.impacts() < impacts && orbit.advance(contact_horizon, sink)) {
            double turned = 0;
            for (const TrajectorySegment& segment : cutter.passed(orbit, true)) {
                look_at(cutter, segment, look);
                const Moment first = moment_at(cutter.scene(), segment, segment.start);
                look.jump =
                    std::max({look.jump, std::hypot(first.centre.x - last.centre.x, first.centre.y - last.centre.y),
                              std::abs(first.angle - last.angle)});
                last = moment_at(cutter.scene(), segment, segment.end);
                turned += last.turned;
            }
            look.turned = std::max(look.turned, std::abs(turned - orbit.return_step().turned));
        }
        const auto lab = orbit.lab();
        EXPECT_NEAR(last.centre.x, lab.x, 1e-12);
        EXPECT_NEAR(last.centre.y, lab.y, 1e-12);
        return look;
    });
}

/// Times are known to ε t (10⁻¹³ after some hundred units), the angle's sum gathers some ε a segment.
void check(const Scene<double>& scene, int impacts) {
    const Look look = follow(scene, {scene.beta, 0, 0.11, 0.09, 0.3, 0.1}, impacts);
    EXPECT_GT(look.contacts, 0);
    EXPECT_GT(look.trajectory, look.contacts);
    EXPECT_LE(look.gap, 1e-12);
    EXPECT_LE(look.outside, 1e-12);
    EXPECT_LE(look.jump, 1e-11);
    EXPECT_LE(look.turned, 1e-12);
}

TEST(TrajectorySegment, APolygonStaysOnTheWallInContactAndInsideInFlight) {
    check(tests::uniform_scene(3, 0.4, 0.8, 0.5, 0.5), 200);
    check(tests::uniform_scene(5, 0.6433, 0.5562, 2, 0), 200);
    check(tests::uniform_scene(12, 0.5, 0.9, 0.3, 0.2, Law::stronge), 200);
    check(tests::uniform_scene(4, 0.3, 0.6, 0, 0.3), 200);
}

TEST(TrajectorySegment, ADiskToo) {
    check(tests::uniform_scene(disk_sides, 0.1, 0.05, 0.4, 0.3), 200);
}

TEST(TrajectorySegment, AStartOnTheSectionBeginsWhereItStands) {
    const auto scene = tests::uniform_scene(6, 0.4, 0.5, 0.5, 0.9);
    const SectionPoint<double> z{-0.08, 0.03, -0.55, 0.89, -0.98};
    with_collision_map(scene, [&](const auto& map) {
        Orbit orbit(map, z);
        TrajectorySegmenter cutter(scene, z);
        const auto before = orbit.lab();
        EXPECT_TRUE(orbit.advance(contact_horizon, cutter.sink()));
        const auto& trajectory = cutter.passed(orbit, true);
        EXPECT_EQ(trajectory.size(), 1U);
        const Moment first = moment_at(cutter.scene(), trajectory.front(), 0);
        EXPECT_NEAR(first.centre.x, before.x, 1e-15);
        EXPECT_NEAR(first.centre.y, before.y, 1e-15);
        EXPECT_NEAR(first.angle, before.angle, 1e-15);
        return 0;
    });
}

}  // namespace
}  // namespace swirl
