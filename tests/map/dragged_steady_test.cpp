// Steady modes over a floor that drags: solutions of three equations are fixed points of the map, and its fixed points
// solve them. And what is known in closed form of riding and of rolling locked to the swirl.
#include "map/dragged/dragged_derivative.hpp"
#include "map/dragged/dragged_modes.hpp"
#include "map/dragged/floor_facts.hpp"
#include "map/orbit/orbit.hpp"
#include "tests/map/dragged_draw.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <optional>
#include <stdexcept>

namespace swirl {
namespace {

using Number = std::complex<double>;
using Unknowns = Eigen::Vector3d;  // tau, psi, chi

/// A steady mode by its three unknowns and j: with P₀ = 1 − α cis χ + hβ cis(−ψ), the body's place from the circle's
/// centre, a flight turns everything by τ, so that U D = E P₀; the impulse is −p + iq = U (1 − e^{−γτ} cis(−τ)).
struct Mode {
    SectionPoint<double> z;
    Eigen::Vector3d residual;
};

template <ImpactRule rule>
Mode mode_of(const Scene<double>& scene, const Unknowns& unknowns, int j) {
    const Body<double> body = make_body(scene);
    const double tau = unknowns[0], psi = unknowns[1], chi = unknowns[2];
    const double g = scene.drag, r = scene.turning_drag(), alpha = scene.alpha;
    const Number h = scene.floor == Floor::dish ? 1.0 / Number(1, -g) : Number(1);
    const Number carrying = scene.floor == Floor::dish ? g * h : Number(0);
    const Number swirl = std::polar(scene.beta, -psi), arm = std::polar(alpha, chi);
    const Number place = 1.0 - arm + h * swirl;
    const Number stream = (std::polar(1.0, tau) - 1.0) * place * g / -std::expm1(-g * tau);
    const Number jump = stream * (1.0 - std::exp(-g * tau) * std::polar(1.0, -tau));
    const double p = -jump.real(), q = jump.imag();
    const double turned = tau - 2 * pi<double>() * j / scene.sides;
    const double spin = turned * r / -std::expm1(-r * tau), before_spin = spin * std::exp(-r * tau);
    const Number after = stream + carrying * swirl, before = after - jump;
    const PostImpactState<double> state{
        {std::cos(psi), std::sin(psi)}, {std::cos(chi), std::sin(chi)}, before.real(), before.imag(), before_spin};
    const Impulse<double> law = impulse<rule>(contact_kinematics(body, state), scene.mu, scene.restitution);
    Mode mode;
    mode.z = {psi, chi, after.real(), after.imag(), spin};
    mode.residual = {law.normal - p, law.tangential - q,
                     (spin - before_spin) * body.inertia - (arm.real() * q + arm.imag() * p)};
    return mode;
}

template <ImpactRule rule>
std::optional<Unknowns> solved(const Scene<double>& scene, Unknowns x, int j) {
    for (int i = 0; i < 60; ++i) {
        if (!(x[0] > 0.02 && x[0] < 15)) return std::nullopt;
        const Eigen::Vector3d f = mode_of<rule>(scene, x, j).residual;
        if (!f.allFinite()) return std::nullopt;
        Eigen::Matrix3d d;
        for (int k = 0; k < 3; ++k) {
            Unknowns up = x, down = x;
            up[k] += 1e-6;
            down[k] -= 1e-6;
            d.col(k) = (mode_of<rule>(scene, up, j).residual - mode_of<rule>(scene, down, j).residual) / 2e-6;
        }
        Unknowns step = d.fullPivLu().solve(-f);
        if (!step.allFinite()) return std::nullopt;
        step *= std::min(1.0, 0.5 / step.norm());
        x += step;
        if (step.norm() < 1e-13 && f.norm() < 1e-12) return x;
    }
    return std::nullopt;
}

double apart(const SectionPoint<double>& a, const SectionPoint<double>& b) {
    return std::max({std::abs(wrapped_angle(a.psi - b.psi)), std::abs(wrapped_angle(a.chi - b.chi)),
                     std::abs(a.vn - b.vn), std::abs(a.vt - b.vt), std::abs(a.spin - b.spin)});
}

constexpr ImpactRule rule = ImpactRule::poisson;
using Map = DraggedMap<double, Shape::polygon, rule>;

Scene<double> hexagon(double drag, double spin_drag, Floor floor) {
    Scene<double> scene{.sides = 6,
                        .alpha = 0.4,
                        .beta = 0.5,
                        .mu = 0.5,
                        .restitution = 0.9,
                        .inertia_factor = uniform_inertia_factor<double>(6)};
    scene.drag = drag;
    scene.spin_drag = spin_drag;
    scene.floor = floor;
    return scene;
}

/// A start that is inside and leaves.
bool is_start(const Map& map, const SectionPoint<double>& z) {
    try {
        require_leaving(map.body(), z);
        return contact_kinematics(map.body(), post_impact_state(z)).un < -1e-6;
    } catch (const std::invalid_argument&) {
        return false;
    }
}

/// What Newton's method finds from random starts, and the map confirms, is in the list made on a grid.
TEST(DraggedSteady, TheListHasWhatRandomStartsFind) {
    tests::DraggedDraw draw(5);
    int found = 0, missing = 0;
    for (const Floor floor : {Floor::dish, Floor::table}) {
        const Scene<double> scene = hexagon(0.3, 0.2, floor);
        const Map map(scene);
        const DraggedModes listed = dragged_modes(scene, {.longest_flight = 6, .fastest_spin = 6});
        EXPECT_EQ(listed.searched_to, 6);
        for (int i = 0; i < 400; ++i) {
            const Unknowns start{draw.uniform(0.1, 6), draw.uniform(-3.14, 3.14), draw.uniform(-0.3, 0.3)};
            const int j = static_cast<int>(draw.uniform(-3, 9));
            const auto x = solved<rule>(scene, start, j);
            if (!x || (*x)[0] > 6) continue;
            const Mode mode = mode_of<rule>(scene, *x, j);
            if (std::abs(mode.z.spin) > 6 || !is_start(map, mode.z)) continue;
            const auto next = map.advance(post_impact_state(mode.z));
            if (std::abs(next.flight_time - (*x)[0]) > 1e-9) continue;
            ++found;
            missing += std::none_of(listed.modes.begin(), listed.modes.end(), [&](const SteadyMode& other) {
                return other.j == j && apart(other.point, mode.z) < 1e-7;
            });
        }
    }
    std::printf("  %d times one was found, %d times one that is not listed\n", found, missing);
    EXPECT_GT(found, 20);
    EXPECT_EQ(missing, 0);
}

TEST(DraggedSteady, SolutionsOfTheThreeEquationsAreFixedPoints) {
    tests::DraggedDraw draw(21);
    int solutions = 0, confirmed = 0, preceded = 0;
    for (const double drag : {0.01, 0.1, 0.5})
        for (const Floor floor : {Floor::dish, Floor::table}) {
            const Scene<double> scene = hexagon(drag, floor == Floor::dish ? drag : 0.3 * drag, floor);
            const Map map(scene);
            for (int i = 0; i < 200; ++i) {
                const Unknowns start{draw.uniform(0.1, 8), draw.uniform(-3.14, 3.14), draw.uniform(-0.3, 0.3)};
                const int j = static_cast<int>(draw.uniform(0, 6));
                const auto x = solved<rule>(scene, start, j);
                if (!x) continue;
                const Mode mode = mode_of<rule>(scene, *x, j);
                if (!is_start(map, mode.z)) continue;
                ++solutions;
                const auto next = map.advance(post_impact_state(mode.z));
                ASSERT_EQ(next.outcome, FirstContactOutcome::contact);
                EXPECT_LE(next.flight_time, (*x)[0] + 1e-9);  // what the equations have touch is no later
                if (next.flight_time < (*x)[0] - 1e-9) {      // another vertex, or this one, strikes before
                    ++preceded;
                    continue;
                }
                EXPECT_EQ(next.vertex_step, j);
                const auto d = derivative_by_saltation(map, post_impact_state(mode.z), next);
                EXPECT_LE(apart(section_point(next.after), mode.z), 1e-11 * (1 + d.norm()));
                ++confirmed;
            }
        }
    std::printf("%d solutions, %d confirmed by the map, %d preceded by another contact\n", solutions, confirmed,
                preceded);
    EXPECT_GE(confirmed, 100);
}

TEST(DraggedSteady, FixedPointsSolveTheThreeEquations) {
    tests::DraggedDraw draw(22);
    int found = 0;
    double worst = 0;
    for (const double drag : {0.02, 0.2})
        for (const Floor floor : {Floor::dish, Floor::table}) {
            const Scene<double> scene = hexagon(drag, 2 * drag, floor);
            const Map map(scene);
            for (int i = 0; i < 400; ++i) {
                SectionPoint<double> z = draw.point(scene);
                for (int k = 0; k < 40; ++k) {
                    if (!is_start(map, z)) break;
                    const auto next = map.advance(post_impact_state(z));
                    if (next.outcome != FirstContactOutcome::contact) break;
                    const auto image = section_point(next.after);
                    if (apart(image, z) < 1e-12) {
                        const Mode mode = mode_of<rule>(scene, {next.flight_time, z.psi, z.chi}, next.vertex_step);
                        // S is known from τ: a turn of 2π more is the same vertex.
                        const double turns = std::round(
                            (map.turned(z.spin, next.flight_time) - map.turned(mode.z.spin, next.flight_time)) /
                            (2 * pi<double>()));
                        const Mode same = mode_of<rule>(scene, {next.flight_time, z.psi, z.chi},
                                                        next.vertex_step - static_cast<int>(turns) * scene.sides);
                        const double error = std::max(same.residual.cwiseAbs().maxCoeff(), apart(same.z, z));
                        worst = std::max(worst, error);
                        EXPECT_LE(error, 1e-9);
                        ++found;
                        break;
                    }
                    const Eigen::Matrix<double, 5, 5> d = derivative_by_saltation(map, post_impact_state(z), next);
                    Eigen::Matrix<double, 5, 1> f;
                    f << wrapped_angle(image.psi - z.psi), wrapped_angle(image.chi - z.chi), image.vn - z.vn,
                        image.vt - z.vt, image.spin - z.spin;
                    Eigen::Matrix<double, 5, 1> step =
                        (d - Eigen::Matrix<double, 5, 5>::Identity()).fullPivLu().solve(-f);
                    if (!step.allFinite()) break;
                    step *= std::min(1.0, 0.5 / step.norm());
                    z = {wrapped_angle(z.psi + step[0]), z.chi + step[1], z.vn + step[2], z.vt + step[3],
                         z.spin + step[4]};
                }
            }
        }
    std::printf("%d times a fixed point, largest residual %.1e\n", found, worst);
    EXPECT_GE(found, 50);
}

/// The forces on a disk that rolls locked to the swirl, in the laboratory: the wall's and the floor's are m P″, and
/// their moment is I S′ = 0.
TEST(DraggedSteady, LockedRollingBalancesItsForces) {
    tests::DraggedDraw draw(23);
    int locked = 0, free = 0;
    for (int i = 0; i < 400; ++i) {
        Scene<double> scene = draw.scene(1e-2, 3);
        scene.sides = disk_sides;
        scene.mu = 10;
        scene.beta = draw.uniform(0.01, 2);
        scene.inertia_factor = draw.uniform(0.2, 1);
        const FloorFacts facts = floor_facts(scene);
        ASSERT_TRUE(facts.locking_ratio.has_value());
        ASSERT_EQ(facts.locked.has_value(), *facts.locking_ratio <= 1);
        if (!facts.locked) {
            ++free;
            continue;
        }
        ++locked;
        const double psi = facts.locked->psi, rho = 1 - scene.alpha, spin = facts.locked->spin;
        const Number swirl = std::polar(scene.beta, -psi), i1(0, 1);  // axes (n, t)
        const Number velocity = i1 * (swirl + rho), acceleration = -(swirl + rho);
        const Number wind = scene.floor == Floor::dish ? i1 * swirl : Number(0);
        const double slip = velocity.imag() + scene.alpha * spin - (i1 * swirl).imag();
        const double friction = scene.turning_drag() * scene.inertia_factor * scene.alpha * spin;  // from α f = γ_r I S
        const Number force = acceleration + scene.drag * (velocity - wind);
        EXPECT_NEAR(slip, 0, 1e-14);
        EXPECT_NEAR(force.imag(), friction, 1e-13);
        EXPECT_NEAR(-force.real(), facts.locked->force, 1e-13);
        EXPECT_NEAR(std::abs(friction), facts.locked->friction * facts.locked->force, 1e-13);
        // Restored: a disk that is ahead is driven back.
        const double ahead = psi + 1e-6;
        const double tilt = scene.floor == Floor::table ? scene.drag : 0;
        const double pull = -scene.beta * (std::sin(ahead) + tilt * std::cos(ahead)) -
                            (scene.drag + scene.inertia_factor * scene.turning_drag()) * rho;
        EXPECT_LE(pull, 0);
    }
    EXPECT_GT(locked, 50);
    EXPECT_GT(free, 50);
}

}  // namespace
}  // namespace swirl
