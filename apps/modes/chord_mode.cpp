#include "apps/modes/chord_mode.hpp"

#include "map/chords/chord_fate.hpp"
#include "map/chords/chord_response.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace swirl::apps {

namespace {

using PolygonMap = SceneMap<polygon_dimension>;
using analysis::Kind, analysis::Mode;

/// The body in the container's frame, just after an impact.
struct ContainerState {
    double chi, speed, angle, energy;
};

ContainerState in_container(const Scene<double>& scene, const PostImpactState<double>& z) {
    const double wn = z.vn - scene.beta * z.psi.y, wt = z.vt - scene.beta * z.psi.x;
    const double turning = scene.inertia_factor * std::pow(scene.alpha * z.spin, 2);
    return {std::atan2(z.chi.y, z.chi.x), std::hypot(wn, wt), std::atan2(wt, -wn), 0.5 * (wn * wn + wt * wt + turning)};
}

/// Deviations are linear up to about here, in radians.
constexpr double most_bent = 0.25;
/// What the orbit may deviate by, over the forced response.
constexpr double largest_excess = 2;
constexpr int impacts_watched = 256;

/// The attracting chord whose direction is nearest to that of a state, within `most_bent`.
std::optional<Chord> chord_near(const Scene<double>& scene, const ContainerState& now) {
    if (std::abs(now.chi) > most_bent) return {};
    std::optional<Chord> nearest;
    double least = most_bent;
    for (const Chord& chord : chords_of(scene).chords) {
        const double off = std::abs(now.angle - chord.angle);
        if (off < least && chord.attracts()) {
            least = off;
            nearest = chord;
        }
    }
    return nearest;
}

/// How far an orbit stays from a chord, over what the swirl forces; infinite if it leaves the chord's word, or the
/// response is no small one.
double deviation_of(const PolygonMap& map, const Scene<double>& scene, const Chord& chord, PostImpactState<double> z) {
    const double v = in_container(scene, z).speed;
    if (v <= chord_resonance(chord)) return analysis::infinity;
    const ChordResponse response = chord_response(scene, chord, v);
    const double chi = scene.beta * std::abs(response.amplitude[1]);
    const double bend = scene.beta * std::hypot(std::abs(response.amplitude[2]), std::abs(response.amplitude[3])) / v;
    if (!(std::max(chi, bend) < most_bent)) return analysis::infinity;
    double largest = 0;
    for (int n = 0; n < impacts_watched; ++n) {
        const auto step = map.advance(z);
        if (!step.alive) return analysis::infinity;
        const Letter letter = letter_from(step.letter);
        if (letter.through_contact || !ends_in_stick(letter.mode) || letter.vertex_step != chord.vertex_step)
            return analysis::infinity;
        z = step.state;
        const ContainerState now = in_container(scene, z);
        largest = std::max({largest, std::abs(now.chi) / chi, std::abs(now.angle - chord.angle) / bend});
    }
    return largest;
}

std::vector<double> energies_of(const Scene<double>& scene, const analysis::Tail<PolygonMap>& tail) {
    std::vector<double> energies;
    for (const auto& z : tail.states) energies.push_back(in_container(scene, z).energy);
    if (energies.empty())
        for (const auto& point : tail.points)
            energies.push_back(in_container(scene, PolygonMap::state_at(point)).energy);
    return energies;
}

/// ΔE an impact along the tail, by least squares.
double measured_gain(const std::vector<double>& energies) {
    std::vector<double> n(energies.size());
    for (std::size_t i = 0; i < n.size(); ++i) n[i] = static_cast<double>(i);
    double intercept = 0, slope = 0, c00 = 0, c01 = 0, c11 = 0, sum = 0;
    gsl_fit_linear(n.data(), 1, energies.data(), 1, n.size(), &intercept, &slope, &c00, &c01, &c11, &sum);
    return slope;
}

/// What the chord gains an impact, mean over the speeds of the tail: G falls along it.
double predicted_gain(const Scene<double>& scene, const Chord& chord, const std::vector<double>& energies) {
    constexpr int blocks = 16;
    const double sine = std::sin(chord.angle), inertia = 1 + scene.inertia_factor * sine * sine;
    double sum = 0;
    for (const double energy : analysis::block_means(energies, blocks))
        sum += chord_response(scene, chord, std::sqrt(2 * energy / inertia)).gain();
    return sum / blocks * scene.beta * scene.beta;
}

std::string way_in_words(const Scene<double>& scene, const Chord& chord, const ChordSpeeds& speeds, double v) {
    constexpr double nearly = 0.99;
    if (speeds.fate == ChordFate::accelerates && chord.is_diameter())
        return fmt::format("J doubles within {:.2g} impacts and grows as ({:.4g} beta^2 n)^(1/3)",
                           impacts_between(scene, chord, v, std::sqrt(2.0) * v), 0.75 * diameter_growth(scene));
    if (speeds.fate == ChordFate::accelerates) return "the swirl feeds it at every speed";
    const double near = speeds.limit * (v < speeds.limit ? nearly : 2 - nearly);
    const bool there = std::abs(v / speeds.limit - 1) <= 1 - nearly;
    return there ? fmt::format("S has come to its limit {:.4f} within 1 %", speeds.limit_spin)
                 : fmt::format("S goes to {:.4f}, 1 % from which it is after {:.2g} impacts more", speeds.limit_spin,
                               impacts_between(scene, chord, v, near));
}

/// The verdict of an orbit on a chord.
void name_chord(const Scene<double>& scene, const Chord& chord, const ChordSpeeds& speeds, double v, double deviation,
                const std::vector<double>& energies, NamedMode& named) {
    auto& verdict = named.verdict;
    const bool accelerated = speeds.fate == ChordFate::accelerates;
    const double there = 0.01;
    verdict.mode = Mode::quasi_steady;
    verdict.kind = accelerated ? Kind::accelerated : Kind::chord;
    verdict.rotation = analysis::nan;
    if (accelerated || std::abs(v / speeds.limit - 1) > there) verdict.mean = verdict.mean_per_step = analysis::nan;
    if (accelerated)
        named.growth = analysis::growth_exponent(
            energies, static_cast<double>(named.impacts) - static_cast<double>(energies.size()));
    else
        named.limit_spin = speeds.limit_spin;
    const std::string name = chord.is_diameter() ? "a diameter fixed in the laboratory"
                                                 : fmt::format("a no-slip chord, a = {:.6g} rad", chord.angle);
    const double predicted = predicted_gain(scene, chord, energies);
    verdict.evidence = {
        {"slowest multiplier of the chord", std::abs(chord.multipliers[0]), 1, "small deviations from the chord decay",
         "1 or more: it would not attract"},
        {"deviation from the chord over the forced one", deviation, largest_excess,
         fmt::format("for {} impacts it sticks and goes on by {} vertices, on {}", impacts_watched, chord.vertex_step,
                     name),
         fmt::format("above {:g}: it would not be on the chord yet", largest_excess)},
        {"gain of energy per impact", measured_gain(energies), predicted,
         fmt::format("on {}; predicted {:.4g}; {}", name, predicted, way_in_words(scene, chord, speeds, v)),
         "nothing: the prediction is of the scene's numbers alone"}};
}

void name_created_energy(const std::vector<double>& energies, NamedMode& named) {
    auto& verdict = named.verdict;
    verdict.mode = Mode::undecided;
    verdict.kind = Kind::accelerated;
    verdict.mean = verdict.mean_per_step = verdict.rotation = analysis::nan;
    named.growth =
        analysis::growth_exponent(energies, static_cast<double>(named.impacts) - static_cast<double>(energies.size()));
    verdict.evidence.push_back({"energy at the end over that at the tail's begin", energies.back() / energies.front(),
                                100,
                                "Newton's law creates energy: the means of eight parts of the tail rise from each to "
                                "the next, without bound as far as it was followed",
                                "a part below the one before, or less than 100 times in all: not called so"});
}

}  // namespace

