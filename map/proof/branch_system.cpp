#include "map/proof/branch_system.hpp"

#include <cmath>
#include <utility>

namespace swirl::proof {

BranchSystem branch_system(const CycleSystem& cycle, Parameter parameter) {
    const auto number = [](const Ball& x) { return RunningDual(Running(x)); };
    return {cycle, parameter, scene_as<RunningDual>(cycle.scene, number)};
}

SceneIn<RunningDual> scene_at(const BranchSystem& system, const Running& parameter) {
    SceneIn<RunningDual> scene = system.constants;
    set_parameter(scene, system.parameter, RunningDual::variable(parameter, parameter_index));
    set_inertia(scene);
    return scene;
}

BallStep<RunningDual> step_at(const BranchSystem& system, const SceneIn<RunningDual>& scene,
                              const std::vector<Running>& unknowns, std::size_t i, Margins* margins) {
    const BallPoint<Running> at = point_of(system.cycle, unknowns, i);
    const auto variable = [](const Running& x, std::size_t index) { return RunningDual::variable(x, index); };
    BallPoint<RunningDual> z{variable(at.psi, 0), variable(at.chi, 1), variable(at.vn, 2), variable(at.vt, 3),
                             variable(at.spin, 4)};
    return step_in_balls<RunningDual>(scene, system.cycle.itinerary[i], system.cycle.advances[i], z,
                                      variable(time_of(system.cycle, unknowns, i), time_index), margins);
}

namespace {

using Row = std::vector<std::pair<std::size_t, Running>>;

/// A row's entries for the unknowns of step i and the parameter.
void put(Row& row, const BranchSystem& system, std::size_t i, const RunningDual& f) {
    const CycleSystem& cycle = system.cycle;
    const std::size_t first = i * cycle.unknowns_of_step();
    for (std::size_t a = 0; a < cycle.active.size(); ++a) row.emplace_back(first + a, f.by[cycle.active[a]]);
    row.emplace_back(first + cycle.active.size(), f.by[time_index]);
    row.emplace_back(system.parameter_column(), f.by[parameter_index]);
}

}  // namespace

intervals::CurveLinearisation evaluate(const BranchSystem& system, const std::vector<Running>& unknowns) {
    const CycleSystem& cycle = system.cycle;
    const std::size_t width = cycle.unknowns_of_step(), k = cycle.period();
    intervals::CurveLinearisation result;
    const SceneIn<RunningDual> scene = scene_at(system, unknowns[system.parameter_column()]);
    const Running turn = Running(Ball(2) * intervals::pi_ball());
    for (std::size_t i = 0; i < k; ++i) {
        const BallStep<RunningDual> step = step_at(system, scene, unknowns, i, nullptr);
        const std::array<const RunningDual*, 5> image{&step.after.psi, &step.after.chi, &step.after.vn, &step.after.vt,
                                                      &step.after.spin};
        const std::size_t next = (i + 1) % k;
        for (std::size_t a = 0; a < cycle.active.size(); ++a) {
            const std::size_t index = cycle.active[a], column = next * width + a;
            Running value = image[index]->value - unknowns[column];
            if (index < 2) value -= Running(cycle.turns[i][index]) * turn;
            Row row;
            put(row, system, i, *image[index]);
            row.emplace_back(column, Running(-1));
            result.values.push_back(value);
            result.rows.push_back(std::move(row));
        }
        Row row;
        put(row, system, i, step.gap);
        result.values.push_back(step.gap.value);
        result.rows.push_back(std::move(row));
    }
    return result;
}

void follow_advances(BranchSystem& system, const std::vector<double>& point) {
    const std::vector<Running> unknowns(point.begin(), point.end());
    const SceneIn<RunningDual> scene = scene_at(system, unknowns[system.parameter_column()]);
    for (std::size_t i = 0; i < system.cycle.period(); ++i) {
        const BallStep<RunningDual> step = step_at(system, scene, unknowns, i, nullptr);
        const double advance = step.before.psi.value.mid - point_of(system.cycle, unknowns, i).psi.mid +
                               time_of(system.cycle, unknowns, i).mid;
        if (std::isfinite(advance)) system.cycle.advances[i] = advance;
    }
}

}  // namespace swirl::proof
