// What a film without a fit is refused for.
#include "apps/studies/fits/film_impacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace swirl::studies {
namespace {

constexpr double two_pi = 6.283185307179586;
const FilmedScene scene{3, 0.3, 0.8, 0.3 * 0.3 * 0.25, {}};

Eigen::Vector2d direction(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

/// 60 turns of the swirl at 30 frames each; place(time) gives (x, y, θ).
template <class Place>
std::vector<analysis::FilmFrame> filmed(Place place) {
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal(0, 0.002);
    std::vector<analysis::FilmFrame> frames;
    for (int i = 0; i < 1800; ++i) {
        analysis::FilmFrame frame;
        frame.time = two_pi * i / 30;
        frame.place = place(frame.time);
        for (Eigen::Index k = 0; k < 3; ++k) frame.place[k] += normal(engine);
        frames.push_back(frame);
    }
    return frames;
}

analysis::ImpactFitSettings few_resamples() {
    analysis::ImpactFitSettings settings;
    settings.resamples = 10;
    settings.threads = 1;
    return settings;
}

TEST(FilmFit, ABodyThatStaysOnTheWallHasNoWrongScale) {
    // One vertex follows the swirl along the wall, swaying.
    const auto frames = filmed([](double time) {
        const double outwards = time + 0.3 * std::sin(0.37 * time), turned = outwards + 0.2 * std::sin(0.51 * time);
        const Eigen::Vector2d centre = 0.8 * direction(time) + direction(outwards) - 0.3 * direction(turned);
        return Eigen::Vector3d(centre[0], centre[1], turned);
    });
    const FilmFit film = fit_film(frames, two_pi, scene, {}, few_resamples());
    EXPECT_TRUE(film.outcome == FilmFitOutcome::few_impacts || film.outcome == FilmFitOutcome::few_kinks);
    EXPECT_LT(film.frames_off_wall, 0.004);  // the noise of place and angle: 0.002 each way
    EXPECT_EQ(film.counts[static_cast<std::size_t>(KinkUse::off_the_wall)], 0U);
    // The same frames in another dish are not on its wall.
    FilmedScene wrong = scene;
    wrong.alpha = 0.6, wrong.beta = 0.2;
    const FilmFit other = fit_film(frames, two_pi, wrong, {}, few_resamples());
    EXPECT_NE(other.outcome, FilmFitOutcome::fitted);
    EXPECT_GT(other.frames_off_wall, near_wall);
}

TEST(FilmFit, FlightsThatTurnNowhereNearTheWallHaveAWrongScale) {
    // A path with corners at random, which no dish's motion passes through.
    std::mt19937_64 engine(2);
    std::uniform_real_distribution<double> even(-1, 1);
    std::vector<Eigen::Vector3d> corners;
    for (int i = 0; i < 400; ++i) corners.emplace_back(even(engine), even(engine), 3 * even(engine));
    const auto frames = filmed([&](double time) {
        const double step = 1.7, part = time / step - std::floor(time / step);
        const auto corner = static_cast<std::size_t>(time / step);
        return Eigen::Vector3d((1 - part) * corners[corner] + part * corners[corner + 1]);
    });
    const FilmFit film = fit_film(frames, two_pi, scene, {}, few_resamples());
    EXPECT_EQ(film.outcome, FilmFitOutcome::no_wall);
    EXPECT_GT(film.frames_off_wall, near_wall);
}

}  // namespace
}  // namespace swirl::studies
