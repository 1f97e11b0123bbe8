#include "map/steady/sticking_curves.hpp"

#include "map/contact/contact_state.hpp"
#include "map/steady/flight_times.hpp"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace swirl::steady {

namespace {

constexpr int even_parts = 200, small_parts = 264;  // twelve a decade
constexpr double smallest_share = 1e-22;  // of the widest χ: χ ≈ Q(1 − e)/2 near e = 1, where 1 − e ≥ 10⁻¹⁶

/// G/(1 + G), cut at where G = 1.5 and so where G has no value: continuous, and precise where G is small. The flight's
/// (1 − cos τ)/τ stays below 0.73.
double bounded(const Scene<double>& scene, SteadyBranch branch, double chi) {
    constexpr double cut = 0.6;
    const SteadyGeometry<double> at = geometry_at(scene, branch, chi);
    const double square = at.cosine * at.cosine, size = std::fabs(at.sine);
    const double needed = at.sine * at.sine + restitution_deficit(scene, at.sine, at.cosine) * square;
    const double along = at.sine < 0 ? -needed : needed;
    if (!(at.radius > 0 && along > 0)) return cut;
    return std::min(cut, size / (at.radius * along + size));
}

/// |χ| from small to wide: by equal ratios, and evenly but closer towards the end, where w has a root.
std::vector<double> sizes_up_to(double widest) {
    std::vector<double> sizes;
    for (int i = 0; i <= small_parts; ++i)
        sizes.push_back(widest * std::pow(smallest_share, 1 - static_cast<double>(i) / small_parts));
    for (int i = 1; i < even_parts; ++i) sizes.push_back(widest * std::sin(0.5 * pi<double>() * i / even_parts));
    std::sort(sizes.begin(), sizes.end());
    return sizes;
}

/// Where the bounded function turns on one side of χ = 0, with both ends.
std::vector<double> turns_of(const Scene<double>& scene, SteadyBranch branch, double side,
                             const std::vector<double>& sizes) {
    const auto value = [&](double size) { return bounded(scene, branch, side * size); };
    std::vector<double> values(sizes.size());
    std::transform(sizes.begin(), sizes.end(), values.begin(), value);
    std::vector<double> turns{sizes.front()};
    for (std::size_t i = 1; i + 1 < sizes.size(); ++i) {
        const double before = values[i - 1], here = values[i], after = values[i + 1];
        if ((here - before) * (after - here) > 0 || (here == before && here == after)) continue;
        const double sign = here > before || here > after ? -1 : 1;
        std::uintmax_t iterations = 60;
        turns.push_back(boost::math::tools::brent_find_minima([&](double x) { return sign * value(x); }, sizes[i - 1],
                                                              sizes[i + 1], 50, iterations)
                            .first);
    }
    turns.push_back(sizes.back());
    std::sort(turns.begin(), turns.end());
    return turns;
}

}  // namespace

double widest_sticking_chi(const Scene<double>& scene) {
    const double room = contact_scene(make_body(scene), scene.mu, scene.restitution, ImpactRule::poisson).widest_chi;
    const double swirl = scene.beta < 1 ? std::asin(scene.beta) : 0.5 * pi<double>();
    return std::min({room, swirl, std::atan(scene.mu)});
}

std::vector<StickingCurve> sticking_curves(const Scene<double>& scene, double longest) {
    std::vector<StickingCurve> curves;
    const double widest = widest_sticking_chi(scene);
    if (!(widest > 0)) return curves;
    const std::vector<double> sizes = sizes_up_to(widest);
    for (const SteadyBranch branch : {SteadyBranch::plus, SteadyBranch::minus})
        for (const double side : {1.0, -1.0}) {
            const std::vector<double> turns = turns_of(scene, branch, side, sizes);
            for (std::size_t i = 1; i < turns.size(); ++i) {
                const double one = bounded(scene, branch, side * turns[i - 1]);
                const double other = bounded(scene, branch, side * turns[i]);
                if (one == other) continue;
                const double low = std::min(one, other), high = std::max(one, other);
                const double lowest = low / (1 - low), highest = high / (1 - high);
                for (const auto& [from, to] : flight_times_between(lowest, highest, longest))
                    curves.push_back({branch, from, to, side * turns[i - 1], side * turns[i]});
            }
        }
    return curves;
}

double chi_at(const Scene<double>& scene, const StickingCurve& curve, double tau) {
    const double level = versine_rate(tau) / (1 + versine_rate(tau));
    const auto f = [&](double chi) { return bounded(scene, curve.branch, chi) - level; };
    const double at_low = f(curve.chi_low), at_high = f(curve.chi_high);
    // At an end of the curve rounding may put the level beyond it.
    if ((at_low > 0) == (at_high > 0) || at_low == 0 || at_high == 0)
        return std::fabs(at_low) < std::fabs(at_high) ? curve.chi_low : curve.chi_high;
    std::uintmax_t iterations = 100;
    const bool rising = curve.chi_low < curve.chi_high;
    const double a = rising ? curve.chi_low : curve.chi_high, b = rising ? curve.chi_high : curve.chi_low;
    const auto [low, high] =
        boost::math::tools::toms748_solve(f, a, b, rising ? at_low : at_high, rising ? at_high : at_low,
                                          boost::math::tools::eps_tolerance<double>(52), iterations);
    return 0.5 * (low + high);
}

}  // namespace swirl::steady
