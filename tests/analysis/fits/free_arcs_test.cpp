// Films of a point that moves on known straight lines.
#include "analysis/fits/free_arcs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace swirl::analysis {
namespace {

constexpr double period = 6.283185307179586;

struct TrueMotion {
    std::vector<double> kinks;  ///< the first is the start, the last the end
    std::vector<Eigen::Vector3d> places, velocities;
};

TrueMotion random_motion(std::size_t arcs, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> turn(-1, 1), length(0.8, 2.5);
    TrueMotion motion;
    motion.kinks.push_back(0);
    motion.places.push_back(Eigen::Vector3d::Zero());
    for (std::size_t k = 0; k < arcs; ++k) {
        motion.velocities.emplace_back(turn(random), turn(random), 2 * turn(random));
        motion.kinks.push_back(motion.kinks.back() + length(random));
        motion.places.push_back(motion.places.back() +
                                motion.velocities.back() * (motion.kinks.back() - motion.kinks[k]));
    }
    return motion;
}

std::vector<FilmFrame> filmed(const TrueMotion& motion, double step, double noise, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, 1);
    std::vector<FilmFrame> frames;
    std::size_t arc = 0;
    for (double time = 0; time < motion.kinks.back(); time += step) {
        while (time >= motion.kinks[arc + 1]) ++arc;
        FilmFrame frame;
        frame.time = time;
        frame.place = motion.places[arc] + motion.velocities[arc] * (time - motion.kinks[arc]);
        for (int axis = 0; axis < 3; ++axis) frame.place[axis] += noise * (axis == 2 ? 2 : 1) * normal(random);
        frame.place[2] = std::remainder(frame.place[2], period);
        frames.push_back(frame);
    }
    return frames;
}

TEST(FreeArcs, ExactLinesAndTheirKinksAreFoundToRounding) {
    const TrueMotion motion = random_motion(40, 1);
    const FilmArcs film = fit_arcs(filmed(motion, 0.1, 0, 1), period);
    ASSERT_EQ(film.arcs.size(), 40U);
    EXPECT_EQ(film.outliers, 0U);
    const std::vector<Kink> kinks = kinks_of(film);
    ASSERT_EQ(kinks.size(), 39U);
    for (std::size_t k = 0; k < 40; ++k) EXPECT_LT((film.arcs[k].velocity - motion.velocities[k]).norm(), 1e-9) << k;
    for (std::size_t k = 0; k < 39; ++k) {
        EXPECT_NEAR(kinks[k].time, motion.kinks[k + 1], 1e-9) << k;
        EXPECT_LT((kinks[k].place - motion.places[k + 1]).head<2>().norm(), 1e-9) << k;
    }
}

TEST(FreeArcs, NoiseAndErrorsAreThoseOfTheFrames) {
    const double noise = 0.004;
    const TrueMotion motion = random_motion(400, 2);
    const FilmArcs film = fit_arcs(filmed(motion, 0.1, noise, 3), period);
    EXPECT_NEAR(film.place_noise, noise, 0.03 * noise);
    EXPECT_NEAR(film.angle_noise, 2 * noise, 0.06 * noise);
    // Kinks that can hardly be seen join two lines; of the others time and velocities are within their errors.
    double time_squares = 0, velocity_squares = 0, count = 0;
    std::size_t truth = 1;
    for (const Kink& kink : kinks_of(film)) {
        while (truth + 1 < 400 && motion.kinks[truth] < kink.time - 0.3) ++truth;
        if (std::abs(motion.kinks[truth] - kink.time) > 0.3 || kink.distance > 13.8) continue;
        const FreeArc& arc = film.arcs[kink.before];
        time_squares += std::pow((kink.time - motion.kinks[truth]) / kink.error, 2);
        velocity_squares +=
            (arc.velocity - motion.velocities[truth - 1]).head<2>().squaredNorm() * arc.spread[0] / (2 * noise * noise);
        ++count;
    }
    ASSERT_GT(count, 350);
    // Means of some 370 and 740 squares: 1 within four standard errors, a few joined lines beside.
    EXPECT_NEAR(time_squares / count, 1, 0.35);
    EXPECT_NEAR(velocity_squares / count, 1, 0.3);
}

TEST(FreeArcs, FramesOffTheLineAreOutliersAndNoImpacts) {
    const TrueMotion motion = random_motion(40, 4);
    std::vector<FilmFrame> frames = filmed(motion, 0.1, 0.002, 5);
    const std::size_t true_arcs = fit_arcs(frames, period).arcs.size();
    std::size_t moved = 0, arc = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        while (frames[i].time >= motion.kinks[arc + 1]) ++arc;
        const double from_kink = std::min(frames[i].time - motion.kinks[arc], motion.kinks[arc + 1] - frames[i].time);
        if (i % 17 != 5 || from_kink < 0.35) continue;
        frames[i].place += Eigen::Vector3d(0.1, -0.05, 0.3);
        ++moved;
    }
    ASSERT_GT(moved, 10U);
    const FilmArcs film = fit_arcs(frames, period);
    EXPECT_EQ(film.outliers, moved);
    EXPECT_EQ(film.arcs.size(), true_arcs);
}

