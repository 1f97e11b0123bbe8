// The error of one step of the map in double, against 113 bits from the very same doubles.
#pragma once

#include "map/collision_map.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "tests/map/random_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace swirl::tests {

/// The scene's doubles, in 113 bits.
inline Scene<Quad> widened(const Scene<double>& scene) {
    return {scene.sides, Quad(scene.alpha),         Quad(scene.beta), Quad(scene.mu), Quad(scene.restitution),
            scene.law,   Quad(scene.inertia_factor)};
}

inline PostImpactState<Quad> widened(const PostImpactState<double>& z) {
    const auto wide = [](const Vec2<double>& v) { return Vec2<Quad>{Quad(v.x), Quad(v.y)}; };
    return {wide(z.psi), wide(z.chi), Quad(z.vn), Quad(z.vt), Quad(z.spin)};
}

/// What a coordinate's rounding is relative to: 1 for angles, the fastest of V, the swirl and the rim for v, and for S
/// what an impulse of that size changes it by.
using FiveNumbers = std::array<double, 5>;
inline FiveNumbers scales_of(const Scene<double>& scene, const PostImpactState<double>& z) {
    const double fastest = std::hypot(z.vn, z.vt) + scene.beta + scene.alpha * std::fabs(z.spin);
    return {1, 1, fastest, fastest, fastest / scene.alpha};
}

/// a − b, coordinate by coordinate; angles by the sine of their difference.
template <class T>
FiveNumbers difference(const PostImpactState<T>& a, const PostImpactState<T>& b) {
    const auto plain = [](const T& x) { return static_cast<double>(x); };
    return {plain(cross(b.psi, a.psi)), plain(cross(b.chi, a.chi)), plain(a.vn - b.vn), plain(a.vt - b.vt),
            plain(a.spin - b.spin)};
}

/// z with one coordinate changed by `change`.
inline PostImpactState<Quad> nudged(PostImpactState<Quad> z, int coordinate, const Quad& change) {
    if (coordinate == 0) z.psi = turned(z.psi, cis_minus_one(change));
    if (coordinate == 1) z.chi = turned(z.chi, cis_minus_one(change));
    if (coordinate == 2) z.vn += change;
    if (coordinate == 3) z.vt += change;
    if (coordinate == 4) z.spin += change;
    return z;
}

/// F at z in the scene whose α (0) or β (1) is larger by 10⁻²⁰ of itself.
template <class WideMap>
PostImpactState<Quad> in_nudged_scene(const WideMap& map, const PostImpactState<Quad>& z, int number) {
    Scene<Quad> scene = map.scene();
    Quad& value = number == 0 ? scene.alpha : scene.beta;
    value *= Quad(1) + Quad(1e-20);
    return WideMap(scene).advance(z).after;
}

struct StepError {
    bool compared = false;  ///< both arithmetics find a contact, of the same vertex, in the same contact mode
    bool contact = false;   ///< double finds one
    double error = 0;  ///< the largest of the five, in ε × (its scale + Σⱼ |∂F/∂zⱼ| scaleⱼ, over z, α and β)
    double condition = 0;  ///< the largest of those factors over its own scale
};

/// One step from z. What is allowed for: each coordinate of z, α and β known to ε of their scales, and each result
/// rounded to that.
template <class Map, class WideMap>
StepError one_step_error(const Map& map, const WideMap& wide_map, const PostImpactState<double>& z) {
    StepError result;
    const auto step = map.advance(z);
    result.contact = step.outcome == FirstContactOutcome::contact;
    const PostImpactState<Quad> wide = widened(z);
    const auto exact = wide_map.advance(wide);
    if (!result.contact || exact.outcome != FirstContactOutcome::contact || exact.vertex_step != step.vertex_step ||
        exact.impulse.mode != step.impulse.mode)
        return result;
    result.compared = true;
    const FiveNumbers scales = scales_of(map.scene(), z);
    FiveNumbers allowed = scales_of(map.scene(), step.after);
    const FiveNumbers own = allowed;
    const auto allow = [&](const PostImpactState<Quad>& changed) {
        const FiveNumbers change = difference(changed, exact.after);
        for (std::size_t i = 0; i < 5; ++i) allowed[i] += std::fabs(change[i]) / 1e-20;
    };
    for (int j = 0; j < 5; ++j) {
        if (Map::shape == Shape::disk && j == 1) continue;
        allow(wide_map.advance(nudged(wide, j, Quad(1e-20 * scales[static_cast<std::size_t>(j)]))).after);
    }
    allow(in_nudged_scene(wide_map, wide, 0));
    if (map.scene().beta > 0) allow(in_nudged_scene(wide_map, wide, 1));
    const FiveNumbers error = difference(widened(step.after), exact.after);
    for (std::size_t i = 0; i < 5; ++i) {
        result.error = std::max(result.error, std::fabs(error[i]) / (epsilon<double>() * allowed[i]));
        result.condition = std::max(result.condition, allowed[i] / own[i]);
    }
    return result;
}

}  // namespace swirl::tests
