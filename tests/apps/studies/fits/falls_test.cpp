// Falls of known bodies on a known plate: parabolas in closed form, impacts by the project's laws, a tracker's noise
// and rounding.
#include "analysis/fits/robust.hpp"
#include "apps/studies/fits/falls_fit.hpp"
#include "apps/studies/fits/impact_laws.hpp"
#include "map/model/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace swirl::studies {
namespace {

using analysis::FilmFrame;
using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

struct Truth {
    int sides = 4;
    double radius = 0.04, restitution = 0.6, friction = 0.2;
    std::size_t law = 0;  ///< of impact_laws()
    double gravity = 9.81, drag = 0, spin_drag = 0, tilt = 0, height = 0.01, mark = 0.3;
    double frames_a_second = 250, place_noise = 5e-5, angle_noise = 1e-3, digit = 1e-6;
    double speed = 0.6, spin = 8;  ///< of the start, at most

    FallenBody body() const {
        const double shape = sides == disk_sides ? 0.5 : (2 + std::cos(2 * pi / sides)) / 6;
        return {sides, radius, shape * radius * radius, false, {}};
    }
    Vector2d normal() const { return {-std::sin(tilt), std::cos(tilt)}; }
};

/// (x, y, theta) and its rates. X" = g - gamma X', theta" = -gamma_r theta'.
struct Flight {
    double start = 0;
    Vector3d place = Vector3d::Zero(), velocity = Vector3d::Zero();

