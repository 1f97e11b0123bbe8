#include "analysis/classification/swing.hpp"

#include "analysis/classification/settled.hpp"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace swirl::analysis {

namespace {

constexpr double full_turn = 6.283185307179586;

/// Cubic Hermite interpolation at s in [0, 1] of a step h.
double hermite(double from, double from_rate, double to, double to_rate, double h, double s) {
    const double t = 1 - s;
    return t * t * ((1 + 2 * s) * from + s * h * from_rate) + s * s * ((3 - 2 * s) * to - t * h * to_rate);
}

struct Crossing {
    double time, turned;
};

/// Where the angle passes `level` upwards (direction 1) or downwards (−1) between two samples.
bool crossing_between(const SwingSample& a, const SwingSample& b, double level, int direction, Crossing& found) {
    const double before = direction * (a.angle - level), after = direction * (b.angle - level);
    if (!(before < 0 && after >= 0)) return false;
    const double h = b.time - a.time;
    const auto value = [&](double s) { return direction * (hermite(a.angle, a.rate, b.angle, b.rate, h, s) - level); };
    double s = 1;
    if (after > 0) {
        std::uintmax_t iterations = 60;
        const auto root = boost::math::tools::toms748_solve(value, 0.0, 1.0, before, after,
                                                            boost::math::tools::eps_tolerance<double>(45), iterations);
        s = 0.5 * (root.first + root.second);
    }
    found = {a.time + s * h, hermite(a.turned, a.rotation, b.turned, b.rotation, h, s)};
    return true;
}

std::vector<Crossing> crossings_of(const std::vector<SwingSample>& samples, const Swing& swing, double middle) {
    std::vector<Crossing> found;
    Crossing crossing{};
    const double drift = samples.back().angle - samples.front().angle;
    const int direction = swing.kind == SwingKind::circulating && drift < 0 ? -1 : 1;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        double level = middle;
        if (swing.kind == SwingKind::circulating) {
            // The next whole turn in the direction of travel.
            const double at = samples[i].angle / full_turn;
            level = full_turn * (direction > 0 ? std::floor(at) + 1 : std::ceil(at) - 1);
        }
        if (crossing_between(samples[i], samples[i + 1], level, direction, crossing)) found.push_back(crossing);
    }
    return found;
}

/// Mean periods over four equal quarters of the crossings, relative to the mean of all.
SlowSettling settling_of_periods(const std::vector<Crossing>& crossings, double period) {
    const std::size_t quarter = (crossings.size() - 1) / 4;
    if (quarter == 0) return {};
    std::array<double, 4> means{};
    for (std::size_t q = 0; q < 4; ++q)
        means[q] =
            (crossings[(q + 1) * quarter].time - crossings[q * quarter].time) / (static_cast<double>(quarter) * period);
    return settling_of(means);
}

}  // namespace

Swing judge_swing(const std::vector<SwingSample>& samples, double rest, double tolerance, double nearly) {
    Swing swing;
    if (samples.size() < 2) return swing;
    double low = samples[0].angle, high = low, slow = samples[0].rotation, fast = slow;
    for (const auto& s : samples) {
        low = std::min(low, s.angle);
        high = std::max(high, s.angle);
        slow = std::min(slow, s.rotation);
        fast = std::max(fast, s.rotation);
    }
    swing.range = fast - slow;
    swing.mean = (samples.back().turned - samples.front().turned) / (samples.back().time - samples.front().time);
    if (high - low <= rest && swing.range <= rest) {
        swing.kind = SwingKind::at_rest;
        return swing;
    }
    swing.kind = std::abs(samples.back().angle - samples.front().angle) >= full_turn ? SwingKind::circulating
                                                                                     : SwingKind::librating;
    const auto crossings = crossings_of(samples, swing, 0.5 * (low + high));
    swing.periods = static_cast<int>(crossings.size()) - 1;
    if (swing.periods < 3) {
        swing.kind = SwingKind::irregular;
        return swing;
    }
    const double span = crossings.back().time - crossings.front().time;
    swing.period = span / swing.periods;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i)
        swing.period_spread = std::max(
            swing.period_spread, std::abs(crossings[i + 1].time - crossings[i].time - swing.period) / swing.period);
    swing.mean = (crossings.back().turned - crossings.front().turned) / span;
    if (swing.period_spread <= tolerance) return swing;
    const SlowSettling settling = settling_of_periods(crossings, swing.period);
    swing.settling_exponent = settling.exponent;
    swing.still_to_come = settling.remaining;
    if (!(settling.remaining <= nearly)) swing.kind = SwingKind::irregular;
    return swing;
}

}  // namespace swirl::analysis
