#include "apps/studies/basins/saddles.hpp"

#include "analysis/classification/basin_boundary.hpp"
#include "analysis/cycles/cycle.hpp"
#include "analysis/cycles/multi_shooting.hpp"
#include "analysis/enum_name.hpp"
#include "analysis/rotation/rotation_number.hpp"
#include "analysis/rotation/weighted_birkhoff.hpp"
#include "apps/studies/basins/basins.hpp"
#include "apps/studies/parallel/pieces.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"
#include "map/model/parameter.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

namespace swirl::studies::grids {

using analysis::CyclePoints;

namespace {

constexpr double closes = 1e-10;      // a cycle's residual, as in a diagram's branches
constexpr double is_multiple = 1e-8;  // a cycle run through more than once, by how it closes
constexpr int most_halvings = 4;

Scene<double> scene_between(const Scene<double>& a, const Scene<double>& b, double part) {
    Scene<double> scene = a, other = b;
    for (const Parameter parameter : all_parameters) {
        double& value = number_of(scene, parameter);
        value += part * (number_of(other, parameter) - value);
    }
    return scene;
}

/// A cycle's points in another scene; none if Newton's method does not lead there.
CyclePoints solved_in(const Scene<double>& scene, Accuracy accuracy, const CyclePoints& from) {
    const analysis::ShootingMap map = shooting_map_of(scene, accuracy);
    const auto shot = analysis::solve_shooting(map, from, 0, closes);
    if (!shot.converged) return {};
    return analysis::minimal_cycle(map, shot.points, is_multiple).size() == from.size() ? shot.points : CyclePoints{};
}

bool is_stopped(const analysis::Stop& stop) {
    return stop && stop();
}

CyclePoints in_steps(const Scene<double>& from, const Scene<double>& to, Accuracy accuracy, int steps,
                     CyclePoints points, const analysis::Stop& stop) {
    for (int i = 1; i <= steps && !points.empty() && !is_stopped(stop); ++i)
        points = solved_in(i == steps ? to : scene_between(from, to, static_cast<double>(i) / steps), accuracy, points);
    return points;
}

}  // namespace

CarriedCycle carried(const Scene<double>& from, const Scene<double>& to, Accuracy accuracy, const CyclePoints& points,
                     const analysis::Stop& stop) {
    const analysis::ShootingMap home = shooting_map_of(from, accuracy);
    for (int steps = 2; steps <= 1 << most_halvings && !is_stopped(stop); steps *= 2) {
        CarriedCycle there{in_steps(from, to, accuracy, steps, points, stop)};
        if (there.points.empty()) continue;
        const CyclePoints back = in_steps(to, from, accuracy, steps, there.points, stop);
        if (back.empty() || !(analysis::distance_between(home, back, points) < analysis::same_cycle)) continue;
        const auto shooting = analysis::shooting_residual(shooting_map_of(to, accuracy), there.points, 0);
        if (!shooting.alive) continue;
        there.mean_spin = shooting.integral / shooting.duration;
        for (const auto& z : there.points) there.mean_spin_per_impact += z.tail(1)[0];
        there.mean_spin_per_impact /= static_cast<double>(there.points.size());
        const auto multipliers = analysis::sorted_multipliers(analysis::monodromy(shooting));
        there.stable = !multipliers.empty() && analysis::stability_of(multipliers) == analysis::Stability::stable;
        return there;
    }
    return {};
}

std::string_view name_of(analysis::StraddleEnd end) {
    using enum analysis::StraddleEnd;
    return analysis::name_in<analysis::StraddleEnd>({{found, "saddle"},
                                                     {border, "border"},
                                                     {rounding, "rounding"},
                                                     {undecided, "undecided"},
                                                     {ended, "ended"},
                                                     {not_found, "not-found"}},
                                                    end);
}

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

namespace {

/// Neighbours of the grid that came to different attractors.
struct Neighbours {
    std::size_t first = 0, second = 0;  ///< cells
    std::int64_t from = 0, to = 0;      ///< their basins
    RunResult attractor;                ///< of the first
};

std::vector<Neighbours> on_boundaries(const GridStudy& study, std::span<const RunResult> results,
                                      std::span<const char> visited, const std::vector<std::int64_t>& basin) {
    const auto is_visited = [&](std::size_t cell) { return visited.empty() || visited[cell] != 0; };
    std::vector<Neighbours> pairs;
    for (std::size_t cell = 0; cell < basin.size(); ++cell) {
        std::size_t stride = basin.size();
        for (const GridAxis& axis : study.grid) {
            stride /= axis.points.size();
            if (cell / stride % axis.points.size() + 1 == axis.points.size()) continue;
            const std::size_t next = cell + stride;
            const bool known = basin[cell] != no_basin && basin[next] != no_basin;
            if (known && basin[cell] != basin[next] && is_visited(cell) && is_visited(next))
                pairs.push_back({cell, next, basin[cell], basin[next], results[cell]});
        }
    }
    return pairs;
}

/// `count` of them, evenly spread.
std::vector<Neighbours> spread(const std::vector<Neighbours>& pairs, std::size_t count) {
    if (pairs.size() <= count) return pairs;
    std::vector<Neighbours> some;
    for (std::size_t i = 0; i < count; ++i) some.push_back(pairs[(2 * i + 1) * pairs.size() / (2 * count)]);
    return some;
}

/// A place and what it leads to, before the saddles of all are put together.
struct Led {
    BoundaryPlace place;
    Saddle saddle;
};

template <int D>
Led led_from(const GridStudy& study, const Neighbours& between, const analysis::Stop& stop) {
    constexpr int halvings = 40;  // of a step of the grid: to 10⁻¹², far above rounding
    const Scene<double> scene = cell_scene(study, between.first);
    const BasinEdge<D> edge(scene, study.settings, study.accuracy, between.attractor, stop);
    std::vector<double> in = cell_point(study.grid, between.first), out = cell_point(study.grid, between.second);
    const auto start_at = [&](const std::vector<double>& point) { return placed_start(study, scene, point); };
    for (int i = 0; i < halvings; ++i) {
        std::vector<double> middle = in;
        for (std::size_t k = 0; k < in.size(); ++k) middle[k] += (out[k] - in[k]) / 2;
        if (middle == in || middle == out) break;
        const auto inside = edge.is_inside(start_at(middle));
        if (!inside) return {{middle, between.from, between.to, no_saddle, analysis::StraddleEnd::undecided}, {}};
        (*inside ? in : out) = middle;
    }
    Led led{{in, between.from, between.to}, {}};
    led.place.leads_to = edge.follow(start_at(in), start_at(out), led.saddle);
    return led;
}

/// The saddles of all places, each once, those of most places first.
Boundaries put_together(const analysis::ShootingMap& map, const std::vector<Led>& led) {
    std::vector<Saddle> saddles;
    std::vector<std::size_t> of_place(led.size());
    for (std::size_t i = 0; i < led.size(); ++i) {
        if (led[i].place.leads_to != analysis::StraddleEnd::found) continue;
        auto known = std::find_if(saddles.begin(), saddles.end(),
                                  [&](const Saddle& saddle) { return is_same_saddle(map, saddle, led[i].saddle); });
        if (known == saddles.end()) known = saddles.insert(known, led[i].saddle);
        ++known->places;
        of_place[i] = static_cast<std::size_t>(known - saddles.begin());
    }
    std::vector<std::size_t> order(saddles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return saddles[a].places > saddles[b].places; });
    Boundaries all;
    const auto places = static_cast<double>(led.size());
    for (const std::size_t s : order) {
        all.saddles.push_back(saddles[s]);
        all.saddles.back().share = static_cast<double>(saddles[s].places) / places;
        all.saddles.back().interval = wilson_interval(all.saddles.back().share, places);
    }
    for (std::size_t i = 0; i < led.size(); ++i) {
        all.places.push_back(led[i].place);
        if (led[i].place.leads_to == analysis::StraddleEnd::found)
            all.places.back().saddle = std::find(order.begin(), order.end(), of_place[i]) - order.begin();
    }
    return all;
}

}  // namespace

std::optional<Boundaries> find_saddles(const GridStudy& study, std::span<const RunResult> results,
                                       std::span<const char> visited, const Basins& basins, std::size_t places,
                                       const RunControl& control) {
    const auto pairs = spread(on_boundaries(study, results, visited, basins.of_cell), places);
    const Scene<double> scene = cell_scene(study, 0);
    const auto led = std::make_shared<std::vector<Led>>(pairs.size());
    const auto look = [study, pairs, led, control, disk = scene.is_disk()](std::size_t i) -> KeepResult {
        const auto found = std::make_shared<Led>(disk ? led_from<disk_dimension>(study, pairs[i], control.stop)
                                                      : led_from<polygon_dimension>(study, pairs[i], control.stop));
        if (control.is_stopped()) return {};
        return [led, i, found] { (*led)[i] = std::move(*found); };
    };
    if (!run_pieces(pairs.size(), "sweep: saddles", control, look)) return std::nullopt;
    return put_together(shooting_map_of(scene, study.accuracy), *led);
}

}  // namespace swirl::studies::grids
