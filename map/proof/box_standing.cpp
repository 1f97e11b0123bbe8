#include "map/proof/box_standing.hpp"

#include "map/intervals/unit_circle.hpp"
#include "map/proof/cell_flight.hpp"
#include "map/proof/clear_flight.hpp"
#include "map/proof/words.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::proof {

namespace {

using intervals::CurvePiece;
using RunningUnknowns = std::vector<Running>;
using Steps = std::vector<BallStep<RunningDual>>;
using intervals::RunningMatrix;

BoxStanding doubtful(BranchEndKind kind, bool refuted, std::string reason) {
    return {refuted ? Verdict::refuted : Verdict::undecided, kind, std::move(reason), false, 0, 0};
}

/// All steps; empty `reason` if all are in their contact modes.
BoxStanding take_steps(const BranchSystem& system, const RunningUnknowns& unknowns, Steps& steps) {
    const auto scene = scene_at(system, unknowns[system.parameter_column()]);
    for (std::size_t i = 0; i < system.cycle.period(); ++i) {
        Margins margins;
        steps.push_back(step_at(system, scene, unknowns, i, &margins));
        for (const Margin& margin : margins) {
            if (intervals::is_positive(margin.value)) continue;
            return doubtful(BranchEndKind::contact_mode, intervals::is_negative(margin.value),
                            words("impact %zu, %s: %s", i + 1,
                                  std::string(name_of(system.cycle.itinerary[i].mode)).c_str(), margin.name.c_str()));
        }
    }
    return {Verdict::proven, BranchEndKind::range, {}, false, 0, 0};
}

/// By the running unknown alone; the second variable has no weight, the third is a share of time.
Timed timed_of(const Running& x) {
    const auto straight = x.sloped();
    Timed result(straight.mid);
    result.by[0] = straight.by[0];
    result.rest = straight.rest;
    return result;
}

/// Which vertex is outside, if one is for all of a box that is a point.
std::string outside_in_words(const BranchSystem& system, const RunningUnknowns& unknowns, std::size_t i, int arriving) {
    BallScene scene = system.cycle.scene;
    set_parameter(scene, system.parameter, values_of(unknowns[system.parameter_column()]));
    set_inertia(scene);
    std::vector<Ball> balls;
    for (const Running& x : unknowns) balls.push_back(values_of(x));
    return clear_flight(scene, point_of(system.cycle, balls, i), time_of(system.cycle, balls, i), arriving).reason;
}

BoxStanding look_at_flights(const BranchSystem& system, const RunningUnknowns& unknowns, bool is_point) {
    auto scene = scene_as<Timed>(system.cycle.scene, [](const Ball& x) { return Timed(x); });
    set_parameter(scene, system.parameter, timed_of(unknowns[system.parameter_column()]));
    set_inertia(scene);
    std::vector<Timed> at;
    for (const Running& x : unknowns) at.push_back(timed_of(x));
    const int sides = std::max(1, scene.sides);
    for (std::size_t i = 0; i < system.cycle.period(); ++i) {
        const int arriving = ((system.cycle.itinerary[i].vertex_step % sides) + sides) % sides;
        const Verdict verdict = clear_over_cell(scene, point_of(system.cycle, at, i), time_of(system.cycle, at, i),
                                                arriving, {0x1p-14, 3000});
        if (verdict == Verdict::proven) continue;
        const std::string seen = is_point ? outside_in_words(system, unknowns, i, arriving) : std::string();
        return doubtful(BranchEndKind::clearance, verdict == Verdict::refuted,
                        words("flight %zu: %s", i + 1,
                              seen.empty() ? "another vertex, or the same, is not proven inside" : seen.c_str()));
    }
    return {Verdict::proven, BranchEndKind::range, {}, false, 0, 0};
}

/// Points 1 and i + 1 differ, angles modulo 2π.
bool differ(const CycleSystem& cycle, const RunningUnknowns& unknowns, std::size_t i) {
    for (std::size_t a = 0; a < cycle.active.size(); ++a) {
        Running apart = unknowns[a] - unknowns[i * cycle.unknowns_of_step() + a];
        if (cycle.active[a] < 2) apart = sine_cosine(Running(0.5) * apart).sine;
        if (!contains_zero(apart)) return true;
    }
    return false;
}

BoxStanding look_at_period(const CycleSystem& cycle, const RunningUnknowns& unknowns) {
    for (std::size_t i = 1; i < cycle.period(); ++i)
        if (!differ(cycle, unknowns, i))
            return doubtful(BranchEndKind::period, false, words("points 1 and %zu may be one", i + 1));
    return {Verdict::proven, BranchEndKind::range, {}, false, 0, 0};
}

const RunningDual& coordinate(const BallPoint<RunningDual>& z, std::size_t index) {
    return *std::array<const RunningDual*, 5>{&z.psi, &z.chi, &z.vn, &z.vt, &z.spin}[index];
}

/// DF of a step by its active coordinates.
RunningMatrix derivative_of(const CycleSystem& cycle, const BallStep<RunningDual>& step) {
    RunningMatrix derivative;
    for (const std::size_t to : cycle.active) {
        derivative.emplace_back();
        const RunningDual& image = coordinate(step.after, to);
        const Running rate = image.by[time_index] / step.gap.by[time_index];
        for (const std::size_t from : cycle.active)
            derivative.back().push_back(image.by[from] - rate * step.gap.by[from]);
    }
    return derivative;
}

/// Of a fixed point the equations themselves, as in branch_standing.cpp; of others DF − λ.
std::optional<int> multipliers_inside(const CycleSystem& cycle, const Steps& steps) {
    const std::size_t m = cycle.active.size();
    const bool whole = cycle.period() == 1;
    RunningMatrix a, b(whole ? m + 1 : m, std::vector<Running>(whole ? m + 1 : m));
    for (std::size_t i = 0; i < m; ++i) b[i][i] = Running(-1);
    if (whole) {
        for (std::size_t row = 0; row <= m; ++row) {
            const RunningDual& f = row < m ? coordinate(steps[0].after, cycle.active[row]) : steps[0].gap;
            a.emplace_back();
            for (const std::size_t from : cycle.active) a.back().push_back(f.by[from]);
            a.back().push_back(f.by[time_index]);
        }
    } else {
        a = derivative_of(cycle, steps[0]);
        for (std::size_t i = 1; i < steps.size(); ++i) a = intervals::product(derivative_of(cycle, steps[i]), a);
    }
    return zeros_inside(with_second_variable(a), with_second_variable(b));
}

}  // namespace

BoxStanding standing_of(const BranchSystem& system, const CurvePiece& piece) {
    const RunningUnknowns unknowns = intervals::tube(piece, piece.near);
    Steps steps;
    BoxStanding standing = take_steps(system, unknowns, steps);
    if (standing.verdict != Verdict::proven) return standing;
    standing = look_at_flights(system, unknowns, piece.low == piece.high);
    if (standing.verdict != Verdict::proven) return standing;
    standing = look_at_period(system.cycle, unknowns);
    if (standing.verdict != Verdict::proven) return standing;
    if (const auto inside = multipliers_inside(system.cycle, steps)) {
        standing.decided = true;
        standing.inside = *inside;
        standing.outside = static_cast<int>(system.cycle.active.size()) - *inside;
    }
    return standing;
}

}  // namespace swirl::proof
