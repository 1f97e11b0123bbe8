#include "map/chords/chord_fate.hpp"

#include "map/chords/chord_response.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>

namespace swirl {

namespace {

/// Speeds that are looked at, from above the resonance to `fastest_chord`: each this much above the one before.
constexpr double speed_ratio = 1.05;
/// Nearer to the resonance the response is too large for its leading order.
constexpr double above_resonance = 1.2;

/// Where g changes its sign between low and high, to the last bits.
double sign_change(const std::function<double(double)>& g, double low, double high) {
    const bool positive = g(low) > 0;
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high || high - low < 1e-15 * high) return middle;
        ((g(middle) > 0) == positive ? low : high) = middle;
    }
}

/// The highest interval of speeds in which g > 0; both ends 0 if there is none, `above` infinite if it has no end.
struct Fed {
    double from = 0, to = 0;
    bool ends = false;
};

Fed highest_fed(const std::function<double(double)>& g, double slowest, double fastest) {
    Fed fed;
    double above = fastest;
    bool was_fed = g(above) > 0;
    if (was_fed) fed.to = fastest;
    for (double v = above / speed_ratio; v >= slowest; v /= speed_ratio) {
        const bool is_fed = g(v) > 0;
        if (is_fed && !was_fed) {
            fed.to = sign_change(g, v, above);
            fed.ends = true;
        }
        if (!is_fed && was_fed) {
            fed.from = sign_change(g, v, above);
            break;
        }
        was_fed = is_fed;
        above = v;
    }
    return fed;
}

}  // namespace

std::string_view name_of(ChordFate fate) {
    static constexpr std::string_view names[] = {"leaves", "starves", "limit", "accelerates"};
    return names[static_cast<std::size_t>(fate)];
}

double diameter_growth(const Scene<double>& scene) {
    const double a = scene.alpha, k = scene.inertia_factor, rho = 1 - a;
    const double arm = 1 - (1 - k) * a;
    const double common = rho * rho * rho * (1 - 2 * a + a * k + 2 * a * a * (2 + k)) / (9 * arm * arm);
    if (scene.law == Law::newton) return 2 * common * (1 + a * (2 + k));
    return common * (3 + 2 * k + 2 * a * k * (2 + k)) / (1 + k);
}

ChordSpeeds chord_speeds(const Scene<double>& scene, const Chord& chord) {
    if (!chord.attracts()) return {};
    if (chord.is_diameter()) return {ChordFate::accelerates, 0, 0, 0};
    const auto gain = [&](double v) { return chord_response(scene, chord, v).gain(); };
    const Fed fed = highest_fed(gain, above_resonance * chord_resonance(chord), fastest_chord);
    if (fed.to == 0) return {ChordFate::starves, 0, 0, 0};
    if (!fed.ends) return {ChordFate::accelerates, fed.from, 0, 0};
    return {ChordFate::limit, fed.from, fed.to, -fed.to * std::sin(chord.angle) / scene.alpha};
}

double impacts_between(const Scene<double>& scene, const Chord& chord, double from, double to) {
    constexpr int intervals = 128;  // of Simpson's rule in ln v
    const double sine = std::sin(chord.angle), inertia = 1 + scene.inertia_factor * sine * sine;
    const double width = std::log(to / from) / intervals;
    double sum = 0;
    for (int k = 0; k <= intervals; ++k) {
        const double v = from * std::exp(k * width), gain = chord_response(scene, chord, v).gain();
        if (!(gain * width > 0)) return std::numeric_limits<double>::infinity();
        const double weight = k == 0 || k == intervals ? 1 : k % 2 == 1 ? 4 : 2;
        sum += weight * v * v / gain;
    }
    return sum * width / 3 * inertia / (scene.beta * scene.beta);
}

std::optional<double> balanced_speed(const Scene<double>& scene, const Chord& chord) {
    const double e = scene.restitution;
    if (!(e < 1) || scene.beta == 0 || !chord.attracts()) return {};
    const double cosine = std::cos(chord.angle), loss = 0.5 * (1 - e) * (1 + e) * cosine * cosine;
    const auto gain = [&](double v) {
        return chord_response(scene, chord, v).gain() * scene.beta * scene.beta - loss * v * v;
    };
    const Fed fed = highest_fed(gain, above_resonance * chord_resonance(chord), fastest_chord);
    if (!fed.ends) return {};
    return fed.to;
}

}  // namespace swirl