TEST(FreeArcs, NoKinkReachesAcrossAGap) {
    const TrueMotion motion = random_motion(20, 6);
    std::vector<FilmFrame> frames = filmed(motion, 0.1, 0.002, 7);
    const std::size_t kinks = kinks_of(fit_arcs(frames, period)).size();
    for (FilmFrame& frame : frames)
        if (std::abs(frame.time - motion.kinks[10]) < 0.35) frame.place.setConstant(nan);
    const FilmArcs film = fit_arcs(frames, period);
    EXPECT_EQ(kinks_of(film).size(), kinks - 1);
    for (const FreeArc& arc : film.arcs) EXPECT_FALSE(arc.start < motion.kinks[10] && arc.end > motion.kinks[10]);
}

/// A tracker that takes the angle from two points, `arm` apart: the angle's error goes with that across it.
TEST(FreeArcs, TheNoiseOfAngleAndPlaceIsKnownWithItsCorrelation) {
    const double noise = 0.004, arm = 0.4;
    std::vector<FilmFrame> frames = filmed(random_motion(400, 8), 0.1, 0, 9);
    std::mt19937 random(10);
    std::normal_distribution<double> normal(0, noise);
    for (FilmFrame& frame : frames) {
        const double along = normal(random), across = normal(random), angle = frame.place[2];
        frame.place[0] += along * std::cos(angle) - across * std::sin(angle);
        frame.place[1] += along * std::sin(angle) + across * std::cos(angle);
        frame.place[2] += (normal(random) - across) / arm;
    }
    const Eigen::Matrix3d found = fit_arcs(frames, period).noise;
    const Eigen::Vector3d errors(noise, noise, std::sqrt(2.0) * noise / arm);
    const Eigen::Matrix3d shares = errors.cwiseInverse().asDiagonal() * found * errors.cwiseInverse().asDiagonal();
    Eigen::Matrix3d truth = Eigen::Matrix3d::Identity();
    truth(1, 2) = truth(2, 1) = -1 / std::sqrt(2.0);
    EXPECT_LT((shares - truth).cwiseAbs().maxCoeff(), 0.08);  // some 5000 frames; frames at kinks on the wrong line
}

/// X" = g - gamma X', from rest; of a small drag as of none.
TEST(FreeArcs, AFallObeysItsEquation) {
    const UniformFall fall{{0.3, -9.81}, 0.2};
    for (const double drag : {0.0, 1e-7, 0.5}) {
        constexpr double h = 1e-3, time = 1.7;
        const auto velocity = [&](double t) { return fall.velocity(t, drag); };
        const Eigen::Vector3d acceleration = (velocity(time + h) - velocity(time - h)) / (2 * h);
        const Eigen::Vector3d moved = (fall.place(time + h, drag) - fall.place(time - h, drag)) / (2 * h);
        EXPECT_LT((moved - velocity(time)).norm(), 1e-5) << drag;
        EXPECT_LT((acceleration + drag * velocity(time) - Eigen::Vector3d(0.3, -9.81, 0)).norm(), 1e-5) << drag;
        EXPECT_EQ(fall.place(fall.from, drag).norm(), 0) << drag;
    }
    EXPECT_NEAR(fall.place(1.7, 1e-7)[1], fall.place(1.7, 0)[1], 1e-6);
}

TEST(FreeArcs, TheirEndsAreTheirFramesNextToKinks) {
    const FilmArcs film = fit_arcs(filmed(random_motion(10, 1), 0.05, 0, 1), period);
    const FilmArcs ends = end_pieces(film, 8);
    const std::vector<Kink> whole = kinks_of(film), parts = kinks_of(ends);
    ASSERT_EQ(film.arcs.size(), 10U);
    EXPECT_EQ(ends.arcs.size(), 20U);  // each arc has more than 10 frames
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        EXPECT_NEAR(parts[i].time, whole[i].time, 1e-5);
        EXPECT_EQ(ends.arcs[parts[i].before].count, 8U);
        EXPECT_LT(ends.arcs[parts[i].before].end, film.arcs[whole[i].before].end);
    }
}

TEST(FreeArcs, OfAFewFramesThereIsNothing) {
    std::vector<FilmFrame> frames(2);
    frames[0] = {0, Eigen::Vector3d::Zero()};
    frames[1] = {1, Eigen::Vector3d::Ones()};
    EXPECT_TRUE(fit_arcs(frames, period).arcs.empty());
    EXPECT_TRUE(fit_arcs({}, period).arcs.empty());
}

}  // namespace
}  // namespace swirl::analysis
