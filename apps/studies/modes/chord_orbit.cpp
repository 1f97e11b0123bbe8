#include "apps/studies/modes/chord_orbit.hpp"

#include "analysis/special_values.hpp"
#include "apps/studies/scene_map/letter.hpp"
#include "map/chords/chord_response.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::studies {

ContainerState in_container(const Scene<double>& scene, const PostImpactState<double>& z) {
    const double wn = z.vn - scene.beta * z.psi.y, wt = z.vt - scene.beta * z.psi.x;
    const double turning = scene.inertia_factor * std::pow(scene.alpha * z.spin, 2);
    return {std::atan2(z.chi.y, z.chi.x), std::hypot(wn, wt), std::atan2(wt, -wn), 0.5 * (wn * wn + wt * wt + turning)};
}

bool is_neutral(const Chord& chord) {
    constexpr double margin = 1e-6;  // a double multiplier is known to √ε
    return std::abs(std::max(std::abs(chord.multipliers[0]), std::abs(chord.multipliers[1])) - 1) <= margin;
}

std::optional<Chord> chord_near(const Scene<double>& scene, const ContainerState& now) {
    if (std::abs(now.chi) > most_bent) return {};
    std::optional<Chord> nearest;
    double least = most_bent;
    for (const Chord& chord : chords_of(scene).chords) {
        const double off = std::abs(now.direction - chord.angle);
        if (off < least && (chord.attracts() || is_neutral(chord))) {
            least = off;
            nearest = chord;
        }
    }
    return nearest;
}

double ForcedBend::largest() const {
    return std::max(chi, direction);
}

ForcedBend forced_bend(const Scene<double>& scene, const Chord& chord, double v) {
    if (v <= chord_resonance(chord)) return {analysis::infinity, analysis::infinity};
    const ChordDeviation amplitude = chord_response(scene, chord, v).amplitude;
    return {scene.beta * std::abs(amplitude[1]),
            scene.beta * std::hypot(std::abs(amplitude[2]), std::abs(amplitude[3])) / v};
}

double excess_over(const SceneMap<polygon_dimension>& map, const Scene<double>& scene, const Chord& chord,
                   const ForcedBend& forced, PostImpactState<double> z, int impacts) {
    double largest = 0;
    for (int n = 0; n < impacts; ++n) {
        const auto step = map.advance(z);
        if (!step.alive) return analysis::infinity;
        const Letter letter = letter_from(step.letter);
        if (letter.through_contact || !ends_in_stick(letter.mode) || letter.vertex_step != chord.vertex_step)
            return analysis::infinity;
        z = step.state;
        const ContainerState now = in_container(scene, z);
        largest = std::max(
            {largest, std::abs(now.chi) / forced.chi, std::abs(now.direction - chord.angle) / forced.direction});
    }
    return largest;
}

}  // namespace swirl::studies
