// Polygons with rounded corners: their numbers, reference orbits, the sharp polygon and the disk as their ends,
// balances of J, DF.
#include "map/corners/corner_derivative.hpp"
#include "map/corners/corner_map.hpp"
#include "map/numbers/quad.hpp"
#include "map/orbit/laboratory.hpp"
#include "map/orbit/orbit.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/map/reference_orbits.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace swirl {
namespace {

using tests::Random;

/// |χ| up to which the other corners have room.
double room_of(const Scene<double>& scene) {
    const Body<double> body = make_body(scene);
    return std::numbers::pi / scene.sides - std::asin(body.alpha * std::sin(std::numbers::pi / scene.sides));
}

Scene<double> random_rounded(Random& random, double share) {
    const double mu = random.chance(0.2) ? 0 : random.between(0, 1.5),
                 e = random.chance(0.3) ? 1 : random.between(0.3, 1);
    const int sides = random.one_of({2, 3, 4, 5, 6, 8, 12});
    const int law = random.one_of({0, 1, 2});
    Scene<double> scene = tests::random_scene(random, sides, mu, e, static_cast<Law>(law));
    scene.corner = share * scene.alpha;
    scene.inertia_factor = uniform_inertia_factor<double>(sides, scene.alpha, scene.corner);
    return scene;
}

/// A state just after an impact that leaves the wall at |u_n| = `leaving`.
SectionPoint<double> random_leaving(Random& random, const Scene<double>& scene, double leaving) {
    SectionPoint<double> z;
    z.psi = random.angle();
    z.chi = 0.999 * room_of(scene) * random.between(-1, 1);
    z.spin = random.between(-3, 3);
    z.vt = random.between(-1, 1) + scene.beta * std::cos(z.psi);
    z.vn = -leaving + (scene.alpha - scene.corner) * z.spin * std::sin(z.chi) + scene.beta * std::sin(z.psi);
    return z;
}

TEST(RoundCorner, InertiaIsTheQuadratureOfItsShape) {
    double worst = 0;
    for (const int sides : {2, 3, 4, 5, 6, 8, 12, 100})
        for (const double r : {1e-3, 0.02, 0.1, 0.25, 0.39, 0.4 - 1e-9}) {
            // Round the edge, from the middle of a side to the next: half a side, the corner, half a side. ∮ z × dz and
            // ∮ |z|² z × dz by the midpoint rule, Richardson's extrapolation of it.
            const double half = std::numbers::pi / sides, rho = 0.4 - r;
            const auto sums = [&](int n) {
                Vec2<long double> sum{0, 0};
                const auto add = [&](const Vec2<long double>& z, const Vec2<long double>& dz) {
                    sum.x += cross(z, dz);
                    sum.y += dot(z, z) * cross(z, dz);
                };
                const Vec2<long double> n0 = cis(static_cast<long double>(-half)), along{-n0.y, n0.x};
                const long double reach = 2 * rho * std::sin(half), off = rho * std::cos(half) + r;
                for (int i = 0; i < n; ++i) {
                    const long double s = (i + 0.5L) / n;
                    add(off * n0 + ((s - 0.5L) * reach) * along, (reach / n) * along);
                    const Vec2<long double> u = cis((2 * s - 1) * static_cast<long double>(half));
                    add(Vec2<long double>{rho + r * u.x, r * u.y},
                        (static_cast<long double>(r) * 2 * half / n) * Vec2<long double>{-u.y, u.x});
                }
                return sum;
            };
            const auto coarse = sums(2000), fine = sums(4000);
            const long double area = (4 * fine.x - coarse.x) / 3 / 2, second = (4 * fine.y - coarse.y) / 3 / 4;
            const double kappa = static_cast<double>(second / area) / (0.4 * 0.4);
            const double found = uniform_inertia_factor<double>(sides, 0.4, r);
            worst = std::max(worst, std::abs(found - kappa));
        }
    std::printf("kappa within %.2g\n", worst);
    EXPECT_LE(worst, 1e-12);
    for (const int sides : {2, 3, 6}) {
        EXPECT_EQ(uniform_inertia_factor<double>(sides, 0.4, 0.0), uniform_inertia_factor<double>(sides));
        EXPECT_NEAR(uniform_inertia_factor<double>(sides, 0.4, 1e-9), uniform_inertia_factor<double>(sides), 1e-7);
        EXPECT_NEAR(uniform_inertia_factor<double>(sides, 0.4, 0.4), 0.5, 1e-15);
    }
}

/// The 24 orbits of tests/references/corner_trajectories.json.
template <class T>
void reproduce(const tests::Tolerance& tolerance, int least) {
    const nlohmann::json references = tests::read_reference("corner_trajectories.json");
    tests::Reproduced tally;
    for (const nlohmann::json& orbit : references["cases"]) {
        SCOPED_TRACE("orbit " + std::to_string(tally.orbits));
        with_corner_map(tests::scene_from<T>(orbit), [&](const auto& map) {
            tests::follow_reference(map, orbit, tolerance, tally, [](const auto&, const auto&, int) {});
        });
        ++tally.orbits;
    }
    std::printf("%d orbits, %d impacts, largest error %.3f of what is allowed\n", tally.orbits, tally.impacts,
                tally.worst);
    EXPECT_EQ(tally.orbits, 24);
    EXPECT_GE(tally.impacts, least);
}

TEST(RoundCorner, ReferenceOrbitsAreReproducedInDouble) {
    reproduce<double>({1e-13, 1e-12, 1e10}, 250);
}
TEST(RoundCorner, ReferenceOrbitsAreReproducedInLongDouble) {
    reproduce<long double>({1e-13 / 2048, 1e-12 / 2048, 1e13}, 250);
}
TEST(RoundCorner, ReferenceOrbitsAreReproducedInQuad) {
    reproduce<Quad>({1e-24, 1e-22, HUGE_VAL}, 288);
}

/// States after `impacts` impacts from a start in the laboratory; empty if there are not so many.
template <class Map>
std::vector<LabState<double>> states(const Map& map, const LabStart<double>& start, int impacts) {
    Orbit orbit(map, start);
    std::vector<LabState<double>> all;
    while (orbit.impacts() < impacts && orbit.advance()) all.push_back(orbit.lab());
    return all;
}

double distance(const LabState<double>& a, const LabState<double>& b, bool with_angle) {
    double most = 0;
    for (const double d : {a.t - b.t, a.x - b.x, a.y - b.y, a.vx - b.vx, a.vy - b.vy, a.spin - b.spin,
                           with_angle ? a.angle - b.angle : 0.0})
        most = std::max(most, std::abs(d));
    return most;
}

TEST(RoundCorner, JoinsTheSharpPolygonAsItsRadiusFalls) {
    constexpr int impacts = 6;
    Random random(31);
    std::printf("r: largest change of 6 impacts, and that over r\n");
    std::vector<Scene<double>> scenes;
    std::vector<LabStart<double>> starts;
    std::vector<std::vector<LabState<double>>> sharp;
    for (int tries = 0; scenes.size() < 20 && tries < 4000; ++tries) {
        Scene<double> scene = random_rounded(random, 0);
        scene.alpha = std::min(scene.alpha, 0.8);
        if (scene.sides == rod_sides) continue;  // its sides have no width
        const double vx = random.between(-1, 1), vy = random.between(-1, 1), spin = random.between(-2, 2);
        const LabStart<double> start{scene.beta, 0, vx, vy, random.angle(), spin};
        std::vector<LabState<double>> all;
        bool free = true;
        double growth = 1;  // bounds that of an error of the start
        with_collision_map(scene, [&](const auto& map) {
            Orbit orbit(map, start);
            PostImpactState<double> before;
            while (orbit.impacts() < impacts && orbit.advance()) {
                all.push_back(orbit.lab());
                free = free && orbit.contacts().empty();
                if (free && all.size() > 1) growth *= derivative_by_saltation(map, before, orbit.collision()).norm();
                before = orbit.post_impact();
            }
        });
        if (growth > 1e4) continue;
        if (!free || all.size() < impacts) continue;
        scenes.push_back(scene);
        starts.push_back(start);
        sharp.push_back(all);
    }
    ASSERT_EQ(scenes.size(), 20U);
    for (const double r : {0.0, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3}) {
        double worst = 0;
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            Scene<double> scene = scenes[i];
            scene.corner = r;
            scene.inertia_factor = uniform_inertia_factor<double>(scene.sides, scene.alpha, r);
            with_corner_map(scene, [&](const auto& map) {
                const auto rounded = states(map, starts[i], impacts);
                ASSERT_EQ(rounded.size(), sharp[i].size()) << "scene " << i << ", r = " << r;
                for (std::size_t k = 0; k < rounded.size(); ++k)
                    worst = std::max(worst, distance(rounded[k], sharp[i][k], true));
            });
        }
        std::printf("%g: %.3g, %.3g\n", r, worst, r > 0 ? worst / r : 0);
        if (r <= 1e-4) {
            EXPECT_LE(worst, 1e4 * r + 1e-11);
        }
        if (r >= 1e-6) {
            EXPECT_GE(worst, r);  // a rounded corner is another body
        }
    }
}

