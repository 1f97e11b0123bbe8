#include "apps/studies/bifurcation_curves/against.hpp"

#include "analysis/cycles/cycle.hpp"
#include "apps/studies/modes/attractors.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace swirl::studies::bifurcation_curves {

namespace {

struct AttractingCycle {
    analysis::CyclePoints points;
    double mean_spin = 0;
};

/// The attracting cycles of every cell, carried from cell to cell.
class CellCycles {
public:
    CellCycles(const Scene<double>& scene, const Plane& plane, const MappedPlane& map)
        : scene_(scene), plane_(plane), map_(map), cycles_(map.cells()) {}

    void spread_from(const std::vector<Curve>& curves, const std::function<bool()>& is_stopped) {
        for (const auto& curve : curves)
            for (std::size_t i = 0; i < curve.points.size(); ++i) {
                if (is_edge_of_stability(curve.points[i])) push_at(curve.points[i].parameters, curve.points[i].points);
                if (i > 0) push_between(curve.points[i - 1], curve.points[i]);
            }
        while (!waiting_.empty() && !is_stopped()) {
            const auto [cell, guess] = std::move(waiting_.front());
            waiting_.pop_front();
            look(cell, guess);
        }
    }

    const std::vector<AttractingCycle>& of(std::size_t cell) const { return cycles_[cell]; }

private:
    /// No multiplier lies outside the circle: the cycle attracts on one side.
    static bool is_edge_of_stability(const CurveCycle& point) {
        return !point.multipliers.empty() && std::abs(point.multipliers.front()) < 1 + analysis::neutral_margin;
    }

    std::size_t nearest_cell(const Eigen::Vector2d& p) const {
        std::size_t place[2];
        for (int axis = 0; axis < 2; ++axis) {
            const auto& values = map_.values[static_cast<std::size_t>(axis)];
            const auto nearer = [&](double a, double b) { return std::abs(a - p[axis]) < std::abs(b - p[axis]); };
            place[axis] =
                static_cast<std::size_t>(std::min_element(values.begin(), values.end(), nearer) - values.begin());
        }
        return place[0] * map_.values[1].size() + place[1];
    }

    void push_at(const Eigen::Vector2d& p, const analysis::CyclePoints& guess) { push(nearest_cell(p), guess, true); }

