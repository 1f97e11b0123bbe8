// Flight, first contact, the map and its derivative over a floor that drags.
#include "map/dragged/dragged_derivative.hpp"
#include "map/orbit/dragged_return.hpp"
#include "map/orbit/laboratory.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "map/orbit/orbit.hpp"
#include "tests/map/dragged_draw.hpp"
#include "tests/map/reference_error.hpp"
#include "tests/references/references.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <type_traits>

namespace swirl {
namespace {

using nlohmann::json;
using tests::error_of;
using tests::number;
using tests::Tolerance;

template <class T>
Scene<T> dragged_scene_from(const json& c) {
    Scene<T> scene = tests::scene_from<T>(c);
    scene.drag = number<T>(c["drag"]);
    scene.spin_drag = number<T>(c["spin_drag"]);
    scene.floor = c["floor"] == "table" ? Floor::table : Floor::dish;
    return scene;
}

template <class Map>
void follow(const Map& map, const json& orbit, const Tolerance& tolerance, int& impacts, double& worst) {
    using T = typename Map::Number;
    const json& i = orbit["initial"];
    const LabStart<T> start{number<T>(i["x"]),  number<T>(i["y"]),     number<T>(i["vx"]),
                            number<T>(i["vy"]), number<T>(i["angle"]), number<T>(i["spin"])};
    Orbit<Map> followed(map, start);
    for (const json& row : orbit["collisions"]) {
        const double amplification = row["amplification"];
        ASSERT_TRUE(followed.advance()) << name_of(followed.outcome());
        if (amplification > tolerance.reach) continue;
        EXPECT_EQ(followed.frame().vertex, row["vertex"].get<int>());
        const double error = error_of(followed.lab(), followed.collision(), row);
        const double allowed = std::max(tolerance.floor, tolerance.relative * amplification);
        EXPECT_LE(error, allowed) << "impact " << followed.impacts();
        worst = std::max(worst, error / allowed);
        ++impacts;
    }
}

template <class T>
void reproduce(const Tolerance& tolerance, int fewest) {
    const json references = tests::read_reference("dragged_trajectories.json");
    int orbits = 0, impacts = 0;
    double worst = 0;
    for (const json& orbit : references["cases"]) {
        SCOPED_TRACE("orbit " + std::to_string(orbits));
        with_dragged_map(dragged_scene_from<T>(orbit),
                         [&](const auto& map) { follow(map, orbit, tolerance, impacts, worst); });
        ++orbits;
    }
    std::printf("%d orbits, %d impacts, largest error %.3f of what is allowed\n", orbits, impacts, worst);
    EXPECT_EQ(orbits, 120);
    EXPECT_GE(impacts, fewest);
}

// The tolerances are those of the orbits without drag (tests/map/trajectories_test.cpp).
TEST(Dragged, ReferenceOrbitsAreReproducedInDouble) {
    reproduce<double>({1e-13, 1e-12, 1e10}, 700);
}

TEST(Dragged, ReferenceOrbitsAreReproducedInQuad) {
    reproduce<Quad>({1e-24, 1e-22, HUGE_VAL}, 120 * 6);
}

/// As γ → 0 the map is that without drag to rounding: |F_γ − F₀| ≤ (what γ changes) + (rounding).
TEST(Dragged, JoinsTheMapWithoutDrag) {
    tests::DraggedDraw draw(1);
    for (double drag = 1e-16; drag < 2e-3; drag *= 10) {
        double worst = 0, sum = 0;
        int count = 0;
        for (int i = 0; i < 300; ++i) {
            Scene<double> scene = draw.scene(drag, drag * 1.0000001);
            scene.spin_drag = -1;
            const SectionPoint<double> z = draw.point(scene);
            Scene<double> still = scene;
            still.drag = 0;
            with_dragged_map(scene, [&](const auto& map) {
                using Map = std::decay_t<decltype(map)>;
                const typename Map::Impacts without(still);
                const auto dragged = map.advance(post_impact_state(z));
                const auto free = without.advance(post_impact_state(z));
                if (dragged.outcome != FirstContactOutcome::contact || free.outcome != dragged.outcome ||
                    dragged.vertex_step != free.vertex_step || free.flight_time > 20)
                    return;
                const auto derivative = derivative_by_saltation(without, post_impact_state(z), free);
                const double condition = 1 + derivative.norm();
                const auto a = section_point(dragged.after), b = section_point(free.after);
                const double apart = std::abs(wrapped_angle(a.psi - b.psi)) + std::abs(wrapped_angle(a.chi - b.chi)) +
                                     std::abs(a.vn - b.vn) + std::abs(a.vt - b.vt) + std::abs(a.spin - b.spin);
                const double tau = 1 + free.flight_time;
                const double scaled = apart / (condition * (drag * tau * tau * 10 + 4e-14));
                worst = std::max(worst, scaled);
                sum += apart;
                ++count;
            });
        }
        std::printf("gamma %.0e: %d steps, mean change %.2e, largest %.3f of what is allowed\n", drag, count,
                    sum / count, worst);
        EXPECT_GE(count, 200);
        EXPECT_LE(worst, 1) << "gamma " << drag;
    }
}

/// Central differences of F in 113 bits, of steps of 10⁻¹²; none where a step takes another branch than `known`.
///   moved  F from a start, or of a scene, that is moved by so much
template <Shape shape, class Moved>
std::optional<std::array<double, section_dimension<shape>>> differences(const Collision<double>& known,
                                                                        const Moved& moved) {
    constexpr int D = section_dimension<shape>;
    const Quad step(1e-12);
    std::array<Quad, D> image[2];
    for (const int side : {0, 1}) {
        const Collision<Quad> next = moved(side == 0 ? Quad(-step) : step);
        if (next.outcome != FirstContactOutcome::contact || next.vertex_step != known.vertex_step ||
            next.impulse.mode != known.impulse.mode)
            return std::nullopt;
        image[side] = coordinates<shape>(section_point(next.after));
    }
    std::array<double, D> result;
    for (int k = 0; k < D; ++k) {
        const Quad change = image[1][k] - image[0][k];
        result[k] = static_cast<double>((k < D - 3 ? wrapped_angle(change) : change) / (2 * step));
    }
    return result;
}

/// DF by hand against differences of F in 113 bits.
TEST(Dragged, DerivativeByHandIsThatOfDifferences) {
    tests::DraggedDraw draw(2);
    int count = 0;
    double worst = 0;
    while (count < 200) {
        const Scene<double> scene = draw.scene(1e-2, 2);
        const SectionPoint<double> z = draw.point(scene);
        with_dragged_map(scene, [&](const auto& map) {
            using Map = std::decay_t<decltype(map)>;
            constexpr int D = section_dimension<Map::shape>;
            const DraggedMap<Quad, Map::shape, Map::rule> precise(scene_in<Quad>(scene));
            const auto known = map.advance(post_impact_state(z));
            if (known.outcome != FirstContactOutcome::contact) return;
            const auto by_hand = derivative_by_saltation(map, post_impact_state(z), known);
            const auto in_coordinates = coordinates<Map::shape>(z);
            for (int i = 0; i < D; ++i) {
                const auto column = differences<Map::shape>(known, [&](const Quad& by) {
                    std::array<Quad, D> c;
                    for (int k = 0; k < D; ++k) c[k] = Quad(in_coordinates[k]);
                    c[i] += by;
                    return precise.advance(post_impact_state(section_point<Map::shape>(c)));
                });
                if (!column) return;
                for (int k = 0; k < D; ++k) {
                    const double scale = 1 + by_hand.norm() * by_hand.norm();
                    worst = std::max(worst, std::abs(by_hand(k, i) - (*column)[k]) / scale);
                    EXPECT_NEAR(by_hand(k, i), (*column)[k], 1e-10 * scale)
                        << "row " << k << " column " << i << " N " << scene.sides;
                }
            }
            ++count;
        });
    }
    std::printf("%d states, largest difference %.2e\n", count, worst);
}

/// ∂F along every parameter by Jets against differences of F in 113 bits.
TEST(Dragged, DerivativeAlongAParameterIsThatOfDifferences) {
    tests::DraggedDraw draw(3);
    int count = 0;
    while (count < 150) {
        const Scene<double> scene = draw.scene(1e-3, 2);
        const SectionPoint<double> z = draw.point(scene);
        with_dragged_map(scene, [&](const auto& map) {
            using Map = std::decay_t<decltype(map)>;
            constexpr int D = section_dimension<Map::shape>;
            const auto known = map.advance(post_impact_state(z));
            if (known.outcome != FirstContactOutcome::contact || scene.restitution > 0.999 || scene.mu == 0) return;
            const auto by_hand = derivative_by_saltation(map, post_impact_state(z), known);
            for (const Parameter parameter : all_parameters) {
                if (parameter == Parameter::tangential_restitution) continue;  // of the disk alone, and not below 0
                if (parameter == Parameter::corner) continue;                  // not over a floor that drags
                const auto along = derivative_along(map, parameter, post_impact_state(z), known);
                const auto column = differences<Map::shape>(known, [&](const Quad& by) {
                    Scene<Quad> there = scene_in<Quad>(scene);
                    number_of(there, parameter) += by;
                    const SectionPoint<Quad> start{Quad(z.psi), Quad(z.chi), Quad(z.vn), Quad(z.vt), Quad(z.spin)};
                    return DraggedMap<Quad, Map::shape, Map::rule>(there).advance(post_impact_state(start));
                });
                if (!column) return;
                for (int k = 0; k < D; ++k) {
                    const double scale = (1 + by_hand.norm() * by_hand.norm()) * (1 + along.norm());
                    EXPECT_NEAR(along[k], (*column)[k], 1e-10 * scale)
                        << name_of(parameter) << " row " << k << " N " << scene.sides;
                }
            }
            ++count;
        });
    }
}

}  // namespace
}  // namespace swirl
