// Films of bodies on a floor that drags: flights in closed form, impacts by the project's law, a tracker's noise.
#include "apps/studies/fits/film_impacts.hpp"
#include "apps/studies/fits/impact_laws.hpp"
#include "map/model/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <numbers>
#include <ostream>
#include <random>
#include <utility>
#include <vector>

namespace swirl::studies {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

struct Truth {
    int sides = 6;
    double alpha = 0.4, beta = 0.5, friction = 0.2, restitution = 0.7, drag = 0.1, spin_drag = 0.1;
    Floor floor = Floor::dish;

    FilmedScene scene() const {
        const double shape = sides == disk_sides ? 0.5 : (2 + std::cos(2 * pi / sides)) / 6;
        return {sides, alpha, beta, shape * alpha * alpha, {}};
    }
};

/// The body in the laboratory, from a time on. X" = -gamma (X' - V), V = i beta cis t of a dish's floor and 0 of a
/// table's; theta" = -gamma_r theta'.
struct Flight {
    double start = 0, angle = 0, spin = 0;
    Complex place, velocity;

    Complex carried(const Truth& truth, double time) const {
        if (truth.floor == Floor::table) return 0;
        return truth.drag * truth.beta / Complex(truth.drag, 1) * std::polar(1.0, time);
    }
    double eased(double drag, double time) const {
        return drag == 0 ? time - start : -std::expm1(-drag * (time - start)) / drag;
    }
    Flight at(const Truth& truth, double time) const {
        const Complex free = velocity - Complex(0, 1) * carried(truth, start);
        Flight then;
        then.start = time;
        then.place = place - carried(truth, start) + free * eased(truth.drag, time) + carried(truth, time);
        then.velocity = free * std::exp(-truth.drag * (time - start)) + Complex(0, 1) * carried(truth, time);
        then.angle = angle + spin * eased(truth.spin_drag, time);
        then.spin = spin * std::exp(-truth.spin_drag * (time - start));
        return then;
    }
};

/// The point that reaches farthest beyond the wall, from the body's centre and from the dish's.
struct Reach {
    double gap = -1;
    Complex offset, from_dish;
};

Reach reach_of(const Truth& truth, const Flight& body) {
    const Complex centre = body.place - truth.beta * std::polar(1.0, body.start);
    Reach reach;
    const auto look = [&](Complex offset) {
        if (std::abs(centre + offset) - 1 > reach.gap) reach = {std::abs(centre + offset) - 1, offset, centre + offset};
    };
    if (truth.sides == disk_sides) look(truth.alpha * centre / std::abs(centre));
    for (int i = 0; i < truth.sides; ++i) look(std::polar(truth.alpha, body.angle + 2 * pi * i / truth.sides));
    return reach;
}

/// The body just after its impact, by Poisson's law.
Flight after_impact(const Truth& truth, const Flight& body) {
    const Reach reach = reach_of(truth, body);
    const Complex normal = reach.from_dish / std::abs(reach.from_dish), along = Complex(0, 1) * normal;
    const Complex wall = Complex(0, truth.beta) * std::polar(1.0, body.start), relative = body.velocity - wall;
    const auto dot = [](Complex a, Complex b) { return (std::conj(a) * b).real(); };
    const Eigen::Vector3d before(dot(along, relative), -dot(normal, relative), body.spin);
    const Eigen::Vector2d offset(dot(along, reach.offset), -dot(normal, reach.offset));
    const double inertia = truth.scene().inertia;
    const analysis::PredictedImpulse found = impact_laws().front().law(
        offset, inertia, analysis::contact_velocity(offset, before), {truth.restitution, truth.friction});
    const Eigen::Vector3d after = before + analysis::effect_of_impulse(offset, inertia) * found.impulse;
    Flight next = body;
    next.velocity = wall + after[0] * along - after[1] * normal;
    next.spin = after[2];
    return next;
}

/// The next impact's time: the first of steps of 0.002 beyond which the body reaches out of the dish; bisected. NaN
/// where the body does not leave the wall.
double next_impact(const Truth& truth, const Flight& from) {
    constexpr double step = 0.002, longest = 100;
    double time = from.start + step;
    if (reach_of(truth, from.at(truth, time)).gap > 0) return analysis::nan;
    while (reach_of(truth, from.at(truth, time + step)).gap <= 0)
        if ((time += step) > from.start + longest) return analysis::nan;
    double later = time + step;
    for (int i = 0; i < 40; ++i) {
        const double middle = (time + later) / 2;
        (reach_of(truth, from.at(truth, middle)).gap > 0 ? later : time) = middle;
    }
    return time;
}

/// Frames of a tracker that sees the centre and a vertex, each coordinate with this noise; the film ends with the last
/// turn of the swirl, or where the body stays on the wall.
std::vector<analysis::FilmFrame> filmed(const Truth& truth, double noise, int turns, int frames_a_turn, unsigned seed) {
    std::mt19937_64 engine(seed);
    // Of the noise's unit, for a distribution's width must not be 0, which a film's noise can be.
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> even(0, 2 * pi);
    Flight body;
    body.place = truth.beta, body.velocity = std::polar(1.0, even(engine)), body.angle = even(engine);
    std::vector<analysis::FilmFrame> frames;
    double end = next_impact(truth, body);
    for (int i = 0; i < turns * frames_a_turn; ++i) {
        const double time = 2 * pi * i / frames_a_turn;
        while (end < time) {
            body = after_impact(truth, body.at(truth, end));
            end = next_impact(truth, body);
        }
        if (std::isnan(end)) break;
        const Flight now = body.at(truth, time);
        const auto seen = [&](Complex point) { return point + noise * Complex(normal(engine), normal(engine)); };
        const Complex centre = seen(now.place), vertex = seen(now.place + std::polar(truth.alpha, now.angle));
        analysis::FilmFrame frame;
        frame.time = time;
        frame.place << centre.real(), centre.imag(), std::arg(vertex - centre);
        frames.push_back(frame);
    }
    return frames;
}

FilmFit fit_of(const Truth& truth, const std::vector<analysis::FilmFrame>& frames, std::size_t resamples,
               const FilmSetting& setting = {}) {
    analysis::ImpactFitSettings settings;
    settings.resamples = resamples;
    settings.threads = 1;
    return fit_film(frames, 2 * pi, truth.scene(), setting, settings);
}

bool holds(const analysis::FittedNumber& number, double truth) {
    return number.low <= truth && !(number.high < truth);
}

bool holds(const analysis::DragFit& drag, double truth) {
    return std::abs(drag.value - truth) <= analysis::sure_drag * drag.error;
}

TEST(DraggedFilm, AFlightFreeOfWallsObeysItsEquation) {
    Truth truth;
    truth.spin_drag = 0.3;
    Flight body;
    body.start = 0.3, body.place = {0.2, 0.1}, body.velocity = {0.4, -0.7}, body.spin = 1.5;
    constexpr double h = 1e-3, time = 1.9;
    const auto at = [&](double t) { return body.at(truth, t); };
    const Complex acceleration = (at(time + h).velocity - at(time - h).velocity) / (2 * h);
    const Complex floor = Complex(0, truth.beta) * std::polar(1.0, time);
    EXPECT_LT(std::abs(acceleration + truth.drag * (at(time).velocity - floor)), 1e-6);
    EXPECT_LT(std::abs((at(time + h).place - at(time - h).place) / (2 * h) - at(time).velocity), 1e-6);
    EXPECT_NEAR(at(time).spin, 1.5 * std::exp(-1.6 * 0.3), 1e-12);
    EXPECT_NEAR((at(time + h).angle - at(time - h).angle) / (2 * h), at(time).spin, 1e-6);
}

/// Where the spin decays as the places do, not at all, and faster.
TEST(DraggedFilm, GivesTheDragAndWithItTheLaw) {
    for (const auto& [floor, spin_drag] :
         {std::pair{Floor::dish, 0.1}, {Floor::dish, 0.0}, {Floor::table, 0.1}, {Floor::table, 0.25}}) {
        Truth truth;
        truth.floor = floor, truth.spin_drag = spin_drag;
        const FilmFit film = fit_of(truth, filmed(truth, 0.003, 60, 30, 1), 40);
        ASSERT_EQ(film.outcome, FilmFitOutcome::fitted);
        EXPECT_EQ(film.drag.floor, floor) << spin_drag;
        EXPECT_TRUE(film.drag.floor_told()) << spin_drag;
        EXPECT_TRUE(holds(film.drag.with.drag, truth.drag)) << spin_drag;
        EXPECT_TRUE(holds(film.drag.with.spin, spin_drag)) << spin_drag;
        EXPECT_EQ(film.arcs.drags.places, film.drag.with.drag.value);
        EXPECT_EQ(film.arcs.drags.angle, film.drag.with.spin.value);
        EXPECT_TRUE(holds(film.fit.restitution, truth.restitution)) << spin_drag;
        EXPECT_TRUE(holds(film.fit.friction, truth.friction)) << spin_drag;
    }
}

TEST(DraggedFilm, ASpinThatAloneDecaysBendsTheAngleAlone) {
    Truth truth;
    truth.drag = 0;
    const FilmFit film = fit_of(truth, filmed(truth, 0.003, 60, 30, 4), 40);
    ASSERT_EQ(film.outcome, FilmFitOutcome::fitted);
    EXPECT_TRUE(holds(film.drag.with.drag, 0));
    EXPECT_EQ(film.arcs.drags.places, 0);
    EXPECT_TRUE(holds(film.drag.with.spin, truth.spin_drag));
    EXPECT_EQ(film.arcs.drags.angle, film.drag.with.spin.value);
    EXPECT_TRUE(holds(film.fit.restitution, truth.restitution));
    EXPECT_TRUE(holds(film.fit.friction, truth.friction));
}

/// A floor that is given is kept, and said to be wrong.
TEST(DraggedFilm, AFloorThatIsGivenIsComparedWithTheOther) {
    const Truth truth;
    const auto frames = filmed(truth, 0.003, 60, 30, 1);
    for (const Floor floor : {Floor::dish, Floor::table}) {
        const FilmFit film = fit_of(truth, frames, 0, {Eigen::Vector2d::Zero(), floor, Eigen::Vector3d::Zero()});
        EXPECT_EQ(film.drag.floor, floor);
        EXPECT_EQ(film.drag.floor_told(), floor == Floor::dish);
        EXPECT_EQ(film.drag.floor_contradicted(), floor == Floor::table);
    }
}

/// Noise that is less than what was written tells: exact frames scatter by their rounding alone, and from frame to
/// frame mostly not at all.
TEST(DraggedFilm, OfExactFramesTheRoundingIsTheNoise) {
    constexpr double digit = 1e-4;
    const double uniform = digit / std::sqrt(12.0);
    const Truth truth;
    for (const double noise : {0.0, 1e-6, 1e-4}) {
        std::vector<analysis::FilmFrame> frames = filmed(truth, noise, 60, 30, 1);
        for (analysis::FilmFrame& frame : frames)
            for (double& number : frame.place) number = digit * std::round(number / digit);
        const FilmFit film =
            fit_of(truth, frames, 20, {Eigen::Vector2d::Zero(), {}, Eigen::Vector3d::Constant(uniform)});
        ASSERT_EQ(film.outcome, FilmFitOutcome::fitted) << noise;
        EXPECT_NEAR(film.arcs.place_noise, std::hypot(noise, uniform), 0.1 * std::hypot(noise, uniform)) << noise;
        EXPECT_NEAR(film.drag.with.drag.value, truth.drag, 4 * film.drag.with.drag.error) << noise;
        EXPECT_LT(film.drag.with.drag.error, 0.001) << noise;
        EXPECT_TRUE(holds(film.fit.restitution, truth.restitution)) << noise;
        EXPECT_TRUE(holds(film.fit.friction, truth.friction)) << noise;
        EXPECT_LT(film.fit.friction.high - film.fit.friction.low, 0.01) << noise;
    }
}

/// Of little noise an arc bends by many times it from frame to frame, and the ends of straight pieces of it are no
/// impacts.
TEST(DraggedFilm, OfExactFramesBentArcsAreNoImpacts) {
    struct Film {
        Floor floor;
        double drag, spin_drag;
        int frames_a_turn;
        double noise, digit;
    };
    for (const auto& [floor, drag, spin_drag, frames_a_turn, noise, digit] :
         {Film{Floor::dish, 0.05, 0.05, 120, 0, 1e-4}, Film{Floor::table, 0.3, 0.1, 400, 0, 1e-9},
          Film{Floor::dish, 0.1, 0.3, 400, 1e-6, 1e-12}}) {
        Truth truth{6, 0.4, 0.5, 0.3, 0.95, drag, spin_drag, floor};
        std::vector<analysis::FilmFrame> frames = filmed(truth, noise, 8, frames_a_turn, 1);
        for (analysis::FilmFrame& frame : frames)
            for (double& number : frame.place) number = digit * std::round(number / digit);
        const double uniform = digit / std::sqrt(12.0);
        const FilmFit film =
            fit_of(truth, frames, 20, {Eigen::Vector2d::Zero(), {}, Eigen::Vector3d::Constant(uniform)});
        ASSERT_EQ(film.outcome, FilmFitOutcome::fitted) << drag;
        EXPECT_EQ(film.drag.floor, floor) << drag;
        EXPECT_TRUE(film.drag.floor_told()) << drag;
        EXPECT_NEAR(film.drag.with.drag.value, drag, 4 * film.drag.with.drag.error) << drag;
        EXPECT_NEAR(film.drag.with.spin.value, spin_drag, 4 * film.drag.with.spin.error) << drag;
        EXPECT_LT(film.drag.with.drag.error, 0.001) << drag;
        EXPECT_TRUE(holds(film.fit.restitution, truth.restitution)) << drag;
        EXPECT_TRUE(holds(film.fit.friction, truth.friction)) << drag;
    }
}

/// What the films of one drag came to; of those with straight arcs e's interval is longer by what such a drag would
/// add.
struct Count {
    int films = 0, refused = 0, sure = 0, told = 0, wrong_floor = 0, drag = 0, spin = 0, restitution = 0, friction = 0;

