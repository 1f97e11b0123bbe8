#include "apps/studies/certify/certified_orbit.hpp"
#include "apps/studies/parallel/pieces.hpp"
#include "apps/studies/scene_map/itinerary_map.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::studies::certify {

Candidate candidate_at(const CyclePlace& place) {
    const Scene<double>& scene = place.scene;
    Candidate candidate;
    const analysis::ShootingMap map = shooting_map_of(scene);
    for (const SectionPoint<double>& z : place.points) {
        const analysis::ShootingStep step = map.step(coordinates_of(z, scene.is_disk()), 0);
        if (!step.alive) {
            candidate.reason = "the map ends on the cycle";
            return candidate;
        }
        const Letter letter = letter_from(step.letter);
        if (letter.through_contact) {
            candidate.reason = "the cycle leads through sustained contact";
            return candidate;
        }
        candidate.claim.points.push_back(z);
        candidate.claim.times.push_back(step.duration);
        candidate.claim.itinerary.push_back({letter.vertex_step, letter.mode, 0});
    }
    return candidate;
}

CertifiedOrbit proven_at(const CyclePlace& place) {
    CertifiedOrbit orbit{place.number, place.scene, place.points.size(), place.points.front(), {}};
    const Candidate candidate = candidate_at(place);
    if (candidate.reason.empty())
        orbit.proof = proof::prove_cycle(place.scene, candidate.claim);
    else
        orbit.proof.reason = candidate.reason;
    if (!orbit.proof.radii.empty()) orbit.point = orbit.proof.points.front();  // the box's centre
    return orbit;
}

std::vector<CertifiedOrbit> prove_cycles(std::vector<CyclePlace> places, const RunControl& control) {
    const auto work = std::make_shared<const std::vector<CyclePlace>>(std::move(places));
    const auto results = std::make_shared<std::vector<std::optional<CertifiedOrbit>>>(work->size());
    run_pieces(work->size(), "certify", control, [work, results](std::size_t i) -> KeepResult {
        CertifiedOrbit orbit = proven_at((*work)[i]);
        return [results, i, orbit = std::move(orbit)] { (*results)[i] = orbit; };
    });
    std::vector<CertifiedOrbit> orbits;
    for (auto& orbit : *results)
        if (orbit) orbits.push_back(std::move(*orbit));
    return orbits;
}

}  // namespace swirl::studies::certify