TEST(RoundCorner, JoinsTheDiskAsItsRadiusRises) {
    constexpr int impacts = 8;
    Random random(32);
    std::printf("1 - r/alpha: largest difference of 8 impacts from the disk's\n");
    for (const double missing : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14}) {
        double worst = 0;
        int compared = 0;
        Random same(33);
        for (int i = 0; i < 40; ++i) {
            Scene<double> scene = random_rounded(same, 1 - missing);
            scene.alpha = std::min(scene.alpha, 0.8);
            scene.corner = scene.alpha * (1 - missing);
            scene.inertia_factor = 0.5;
            const double vx = same.between(-1, 1), vy = same.between(-1, 1), spin = same.between(-2, 2);
            const LabStart<double> start{scene.beta, 0, vx, vy, same.angle(), spin};
            Scene<double> disk = scene;
            disk.sides = disk_sides;
            disk.corner = 0;
            std::vector<LabState<double>> reference;
            bool free = true;
            with_collision_map(disk, [&](const auto& map) {
                Orbit orbit(map, start);
                while (orbit.impacts() < impacts && orbit.advance()) {
                    reference.push_back(orbit.lab());
                    free = free && orbit.contacts().empty() && orbit.return_step().collision.flight_time > 0.05;
                }
            });
            if (!free || reference.size() < impacts) continue;
            with_corner_map(scene, [&](const auto& map) {
                const auto rounded = states(map, start, impacts);
                ASSERT_EQ(rounded.size(), reference.size()) << "scene " << i << ", " << missing;
                for (std::size_t k = 0; k < rounded.size(); ++k)
                    worst = std::max(worst, distance(rounded[k], reference[k], false));
            });
            ++compared;
        }
        std::printf("%g: %.3g (%d orbits)\n", missing, worst, compared);
        EXPECT_GT(compared, 10);
        if (missing <= 1e-4) {
            EXPECT_LE(worst, 1e3 * missing + 1e-11);
        }
    }
}

