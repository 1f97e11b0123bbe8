#include "map/proof_check/checked_system.hpp"

#include "map/intervals/arb.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace swirl::proof_check {

namespace {

constexpr std::size_t spin = 4, time_variable = 5, next = 6;

/// The equations of a step that go with its unknowns, in the same number.
std::vector<const Gradient*> equations_of(const CheckedSystem& system, const StepEquations& all) {
    std::vector<const Gradient*> list{&all.position_x, &all.position_y, &all.friction, &all.restitution};
    if (!system.scene.disk()) list.push_back(&all.turn);
    if (system.kept.back() == spin) list.push_back(&all.spin);
    return list;
}

struct Rows {
    Balls values;
    std::vector<Balls> matrix;
};

Rows rows_of(const CheckedSystem& system, const Balls& unknowns) {
    const std::size_t n = system.size(), k = system.steps.size(), width = system.width();
    Rows rows{{}, {}};
    for (std::size_t i = 0; i < k; ++i) {
        const StepEquations all =
            step_equations(system.scene, system.steps[i], system.variables_of(unknowns, i), nullptr);
        for (const Gradient* equation : equations_of(system, all)) {
            if (system.shortage == Shortage::symmetric && equation == &all.restitution) continue;
            Balls row(n);
            for (std::size_t a = 0; a < system.kept.size(); ++a) {
                row[i * width + a] += equation->d[system.kept[a]];
                row[(i + 1) % k * width + a] += equation->d[next + system.kept[a]];
                if (system.shortage == Shortage::conserved && i + 1 == k)
                    row[n - 1].add_product(Ball(-system.direction[system.kept[a]]), equation->d[next + system.kept[a]]);
            }
            row[(i + 1) * width - 1] += equation->d[time_variable];
            rows.values.push_back(equation->f);
            rows.matrix.push_back(std::move(row));
        }
    }
    if (system.shortage != Shortage::none) {
        const std::size_t index = system.phase.by_time ? width - 1 : width - 2;
        Balls row(n);
        row[index] = Ball(1);
        rows.values.push_back(unknowns[index] - intervals::decimal(system.phase.value));
        rows.matrix.push_back(std::move(row));
    }
    return rows;
}

void require(bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(what);
}

}  // namespace

void require_itinerary(const StatedCycle& cycle) {
    for (const StatedStep& step : cycle.steps) {
        const std::string& mode = step.contact_mode;
        const bool known = mode == "frictionless" || mode == "sliding" || mode == "c-sticking" ||
                           mode == "r-sticking" || mode == "c-reversed" || mode == "r-reversed";
        require(known, "its word has a contact mode that is none");
        require((mode == "frictionless") == (cycle.mu == 0), "its word does not go with the scene's friction");
        require(mode == "frictionless" || mode == "c-sticking" ? std::abs(step.slip) <= 1 : std::abs(step.slip) == 1,
                "its word has a sign of slip that does not go with the contact mode");
        require(mode != "frictionless" || step.slip == 0, "its word has slip without friction");
        require(cycle.sides == 0 ? step.vertex_step == 0 : step.vertex_step >= 0 && step.vertex_step < cycle.sides,
                "its word has a vertex that the body does not have");
    }
    require(cycle.law == "poisson" || cycle.law == "newton" || cycle.law == "stronge", "its law is none");
}

StepVariables CheckedSystem::variables_of(const Balls& unknowns, std::size_t i) const {
    std::array<Gradient, variables> g;
    const std::size_t j = (i + 1) % steps.size();
    for (std::size_t index = 0; index < 5; ++index) {  // what is no unknown is stated with radius 0
        g[index] = Gradient(Ball(steps[i].point[index]), index);
        g[next + index] = Gradient(Ball(steps[j].point[index]), next + index);
    }
    for (std::size_t a = 0; a < kept.size(); ++a) {
        g[kept[a]].f = unknowns[i * width() + a];
        g[next + kept[a]].f = unknowns[j * width() + a];
        if (shortage == Shortage::conserved && j == 0)
            g[next + kept[a]].f -= unknowns.back() * Ball(direction[kept[a]]);
    }
    g[time_variable] = Gradient(unknowns[(i + 1) * width() - 1], time_variable);
    return {g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8], g[9], g[10]};
}

CheckedSystem checked_system(const StatedCycle& cycle) {
    require(!cycle.steps.empty(), "it has no points");
    require_itinerary(cycle);
    CheckedSystem system;
    system.scene = scene_of(cycle);
    system.steps = cycle.steps;
    const bool disk = cycle.sides == 0;
    system.kept = disk ? std::vector<std::size_t>{0, 2, 3, 4} : std::vector<std::size_t>{0, 1, 2, 3, 4};
    if (disk && cycle.mu == 0) system.kept.pop_back();
    for (const StatedStep& step : cycle.steps) {
        require(!disk || (step.point[1] == 0 && step.radius[1] == 0), "a disk has chi = 0");
        require(
            !(disk && cycle.mu == 0) || (step.point[spin] == cycle.steps.front().point[spin] && step.radius[spin] == 0),
            "a disk's S does not change without friction");
        for (const std::size_t index : system.kept)
            require(step.radius[index] > 0, "a half-width of its box is not positive");
        require(step.time_radius > 0, "a half-width of its box is not positive");
    }
    if (cycle.restitution == 1 && cycle.mu == 0) system.shortage = Shortage::conserved;
    if (cycle.restitution == 1 && cycle.mu > 0 && disk && cycle.steps.size() == 1)
        system.shortage = Shortage::symmetric;
    require((system.shortage != Shortage::none) == cycle.phase.has_value(),
            "a family's member needs its phase, and an isolated cycle has none");
    if (!cycle.phase) return system;
    system.phase = *cycle.phase;
    require(system.phase.by_time || system.kept.back() == spin,
            "the phase S does not tell members of this family apart");
    std::array<Ball, 5> z;
    for (std::size_t i = 0; i < 5; ++i) z[i] = Ball(cycle.steps.front().point[i]);
    const auto gradient = gradient_of_energy(system.scene, z);
    for (std::size_t i = 0; i < 5; ++i) system.direction[i] = intervals::middle(gradient[i]);
    return system;
}

