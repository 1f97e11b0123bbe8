#include "apps/certify/certified_orbit.hpp"
#include "apps/system/letter.hpp"
#include "apps/system/section_coordinates.hpp"
#include "apps/system/shooting_map.hpp"

namespace swirl::apps::certify {

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
        candidate.claim.word.push_back({letter.vertex_step, letter.mode, 0});
    }
    return candidate;
}

}  // namespace swirl::apps::certify
