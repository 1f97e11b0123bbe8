#include "map/chords/chords.hpp"

#include "map/chords/chord_response.hpp"
#include "map/collision_map.hpp"
#include "map/numbers/real.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swirl {

namespace {

/// By what contact goes on minus what the body turns: 2πj/N on a chord. f(−a) = 2π − f(a).
struct Advance {
    double ratio;  ///< ρ/α
    double operator()(double a) const { return pi<double>() - 2 * a + ratio * std::sin(2 * a); }
    /// Where it turns back, 0 < a < π/2; π/2 if nowhere.
    double turning_point() const { return ratio > 1 ? 0.5 * std::acos(1 / ratio) : 0.5 * pi<double>(); }
};

/// The root of f = level in a monotone piece that has one, to the last bit.
double root_between(const Advance& f, double level, double low, double high) {
    const bool rises = f(low) < f(high);
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) return middle;
        ((f(middle) < level) == rises ? low : high) = middle;
    }
}

/// The two multipliers besides 1 and 0: M has the polynomial x(x − 1)(x² − (t − 1)x + e₂ − t + 1), t and e₂ the sums of
/// its principal minors of first and second order.
void set_multipliers(const Scene<double>& scene, Chord& chord) {
    const Eigen::Matrix4d m = chord_derivative(scene, chord, 1).bottomRightCorner<4, 4>();
    const double trace = m.trace(), second = 0.5 * (trace * trace - (m * m).trace());
    const double sum = trace - 1, product = second - sum;
    const std::complex<double> root = std::sqrt(std::complex<double>(0.25 * sum * sum - product));
    chord.multipliers[0] = 0.5 * sum + (sum < 0 ? -root : root);
    chord.multipliers[1] = 0.5 * sum - (sum < 0 ? -root : root);
}

/// Does the map take this way, without another vertex that strikes before?
template <class Map>
bool is_taken(const Map& map, const Chord& chord) {
    const double a = chord.angle, alpha = map.scene().alpha;
    const SectionPoint<double> z{0, 0, -std::cos(a), std::sin(a), -std::sin(a) / alpha};
    const auto next = map.advance(post_impact_state(z));
    constexpr double rounding = 1e-9;
    return next.outcome == FirstContactOutcome::contact && next.vertex_step == chord.vertex_step &&
           std::abs(next.flight_time - chord.length) <= rounding;
}

Chord chord_at(const Scene<double>& scene, double a, long long j) {
    const double inner = 1 - scene.alpha;
    const long long step = ((j % scene.sides) + scene.sides) % scene.sides;
    const double turn = a == 0 ? 0 : -inner / scene.alpha * std::sin(2 * a);
    Chord chord{a, static_cast<int>(step), turn, 2 * inner * std::cos(a), {}};
    set_multipliers(scene, chord);
    return chord;
}

using Candidate = std::pair<double, long long>;  // a, j

/// The roots in a monotone piece; of a piece with too many those of the levels nearest to π.
void add_roots(const Advance& f, int sides, double low, double high, std::size_t most, std::vector<Candidate>& found,
               bool& complete) {
    const double spacing = 2 * pi<double>() / sides;
    const double first = std::min(f(low), f(high)), last = std::max(f(low), f(high));
    auto from = static_cast<long long>(std::floor(first / spacing)) + 1;
    auto to = static_cast<long long>(std::ceil(last / spacing)) - 1;
    const long long half = sides / 2, reach = static_cast<long long>(most);
    complete &= from >= half - reach && to <= half + reach;
    from = std::max(from, half - reach);
    to = std::min(to, half + reach);
    for (long long j = from; j <= to; ++j) {
        const bool diameter = 2 * j == sides && low <= 0 && high >= 0;
        found.emplace_back(diameter ? 0 : root_between(f, spacing * static_cast<double>(j), low, high), j);
    }
}

}  // namespace

Chords chords_of(const Scene<double>& scene, std::size_t most) {
    Scene<double> unswirled = without_rounding(without_floor(validated(scene), "a chord"), "a chord");
    Chords result;
    if (scene.is_disk() || scene.mu == 0) return result;
    unswirled.beta = 0;
    unswirled.restitution = 1;
    unswirled.law = Law::poisson;
    const Advance f{(1 - scene.alpha) / scene.alpha};
    const double end = 0.5 * pi<double>(), turn = f.turning_point();
    std::vector<Candidate> found;
    add_roots(f, scene.sides, -turn, turn, most, found, result.complete);
    if (turn < end) {
        add_roots(f, scene.sides, -end, -turn, most, found, result.complete);
        add_roots(f, scene.sides, turn, end, most, found, result.complete);
    }
    std::sort(found.begin(), found.end(),
              [](const Candidate& x, const Candidate& y) { return std::abs(x.first) < std::abs(y.first); });
    const CollisionMap<double, Shape::polygon, ImpactRule::poisson> map(unswirled);
    for (const auto& [a, j] : found) {
        const Chord chord = chord_at(scene, a, j);
        if (!is_taken(map, chord)) continue;
        if ((result.complete &= result.chords.size() < most)) result.chords.push_back(chord);
    }
    std::sort(result.chords.begin(), result.chords.end(),
              [](const Chord& x, const Chord& y) { return x.angle < y.angle; });
    return result;
}

}  // namespace swirl
