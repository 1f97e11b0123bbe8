#include "map/steady/steady_modes.hpp"

#include "map/numbers/jets.hpp"
#include "map/steady/flight_times.hpp"
#include "map/steady/sticking_curves.hpp"
#include "map/steady/whole_numbers.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace swirl {

std::string_view name_of(SteadySet set) {
    static constexpr std::string_view names[] = {"points", "families", "none-lossy-disk", "none-frictionless"};
    return names[static_cast<std::size_t>(set)];
}

std::string_view why_none(SteadySet set) {
    switch (set) {
        case SteadySet::none_frictionless:
            return "no steady mode exists: without friction it has chi = 0 and the same |u_n| before and after an "
                   "impact, but e < 1";
        case SteadySet::none_lossy_disk:
            return "no steady mode exists: a disk's has no tangential impulse and the same |u_n| before and after an "
                   "impact, but e < 1";
        case SteadySet::points:
        case SteadySet::families:
            break;
    }
    return "";
}

namespace {

using namespace steady;

/// Cells per unit of τ in which a curve is searched, and the least.
struct Grid {
    double per_time;
    int least;
};
constexpr Grid fine{200, 64}, coarse{10, 16};
constexpr double shortest_flight_time = 1e-7;  // u_n ≈ Rτ/2 is below `least_speed` for R < 20
constexpr double short_flight = 0.01;
constexpr std::size_t most_sliding = 10'000;  // where only those that attract are sought: few of them do

/// A solution of both equations.
struct Candidate {
    SteadyBranch branch;
    long long j;
    double tau, chi;
    bool slides;
};

struct Search {
    const Scene<double>& scene;
    const SteadyOptions& options;
    std::size_t most;  ///< candidates
    double complete_to;
    std::vector<Candidate> candidates{};
};

/// One curve: χ(τ) and S(τ, χ) on an interval of τ.
template <class ChiAt, class SpinAt>
void search_curve(Search& search, SteadyBranch branch, Interval interval, bool slides, const ChiAt& chi_of,
                  const SpinAt& spin_at) {
    const auto j_at = [&](double tau) {
        return vertices_on(search.scene, tau, spin_at(geometry_at(search.scene, branch, chi_of(tau)), tau));
    };
    const Grid& grid = search.options.attracting ? coarse : fine;
    const int cells = grid.least + static_cast<int>(grid.per_time * (interval.to - interval.from));
    const WholeNumbers whole = whole_numbers(j_at, interval.from, interval.to, cells, search.most);
    if (whole.complete_to < interval.to) search.complete_to = std::min(search.complete_to, whole.complete_to);
    for (const auto& [tau, j] : whole.found) search.candidates.push_back({branch, j, tau, chi_of(tau), slides});
}

void search_sticking(Search& search) {
    const Scene<double>& scene = search.scene;
    const auto spin_at = [&](const SteadyGeometry<double>& at, double tau) { return sticking_spin(scene, at, tau); };
    for (const StickingCurve& curve : sticking_curves(scene, search.options.longest_flight))
        search_curve(
            search, curve.branch, {curve.from, curve.to}, false, [&](double tau) { return chi_at(scene, curve, tau); },
            spin_at);
}

/// The lines χ = `chi` over all τ.
template <class SpinAt>
void search_line(Search& search, double chi, bool slides, const SpinAt& spin_at) {
    for (const SteadyBranch branch : {SteadyBranch::plus, SteadyBranch::minus}) {
        const bool only_repels = search.options.attracting && !slides;
        if (branch == SteadyBranch::minus && (search.scene.beta == 0 || only_repels)) continue;  // at β = 0 the same
        if (!(geometry_at(search.scene, branch, chi).radius > 0)) continue;
        // The line begins at j = 0, τ = 0, where the impact vanishes; roots of j = 0 near it (e → 1) need closer looks.
        const double longest = search.options.longest_flight, shorter = std::min(short_flight, longest);
        for (const Interval interval : {Interval{shortest_flight_time, shorter}, Interval{shorter, longest}})
            if (interval.from < interval.to)
                search_curve(
                    search, branch, interval, slides, [&](double) { return chi; }, spin_at);
    }
}

void search_sliding(Search& search) {
    const Scene<double>& scene = search.scene;
    const double chi = std::atan(scene.mu);
    if (chi > widest_sticking_chi(scene)) return;
    const auto spin_at = [&](const SteadyGeometry<double>& at, double tau) { return sliding_spin(scene, at, tau); };
    search_line(search, chi, true, spin_at);
    search_line(search, -chi, true, spin_at);
}

/// Newton's method for both equations of a sticking contact, exact derivatives by Jets: what the bracketing of one
/// within the other leaves of rounding. Kept only where it settles beside the start.
void polish(const Scene<double>& scene, Candidate& candidate) {
    using Jet = ceres::Jet<double, 2>;
    double tau = candidate.tau, chi = candidate.chi;
    for (int i = 0; i < 4; ++i) {
        const Jet t(tau, 0), x(chi, 1);
        const SteadyGeometry<Jet> at = geometry_at(scene, candidate.branch, x);
        const Jet deficit = restitution_deficit(scene, at.sine, at.cosine);
        const Jet law = at.radius * versine_rate(t) * (at.sine * at.sine + deficit * at.cosine * at.cosine) - at.sine;
        const Jet count = vertices_on(scene, t, sticking_spin(scene, at, t)) - static_cast<double>(candidate.j);
        Eigen::Matrix2d derivative;
        derivative << law.v.transpose(), count.v.transpose();
        const Eigen::Vector2d step = derivative.partialPivLu().solve(Eigen::Vector2d(law.a, count.a));
        tau -= step[0], chi -= step[1];
    }
    constexpr double beside = 1e-6;
    if (std::fabs(tau - candidate.tau) <= beside * candidate.tau &&
        std::fabs(chi - candidate.chi) <= beside * std::fabs(candidate.chi))
        candidate.tau = tau, candidate.chi = chi;
}

/// The contact slips throughout: u_t keeps the side that friction was given, sign χ.
bool keeps_slipping(const Scene<double>& scene, const Candidate& c) {
    const SteadyGeometry<double> at = geometry_at(scene, c.branch, c.chi);
    const double lag = spin_of(scene, c.tau, c.j) - sticking_spin(scene, at, c.tau);  // u_t = α cos χ (S − S_sticking)
    return c.chi > 0 ? lag >= 0 : lag <= 0;
}

bool is_same(const SteadyMode& a, const SteadyMode& b) {
    constexpr double apart = 1e-9;
    return a.branch == b.branch && a.j == b.j && std::fabs(a.tau - b.tau) <= apart * a.tau &&
           std::fabs(a.chi - b.chi) <= apart;
}

/// At e = 0 the body leaves at u_n = 0, which rounding must not make an approach: u_n below it by some ε.
SectionPoint<double> leaving(const Body<double>& body, SectionPoint<double> z) {
    const double rounding = 4 * epsilon<double>() * (1 + body.beta + body.alpha * std::fabs(z.spin));
    const double un = contact_kinematics(body, post_impact_state(z)).un;
    if (un > -rounding) z.vn -= un + rounding;
    return z;
}

void verify(const Search& search, SteadyModes& result) {
    const MapOfScene map = map_of(search.scene);
    for (Candidate candidate : search.candidates) {
        if (candidate.slides && !keeps_slipping(search.scene, candidate)) continue;
        if (!candidate.slides && candidate.chi != 0) polish(search.scene, candidate);
        const auto& [branch, j, tau, chi, slides] = candidate;
        const SectionPoint<double> z = section_point_of(search.scene, branch, tau, chi, spin_of(search.scene, tau, j));
        const auto mode = verified_mode(map, branch, j, tau, leaving(map.body, z));
        if (mode) result.modes.push_back(*mode);
    }
    std::sort(result.modes.begin(), result.modes.end(), [](const SteadyMode& a, const SteadyMode& b) {
        return a.branch == b.branch ? a.tau < b.tau : a.branch == SteadyBranch::plus;
    });
    result.modes.erase(std::unique(result.modes.begin(), result.modes.end(), is_same), result.modes.end());
}

/// The earliest `most` of all curves: what is listed is complete up to some τ.
void keep_earliest(Search& search) {
    auto& all = search.candidates;
    std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.tau < b.tau; });
    if (all.size() > search.most) {
        const double last = all[search.most - 1].tau, next = all[search.most].tau;
        search.complete_to = std::min(search.complete_to, 0.5 * (last + next));  // their last digits are still to come
        all.resize(search.most);
    }
    while (!all.empty() && all.back().tau > search.complete_to) all.pop_back();
}

