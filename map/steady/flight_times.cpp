#include "map/steady/flight_times.hpp"

#include "map/steady/steady_equations.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace swirl::steady {

namespace {

/// The root of (1 − cos τ)/τ = level in a piece on which it rises or falls, cut to the piece.
double flight_time_at(double level, double low, double high) {
    const auto f = [&](double tau) { return versine_rate(tau) - level; };
    const double at_low = f(low), at_high = f(high);
    if (at_low == 0) return low;
    if (at_high == 0) return high;
    if ((at_low > 0) == (at_high > 0)) return std::fabs(at_low) < std::fabs(at_high) ? low : high;
    std::uintmax_t iterations = 100;
    return boost::math::tools::toms748_solve(f, low, high, at_low, at_high,
                                             boost::math::tools::eps_tolerance<double>(52), iterations)
        .first;
}

/// Where (1 − cos τ)/τ is largest between 2πk and 2π(k + 1): tan(τ/2) = τ.
double highest_of_lobe(int k) {
    const double start = 2 * pi<double>() * k;
    std::uintmax_t iterations = 100;
    const auto f = [](double tau) { return tau * std::cos(0.5 * tau) - std::sin(0.5 * tau); };
    return boost::math::tools::toms748_solve(f, start + 1e-3, start + pi<double>(),
                                             boost::math::tools::eps_tolerance<double>(52), iterations)
        .first;
}

}  // namespace

std::vector<Interval> flight_times_between(double lowest, double highest, double longest) {
    std::vector<Interval> intervals;
    const double turn = 2 * pi<double>();
    for (int k = 0; turn * k < longest; ++k) {
        const double top = highest_of_lobe(k), start = k == 0 ? 1e-12 : turn * k;
        if (versine_rate(top) < lowest) continue;
        for (const auto& [a, b] : {Interval{start, top}, Interval{top, turn * (k + 1)}}) {
            const double first = flight_time_at(lowest, a, b), second = flight_time_at(highest, a, b);
            const double from = std::min(first, second), to = std::min(std::max(first, second), longest);
            if (from < to) intervals.push_back({from, to});
        }
    }
    return intervals;
}

}  // namespace swirl::steady