void look_for_growth(const PolygonMap& map, const Scene<double>& scene, const analysis::Tail<PolygonMap>& tail,
                     NamedMode& named) {
    const auto& verdict = named.verdict;
    const bool settled = verdict.period > 0 && !verdict.multipliers.empty();
    if (tail.ended || settled || scene.mu == 0 || tail.durations.size() < impacts_watched) return;
    if (scene.restitution == 1 && scene.beta > 0) {
        const ContainerState now = in_container(scene, tail.last);
        if (const auto chord = chord_near(scene, now)) {
            const ChordSpeeds speeds = chord_speeds(scene, *chord);
            const bool led = speeds.fate == ChordFate::accelerates || speeds.fate == ChordFate::limit;
            const double deviation =
                led && now.speed > speeds.fed_from ? deviation_of(map, scene, *chord, tail.last) : analysis::infinity;
            if (deviation <= largest_excess)
                return name_chord(scene, *chord, speeds, now.speed, deviation, energies_of(scene, tail), named);
        }
    }
    if (scene.law != Law::newton) return;
    const std::vector<double> energies = energies_of(scene, tail);
    if (analysis::grows_geometrically(energies)) name_created_energy(energies, named);
}

void name_divergence(NamedMode& named) {
    named.verdict.kind = Kind::accelerated;
}

}  // namespace swirl::apps