void find_points(const Scene<double>& scene, const SteadyOptions& options, SteadyModes& result) {
    Search search{scene, options, options.most, options.longest_flight};
    search_sticking(search);
    if (!options.attracting) search_sliding(search);
    if (scene.restitution == 1)  // χ = 0: the law holds for every Q
        search_line(search, 0, false,
                    [&](const SteadyGeometry<double>& at, double tau) { return sticking_spin(scene, at, tau); });
    keep_earliest(search);
    if (options.attracting) {  // of many sides thousands slide, which must not crowd out those that stick
        Search sliding{scene, options, std::min(options.most, most_sliding), options.longest_flight};
        search_sliding(sliding);
        keep_earliest(sliding);
        search.candidates.insert(search.candidates.end(), sliding.candidates.begin(), sliding.candidates.end());
        search.complete_to = std::min(search.complete_to, sliding.complete_to);
    }
    result.candidates = search.candidates.size();
    result.complete_to = search.complete_to;
    verify(search, result);
}

/// From which τ on |S| = |1 − 2πj/(Nτ)| ≤ fastest (≥ 1).
double shortest_flight(const Scene<double>& scene, long long j, double fastest) {
    if (scene.is_disk() || j == 0) return 0;
    const double turned = 2 * pi<double>() * static_cast<double>(std::llabs(j)) / scene.sides;
    return turned / (j > 0 ? fastest + 1 : fastest - 1);
}

