#include "apps/studies/modes/chord_mode.hpp"

#include "analysis/special_values.hpp"
#include "apps/studies/scene_map/itinerary_map.hpp"
#include "map/chords/chord_fate.hpp"
#include "map/chords/chord_response.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

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

namespace {

using PolygonMap = SceneMap<polygon_dimension>;
using analysis::Kind, analysis::Mode;

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

/// Where a chord leads an orbit.
struct Lead {
    Chord chord;
    ChordSpeeds speeds;
    double tolerance = 0;  ///< of v*, relative: `limit_tolerance`
    bool accelerates() const { return speeds.fate == ChordFate::accelerates; }
    bool is_at_limit(double v) const { return !accelerates() && std::abs(v / speeds.limit - 1) <= tolerance; }
};

/// Nothing if the chord leads nowhere, or to a limit at which the response to the swirl is no small one.
std::optional<Lead> lead_of(const Scene<double>& scene, const Chord& chord) {
    const ChordSpeeds speeds = chord_speeds(scene, chord);
    if (speeds.fate == ChordFate::accelerates) return Lead{chord, speeds};
    if (speeds.fate != ChordFate::limit) return {};
    const double bend = forced_bend(scene, chord, speeds.limit).largest();
    if (bend > most_bent_at_limit) return {};
    return Lead{chord, speeds, limit_tolerance(bend)};
}

std::string way_in_words(const Scene<double>& scene, const Lead& lead, double v) {
    const auto& [chord, speeds, tolerance] = lead;
    if (lead.accelerates() && chord.is_diameter())
        return fmt::format("J doubles within {:.2g} impacts and grows as ({:.4g} beta^2 n)^(1/3)",
                           impacts_between(scene, chord, v, std::sqrt(2.0) * v), 0.75 * diameter_growth(scene));
    if (lead.accelerates()) return "the swirl feeds it at every speed";
    if (lead.is_at_limit(v))
        return fmt::format("S has come to its limit {:.4f} within {:.2g} %", speeds.limit_spin, 100 * tolerance);
    const double near = speeds.limit * (v < speeds.limit ? 1 - tolerance : 1 + tolerance);
    return fmt::format("S goes to {:.4f}, {:.2g} % from which it is after {:.2g} impacts more", speeds.limit_spin,
                       100 * tolerance, impacts_between(scene, chord, v, near));
}

/// Impacts before the tail of an orbit.
double impacts_before(const analysis::Tail<PolygonMap>& tail, const NamedMode& named) {
    return static_cast<double>(named.impacts) - static_cast<double>(tail.durations.size());
}

std::string chord_in_words(const Chord& chord) {
    return chord.is_diameter() ? "a diameter fixed in the laboratory"
                               : fmt::format("a no-slip chord, a = {:.6g} rad", chord.angle);
}

/// The verdict of an orbit on a chord.
void name_chord(const Scene<double>& scene, const Lead& lead, double v, double deviation,
                const analysis::Tail<PolygonMap>& tail, NamedMode& named) {
    auto& verdict = named.verdict;
    const std::vector<double> energies = energies_of(scene, tail);
    const Chord& chord = lead.chord;
    const bool accelerated = lead.accelerates();
    verdict.mode = Mode::quasi_steady;
    verdict.kind = accelerated ? Kind::accelerated : Kind::chord;
    verdict.rotation = analysis::nan;
    if (!lead.is_at_limit(v)) verdict.mean = verdict.mean_per_step = analysis::nan;
    if (accelerated)
        named.growth = analysis::growth_exponent(energies, impacts_before(tail, named));
    else
        named.limit_spin = lead.speeds.limit_spin;
    const std::string name = chord_in_words(chord);
    const double predicted = predicted_gain(scene, chord, energies);
    verdict.evidence = {{"slowest multiplier of the chord", std::abs(chord.multipliers[0]), 1,
                         "small deviations from the chord decay", "1 or more: it would not attract"},
                        {"deviation from the chord over the forced one", deviation, chord_excess,
                         fmt::format("for {} impacts it sticks and goes on by {} vertices, on {}", chord_impacts,
                                     chord.vertex_step, name),
                         fmt::format("above {:g}: it would not be on the chord yet", chord_excess)},
                        {"gain of energy per impact", measured_gain(energies), predicted,
                         fmt::format("on {}; predicted {:.4g}; {}", name, predicted, way_in_words(scene, lead, v)),
                         "nothing: the prediction is of the scene's numbers alone"}};
}

/// Is a body so fast that the swirl, of speed β, hardly matters? What it does then it does at every higher speed.
bool is_fast(const Scene<double>& scene, double energy) {
    constexpr double faster = 10;
    return energy > 0.5 * std::pow(faster * scene.beta, 2);
}

/// The energies of the tail, and of 20,000 impacts more: over 500 energy that is created hardly differs from chaos.
std::vector<double> energies_followed_on(const PolygonMap& map, const Scene<double>& scene,
                                         const analysis::Tail<PolygonMap>& tail) {
    constexpr int further = 20'000;
    std::vector<double> energies = energies_of(scene, tail);
    auto step = map.advance(tail.last);
    for (int n = 0; n < further && step.alive; ++n, step = map.advance(step.state))
        energies.push_back(in_container(scene, step.state).energy);
    return energies;
}

void name_created_energy(const std::vector<double>& energies, double first, NamedMode& named) {
    auto& verdict = named.verdict;
    verdict.mode = Mode::undecided;
    verdict.kind = Kind::accelerated;
    verdict.mean = verdict.mean_per_step = verdict.rotation = analysis::nan;
    named.growth = analysis::growth_exponent(energies, first);
    const std::string parts = fmt::format("{} parts of {} impacts", analysis::growth_parts, energies.size());
    verdict.evidence.push_back(
        {"energy at the end over that at the begin", energies.back() / energies.front(), analysis::least_growth,
         fmt::format("Newton's law creates energy: the means of {} rise from each to the next, without bound as far "
                     "as it was followed",
                     parts),
         fmt::format("a part below the one before, or less than {:g} times in all: not accelerated",
                     analysis::least_growth)});
}

/// An orbit along a chord that neither attracts nor repels to first order.
void name_neutral(const Chord& chord, NamedMode& named) {
    auto& verdict = named.verdict;
    verdict.mode = Mode::undecided;
    verdict.kind = Kind::transient;
    verdict.mean = verdict.mean_per_step = verdict.rotation = analysis::nan;
    const double modulus = std::max(std::abs(chord.multipliers[0]), std::abs(chord.multipliers[1]));
    verdict.evidence.push_back(
        {"modulus of the chord's multipliers", modulus, 1,
         fmt::format("the orbit follows {}, whose multipliers have modulus 1: terms beyond the linear ones decide "
                     "whether it attracts",
                     chord_in_words(chord)),
         "below 1: the chord attracts, and says where the orbit goes"});
}

/// Names an orbit on a chord. False if it is on none.
bool look_for_chord(const PolygonMap& map, const Scene<double>& scene, const analysis::Tail<PolygonMap>& tail,
                    NamedMode& named) {
    const ContainerState now = in_container(scene, tail.last);
    const std::optional<Chord> chord = chord_near(scene, now);
    if (!chord) return false;
    const ForcedBend forced = forced_bend(scene, *chord, now.speed);
    if (!(forced.largest() < most_bent)) return false;
    const double excess = excess_over(map, scene, *chord, forced, tail.last);
    if (is_neutral(*chord)) {
        if (excess == analysis::infinity || named.verdict.mode != Mode::undecided) return false;
        name_neutral(*chord, named);
        return true;
    }
    const std::optional<Lead> lead = lead_of(scene, *chord);
    if (!lead || now.speed <= lead->speeds.fed_from || excess > chord_excess) return false;
    name_chord(scene, *lead, now.speed, excess, tail, named);
    return true;
}

}  // namespace

void look_for_growth(const PolygonMap& map, const Scene<double>& scene, const analysis::Tail<PolygonMap>& tail,
                     NamedMode& named) {
    const auto& verdict = named.verdict;
    const bool settled = verdict.period > 0 && !verdict.multipliers.empty();
    if (tail.ended || settled || scene.mu == 0 || tail.durations.size() < chord_impacts) return;
    if (scene.restitution == 1 && scene.beta > 0 && !scene.has_own_map() && look_for_chord(map, scene, tail, named))
        return;
    if (scene.law != Law::newton || !is_fast(scene, in_container(scene, tail.last).energy)) return;
    const std::vector<double> energies = energies_followed_on(map, scene, tail);
    if (analysis::grows_geometrically(energies)) name_created_energy(energies, impacts_before(tail, named), named);
}

void name_divergence(NamedMode& named) {
    named.verdict.kind = Kind::accelerated;
}

}  // namespace swirl::studies