Balls stated_box(const CheckedSystem& system) {
    Balls box;
    for (const StatedStep& step : system.steps) {
        for (const std::size_t index : system.kept)
            box.push_back(intervals::around(step.point[index], step.radius[index]));
        box.push_back(intervals::around(step.time, step.time_radius));
    }
    if (system.shortage == Shortage::conserved) box.push_back(intervals::around(0, system.steps.front().time_radius));
    return box;
}

Balls stated_middle(const CheckedSystem& system) {
    Balls middle;
    for (const Ball& x : stated_box(system)) middle.push_back(intervals::exact_middle(x));
    return middle;
}

bool holds_one_solution(const CheckedSystem& system, const Balls& middle, const Balls& box, Balls& image) {
    const Rows at = rows_of(system, middle), over = rows_of(system, box);
    const std::size_t n = box.size();
    if (at.matrix.size() != n || over.matrix.size() != n) return false;
    Eigen::MatrixXd rough(n, n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) rough(i, j) = intervals::middle(at.matrix[i][j]);
    const Eigen::MatrixXd inverse = rough.partialPivLu().inverse();
    if (!inverse.allFinite()) return false;
    image.clear();
    bool inside = true;
    for (std::size_t i = 0; i < n; ++i) {
        Ball entry = middle[i];
        Balls rest(n);
        rest[i] = Ball(1);
        for (std::size_t l = 0; l < n; ++l) {
            const Ball weight(-inverse(i, l));
            entry.add_product(weight, at.values[l]);
            for (std::size_t j = 0; j < n; ++j)
                if (!is_exact_zero(over.matrix[l][j])) rest[j].add_product(weight, over.matrix[l][j]);
        }
        for (std::size_t j = 0; j < n; ++j) entry.add_product(rest[j], box[j] - middle[j]);
        inside = inside && intervals::contains_interior(box[i], entry);
        image.push_back(std::move(entry));
    }
    return inside;
}

std::vector<Balls> derivative_of_step(const CheckedSystem& system, const Balls& unknowns, std::size_t i) {
    const StepEquations all = step_equations(system.scene, system.steps[i], system.variables_of(unknowns, i), nullptr);
    const auto list = equations_of(system, all);
    const auto n = static_cast<slong>(list.size()), m = static_cast<slong>(system.kept.size());
    arb_mat_t left, right, solution;
    arb_mat_init(left, n, n);
    arb_mat_init(right, n, m);
    arb_mat_init(solution, n, m);
    for (slong r = 0; r < n; ++r) {
        for (slong a = 0; a < m; ++a) {
            const std::size_t index = system.kept[static_cast<std::size_t>(a)];
            arb_set(arb_mat_entry(left, r, a), list[r]->d[next + index].raw());
            arb_neg(arb_mat_entry(right, r, a), list[r]->d[index].raw());
        }
        arb_set(arb_mat_entry(left, r, m), list[r]->d[time_variable].raw());
    }
    std::vector<Balls> derivative;
    if (arb_mat_solve(solution, left, right, intervals::ball_precision) != 0)
        for (slong r = 0; r < m; ++r) {
            derivative.emplace_back(m);
            for (slong a = 0; a < m; ++a) arb_set(derivative.back()[a].raw(), arb_mat_entry(solution, r, a));
        }
    arb_mat_clear(left);
    arb_mat_clear(right);
    arb_mat_clear(solution);
    return derivative;
}

std::array<Ball, 5> gradient_of_energy(const StatedScene& scene, const std::array<Ball, 5>& z) {
    std::array<Gradient, 5> g;
    for (std::size_t i = 0; i < 5; ++i) g[i] = Gradient(z[i], i);
    // The centre from the swirl's, in axes along the swirl's arm, and the velocity in the same axes.
    const Gradient c = cosine(g[0]), s = sine(g[0]), corner = g[0] + g[1];
    const Gradient x = scene.beta + (c - scene.alpha * cosine(corner)), y = s - scene.alpha * sine(corner);
    const Gradient vx = c * g[2] - s * g[3], vy = s * g[2] + c * g[3];
    const Gradient energy = Ball(0.5) * (vx * vx + vy * vy) + (Ball(0.5) * scene.inertia) * (g[4] * g[4]);
    const Gradient momentum = x * vy - y * vx + scene.inertia * g[4];
    const Gradient jacobi = energy - momentum;
    std::array<Ball, 5> result;
    for (std::size_t i = 0; i < 5; ++i) result[i] = jacobi.d[i];
    return result;
}

}  // namespace swirl::proof_check