    void add(const Truth& truth, const FilmFit& film) {
        if (film.outcome != FilmFitOutcome::fitted) {
            ++refused;
            return;
        }
        const analysis::DraggedArcs& found = film.drag.with;
        EXPECT_EQ(film.arcs.drags.places, found.drag.surely_drags() ? found.drag.value : 0);
        EXPECT_TRUE(film.arcs.drags.any() || !found.spin.surely_drags());
        analysis::FittedNumber e = film.fit.restitution;
        const double shift = unseen_drag_shift(film);
        if (!std::isnan(shift)) e.high += shift;
        ++films;
        sure += film.arcs.drags.places != 0 ? 1 : 0;
        told += film.drag.floor_told() ? 1 : 0;
        wrong_floor += film.drag.floor_told() && film.drag.floor != truth.floor ? 1 : 0;
        // Where the floor is not told, what is said is what the drag would be on either.
        const analysis::DragFit& on = film.drag.floor == truth.floor || std::isnan(film.drag.on_the_other.value)
                                          ? found.drag
                                          : film.drag.on_the_other;
        drag += std::isnan(on.value) || holds(on, truth.drag) ? 1 : 0;
        const analysis::DragFit& turning = found.spin;
        spin += std::isnan(turning.value) || holds(turning, truth.spin_drag) ? 1 : 0;
        restitution += std::isnan(shift) || holds(e, truth.restitution) ? 1 : 0;
        friction += holds(film.fit.friction, truth.friction) ? 1 : 0;
    }
};

std::ostream& operator<<(std::ostream& out, const Count& count) {
    return out << count.films << " films (and " << count.refused << " refused); drag sure in " << count.sure
               << ", floor told in " << count.told << ", wrongly in " << count.wrong_floor << "; inside: drag "
               << count.drag << ", spin's " << count.spin << ", e " << count.restitution << ", mu " << count.friction;
}

/// Films of five scenes, three noises and both floors, two each; those of bodies that stay on the wall at once are
/// refused. The spin's drag is so many times the floor's in the second of them.
Count count_of(double drag, double spin_share, unsigned& seed) {
    constexpr Truth scenes[] = {{6, 0.4, 0.5, 0.2, 0.7},
                                {4, 0.3, 0.6, 0.1, 0.9},
                                {3, 0.5, 0.5, 0.3, 0.8},
                                {8, 0.35, 0.5, 0.25, 0.9},
                                {disk_sides, 0.3, 0.4, 0.1, 0.95}};
    Count count;
    for (const double noise : {0.001, 0.003, 0.01})
        for (const Floor floor : {Floor::dish, Floor::table})
            for (std::size_t i = 0; i < 2 * std::size(scenes); ++i) {
                Truth truth = scenes[i / 2];
                truth.drag = drag, truth.spin_drag = i % 2 == 0 ? drag : spin_share * drag, truth.floor = floor;
                count.add(truth, fit_of(truth, filmed(truth, noise, 120, 30, ++seed), 100));
            }
    return count;
}

/// Intervals of 95 %: fewer than 0.9 of 150 inside are a chance of 1 in 100.
TEST(DraggedFilmNightly, IntervalsHoldTheTruth) {
    Count all;
    unsigned seed = 0;
    const auto add = [&all](const Count& count) {
        for (int Count::*number : {&Count::films, &Count::refused, &Count::sure, &Count::told, &Count::wrong_floor,
                                   &Count::drag, &Count::spin, &Count::restitution, &Count::friction})
            all.*number += count.*number;
    };
    for (const auto& [drag, spin_share] : {std::pair{0.02, 0.0}, {0.05, 3.0}, {0.1, 0.0}, {0.3, 0.5}}) {
        const Count count = count_of(drag, spin_share, seed);
        std::cout << "drag " << drag << ", the spin's " << spin_share << " of it in half: " << count << std::endl;
        if (drag >= 0.1) {  // sure but in films of few impacts, where it can't be told at all
            EXPECT_GE(count.sure, 0.85 * count.films) << drag;
        }
        add(count);
    }
    std::cout << "all: " << all << std::endl;
    EXPECT_GE(all.films, 150);
    EXPECT_GE(all.sure, 0.8 * all.films);
    EXPECT_GE(all.told, 0.6 * all.films);
    EXPECT_EQ(all.wrong_floor, 0);  // 3 in 10,000 by noise
    EXPECT_GE(all.drag, 0.9 * all.films);
    EXPECT_GE(all.spin, 0.9 * all.films);
    EXPECT_GE(all.restitution, 0.9 * all.films);
    EXPECT_GE(all.friction, 0.9 * all.films);
}

/// Films of which the digits that are written are all the noise there is: each of an orbit of its own. (Noise below the
/// digits writes one orbit as one film, whatever its seed, and one chance as many.) Fewer than 0.88 of 60 inside are a
/// chance of 1 in 100.
TEST(DraggedFilmNightly, IntervalsHoldTheTruthOfRoundedFrames) {
    constexpr double digit = 1e-4;
    constexpr Truth scenes[] = {{6, 0.4, 0.5, 0.2, 0.7},
                                {4, 0.3, 0.6, 0.1, 0.9},
                                {3, 0.5, 0.5, 0.3, 0.8},
                                {8, 0.35, 0.5, 0.25, 0.9},
                                {6, 0.4, 0.5, 0.3, 0.95}};
    int films = 0, drag = 0, spin = 0;
    unsigned seed = 7000;
    for (const double noise : {1e-7, 1e-6, 1e-5})
        for (int i = 0; i < 30; ++i) {
            Truth truth = scenes[i % 5];
            truth.drag = 0.03 + 0.003 * i, truth.spin_drag = 0.12 - 0.003 * i;
            truth.floor = i % 3 == 0 ? Floor::table : Floor::dish;
            constexpr int rates[] = {31, 60, 94};
            auto frames = filmed(truth, noise, 30, rates[(i / 5) % 3], ++seed);
            for (analysis::FilmFrame& frame : frames)
                for (double& number : frame.place) number = digit * std::round(number / digit);
            const FilmFit film = fit_of(
                truth, frames, 0, {Eigen::Vector2d::Zero(), {}, Eigen::Vector3d::Constant(digit / std::sqrt(12.0))});
            if (film.outcome != FilmFitOutcome::fitted || std::isnan(film.drag.with.spin.value)) continue;
            ++films;
            drag += holds(film.drag.with.drag, truth.drag) ? 1 : 0;
            spin += holds(film.drag.with.spin, truth.spin_drag) ? 1 : 0;
        }
    std::cout << films << " films; inside: drag " << drag << ", spin's " << spin << std::endl;
    EXPECT_GE(films, 60);
    EXPECT_GE(drag, 0.88 * films);
    EXPECT_GE(spin, 0.88 * films);
}

}  // namespace
}  // namespace swirl::studies
