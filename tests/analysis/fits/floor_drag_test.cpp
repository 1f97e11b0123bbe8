// Films of a point that a moving floor drags, integrated in closed form.
#include "analysis/fits/floor_drag.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <random>
#include <span>
#include <vector>

namespace swirl::analysis {
namespace {

using Complex = std::complex<double>;
constexpr double period = 6.283185307179586;
const FloorMotion floor_motion{0.5, 1.002, 0.7};

/// The place after a free motion of so long, by the classic Runge-Kutta method in small steps.
Complex integrated(Complex place, Complex velocity, double begin, double duration, double drag) {
    constexpr int steps = 2000;
    const double h = duration / steps;
    const auto acceleration = [&](double time, Complex v) {
        const Complex floor = Complex(0, floor_motion.radius * floor_motion.rate) *
                              std::polar(1.0, floor_motion.rate * time + floor_motion.phase);
        return -drag * (v - floor);
    };
    for (int i = 0; i < steps; ++i) {
        const double t = begin + i * h;
        const Complex a = acceleration(t, velocity), b = acceleration(t + h / 2, velocity + h / 2 * a),
                      c = acceleration(t + h / 2, velocity + h / 2 * b), d = acceleration(t + h, velocity + h * c);
        place += h * velocity + h * h / 6 * (a + b + c);
        velocity += h / 6 * (a + 2.0 * b + 2.0 * c + d);
    }
    return place;
}

/// X = A + B (1 - e^(-gamma t))/gamma + K cis(rate t + phase), from just after an impact.
struct Arc {
    double start = 0, drag = 0, angle = 0, spin = 0;
    Complex constant, velocity;