TEST(RoundCorner, KeepsTheBalanceOfJ) {
    Random random(34);
    double worst = 0;
    long impacts = 0, ended = 0;
    for (int k = 0; k < 200; ++k) {
        const double share = random.between(0.01, 0.99);
        const Scene<double> scene = random_rounded(random, share);
        with_corner_map(scene, [&](const auto& map) {
            const double leaving = random.log_between(0.01, 2);
            Collision<double> step;
            step.after = post_impact_state(random_leaving(random, scene, leaving));
            for (int i = 0; i < 200; ++i) {
                const double before = jacobi_of(map.body(), step.after);
                map.advance(step.after, step);
                if (step.outcome != FirstContactOutcome::contact) return void(++ended);
                const double after = jacobi_of(map.body(), step.after);
                const double size = 1 + std::abs(before) + step.after.spin * step.after.spin;
                worst =
                    std::max(worst, std::abs(after - before - step.jacobi_restitution - step.jacobi_friction) / size);
                // In the frame of the wall where it is touched no impact gives energy but Newton's with friction.
                if (scene.law != Law::newton || scene.mu == 0) {
                    EXPECT_LE(step.jacobi_restitution + step.jacobi_friction + step.impulse.tangential, 1e-14 * size);
                }
                ++impacts;
            }
        });
    }
    std::printf("%ld impacts (%ld orbits ended): J's balance within %.2g\n", impacts, ended, worst);
    EXPECT_GT(impacts, 10'000);
    EXPECT_LE(worst, 1e-12);
}

TEST(RoundCorner, KeepsJAndVolumesWithoutFriction) {
    Random random(35);
    double drift = 0, volume = 0;
    for (int k = 0; k < 10; ++k) {
        Scene<double> scene = random_rounded(random, 0.3);
        scene.mu = 0;
        scene.restitution = 1;
        const CornerMap<double, Shape::polygon, ImpactRule::frictionless> map(scene);
        Collision<double> step;
        step.after = post_impact_state(random_leaving(random, scene, 0.7));
        const double start = jacobi_of(map.body(), step.after);
        for (int i = 0; i < 5000; ++i) {
            const PostImpactState<double> before = step.after;
            map.advance(step.after, step);
            ASSERT_EQ(step.outcome, FirstContactOutcome::contact);
            if (i >= 100) continue;
            const auto d = derivative_by_saltation(map, before, step);
            const double un = kinematics_of(map.body(), step.after).un;
            if (un > -1e-2) continue;
            volume = std::max(volume, std::abs(d.determinant() * un / kinematics_of(map.body(), before).un - 1));
        }
        drift = std::max(drift, std::abs(jacobi_of(map.body(), step.after) - start) / (1 + std::abs(start)));
    }
    std::printf("J drifts by %.2g in 5,000 impacts; det DF within %.2g\n", drift, volume);
    EXPECT_LE(drift, 1e-11);
    EXPECT_LE(volume, 1e-9);
}

/// DF by Jets: the map's own code.
template <class Map>
auto by_jets(const Map& map, const PostImpactState<double>& z, const Collision<double>& known) {
    using Jet = ceres::Jet<double, 5>;
    const CornerMap<Jet, Map::shape, Map::rule> jets(scene_in<Jet>(map.scene()));
    const auto after =
        strike_along(jets, jets.flight_after(seeded<Jet, Map::shape>(z)), known.flight_time, known.vertex_step).after;
    const auto next = coordinates<Map::shape>(section_point(after));
    Eigen::Matrix<double, 5, 5> d;
    for (int i = 0; i < 5; ++i) d.row(i) = next[static_cast<std::size_t>(i)].v.transpose();
    return d;
}

TEST(RoundCorner, DerivativesByHandAndByJetsAgree) {
    Random random(36);
    double worst = 0, by_kept = 0;
    int count = 0, modes[6] = {};
    for (int i = 0; i < 2000; ++i) {
        const double share = random.between(0.01, 0.98);
        const Scene<double> scene = random_rounded(random, share);
        with_corner_map(scene, [&](const auto& map) {
            const double leaving = random.log_between(0.05, 2);
            const PostImpactState<double> z = post_impact_state(random_leaving(random, scene, leaving));
            const Collision<double> known = map.advance(z);
            if (known.outcome != FirstContactOutcome::contact || known.simultaneous) return;
            if (-kinematics_of(map.body(), known.after).un < 1e-3) return;
            const auto hand = derivative_by_saltation(map, z, known);
            const double size = hand.cwiseAbs().maxCoeff();
            worst = std::max(worst, (by_jets(map, z, known) - hand).cwiseAbs().maxCoeff() / size);
            const auto kept = derivative_by_saltation(
                map, z, KeptFlight{known.flight_time, known.vertex_step, known.impulse.mode, known.after});
            by_kept = std::max(by_kept, (kept - hand).cwiseAbs().maxCoeff() / size);
            ++modes[static_cast<int>(known.impulse.mode)];
            ++count;
        });
    }
    std::printf("%d states, DF within %.2g, from what is kept %.2g\n", count, worst, by_kept);
    EXPECT_GT(count, 1200);
    for (const int seen : modes) EXPECT_GT(seen, 3);
    EXPECT_LE(worst, 1e-11);
    EXPECT_LE(by_kept, 1e-10);
}

/// In 113 bits, by the section's coordinates and along every number of the scene.
TEST(RoundCorner, DerivativesAreThoseOfDifferences) {
    Random random(37);
    double worst = 0;
    int count = 0;
    for (int i = 0; i < 60; ++i) {
        const double share = random.between(0.01, 0.98);
        const Scene<double> scene = random_rounded(random, share);
        const double leaving = random.log_between(0.1, 2);
        const SectionPoint<double> z = random_leaving(random, scene, leaving);
        with_corner_map(scene, [&](const auto& map) {
            using Map = std::decay_t<decltype(map)>;
            const Collision<double> known = map.advance(post_impact_state(z));
            if (known.outcome != FirstContactOutcome::contact || known.simultaneous) return;
            if (-kinematics_of(map.body(), known.after).un < 1e-2) return;
            const auto hand = derivative_by_saltation(map, post_impact_state(z), known);
            const auto image = [&](const Scene<Quad>& s, int coordinate, double h) {
                auto c = coordinates<Shape::polygon>(
                    SectionPoint<Quad>{Quad(z.psi), Quad(z.chi), Quad(z.vn), Quad(z.vt), Quad(z.spin)});
                if (coordinate >= 0) c[static_cast<std::size_t>(coordinate)] += Quad(h);
                const CornerMap<Quad, Shape::polygon, Map::rule> wide(s);
                const auto next = wide.advance(post_impact_state(section_point<Shape::polygon>(c)));
                EXPECT_EQ(next.outcome, FirstContactOutcome::contact);
                return coordinates<Shape::polygon>(section_point(next.after));
            };
            const Scene<Quad> wide = scene_in<Quad>(scene);
            const double h = 1e-12, size = hand.cwiseAbs().maxCoeff();
            const auto compare = [&](const auto& up, const auto& down, const auto& column, double against) {
                for (std::size_t j = 0; j < 5; ++j) {
                    const Quad change = j < 2 ? wrapped_angle(Quad(up[j] - down[j])) : Quad(up[j] - down[j]);
                    const double d = static_cast<double>(change / Quad(2 * h));
                    worst = std::max(worst, std::abs(d - column[static_cast<Eigen::Index>(j)]) / against);
                }
            };
            for (int k = 0; k < 5; ++k) compare(image(wide, k, h), image(wide, k, -h), hand.col(k), size);
            for (const Parameter parameter : all_parameters) {
                if (parameter == Parameter::drag || parameter == Parameter::tangential_restitution) continue;
                Scene<Quad> at = wide;
                if (number_of(at, parameter) < Quad(1e-3)) continue;
                if (parameter == Parameter::restitution && scene.restitution == 1) continue;
                const auto along = derivative_along(map, parameter, post_impact_state(z), known);
                const Quad value = number_of(at, parameter);
                compare(image(with_parameter(wide, parameter, Quad(value + Quad(h))), -1, 0),
                        image(with_parameter(wide, parameter, Quad(value - Quad(h))), -1, 0), along,
                        size + along.cwiseAbs().maxCoeff());
            }
            ++count;
        });
    }
    std::printf("%d states, derivatives within %.2g\n", count, worst);
    EXPECT_GT(count, 35);
    EXPECT_LE(worst, 1e-9);
}

TEST(RoundCorner, ChatterEndsByName) {
    Scene<double> scene{6, 0.4, 0.5, 0.5, 0.4, Law::poisson};
    scene.corner = 0.1;
    scene.inertia_factor = uniform_inertia_factor<double>(6, 0.4, 0.1);
    int ended = 0;
    for (const double e : {0.0, 0.3, 0.6}) {
        scene.restitution = e;
        scene.mu = e == 0 ? 0.5 : 0;  // without friction and with loss every body comes to rest on the swirling wall
        with_corner_map(scene, [&](const auto& map) {
            Orbit orbit(map, LabStart<double>{0.5, 0, 0.1, 0.2, 0.3, 0.1});
            while (orbit.impacts() < 100'000 && orbit.advance()) {
            }
            ended += orbit.outcome() == Outcome::contact_of_corner;
            EXPECT_TRUE(orbit.contacts().empty());
            std::printf("e = %g: %s after %lld impacts\n", e, std::string(name_of(orbit.outcome())).c_str(),
                        orbit.impacts());
        });
    }
    EXPECT_EQ(ended, 3);
}

/// The largest exponent per impact after a transient; nothing of an orbit that ends.
template <class Map>
std::optional<double> largest_exponent(const Map& map, const LabStart<double>& start) {
    constexpr int transient = 4000, impacts = 3000;
    Collision<double> step = map.advance(flight_from(map.body(), start));
    Eigen::Matrix<double, 5, 1> direction;
    direction << 1, 0.3, -0.2, 0.5, 0.7;
    double growth = 0;
    for (int i = 0; i < transient + impacts && step.outcome == FirstContactOutcome::contact; ++i) {
        const PostImpactState<double> before = step.after;
        map.advance(step.after, step);
        if (i < transient || step.outcome != FirstContactOutcome::contact) continue;
        direction = (derivative_by_saltation(map, before, step) * direction).eval();
        growth += std::log(direction.norm());
        direction.normalize();
    }
    if (step.outcome != FirstContactOutcome::contact) return std::nullopt;
    return growth / impacts;
}

/// map/corners/README.md, "Grazing, and the map of modes".
TEST(RoundCorner, RoundingEndsChaos_Nightly) {
    for (const auto& [restitution, columns] : {std::pair{0.95, 200}, std::pair{1.0, 100}}) {
        std::vector<double> shares;
        for (const double r : {0.0, 0.001, 0.003, 0.01, 0.02, 0.03, 0.05, 0.1, 0.15, 0.2, 0.25}) {
            int chaotic = 0, ended = 0;
            double sum = 0;
            for (int i = 0; i < 2 * columns; ++i) {
                const double alpha = 0.3 + 0.4 * (i / 2 + 0.5) / columns;
                Scene<double> scene{6, alpha, 0.5, 0.5, restitution, Law::poisson};
                scene.corner = r;
                scene.inertia_factor = uniform_inertia_factor<double>(6, alpha, r);
                Random random(static_cast<std::uint64_t>(1000 * (i / 2) + i % 2));
                const double way = random.angle(), angle = random.angle();
                const CornerMap<double, Shape::polygon, ImpactRule::poisson> map(scene);
                const auto exponent = largest_exponent(map, {0.5, 0, std::cos(way) / 7, std::sin(way) / 7, angle, 0});
                ended += exponent ? 0 : 1;
                if (!exponent || *exponent <= 0.01) continue;
                ++chaotic;
                sum += *exponent;
            }
            shares.push_back(static_cast<double>(chaotic) / (2 * columns - ended));
            std::printf("e = %g, r = %g: chaotic %.3f, their mean exponent %.3f, %d ended\n", restitution, r,
                        shares.back(), sum / chaotic, ended);
            EXPECT_LE(ended, 8);
        }
        EXPECT_GT(shares[3], 0.8 * shares[0]);   // r = 0.01
        EXPECT_LT(shares[8], 0.35 * shares[0]);  // r = 0.15
    }
}

TEST(RoundCorner, IsRefusedWhereItIsNotFollowed) {
    Scene<double> scene{6, 0.4, 0.5, 0.5, 0.4, Law::poisson, 0.4};
    scene.corner = 0.1;
    EXPECT_THROW((CollisionMap<double, Shape::polygon, ImpactRule::poisson>(scene)), std::invalid_argument);
    scene.drag = 0.1;
    EXPECT_THROW(validated(scene), std::invalid_argument);
    scene.drag = 0;
    for (const double r : {-0.1, 0.4, 0.5, 1e-80, std::nan("")}) {
        scene.corner = r;
        EXPECT_THROW(validated(scene), std::invalid_argument) << r;
    }
    scene.corner = 0.1;
    scene.sides = disk_sides;
    EXPECT_THROW(validated(scene), std::invalid_argument);
}

}  // namespace
}  // namespace swirl
