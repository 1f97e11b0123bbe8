// Cycles to prove, from the references and from scenes.
#pragma once

#include "map/collision_map.hpp"
#include "map/proof/prove_cycle.hpp"
#include "map/proof_check/stated_cycle.hpp"
#include "tests/references/references.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace swirl::tests {

struct ProofCase {
    Scene<double> scene;
    proof::CycleClaim claim;
    nlohmann::json reference;  ///< what the file says of it
};

/// What the map says of the k-cycle at z: its states, flight times and itinerary.
inline proof::CycleClaim claim_at(const Scene<double>& scene, const SectionPoint<double>& z, int period) {
    proof::CycleClaim claim;
    with_collision_map(scene, [&](const auto& map) {
        auto state = post_impact_state(z);
        for (int i = 0; i < period; ++i) {
            const auto collision = map.advance(state);
            claim.points.push_back(section_point(state));
            claim.times.push_back(collision.flight_time);
            claim.itinerary.push_back({collision.vertex_step, collision.impulse.mode, 0});
            state = collision.after;
        }
    });
    return claim;
}

inline std::vector<ProofCase> proof_cases(const std::string& file) {
    std::vector<ProofCase> cases;
    const nlohmann::json document = read_reference(file);  // outlives what refers into it
    for (const auto& entry : document["cycles"]) {
        const auto scene = scene_from<double>(entry);
        cases.push_back({scene, claim_at(scene, point_from<double>(entry["point"]), entry["period"]), entry});
    }
    return cases;
}

/// A proof as a certificate states it.
inline proof_check::StatedCycle stated(const Scene<double>& scene, const proof::CycleProof& p) {
    proof_check::StatedCycle cycle;
    cycle.sides = scene.sides;
    cycle.alpha = scene.alpha;
    cycle.beta = scene.beta;
    cycle.mu = scene.mu;
    cycle.restitution = scene.restitution;
    cycle.law = name_of(scene.law);
    cycle.inertia_factor = scene.inertia_factor;
    cycle.uniform_lamina = scene.inertia_factor == uniform_inertia_factor<double>(scene.sides);
    for (std::size_t i = 0; i < p.radii.size(); ++i) {
        const auto& z = p.points[i];
        cycle.steps.push_back({{z.psi, z.chi, z.vn, z.vt, z.spin},
                               p.radii[i],
                               p.times[i],
                               p.time_radii[i],
                               p.itinerary[i].vertex_step,
                               std::string(name_of(p.itinerary[i].mode)),
                               p.itinerary[i].slip});
    }
    for (const auto& disc : p.multipliers) cycle.multipliers.push_back({disc.re, disc.im, disc.radius});
    cycle.stability = name_of(p.stability);
    if (p.phase) cycle.phase = proof_check::StatedCycle::Phase{p.phase->by_time, p.phase->value};
    return cycle;
}

inline Scene<double> hexagon() {
    return {6, 0.4, 0.5, 0.5, 0.9, Law::poisson, uniform_inertia_factor<double>(6)};
}

}  // namespace swirl::tests
