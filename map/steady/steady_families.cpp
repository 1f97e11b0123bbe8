#include "map/steady/steady_families.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace swirl {

namespace steady {

namespace {

constexpr double grid = 0.01;

SectionPoint<double> member_point(const Scene<double>& scene, SteadyBranch branch, long long j, double tau,
                                  double spin) {
    return section_point_of(scene, branch, tau, 0, family_spin(scene, branch, j, tau, spin));
}

/// Nearer than this to a multiple of 2π the impact is slower than `least_speed`: u_n = Rτ/2 or R δ²/4πk there.
bool is_too_slow(const Scene<double>& scene, SteadyBranch branch, double tau) {
    return geometry_at(scene, branch, 0.0).radius * versine_rate(tau) < 2 * least_speed;
}

/// Where a condition that holds at `inside` ceases to.
template <class Condition>
double edge_between(const Condition& holds, double inside, double outside) {
    for (int i = 0; i < 60 && std::fabs(outside - inside) > 4 * epsilon<double>() * inside; ++i) {
        const double middle = 0.5 * (inside + outside);
        (holds(middle) ? inside : outside) = middle;
    }
    return inside;
}

}  // namespace

double family_spin(const Scene<double>& scene, SteadyBranch branch, long long j, double tau, double spin) {
    if (scene.mu > 0) return sticking_spin(scene, geometry_at(scene, branch, 0.0), tau);
    return scene.is_disk() ? spin : spin_of(scene, tau, j);
}

std::vector<SteadyFamily> families_of(const MapOfScene& map, SteadyBranch branch, long long j, Interval flights) {
    const Scene<double>& scene = map.scene;
    std::vector<SteadyFamily> families;
    if (!(geometry_at(scene, branch, 0.0).radius > 0)) return families;
    const double turn = 2 * pi<double>();
    const auto holds = [&](double tau) { return arrives(map, j, tau, member_point(scene, branch, j, tau, 0)); };
    for (int k = static_cast<int>(flights.from / turn); turn * k < flights.to; ++k) {
        const double start = std::max(turn * k, flights.from), end = std::min(turn * (k + 1), flights.to);
        const int cells = 1 + static_cast<int>((end - start) / grid);
        double last = start;  // the last flight time looked at
        bool open = false;
        for (int i = 1; i <= cells; ++i) {
            const double tau = start + (end - start) * i / cells;
            if (is_too_slow(scene, branch, tau)) continue;
            const bool now = holds(tau);
            if (now && !open)  // the first that is fast enough: nothing but the vanishing impact lies before it
                families.push_back({branch, j, last == start ? start : edge_between(holds, tau, last), tau, false});
            if (!now && open) families.back().to = edge_between(holds, last, tau);
            open = now;
            last = tau;
        }
        if (open) families.back().to = end;
    }
    for (SteadyFamily& family : families) family.spin_is_free = scene.is_disk() && scene.mu == 0;
    return families;
}

}  // namespace steady

std::optional<SteadyMode> member_of(const Scene<double>& scene, const SteadyFamily& family, double tau, double spin) {
    const double turning = steady::family_spin(scene, family.branch, family.j, tau, spin);
    return steady::verified_mode(steady::map_of(scene), family.branch, family.j, tau,
                                 steady::section_point_of(scene, family.branch, tau, 0, turning));
}

}  // namespace swirl
