#include "apps/studies/basins/carried_cycle.hpp"

#include "analysis/cycles/cycle.hpp"
#include "analysis/cycles/multi_shooting.hpp"
#include "analysis/cycles/stability.hpp"
#include "map/derivative/parameter.hpp"

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

}  // namespace swirl::studies::grids
