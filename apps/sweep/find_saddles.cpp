#include "apps/command_line/interruption.hpp"
#include "apps/command_line/parallel_pieces.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/sweep/basin_edge.hpp"
#include "apps/sweep/starts.hpp"
#include "apps/sweep/sweep_command.hpp"
#include "apps/system/shooting_map.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

namespace swirl::apps::sweep {

namespace {

/// Neighbours of the grid that came to different attractors.
struct Neighbours {
    std::size_t first = 0, second = 0;  ///< cells
    std::int64_t from = 0, to = 0;      ///< their basins
    RunResult attractor;                ///< of the first
};

std::vector<Neighbours> on_boundaries(const Sweep& sweep) {
    const std::vector<std::int64_t>& basin = sweep.basins->of_cell;
    std::vector<Neighbours> pairs;
    for (std::size_t cell = 0; cell < basin.size(); ++cell) {
        std::size_t stride = basin.size();
        for (const GridAxis& axis : sweep.grid) {
            stride /= axis.points.size();
            if (cell / stride % axis.points.size() + 1 == axis.points.size()) continue;
            const std::size_t next = cell + stride;
            const bool known = basin[cell] != no_basin && basin[next] != no_basin;
            if (known && basin[cell] != basin[next] && sweep.is_visited(cell) && sweep.is_visited(next))
                pairs.push_back({cell, next, basin[cell], basin[next], sweep.cell(cell).front()});
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
Led led_from(const SweepOptions& options, const std::vector<GridAxis>& grid, const Neighbours& between) {
    constexpr int halvings = 40;  // of a step of the grid: to 10⁻¹², far above rounding
    const Scene<double> scene = cell_scene(options.scene, grid, between.first);
    const BasinEdge<D> edge(scene, options.settings, options.output.accuracy(), between.attractor);
    std::vector<double> in = cell_point(grid, between.first), out = cell_point(grid, between.second);
    const auto start_at = [&](const std::vector<double>& point) {
        return placed_start(options.start, scene, grid, point);
    };
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

bool find_saddles(const SweepOptions& options, Sweep& sweep) {
    if (options.saddles == 0 || !sweep.basins) return true;
    const auto pairs = spread(on_boundaries(sweep), static_cast<std::size_t>(options.saddles));
    const Scene<double> scene = cell_scene(options.scene, sweep.grid, 0);
    const auto led = std::make_shared<std::vector<Led>>(pairs.size());
    Progress progress("sweep: saddles", static_cast<double>(pairs.size()), options.output.quiet);
    const auto look = [&options, grid = sweep.grid, pairs, led, disk = scene.is_disk()](std::size_t i) -> KeepResult {
        const auto found = std::make_shared<Led>(disk ? led_from<disk_dimension>(options, grid, pairs[i])
                                                      : led_from<polygon_dimension>(options, grid, pairs[i]));
        if (is_interrupted()) return {};
        return [led, i, found] { (*led)[i] = std::move(*found); };
    };
    if (!run_pieces(pairs.size(), options.output.threads, progress, look)) return false;
    sweep.boundaries = put_together(shooting_map_of(scene, options.output.accuracy()), *led);
    return true;
}

}  // namespace swirl::apps::sweep