    /// In every cell that a curve crosses from one of its points to the next: a region may be narrower than they are
    /// apart.
    void push_between(const CurveCycle& first, const CurveCycle& second) {
        if (!is_edge_of_stability(first) && !is_edge_of_stability(second)) return;
        if (first.points.size() != second.points.size()) return;
        double cells = 0;
        for (int axis = 0; axis < 2; ++axis)
            cells = std::max(cells, std::abs(second.parameters[axis] - first.parameters[axis]) / spacing(axis));
        const int parts = static_cast<int>(std::min(std::ceil(2 * cells), 10'000.0));
        if (parts < 2) return;
        const analysis::ShootingMap map = shooting_map_of(scene_at(scene_, plane_, first.parameters));
        for (int i = 1; i < parts; ++i) {
            const double t = static_cast<double>(i) / parts;
            analysis::CyclePoints guess = first.points;
            for (std::size_t k = 0; k < guess.size(); ++k)
                guess[k] += t * map.difference(second.points[k], first.points[k]);
            push_at(first.parameters + t * (second.parameters - first.parameters), guess);
        }
    }

    /// Of the cells, of a list or logarithms that of the nearest two; infinite where there is one.
    double spacing(int axis) const {
        const auto& values = map_.values[static_cast<std::size_t>(axis)];
        if (values.size() < 2) return std::numeric_limits<double>::infinity();
        const double mean = std::abs(values.back() - values.front()) / static_cast<double>(values.size() - 1);
        double least = mean;
        for (std::size_t i = 1; i < values.size(); ++i) least = std::min(least, std::abs(values[i] - values[i - 1]));
        constexpr double of_rounding = 1e-6;
        return least < (1 - of_rounding) * mean ? least : mean;
    }

    /// The cell and those beside it.
    void push(std::size_t cell, const analysis::CyclePoints& guess, bool itself) {
        const std::size_t width = map_.values[1].size(), row = cell / width, column = cell % width;
        if (itself) waiting_.emplace_back(cell, guess);
        if (row > 0) waiting_.emplace_back(cell - width, guess);
        if (row + 1 < map_.values[0].size()) waiting_.emplace_back(cell + width, guess);
        if (column > 0) waiting_.emplace_back(cell - 1, guess);
        if (column + 1 < width) waiting_.emplace_back(cell + 1, guess);
    }

    void look(std::size_t cell, const analysis::CyclePoints& guess) {
        const analysis::ShootingMap map = shooting_map_of(scene_at(scene_, plane_, map_.place(cell)));
        for (const auto& known : cycles_[cell])  // what is all but there already
            if (analysis::distance_between(map, known.points, guess) < analysis::same_cycle) return;
        analysis::CyclePoints points = guess;
        analysis::polish_cycle(map, points, 0);
        const auto shooting = analysis::shooting_residual(map, points, 0);
        if (!analysis::closes_to(shooting, 1e-11)) return;
        for (const auto& known : cycles_[cell])
            if (analysis::distance_between(map, known.points, points) < analysis::same_cycle) return;
        if (analysis::minimal_cycle(map, points, analysis::same_cycle).size() < points.size()) return;
        const auto multipliers = analysis::sorted_multipliers(analysis::monodromy(shooting));
        if (multipliers.empty() || analysis::stability_of(multipliers) != analysis::Stability::stable) return;
        cycles_[cell].push_back({points, shooting.integral / shooting.duration});
        push(cell, points, false);
    }

    const Scene<double>& scene_;
    const Plane& plane_;
    const MappedPlane& map_;
    std::vector<std::vector<AttractingCycle>> cycles_;
    std::deque<std::pair<std::size_t, analysis::CyclePoints>> waiting_;
};

bool agrees(const MappedPlane::Run& run, const AttractingCycle& cycle) {
    return run.periodic && run.period == static_cast<std::int64_t>(cycle.points.size()) &&
           means_agree(run.mean_spin, cycle.mean_spin);
}

/// Within the plane, or on its edge but for rounding.
bool is_within(const Plane& plane, const Eigen::Vector2d& p) {
    const Eigen::Array2d room = 1e-9 * (plane.high() - plane.low()).array();
    return (p.array() >= plane.low().array() - room).all() && (p.array() <= plane.high().array() + room).all();
}

void compare_cell(const MappedPlane& map, std::size_t cell, const std::vector<AttractingCycle>& cycles,
                  std::int64_t longest, Agreement& agreement) {
    const auto begin = map.all.begin() + static_cast<std::ptrdiff_t>(cell * map.runs);
    const std::vector<MappedPlane::Run> runs(begin, begin + static_cast<std::ptrdiff_t>(map.runs));
    const bool waits = std::any_of(runs.begin(), runs.end(), [](const auto& run) { return run.undecided; });
    bool unseen = false, missing = false;
    for (const auto& cycle : cycles) {
        if (std::any_of(runs.begin(), runs.end(), [&](const auto& run) { return agrees(run, cycle); })) continue;
        unseen = true;
        agreement.list.push_back({map.place(cell), static_cast<std::int64_t>(cycle.points.size()), cycle.mean_spin, 0,
                                  waits ? "transient" : "too-few-starts"});
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto& run = runs[i];
        if (!run.periodic || run.period > longest) continue;
        if (std::any_of(cycles.begin(), cycles.end(), [&](const auto& cycle) { return agrees(run, cycle); })) continue;
        missing = true;
        agreement.list.push_back({map.place(cell), run.period, run.mean_spin, i, "curve-missing"});
    }
    agreement.with_cycle += !cycles.empty();
    agreement.unseen_cells += unseen;
    agreement.family_cells += std::any_of(runs.begin(), runs.end(), [](const auto& run) { return run.in_family; });
    agreement.missing_cells += missing;
}

}  // namespace

Agreement compare(const Scene<double>& scene, const Plane& plane, const std::vector<Curve>& curves,
                  const MappedPlane& map, std::int64_t longest, const analysis::Stop& stop) {
    const auto is_stopped = [&stop] { return stop && stop(); };
    CellCycles cycles(scene, plane, map);
    cycles.spread_from(curves, is_stopped);
    Agreement agreement;
    for (std::size_t cell = 0; cell < map.cells() && !is_stopped(); ++cell) {
        if (!is_within(plane, map.place(cell))) {
            ++agreement.outside_cells;
            continue;
        }
        ++agreement.cells;
        compare_cell(map, cell, cycles.of(cell), longest, agreement);
    }
    return agreement;
}

std::vector<MapRun> missing_runs(const Agreement& agreement) {
    std::vector<MapRun> runs;
    const Disagreement* last = nullptr;
    for (const auto& entry : agreement.list) {
        if (entry.why != "curve-missing") continue;
        const bool again = last != nullptr && last->parameters == entry.parameters && last->period == entry.period &&
                           means_agree(last->mean_spin, entry.mean_spin);
        if (!again) runs.push_back({entry.parameters, entry.run});
        last = &entry;
    }
    return runs;
}

}  // namespace swirl::studies::bifurcation_curves
