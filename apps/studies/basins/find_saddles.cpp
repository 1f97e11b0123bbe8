#include "apps/studies/basins/find_saddles.hpp"

#include "apps/studies/basins/basin_edge.hpp"
#include "apps/studies/parallel/pieces.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

namespace swirl::studies::grids {

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