    Arc(double begin, Complex place, Complex speed, double gamma) : start(begin), drag(gamma) {
        const Eigen::Vector3d carried = floor_motion.carried(begin, gamma);
        const Complex part(carried[0], carried[1]);
        constant = place - part;
        velocity = speed - Complex(0, floor_motion.rate) * part;
    }
    Complex at(double time) const {
        const Eigen::Vector3d carried = floor_motion.carried(time, drag);
        return constant + velocity * dragged_time(time - start, drag) + Complex(carried[0], carried[1]);
    }
};

/// Sixty flights of 0.8 to 2.5, a frame each 0.1.
std::vector<FilmFrame> filmed(double drag, double noise, unsigned seed, double spin_drag) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> turn(-1, 1), length(0.8, 2.5);
    std::normal_distribution<double> normal(0, noise);
    std::vector<FilmFrame> frames;
    double kink = 0, time = 0;
    Complex place = 0;
    double angle = 0;
    for (int k = 0; k < 60; ++k) {
        const Arc arc(kink, place, Complex(turn(random), turn(random)), drag);
        const double spin = 2 * turn(random), end = kink + length(random);
        for (; time < end; time += 0.1) {
            const Complex here = arc.at(time);
            FilmFrame frame;
            frame.time = time;
            frame.place << here.real() + normal(random), here.imag() + normal(random),
                angle + spin * dragged_time(time - kink, spin_drag) + 2 * normal(random);
            frames.push_back(frame);
        }
        angle += spin * dragged_time(end - kink, spin_drag);
        place = arc.at(end), kink = end;
    }
    return frames;
}

std::vector<FilmFrame> filmed(double drag, double noise, unsigned seed) {
    return filmed(drag, noise, seed, drag);
}

std::vector<ArcPart> parts_of(const FilmArcs& film) {
    return parts_between(film, kinks_of(film));
}

const FloorMotion table{0, floor_motion.rate, floor_motion.phase};

DraggedArcs arcs_in(const std::vector<FilmFrame>& frames, const FloorMotion& floor = floor_motion) {
    return settled_drag(frames, period, fit_arcs(frames, period), floor, parts_of);
}

DragFit found_in(const std::vector<FilmFrame>& frames) {
    return arcs_in(frames).drag;
}

TEST(FloorDrag, TheClosedFormIsTheMotionUnderAMovingFloorsDrag) {
    const Arc arc(0.4, {0.1, -0.2}, {0.7, 0.3}, 0.3);
    EXPECT_LT(std::abs(arc.at(2.9) - integrated({0.1, -0.2}, {0.7, 0.3}, 0.4, 2.5, 0.3)), 1e-11);
}

TEST(FloorDrag, OfNearlyExactFramesItIsNearlyExact) {
    for (const double drag : {0.0, 0.02, 0.3}) {
        const DragFit found = found_in(filmed(drag, 0.0003, 1));
        EXPECT_NEAR(found.value, drag, 4 * found.error) << drag;
        EXPECT_LT(found.error, 0.0002) << drag;
    }
}

/// Intervals of 95 %: 99 to 109 of 110 are 90 to 99 %.
TEST(FloorDrag, ItsIntervalHoldsTheTruthWithAndWithoutADrag) {
    constexpr unsigned films = 110;
    for (const double drag : {0.0, 0.1}) {
        unsigned inside = 0;
        double sum = 0, errors = 0;
        for (unsigned seed = 0; seed < films; ++seed) {
            const DragFit found = found_in(filmed(drag, 0.004, 100 + seed));
            inside += std::abs(found.value - drag) <= 1.959964 * found.error ? 1 : 0;
            sum += found.value - drag, errors += found.error;
        }
        EXPECT_GE(inside, 99U) << drag;
        EXPECT_LE(inside, 109U) << drag;
        // The mean over the films is off by no more than 4 of its standard errors.
        EXPECT_LT(std::abs(sum / films), 4 * errors / films / std::sqrt(films)) << drag;
    }
}

/// The motion's velocity at a kink is that of both arcs there: 0.0003 of noise in some ten frames 0.1 apart.
TEST(FloorDrag, ArcsGiveTheVelocitiesAtTheirEnds) {
    constexpr double drag = 0.3;
    const std::vector<FilmFrame> frames = filmed(drag, 0.0003, 3);
    const DraggedArcs found = arcs_in(frames);
    double squares = 0, straight_squares = 0, places = 0;
    std::size_t count = 0;
    const FilmArcs straight = with_drags(found.arcs, {});
    const Eigen::Vector3d drags(found.arcs.drags.places, found.arcs.drags.places, found.arcs.drags.angle);
    for (const FreeArc& arc : found.arcs.arcs) {
        if (arc.count < 8) continue;
        // Of the equation, from the arc's own middle on: the end's velocity less the middle's is the integral of -drag
        // (velocity - floor's), that is -drag (place moved - floor moved).
        const auto at = [&](double time) -> Eigen::Vector3d { return found.arcs.velocity_on(arc, time); };
        const Eigen::Vector3d moved = found.arcs.place_on(arc, arc.end) - found.arcs.place_on(arc, arc.start);
        const auto floor_at = [](double time) {
            const Complex place = std::polar(floor_motion.radius, floor_motion.rate * time + floor_motion.phase);
            return Eigen::Vector3d(place.real(), place.imag(), 0);
        };
        const Eigen::Vector3d change = -drags.cwiseProduct(moved - (floor_at(arc.end) - floor_at(arc.start)));
        EXPECT_LT((at(arc.end) - at(arc.start) - change).norm(), 1e-9);
        const std::size_t index = static_cast<std::size_t>(&arc - found.arcs.arcs.data());
        const FreeArc& line = straight.arcs[index];
        squares += arc.squares, straight_squares += line.squares, places += static_cast<double>(arc.count) - 2;
        ++count;
    }
    EXPECT_GT(count, 40U);
    EXPECT_LT(std::sqrt(squares / (2 * places)), 1.1 * 0.0003);  // the residuals are the noise
    EXPECT_GT(straight_squares, 4 * squares);                    // and those of straight arcs are not
}

/// The angle's own drag is told beside that of the places: intervals of 95 % hold it in 90 to 99 % of 110 films.
TEST(FloorDrag, TheSpinsIsToldBesideIt) {
    constexpr unsigned films = 110;
    constexpr double drag = 0.1, spin_drag = 0.25;
    unsigned inside = 0, places_inside = 0;
    for (unsigned seed = 0; seed < films; ++seed) {
        const DraggedArcs found = arcs_in(filmed(drag, 0.004, 300 + seed, spin_drag));
        inside += std::abs(found.spin.value - spin_drag) <= sure_drag * found.spin.error ? 1 : 0;
        places_inside += std::abs(found.drag.value - drag) <= sure_drag * found.drag.error ? 1 : 0;
        EXPECT_EQ(found.arcs.drags.angle, found.spin.value);
        EXPECT_EQ(found.arcs.drags.places, found.drag.value);
    }
    EXPECT_GE(inside, 99U);
    EXPECT_LE(inside, 109U);
    EXPECT_GE(places_inside, 99U);
    EXPECT_LE(places_inside, 109U);
}

TEST(FloorDrag, OfABodyThatDoesNotTurnTheSpinsCannotBeTold) {
    std::vector<FilmFrame> frames = filmed(0.1, 0.004, 9);
    std::mt19937 random(9);
    std::normal_distribution<double> normal(0, 0.008);
    for (FilmFrame& frame : frames) frame.place[2] = normal(random);
    const DraggedArcs found = arcs_in(frames);
    EXPECT_TRUE(std::isnan(found.spin.value));
    EXPECT_EQ(found.arcs.drags.angle, found.drag.value);  // as of a uniform film
}

/// Where the floor stands still the motion is another, on the arcs of either floor, whatever the spin does.
TEST(FloorDrag, AnotherFloorIsWorse) {
    for (const double spin_drag : {0.1, 0.0, 0.3}) {
        const std::vector<FilmFrame> frames = filmed(0.1, 0.004, 5, spin_drag);
        for (const FloorMotion& floor : {floor_motion, table}) {
            const FilmArcs film = arcs_in(frames, floor).arcs;
            const std::vector<ArcPart> parts = parts_of(film);
            const double worse = floor_worse_by(film.kept, parts, table, floor_motion, film.place_noise);
            EXPECT_GT(worse, 12) << spin_drag << " " << floor.radius;
            EXPECT_NEAR(floor_worse_by(film.kept, parts, floor_motion, table, film.place_noise), -worse, 1e-6 * worse);
        }
    }
}

/// Of so little drag the floors are hardly told: the difference is normal, of variance 4 times its mean, so that none
/// of 110 true floors is worse by 9 more often than with a chance of 0.0013.
TEST(FloorDrag, TheTrueFloorIsNotWorse) {
    unsigned right = 0;
    for (unsigned seed = 0; seed < 110; ++seed) {
        const FilmArcs film = arcs_in(filmed(0.02, 0.004, 500 + seed)).arcs;
        const double worse = floor_worse_by(film.kept, parts_of(film), floor_motion, table, film.place_noise);
        EXPECT_LT(worse, 9) << seed;
        right += worse < 0 ? 1 : 0;
    }
    EXPECT_GT(right, 66U);  // more than half, by two of their standard deviations
}

TEST(FloorDrag, OfAFewArcsNothingIsSaid) {
    std::vector<FilmFrame> frames = filmed(0.05, 0.004, 7);
    frames.resize(100);
    EXPECT_TRUE(std::isnan(found_in(frames).value));
}

/// Of straight arcs each flight would be several pieces, since it bends by more than the noise within a few frames.
TEST(BentArcs, AreTheFlightsWithoutKnowingTheFloor) {
    for (const double noise : {1e-9, 1e-6, 1e-4})
        for (const double spin_drag : {0.3, 0.0, 0.8}) {
            const auto frames = filmed(0.3, noise, 1, spin_drag);
            const FilmArcs straight = fit_arcs(frames, period);
            EXPECT_GT(straight.arcs.size(), 90U) << noise;
            const auto bent = bent_arcs(frames, period, straight, floor_motion.rate);
            ASSERT_TRUE(bent) << noise;
            EXPECT_EQ(bent->arcs.size(), 60U) << noise << " " << spin_drag;
            const double near = 30 * noise + 1e-7;
            EXPECT_NEAR(bent->drags.places, 0.3, near) << noise;
            EXPECT_NEAR(bent->drags.angle, spin_drag, near) << noise;
            EXPECT_NEAR(bent->floor.radius, floor_motion.radius, near) << noise;
            EXPECT_NEAR(bent->floor.phase, floor_motion.phase, near) << noise;
        }
}

TEST(BentArcs, AreNoneOfFlightsThatDoNotBend) {
    for (const double noise : {1e-9, 1e-4, 0.003}) {
        const auto frames = filmed(0, noise, 2);
        EXPECT_FALSE(bent_arcs(frames, period, fit_arcs(frames, period), floor_motion.rate)) << noise;
    }
}

}  // namespace
}  // namespace swirl::analysis
