#include "map/steady/whole_numbers.hpp"

#include "map/numbers/real.hpp"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace swirl::steady {

namespace {

using Function = std::function<double(double)>;

struct Sample {
    double x, value;
};

std::vector<Sample> samples_of(const Function& f, double from, double to, int cells) {
    std::vector<Sample> samples;
    for (int i = 0; i <= cells; ++i) {
        const double share = 0.5 * (1 - std::cos(pi<double>() * i / cells));
        const double x = from + (to - from) * share;
        if (const double value = f(x); std::isfinite(value)) samples.push_back({x, value});
    }
    return samples;
}

/// The samples, with the place at which f turns between any three of them.
std::vector<Sample> with_extrema(const Function& f, const std::vector<Sample>& samples) {
    std::vector<Sample> all;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        all.push_back(samples[i]);
        if (i == 0 || i + 1 == samples.size()) continue;
        const Sample &before = samples[i - 1], &here = samples[i], &after = samples[i + 1];
        const double sign = here.value > before.value ? -1 : 1;
        if ((here.value - before.value) * (after.value - here.value) > 0) continue;
        std::uintmax_t iterations = 60;
        const auto [x, value] = boost::math::tools::brent_find_minima([&](double t) { return sign * f(t); }, before.x,
                                                                      after.x, 40, iterations);
        all.push_back({x, sign * value});
    }
    std::sort(all.begin(), all.end(), [](const Sample& a, const Sample& b) { return a.x < b.x; });
    return all;
}

double root_between(const Function& f, const Sample& a, const Sample& b, double level) {
    const double at_a = a.value - level, at_b = b.value - level;
    if (at_a == 0) return a.x;
    if (at_b == 0) return b.x;
    std::uintmax_t iterations = 100;
    const auto [low, high] =
        boost::math::tools::toms748_solve([&](double x) { return f(x) - level; }, a.x, b.x, at_a, at_b,
                                          boost::math::tools::eps_tolerance<double>(52), iterations);
    return 0.5 * (low + high);
}

}  // namespace

WholeNumbers whole_numbers(const Function& f, double from, double to, int cells, std::size_t most) {
    WholeNumbers result;
    result.complete_to = to;
    const std::vector<Sample> all = with_extrema(f, samples_of(f, from, to, cells));
    for (std::size_t i = 1; i < all.size(); ++i) {
        const Sample &a = all[i - 1], &b = all[i];
        const double low = std::min(a.value, b.value), high = std::max(a.value, b.value);
        if (!(std::fabs(low) < 1e15 && std::fabs(high) < 1e15)) continue;  // beyond, every double is whole
        if (high - low >= static_cast<double>(most - result.found.size())) {
            result.complete_to = a.x;
            break;
        }
        for (double level = std::ceil(low); level <= high; ++level)
            if (level != a.value || i == 1)  // else it is of the cell before
                result.found.push_back({root_between(f, a, b, level), static_cast<long long>(level)});
    }
    std::sort(result.found.begin(), result.found.end(),
              [](const WholeNumber& a, const WholeNumber& b) { return a.at < b.at; });
    return result;
}

}  // namespace swirl::steady