void find_families(const Scene<double>& scene, const SteadyOptions& options, SteadyModes& result) {
    const MapOfScene map = map_of(scene);
    const auto look = [&](long long j) {
        const double shortest = shortest_flight(scene, j, options.fastest_spin);
        if (!(shortest < options.longest_flight)) return;
        for (const SteadyBranch branch : {SteadyBranch::plus, SteadyBranch::minus}) {
            if (scene.beta == 0 && branch == SteadyBranch::minus) continue;  // the same
            for (const SteadyFamily& family : families_of(map, branch, j, {shortest, options.longest_flight}))
                result.families.push_back(family);
        }
    };
    look(0);
    for (long long size = 1; !scene.is_disk(); ++size) {
        const double shortest = shortest_flight(scene, size, options.fastest_spin);
        if (shortest >= options.longest_flight) break;  // then −size too
        if (size > options.most_steps) {
            result.complete_to = shortest;
            break;
        }
        look(size);
        look(-size);
    }
    std::sort(result.families.begin(), result.families.end(), [](const SteadyFamily& a, const SteadyFamily& b) {
        if (a.branch != b.branch) return a.branch == SteadyBranch::plus;
        return a.j == b.j ? a.from < b.from : a.j < b.j;
    });
}

}  // namespace

SteadyModes steady_modes(const Scene<double>& scene, const SteadyOptions& options) {
    constexpr auto search = "the search for steady modes";
    without_rounding(without_floor(validated(scene), search), search);
    if (!(options.longest_flight > 0 && options.longest_flight <= 1e4))
        detail::out_of_range("longest-flight", options.longest_flight, "0 < longest-flight <= 10000");
    if (options.most < 1) detail::out_of_range("most", static_cast<double>(options.most), "1 <= most");
    if (!(options.fastest_spin >= 1 && options.fastest_spin <= 1e6))
        detail::out_of_range("fastest-spin", options.fastest_spin, "1 <= fastest-spin <= 1e6");
    SteadyModes result;
    result.complete_to = options.longest_flight;
    result.phase_is_free = scene.beta == 0;
    if (options.attracting && (scene.is_disk() || scene.mu == 0)) return result;
    const bool on_families = scene.is_disk() || scene.mu == 0;
    if (!on_families) {
        find_points(scene, options, result);
    } else if (scene.restitution == 1) {
        result.set = SteadySet::families;
        find_families(scene, options, result);
    } else {
        result.set = scene.mu == 0 ? SteadySet::none_frictionless : SteadySet::none_lossy_disk;
    }
    return result;
}

}  // namespace swirl
