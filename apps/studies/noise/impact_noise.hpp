// Noise at impacts: restitution, friction and the direction of the wall's normal vary from impact to impact.
//
// Impact i of a run has e + σ_e ξ₁, reflected into [0, 1] at both ends (at e = 1 so 1 − |σ_e ξ₁|), μ + σ_μ ξ₂,
// reflected at 0, and a normal turned by η = σ_w ξ₃, |η| ≤ ¼π (beyond it is cut off there), the ξ independent and
// normally distributed: Philox 4×64 keyed by the seed, counter (run, i), so that any impact's noise can be made alone,
// whatever thread follows the orbit. What has no σ is not touched. The values of impact i also are those of sustained
// contact and of summed chatter on the way to it; the normal is not turned there.
#pragma once

#include "apps/studies/scene_map/scene_map.hpp"
#include "apps/studies/scene_map/scene_orbit.hpp"
#include "map/model/scene.hpp"

#include <cstdint>
#include <memory>

namespace swirl::studies {

struct ImpactNoise {
    double restitution = 0;  ///< σ_e
    double mu = 0;           ///< σ_μ
    double wall = 0;         ///< σ_w, in radians
    std::uint64_t seed = 1, run = 0;

    bool is_any() const { return restitution > 0 || mu > 0 || wall > 0; }
};

/// What impact number `impact` (1, 2, …) has.
struct NoisyImpact {
    double restitution, mu, turn;
};
NoisyImpact noisy_impact(const ImpactNoise& noise, const Scene<double>& scene, std::uint64_t impact);

/// The step from z to impact number `impact`.
///   similar  a map of the scene's shape and rule, with friction if μ has noise
///   scene    without noise
/// Cost: a body made anew, some 0.3 µs, and the step.
template <int D>
ReturnStep<double> noisy_step(const SceneMap<D>& similar, const Scene<double>& scene, const ImpactNoise& noise,
                              const PostImpactState<double>& z, std::uint64_t impact, double horizon = contact_horizon,
                              const ContactSink& sink = {});

/// The scene whose map is `similar` to those of its impacts: with friction if μ has noise.
Scene<double> scene_for_noise(const Scene<double>& scene, const ImpactNoise& noise);

/// The orbit of a scene, its first impact from the laboratory included.
/// @throws std::invalid_argument for a scene or start out of range
std::unique_ptr<OrbitOfScene<double>> noisy_orbit(const Scene<double>& scene, const Start<double>& start,
                                                  const ImpactNoise& noise);

extern template ReturnStep<double> noisy_step(const SceneMap<disk_dimension>&, const Scene<double>&, const ImpactNoise&,
                                              const PostImpactState<double>&, std::uint64_t, double,
                                              const ContactSink&);
extern template ReturnStep<double> noisy_step(const SceneMap<polygon_dimension>&, const Scene<double>&,
                                              const ImpactNoise&, const PostImpactState<double>&, std::uint64_t, double,
                                              const ContactSink&);

}  // namespace swirl::studies
