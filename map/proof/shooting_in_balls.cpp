#include "map/proof/shooting_in_balls.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace swirl::proof {

namespace {

template <class T>
T& coordinate(BallPoint<T>& z, std::size_t index) {
    return *std::array<T*, 5>{&z.psi, &z.chi, &z.vn, &z.vt, &z.spin}[index];
}

}  // namespace

BallPoint<Ball> CycleSystem::point(const BallVector& unknowns, std::size_t i) const {
    BallPoint<Ball> z;
    z.spin = Ball(fixed_spin);
    for (std::size_t a = 0; a < active.size(); ++a) coordinate(z, active[a]) = unknowns[i * unknowns_of_step() + a];
    return z;
}

BallStep<Ball> CycleSystem::step(const BallVector& unknowns, std::size_t i, Margins* margins) const {
    return step_in_balls<Ball>(scene, itinerary[i], advances[i], point(unknowns, i), time(unknowns, i), margins);
}

BallStep<StepDual> CycleSystem::differentiated_step(const BallVector& unknowns, std::size_t i) const {
    BallPoint<Ball> at = point(unknowns, i);
    BallPoint<StepDual> z;
    for (std::size_t index = 0; index < 5; ++index) coordinate(z, index).value = coordinate(at, index);
    for (const std::size_t index : active) coordinate(z, index).by[index] = Ball(1);
    return step_in_balls<StepDual>(scene, itinerary[i], advances[i], z,
                                   StepDual::variable(time(unknowns, i), time_index));
}

namespace {

/// A row's entries for the unknowns of step i.
void put(std::vector<std::pair<std::size_t, Ball>>& row, const CycleSystem& system, std::size_t i, const StepDual& f) {
    const std::size_t first = i * system.unknowns_of_step();
    for (std::size_t a = 0; a < system.active.size(); ++a) row.emplace_back(first + a, f.by[system.active[a]]);
    row.emplace_back(first + system.active.size(), f.by[time_index]);
}

/// S_1 or τ_1 less its value.
void put_phase(intervals::Linearisation& result, const CycleSystem& system, const BallVector& unknowns,
               std::size_t row) {
    std::size_t column = system.active.size();
    for (std::size_t a = 0; a < system.active.size() && !system.phase->by_time; ++a)
        if (system.active[a] == spin_index) column = a;
    result.values[row] = unknowns[column] - intervals::decimal(system.phase->value);
    result.rows[row] = {{column, Ball(1)}};
}

}  // namespace

intervals::Linearisation evaluate(const CycleSystem& system, const BallVector& unknowns) {
    const std::size_t n = system.unknowns(), width = system.unknowns_of_step(), k = system.period();
    intervals::Linearisation result{BallVector(n), {}};
    result.rows.resize(n);
    const Ball turn = Ball(2) * intervals::pi_ball();
    for (std::size_t i = 0; i < k; ++i) {
        BallStep<StepDual> step = system.differentiated_step(unknowns, i);
        const std::size_t next = (i + 1) % k;
        BallPoint<Ball> to = system.point(unknowns, next);
        for (std::size_t a = 0; a < system.active.size(); ++a) {
            const std::size_t index = system.active[a], row = i * width + a;
            const StepDual& image = coordinate(step.after, index);
            result.values[row] = image.value - coordinate(to, index);
            if (index < 2) result.values[row] -= Ball(system.turns[i][index]) * turn;
            put(result.rows[row], system, i, image);
            result.rows[row].emplace_back(next * width + a, Ball(-1));
            if (system.form != FamilyForm::conserved || i + 1 != k) continue;
            const Ball along(system.conserved_gradient[index]);
            result.values[row].add_product(along, unknowns[n - 1]);
            result.rows[row].emplace_back(n - 1, along);
        }
        const std::size_t row = (i + 1) * width - 1;
        result.values[row] = step.gap.value;
        put(result.rows[row], system, i, step.gap);
    }
    if (system.form == FamilyForm::conserved) put_phase(result, system, unknowns, n - 1);
    if (system.form == FamilyForm::symmetric)
        for (std::size_t a = 0; a < system.active.size(); ++a)
            if (system.active[a] == normal_index) put_phase(result, system, unknowns, a);
    return result;
}

std::vector<BallVector> step_derivative(const CycleSystem& system, const BallVector& unknowns, std::size_t i) {
    BallStep<StepDual> step = system.differentiated_step(unknowns, i);
    std::vector<BallVector> derivative;
    for (const std::size_t to : system.active) {
        BallVector row;
        const StepDual& image = coordinate(step.after, to);
        for (const std::size_t from : system.active)
            row.push_back(image.by[from] - image.by[time_index] * step.gap.by[from] / step.gap.by[time_index]);
        derivative.push_back(std::move(row));
    }
    return derivative;
}

std::array<Ball, 5> conserved_gradient(const BallScene& scene, const BallPoint<Ball>& z) {
    using D = intervals::Dual<5>;
    const D psi = D::variable(z.psi, 0), chi = D::variable(z.chi, 1), vn = D::variable(z.vn, 2),
            vt = D::variable(z.vt, 3), spin = D::variable(z.spin, 4);
    const auto p = sine_cosine(psi), c = sine_cosine(chi);
    const D x = scene.beta * p.cosine - scene.alpha * c.cosine + Ball(1);
    const D y = -(scene.beta * p.sine + scene.alpha * c.sine);
    const D j =
        Ball(0.5) * (vn * vn + vt * vt) - (x * vt - y * vn) + scene.inertia * (spin * (Ball(0.5) * spin - Ball(1)));
    return j.by;
}

}  // namespace swirl::proof
