#include "apps/studies/basins/basin_edge.hpp"

#include "analysis/classification/basin_boundary.hpp"
#include "analysis/cycles/cycle.hpp"
#include "analysis/cycles/multi_shooting.hpp"
#include "analysis/rotation/rotation_number.hpp"
#include "analysis/rotation/weighted_birkhoff.hpp"
#include "apps/studies/basins/basins.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

namespace swirl::studies::grids {

namespace {

using analysis::CyclePoints, analysis::StraddleEnd;

constexpr int longest_saddle = 32;        // impacts
constexpr double comes_again = 1e-3;      // an orbit that does may be near a cycle
constexpr double is_there = 1e-6;         // so near it has come to it
constexpr double same_torus_mean = 2e-4;  // of S, relative to 1 or |S|: over few turns of its slowest angle
constexpr std::size_t first_look = 2048;  // impacts after which a torus is looked for, and each time twice as many

bool agree(double x, double y) {
    return std::abs(x - y) < same_torus_mean * std::max(1.0, std::abs(x));
}

/// Means of S over an orbit, by weighted averages.
struct MeanSpins {
    double per_impact, per_time;
    double half_difference;  ///< of the first: |first half − second half|
};

/// From one of its impacts on.
MeanSpins mean_spins(std::span<const double> spins, std::span<const double> times, std::span<const double> turned,
                     std::size_t from) {
    const auto per_impact = analysis::weighted_birkhoff_average(spins.subspan(from));
    const double time = analysis::weighted_birkhoff_average(times.subspan(from)).average;
    return {per_impact.average, analysis::weighted_birkhoff_average(turned.subspan(from)).average / time,
            per_impact.half_difference};
}

bool agree(const MeanSpins& a, const MeanSpins& b) {
    return agree(a.per_impact, b.per_impact) && agree(a.per_time, b.per_time);
}

}  // namespace

template <int D>
BasinEdge<D>::BasinEdge(const Scene<double>& scene, const analysis::ClassifyOptions& settings, Accuracy accuracy,
                        const RunResult& attractor, const analysis::Stop& stop)
    : scene_(scene),
      settings_(settings),
      accuracy_(accuracy),
      attractor_(attractor),
      stop_(stop),
      map_(scene, contact_horizon, accuracy),
      shooting_(shooting_map_of(scene, accuracy)) {}

template <int D>
std::optional<bool> BasinEdge<D>::is_inside(const Start<double>& start) const {
    try {
        const NamedMode named = name_mode(scene_, start, settings_, accuracy_, stop_);
        const RunResult run = result_of(named);
        if (!named.finished || !has_attractor(run)) return {};
        return is_same_attractor(run, attractor_);
    } catch (const std::invalid_argument&) {
        return {};  // rounding has put another vertex outside, say
    }
}

template <int D>
analysis::StraddleEnd BasinEdge<D>::follow(const LabStart<double>& in, const LabStart<double>& out,
                                           Saddle& saddle) const {
    const OrbitBegin first = begin_orbit(map_, in), second = begin_orbit(map_, out);
    if (first.outcome != Outcome::completed || second.outcome != Outcome::completed) return StraddleEnd::ended;
    const analysis::StraddleOptions options;
    const double apart = analysis::distance(map_, map_.coordinates(first.state), map_.coordinates(second.state));
    if (apart > options.jump) return StraddleEnd::border;  // a vertex grazes on the flight of the start
    std::size_t look = first_look;
    const auto is_enough = [&](const Points& orbit) {
        if (is_at_cycle(orbit, saddle)) return true;
        if (orbit.size() < look) return false;
        look *= 2;
        return is_torus(orbit, saddle);
    };
    return analysis::follow_basin_boundary(
        map_, first.state, second.state, [&](const PostImpactState<double>& z) { return is_inside(section_point(z)); },
        is_enough, options, stop_);
}

/// Has the orbit come to an unstable cycle?
template <int D>
bool BasinEdge<D>::is_at_cycle(const Points& orbit, Saddle& saddle) const {
    const auto n = static_cast<std::ptrdiff_t>(orbit.size());
    for (std::ptrdiff_t k = 1; k <= std::min<std::ptrdiff_t>(longest_saddle, n - 1); ++k) {
        if (analysis::distance(map_, orbit.back(), *(orbit.end() - 1 - k)) > comes_again) continue;
        const CyclePoints guess(orbit.end() - k, orbit.end());
        const auto shot = analysis::solve_shooting(shooting_, guess, 0, 1e-10);
        if (!shot.converged || analysis::distance_between(shooting_, shot.points, guess) > is_there) return false;
        return take_cycle(analysis::minimal_cycle(shooting_, shot.points, 1e-8), saddle);
    }
    return false;
}

/// False of one that attracts, or is neutral: no edge leads there.
template <int D>
bool BasinEdge<D>::take_cycle(const CyclePoints& cycle, Saddle& saddle) const {
    const auto shooting = analysis::shooting_residual(shooting_, cycle, 0);
    const auto multipliers = analysis::sorted_multipliers(analysis::monodromy(shooting));
    if (analysis::index_of(multipliers) == 0) return false;
    saddle.kind = cycle.size() == 1 ? analysis::Kind::fixed_point : analysis::Kind::cycle;
    saddle.points = cycle;
    saddle.period = static_cast<std::int64_t>(cycle.size());
    saddle.mean_spin = shooting.integral / shooting.duration;
    for (const auto& z : cycle) saddle.mean_spin_per_impact += z.tail(1)[0] / static_cast<double>(cycle.size());
    saddle.multiplier = std::abs(multipliers.front());
    saddle.index = analysis::index_of(multipliers);
    return true;
}

/// Does the orbit's second half go round a torus? Its means by weighted averages: those of both halves have to agree,
/// and those of its last part, or it is still on its way there. (A weighted average hardly sees the ends of what it is
/// made over: an orbit that has left one torus for another would be taken for the first.)
template <int D>
bool BasinEdge<D>::is_torus(const Points& orbit, Saddle& saddle) const {
    std::vector<double> spins, times, turned;
    for (auto point = orbit.end() - static_cast<std::ptrdiff_t>(orbit.size() / 2); point != orbit.end(); ++point) {
        const auto step = map_.advance(map_.state_at(*point));
        spins.push_back((*point)[SceneMap<D>::integrated]);
        times.push_back(step.duration);
        turned.push_back(step.integral);
    }
    const analysis::RotationNumber rotation = analysis::rotation_of_observable(spins);
    if (rotation.outcome != analysis::RotationOutcome::quasi_periodic) return false;
    const MeanSpins means = mean_spins(spins, times, turned, 0);
    if (!(means.half_difference < same_torus_mean * std::max(1.0, std::abs(means.per_impact)))) return false;
    if (!agree(means, mean_spins(spins, times, turned, spins.size() / 2))) return false;
    saddle.kind = analysis::Kind::quasi_periodic;
    saddle.points = {orbit.back()};
    saddle.rotation = rotation.rotation;
    saddle.mean_spin_per_impact = means.per_impact;
    saddle.mean_spin = means.per_time;
    return true;
}

template class BasinEdge<disk_dimension>;
template class BasinEdge<polygon_dimension>;

bool is_same_saddle(const analysis::ShootingMap& map, const Saddle& a, const Saddle& b) {
    if (a.kind != b.kind) return false;
    if (a.kind == analysis::Kind::quasi_periodic)
        return agree(a.mean_spin, b.mean_spin) && agree(a.mean_spin_per_impact, b.mean_spin_per_impact);
    return analysis::distance_between(map, a.points, b.points) < analysis::same_cycle;
}

}  // namespace swirl::studies::grids