    Flight at(const Truth& truth, double time) const {
        const double t = time - start;
        const auto eased = [t](double drag) { return drag == 0 ? t : -std::expm1(-drag * t) / drag; };
        const double fallen = truth.drag == 0 ? t * t / 2 : (t - eased(truth.drag)) / truth.drag;
        Flight then;
        then.start = time;
        then.place =
            place + Vector3d(eased(truth.drag), eased(truth.drag), eased(truth.spin_drag)).cwiseProduct(velocity);
        then.place[1] -= truth.gravity * fallen;
        then.velocity = velocity.cwiseProduct(
            Vector3d(std::exp(-truth.drag * t), std::exp(-truth.drag * t), std::exp(-truth.spin_drag * t)));
        then.velocity[1] -= truth.gravity * eased(truth.drag);
        return then;
    }
};

/// Height of the lowest point above the plate, and where it is from the centre.
std::pair<double, Vector2d> lowest(const Truth& truth, const Vector3d& place) {
    std::pair<double, Vector2d> found{1e9, Vector2d::Zero()};
    const auto look = [&](const Vector2d& offset) {
        const double height = truth.normal().dot(place.head<2>() + offset) - truth.height;
        if (height < found.first) found = {height, offset};
    };
    if (truth.sides == disk_sides) look(-truth.radius * truth.normal());
    for (int i = 0; i < truth.sides; ++i) {
        const double angle = place[2] + truth.mark + 2 * pi * i / truth.sides;
        look(truth.radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
    return found;
}

Flight after_impact(const Truth& truth, const Flight& body) {
    const Vector2d normal = truth.normal(), along(normal[1], -normal[0]), arm = lowest(truth, body.place).second;
    const Vector2d offset(along.dot(arm), normal.dot(arm)), moving = body.velocity.head<2>();
    const Vector3d before(along.dot(moving), normal.dot(moving), body.velocity[2]);
    const double inertia = truth.body().inertia;
    const analysis::PredictedImpulse found = impact_laws()[truth.law].law(
        offset, inertia, analysis::contact_velocity(offset, before), {truth.restitution, truth.friction});
    const Vector3d after = before + analysis::effect_of_impulse(offset, inertia) * found.impulse;
    Flight next = body;
    next.velocity.head<2>() = after[0] * along + after[1] * normal;
    next.velocity[2] = after[2];
    return next;
}

/// The next impact's time, by steps of 0.2 ms; NaN where the body does not leave the plate.
double next_impact(const Truth& truth, const Flight& from) {
    constexpr double step = 2e-4, longest = 3;
    double time = from.start + step;
    if (lowest(truth, from.at(truth, time).place).first < 0) return analysis::nan;
    while (lowest(truth, from.at(truth, time + step).place).first >= 0)
        if ((time += step) > from.start + longest) return analysis::nan;
    double later = time + step;
    for (int i = 0; i < 40; ++i) {
        const double middle = (time + later) / 2;
        (lowest(truth, from.at(truth, middle).place).first < 0 ? later : time) = middle;
    }
    return time;
}

/// Uniform in [0, 1), of a draw.
double even_draw(std::uint64_t seed, std::uint64_t draw, std::size_t i) {
    return std::erfc(-analysis::normal_draws(seed, draw, i)[0] / std::numbers::sqrt2) / 2;
}

struct Fall {
    std::vector<FilmFrame> frames;
    std::vector<std::pair<Flight, Flight>> impacts;  ///< as they truly are: before and after
};

/// 0.8 s from a start at random; where the body does not leave the plate any more it lies still.
Fall filmed(const Truth& truth, std::uint64_t seed, std::uint64_t fall) {
    const auto even = [&](std::size_t i) { return even_draw(seed, 2 * fall, i); };
    Flight body;
    body.place << 0.1 * even(0), truth.height + truth.radius * (2 + 3 * even(1)), 2 * pi * even(2);
    body.velocity << truth.speed * (2 * even(3) - 1), -truth.speed * even(4), truth.spin * (2 * even(5) - 1);
    Fall filmed;
    double end = next_impact(truth, body);
    constexpr double lasts = 0.8;
    for (std::size_t i = 0; static_cast<double>(i) < lasts * truth.frames_a_second; ++i) {
        const double time = static_cast<double>(i) / truth.frames_a_second;
        while (end < time) {
            const Flight before = body.at(truth, end);
            body = after_impact(truth, before);
            filmed.impacts.emplace_back(before, body);
            end = next_impact(truth, body);
        }
        const Vector3d noise = analysis::normal_draws(seed, 2 * fall + 1, i);
        const Vector3d place = std::isnan(end) ? body.place : body.at(truth, time).place;
        FilmFrame frame;
        frame.time = time;
        frame.place = place + Vector3d(truth.place_noise, truth.place_noise, truth.angle_noise).cwiseProduct(noise);
        for (double& number : frame.place) number = truth.digit * std::round(number / truth.digit);
        filmed.frames.push_back(frame);
    }
    return filmed;
}

std::vector<std::vector<FilmFrame>> falls_of(const Truth& truth, std::size_t count, std::uint64_t seed) {
    std::vector<std::vector<FilmFrame>> falls;
    for (std::size_t i = 0; i < count; ++i) falls.push_back(filmed(truth, seed, i).frames);
    return falls;
}

FallsFit fit_of(const Truth& truth, std::size_t count, std::uint64_t seed, std::size_t resamples,
                const FallsSetting& setting = {}) {
    analysis::ImpactFitSettings settings;
    settings.resamples = resamples;
    settings.threads = 1;
    return fit_falls(falls_of(truth, count, seed), 2 * pi, truth.body(), setting, settings);
}

/// Another body than the film's.
FallsFit fit_as(const Truth& truth, int sides, double size, std::size_t falls) {
    FallenBody body = truth.body();
    body.sides = sides;
    body.radius *= size, body.inertia *= size * size;
    analysis::ImpactFitSettings settings;
    settings.resamples = 0;
    settings.threads = 1;
    return fit_falls(falls_of(truth, falls, 1), 2 * pi, body, {}, settings);
}

bool holds(const analysis::FittedNumber& number, double truth) {
    return number.low <= truth && !(number.high < truth);
}

TEST(Falls, GiveGravityPlateAndLaw) {
    Truth truth;
    truth.tilt = 0.05;
    const FallsFit falls = fit_of(truth, 8, 1, 20);
    ASSERT_EQ(falls.outcome, FallsFitOutcome::fitted);
    const Vector2d gravity = truth.radius * falls.fall.model.gravity, error = truth.radius * falls.fall.error;
    EXPECT_NEAR(gravity[0], 0, 4 * error[0]);
    EXPECT_NEAR(gravity[1], -truth.gravity, 4 * error[1]);
    EXPECT_LT(error[1], 0.05);
    EXPECT_EQ(falls.fall.model.drags.places, 0);
    EXPECT_NEAR(falls.plate.tilt, truth.tilt, 2e-3);
    EXPECT_NEAR(truth.radius * falls.plate_height(), truth.height, 1e-4);
    EXPECT_NEAR(std::remainder(falls.plate.mark - truth.mark, pi / 2), 0, 5e-3);
    EXPECT_NEAR(truth.radius * falls.arcs.place_noise, truth.place_noise, 0.1 * truth.place_noise);
    EXPECT_TRUE(holds(falls.fit.restitution, truth.restitution));
    EXPECT_TRUE(holds(falls.fit.friction, truth.friction));
    EXPECT_LT(falls.fit.restitution.high - falls.fit.restitution.low, 0.1);
    EXPECT_TRUE(holds(falls.fit.balance, truth.body().inertia));
    EXPECT_GT(falls.fit.predicted, 0.7);
    ASSERT_EQ(falls.subsets.size(), 9U);  // parts, and the other divisions
    EXPECT_EQ(falls.subsets[0].impacts + falls.subsets[1].impacts,
              falls.counts[static_cast<std::size_t>(KinkUse::used)]);
    EXPECT_EQ(falls.fall_at(falls.starts[3]), 3U);
}

TEST(Falls, ADragOnTopOfGravityBendsArcsOtherwise) {
    Truth truth;
    truth.drag = 0.5, truth.spin_drag = 0.6;
    const FallsFit falls = fit_of(truth, 8, 2, 20);
    ASSERT_EQ(falls.outcome, FallsFitOutcome::fitted);
    EXPECT_NEAR(falls.fall.drag.value, truth.drag, 4 * falls.fall.drag.error);
    EXPECT_NEAR(falls.fall.spin.value, truth.spin_drag, 4 * falls.fall.spin.error);
    EXPECT_GT(falls.fall.model.drags.places, 0);
    EXPECT_NEAR(truth.radius * falls.fall.model.gravity[1], -truth.gravity, 4 * truth.radius * falls.fall.error[1]);
    EXPECT_TRUE(holds(falls.fit.restitution, truth.restitution));
    EXPECT_TRUE(holds(falls.fit.friction, truth.friction));
}

TEST(Falls, YPointsDown) {
    const Truth truth;
    auto falls = falls_of(truth, 6, 3);
    for (auto& fall : falls)
        for (FilmFrame& frame : fall) frame.place[1] *= -1, frame.place[2] *= -1;
    analysis::ImpactFitSettings settings;
    settings.resamples = 0;
    EXPECT_EQ(fit_falls(falls, 2 * pi, truth.body(), {}, settings).outcome, FallsFitOutcome::falls_up);
}

TEST(Falls, ContactsThatStickTellNoUpperEndOfFriction) {
    Truth truth;
    truth.friction = 3;
    const FallsFit falls = fit_of(truth, 8, 4, 20);
    ASSERT_EQ(falls.outcome, FallsFitOutcome::fitted);
    EXPECT_TRUE(falls.fit.friction_open);
    EXPECT_LT(falls.fit.friction.low, truth.friction);
    EXPECT_TRUE(holds(falls.fit.restitution, truth.restitution));
}

TEST(Falls, APreciseFilmIsOneOfFallsToo) {
    Truth truth;  // straight pieces of what flies have two frames, and what lies still is straight for long
    truth.place_noise = 5e-6, truth.angle_noise = 1e-4, truth.digit = 1e-7;
    const FallsFit falls = fit_of(truth, 8, 5, 0);
    ASSERT_EQ(falls.outcome, FallsFitOutcome::fitted);
    EXPECT_NEAR(truth.radius * falls.fall.model.gravity[1], -truth.gravity, 4 * truth.radius * falls.fall.error[1]);
    EXPECT_NEAR(falls.fit.restitution.value, truth.restitution, 0.001);
    EXPECT_NEAR(falls.fit.friction.value, truth.friction, 0.001);
}

/// Flights that each have an acceleration of their own beside gravity, of that standard deviation.
analysis::FilmArcs wandering_flights(double acceleration, double spin_acceleration) {
    constexpr std::size_t flights = 60, frames = 30;
    constexpr double step = 0.004, gravity = 9.81, noise = 5e-5, angle_noise = 1e-3;
    std::vector<FilmFrame> film;
    for (std::size_t k = 0; k < flights; ++k) {
        const Vector3d own =
            Vector3d(acceleration, acceleration, spin_acceleration).cwiseProduct(analysis::normal_draws(7, 0, k));
        for (std::size_t i = 0; i < frames; ++i) {
            const double time = step * static_cast<double>(i);
            FilmFrame frame;
            frame.time = time + step * static_cast<double>(k * (frames + 20));
            frame.place = Vector3d(0.3, 0.5, 2) * time + own * time * time / 2;
            frame.place[1] -= gravity * time * time / 2;
            frame.place += Vector3d(noise, noise, angle_noise).cwiseProduct(analysis::normal_draws(7, k + 1, i));
            film.push_back(frame);
        }
    }
    analysis::ArcOptions options;
    options.fall = {{0, -gravity}, 0};
    options.division_noise.setConstant(1);
    return analysis::fit_arcs(film, 2 * pi, options);
}

TEST(Falls, AccelerationsThatNoModelHasAreSeen) {
    const auto seen = [](double acceleration, double spin_acceleration) {
        const analysis::FilmArcs arcs = wandering_flights(acceleration, spin_acceleration);
        EXPECT_EQ(arcs.arcs.size(), 60U);
        return analysis::unmodelled_accelerations(arcs, std::vector<bool>(arcs.arcs.size(), true));
    };
    EXPECT_EQ(seen(0, 0), Vector3d::Zero());
    const Vector3d both = seen(0.3, 20);
    EXPECT_NEAR(both[0], 0.3, 0.1);
    EXPECT_EQ(both[0], both[1]);
    EXPECT_NEAR(both[2], 20, 8);
}

TEST(Falls, ACovarianceOfIndependentErrorsSaysWhatTheErrorsDo) {
    std::vector<analysis::MeasuredImpact> alone;
    for (std::size_t i = 0; i < 30; ++i) {
        const Vector3d draw = analysis::normal_draws(1, 0, i), other = analysis::normal_draws(1, 1, i);
        analysis::MeasuredImpact impact;
        impact.before << draw[0], -1 - 0.1 * draw[1], draw[2];
        impact.offset << 0.5 * std::sin(other[0]), -0.9;
        const auto found = impact_laws()[0].law(impact.offset, 0.3,
                                                analysis::contact_velocity(impact.offset, impact.before), {0.6, 0.2});
        impact.after = impact.before + analysis::effect_of_impulse(impact.offset, 0.3) * found.impulse + 0.02 * other;
        impact.error_before << 0.02, 0.01, 0.03;
        impact.error_after << 0.01, 0.02, 0.02;
        alone.push_back(impact);
    }
    std::vector<analysis::MeasuredImpact> together = alone;
    for (analysis::MeasuredImpact& impact : together) {
        Eigen::Matrix<double, 8, 1> errors;
        errors << impact.error_before, impact.error_after, 0, 0;
        impact.covariance = errors.cwiseAbs2().asDiagonal();
    }
    const std::vector<double> once(alone.size(), 1);
    const double inertia = analysis::fit_inertia(alone, once, 0.4).inertia;
    EXPECT_NEAR(analysis::fit_inertia(together, once, 0.4).inertia, inertia, 1e-9);
    for (std::size_t i = 0; i < alone.size(); ++i) {
        const auto of = [&](const analysis::MeasuredImpact& impact) {
            return analysis::predict(impact, 0.3, impact_laws()[0].law, {0.6, 0.2}).squared;
        };
        EXPECT_NEAR(of(together[i]), of(alone[i]), 1e-9 * of(alone[i]));
        together[i].covariance->bottomRightCorner<2, 2>().diagonal().setConstant(1e-3);
        EXPECT_LT(of(together[i]), of(alone[i]));
    }
}

TEST(Falls, TellTheBodysSizeAndSides) {
    const Truth truth;
    const FallsFit same = fit_as(truth, 4, 1, 15);
    ASSERT_EQ(same.outcome, FallsFitOutcome::fitted);
    EXPECT_NEAR(same.body->size, 1, 4 * same.body->error);
    EXPECT_LT(same.body->error, 0.02);
    EXPECT_FALSE(same.shape);
    for (const double size : {0.5, 1.25, 2.0}) {
        const FallsFit other = fit_as(truth, 4, size, 15);
        ASSERT_EQ(other.outcome, FallsFitOutcome::another_size) << size;
        EXPECT_NEAR(size * other.body->size, 1, 4 * size * other.body->error) << size;
    }
    for (const int sides : {3, 6}) {
        const FallsFit other = fit_as(truth, sides, 1, 15);
        ASSERT_EQ(other.outcome, FallsFitOutcome::another_shape) << sides;
        EXPECT_EQ(other.shape->sides, 4) << sides;
        EXPECT_NEAR(other.shape->size, 1, 0.05) << sides;
    }
}

TEST(Falls, FewKinksHideHowRoundCornersAre) {
    BodyOnPlate body;
    body.expected = 1, body.scatter = 1.3;
    for (const auto& [kinks, is_sharp] : {std::pair{4, false}, {8, false}, {50, true}}) {
        body.kinks = static_cast<std::size_t>(kinks);
        EXPECT_EQ(body.is_sharp(), is_sharp) << kinks;  // 1.3 sqrt(8/4) > 1.5
    }
}

/// Errors of (before, after, offset) of all impacts that are used, in units of those that are stated.
struct StatedErrors {
    std::size_t impacts = 0, others = 0;  ///< others: no one impact was there
    Eigen::Matrix<double, 8, 1> squares = Eigen::Matrix<double, 8, 1>::Zero();
    double held_out = 0, predicted = 0;

    Eigen::Matrix<double, 8, 1> rms() const { return (squares / static_cast<double>(impacts)).cwiseSqrt(); }
};

Eigen::Matrix<double, 8, 1> true_numbers(const Truth& truth, const Flight& before, const Flight& after) {
    const Vector2d normal = truth.normal(), along(normal[1], -normal[0]), arm = lowest(truth, before.place).second;
    const auto in_axes = [&](const Vector3d& v) {
        return Vector3d(along.dot(v.head<2>()), normal.dot(v.head<2>()), v[2]);
    };
    Eigen::Matrix<double, 8, 1> numbers;
    numbers << in_axes(before.velocity), in_axes(after.velocity), along.dot(arm), normal.dot(arm);
    return numbers;
}

void add_errors(StatedErrors& errors, const Truth& truth, std::size_t count, std::uint64_t seed,
                std::size_t resamples) {
    std::vector<Fall> filmed_falls;
    std::vector<std::vector<FilmFrame>> falls;
    for (std::size_t i = 0; i < count; ++i) {
        filmed_falls.push_back(filmed(truth, seed, i));
        falls.push_back(filmed_falls.back().frames);
    }
    analysis::ImpactFitSettings settings;
    settings.resamples = resamples;
    settings.threads = 1;
    const FallsFit fit = fit_falls(falls, 2 * pi, truth.body(), {}, settings);
    ASSERT_EQ(fit.outcome, FallsFitOutcome::fitted);
    ASSERT_EQ(fit.alike + fit.thinned, 0U);  // impacts are those that are used, in their order
    std::size_t used = 0;
    for (const FilmImpact& found : fit.impacts) {
        if (found.use != KinkUse::used) continue;
        const analysis::MeasuredImpact& impact = fit.fit.impacts[used++];
        const std::size_t fall = fit.fall_at(found.kink.time);
        const double step = 1 / truth.frames_a_second;
        std::vector<std::pair<Flight, Flight>> there;
        for (const auto& hit : filmed_falls[fall].impacts)
            if (hit.first.start > found.kink.earliest - fit.starts[fall] - step &&
                hit.first.start < found.kink.latest - fit.starts[fall] + step)
                there.push_back(hit);
        if (there.size() != 1) {
            ++errors.others;
            continue;
        }
        Eigen::Matrix<double, 8, 1> measured;
        measured << impact.before, impact.after, impact.offset;
        const Eigen::Matrix<double, 8, 1> off = measured - true_numbers(truth, there[0].first, there[0].second);
        errors.squares += off.cwiseAbs2().cwiseQuotient(impact.covariance->diagonal());
        ++errors.impacts;
    }
    errors.held_out += static_cast<double>(fit.fit.held_out.size());
    if (resamples > 0) errors.predicted += fit.fit.predicted * static_cast<double>(fit.fit.held_out.size());
}

TEST(Falls, ErrorsOfImpactsAreWhatIsStated) {
    StatedErrors errors;
    Truth truth;
    for (const std::uint64_t seed : {11, 12}) add_errors(errors, truth, 15, seed, 0);
    ASSERT_GT(errors.impacts, 60U);
    for (const double rms : errors.rms()) EXPECT_NEAR(rms, 1, 0.3);  // those of plate and fall are common to a film
}

/// Bodies and films as of IntervalsHoldTheTruth.
Truth truth_of(std::size_t draw) {
    Truth truth;
    const double frictions[] = {0.05, 0.15, 0.3, 0.6}, restitutions[] = {0.3, 0.5, 0.7, 0.9};
    const int sides[] = {4, 3, 6, 4};
    truth.friction = frictions[draw % 4], truth.restitution = restitutions[(draw / 4) % 4];
    truth.sides = sides[(draw / 2) % 4], truth.law = draw % 3;
    truth.drag = draw % 2 == 0 ? 0 : 0.4, truth.spin_drag = truth.drag;
    truth.tilt = draw % 5 == 0 ? 0.1 : 0;
    truth.frames_a_second = draw % 3 == 0 ? 500 : 250;
    truth.place_noise = draw % 7 == 0 ? 2e-4 : 5e-5, truth.angle_noise = 20 * truth.place_noise;
    return truth;
}

TEST(FallsNightly, ErrorsOfImpactsAreWhatIsStated) {
    StatedErrors errors;
    for (std::size_t draw = 0; draw < 18; ++draw) add_errors(errors, truth_of(draw), 20, 1000 + draw, 20);
    const double predicted = errors.predicted / errors.held_out;
    std::cout << errors.impacts << " impacts (" << errors.others << " no single ones); rms in units of the errors "
              << errors.rms().transpose() << "; held out, within the noise: " << predicted << std::endl;
    for (const double rms : errors.rms()) EXPECT_NEAR(rms, 1, 0.1);
    EXPECT_LE(100 * errors.others, errors.impacts);
    EXPECT_GE(predicted, 0.9);
    EXPECT_LE(predicted, 0.98);
}

struct Count {
    std::size_t fits = 0, refused = 0, restitution = 0, friction = 0, inertia = 0, gravity = 0, predicted = 0;
};

/// Bodies that slip, stick and do either; three laws, with and without a drag, on a level plate and a tilted one, two
/// rates of frames.
Count count_of(std::size_t draws, std::size_t falls, std::uint64_t seed, std::size_t resamples) {
    Count count;
    for (std::size_t draw = 0; draw < draws; ++draw) {
        const Truth truth = truth_of(draw);
        const FallsFit found = fit_of(truth, falls, seed + draw, resamples);
        if (found.outcome != FallsFitOutcome::fitted) {
            ++count.refused;
            continue;
        }
        ++count.fits;
        count.restitution += holds(found.fit.restitution, truth.restitution) ? 1 : 0;
        count.friction += holds(found.fit.friction, truth.friction) ? 1 : 0;
        count.inertia += holds(found.fit.balance, truth.body().inertia) ? 1 : 0;
        const double off = std::abs(truth.radius * found.fall.model.gravity[1] + truth.gravity);
        count.gravity += off <= 1.96 * truth.radius * found.fall.error[1] ? 1 : 0;
    }
    return count;
}

void expect_covered(const Count& count) {
    std::cout << count.fits << " fits (" << count.refused << " refused); inside: e " << count.restitution << ", mu "
              << count.friction << ", I/m " << count.inertia << ", gravity " << count.gravity << std::endl;
    const auto most = static_cast<double>(count.fits);
    EXPECT_GE(static_cast<double>(count.restitution), 0.9 * most);
    EXPECT_GE(static_cast<double>(count.friction), 0.9 * most);
    EXPECT_GE(static_cast<double>(count.inertia), 0.88 * most);
    EXPECT_GE(static_cast<double>(count.gravity), 0.88 * most);
}

/// Short films, of which one number in ten may be outside by chance.
TEST(Falls, IntervalsOfAFewFilmsHoldTheTruth) {
    const Count count = count_of(5, 8, 500, 20);
    EXPECT_GE(count.fits, 4U);
    EXPECT_GE(count.restitution + count.friction + count.inertia + count.gravity, 4 * count.fits - 3);
    EXPECT_GE(count.restitution + 1, count.fits);
    EXPECT_GE(count.friction + 1, count.fits);
}

TEST(FallsNightly, IntervalsHoldTheTruth) {
    const Count count = count_of(120, 20, 1000, 100);
    EXPECT_LE(count.refused, 6U);
    expect_covered(count);
}

}  // namespace
}  // namespace swirl::studies
