// The equations of a cycle with one of the scene's numbers as an unknown, along a curve of solutions.
#pragma once

#include "map/intervals/dual.hpp"
#include "map/intervals/solution_curve.hpp"
#include "map/proof/scene_numbers.hpp"
#include "map/proof/shooting_in_balls.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace swirl::proof {

using intervals::Running;

/// By ψ, χ, v_n, v_t, S, the flight's time, and the parameter.
inline constexpr std::size_t parameter_index = 6;
using RunningDual = intervals::Dual<7, Running>;

/// The unknowns of the cycle, then the parameter.
struct BranchSystem {
    CycleSystem cycle;  ///< word, turns, unknowns; the wall's advance is that of a point nearby
    Parameter parameter = Parameter::alpha;
    SceneIn<RunningDual> constants;  ///< the scene, whose parameter is not read

    std::size_t parameter_column() const { return cycle.unknowns(); }
};
BranchSystem branch_system(const CycleSystem& cycle, Parameter parameter);

/// The scene with that value of the parameter.
SceneIn<RunningDual> scene_at(const BranchSystem& system, const Running& parameter);

/// Step i with derivatives by all seven.
BallStep<RunningDual> step_at(const BranchSystem& system, const SceneIn<RunningDual>& scene,
                              const std::vector<Running>& unknowns, std::size_t i, Margins* margins);

/// The state of step i.
template <class S>
BallPoint<S> point_of(const CycleSystem& cycle, const std::vector<S>& unknowns, std::size_t i) {
    BallPoint<S> z;
    const std::array<S*, 5> places{&z.psi, &z.chi, &z.vn, &z.vt, &z.spin};
    for (std::size_t a = 0; a < cycle.active.size(); ++a)
        *places[cycle.active[a]] = unknowns[i * cycle.unknowns_of_step() + a];
    return z;
}
template <class S>
const S& time_of(const CycleSystem& cycle, const std::vector<S>& unknowns, std::size_t i) {
    return unknowns[(i + 1) * cycle.unknowns_of_step() - 1];
}

intervals::CurveLinearisation evaluate(const BranchSystem& system, const std::vector<Running>& unknowns);

/// The wall's advances at a point of the curve: on a long branch they change by more than half a turn.
void follow_advances(BranchSystem& system, const std::vector<double>& point);

}  // namespace swirl::proof
