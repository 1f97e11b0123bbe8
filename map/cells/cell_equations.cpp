#include "map/cells/cell_equations.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::cells {

namespace {

using intervals::Ball;
using intervals::is_negative;
using intervals::is_positive;
using intervals::lower;
using intervals::upper;
using Matrix = std::array<std::array<double, 2>, 2>;

double largest(const Ranged& x) {
    return std::max(std::abs(lower(x)), std::abs(upper(x)));
}

std::optional<Matrix> inverse_of(const LinearEquations& at) {
    Matrix m{};
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < 2; ++k) m[i][k] = at.by[i][k].mid;
    const double det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    const Matrix inverse{{{m[1][1] / det, -m[0][1] / det}, {-m[1][0] / det, m[0][0] / det}}};
    for (const auto& row : inverse)
        for (const double x : row)
            if (!std::isfinite(x)) return std::nullopt;
    return inverse;
}

LinearEquations at_middle(const CellEquations& equations, const SolutionBranch& branch) {
    return equations.linear(branch.set, Ranged(branch.middle[0]), Ranged(branch.middle[1]), true);
}

/// The branch's middle at the cell's, by Newton's method, and its slopes.
bool settle(const CellEquations& equations, SolutionBranch& branch) {
    constexpr int most = 12;
    const auto whole = static_cast<double>(branch.j);
    std::optional<Matrix> inverse;
    double moved = 1;
    for (int k = 0; k < most && moved > 1e-14; ++k) {
        const LinearEquations at = at_middle(equations, branch);
        inverse = inverse_of(at);
        if (!inverse) return false;
        moved = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            const double change = (*inverse)[i][0] * at.f.mid + (*inverse)[i][1] * (at.j.mid - whole);
            if (!(std::abs(change) < 1)) return false;
            branch.middle[i] -= change;
            moved = std::max(moved, std::abs(change));
        }
        if (!(branch.middle[0] > 0)) return false;
    }
    if (!(moved < 1e-9) || !inverse) return false;
    const Equations at = equations.values(branch.set, Ranged(branch.middle[0]), Ranged(branch.middle[1]));
    for (std::size_t k = 0; k < 2; ++k) {
        const ParameterCell& cell = equations.cell();
        branch.parameters[k] = cell.middle(k);
        const double half = 0.5 * (cell.high[k] - cell.low[k]);
        for (std::size_t i = 0; i < 2; ++i)
            branch.slopes[i][k] = -((*inverse)[i][0] * at.f.by[2 + k] + (*inverse)[i][1] * at.j.by[2 + k]) / half;
    }
    return true;
}

/// C ≈ ∂G⁻¹ and |1 − C ∂G| over |(τ, x) − x₀ − X(p − p₀)| ≤ reach, for all p of the cell.
struct Slopes {
    Matrix inverse{}, left{};
};
std::optional<Slopes> slopes_over(const CellEquations& equations, const SolutionBranch& branch,
                                  const std::array<double, 2>& reach) {
    const ParameterCell& cell = equations.cell();
    const Ranged tau = on_branch<Ranged>(cell, branch, 0, 2, 0) + Ranged::variable(-reach[0], reach[0], 0);
    const Ranged x = on_branch<Ranged>(cell, branch, 1, 2, 0) + Ranged::variable(-reach[1], reach[1], 1);
    if (!(lower(tau) > 0)) return std::nullopt;
    const LinearEquations over = equations.linear(branch.set, tau, x, false);
    const auto inverse = inverse_of(over);
    if (!inverse) return std::nullopt;
    Slopes slopes{*inverse, {}};
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < 2; ++k)
            slopes.left[i][k] = largest(Ranged(i == k ? 1 : 0) - (Ranged((*inverse)[i][0]) * over.by[0][k] +
                                                                  Ranged((*inverse)[i][1]) * over.by[1][k]));
    return slopes;
}

/// Krawczyk's operator there: how far its image reaches. If that is less than `reach`, there is exactly one solution
/// for each p, and it lies in the image.
std::optional<std::array<double, 2>> image_of(const CellEquations& equations, const SolutionBranch& branch,
                                              const std::array<double, 2>& reach) {
    const auto slopes = slopes_over(equations, branch, reach);
    if (!slopes) return std::nullopt;
    const Equations at = equations.values(branch.set, on_branch<Ranged>(equations.cell(), branch, 0, 2, 0),
                                          on_branch<Ranged>(equations.cell(), branch, 1, 2, 0));
    const Ranged j = at.j - Ranged(static_cast<double>(branch.j));
    std::array<double, 2> image{};
    for (std::size_t i = 0; i < 2; ++i) {
        const Ranged moved = Ranged(slopes->inverse[i][0]) * at.f + Ranged(slopes->inverse[i][1]) * j;
        image[i] =
            intervals::detail::at_least(largest(moved) + slopes->left[i][0] * reach[0] + slopes->left[i][1] * reach[1]);
        if (!std::isfinite(image[i])) return std::nullopt;
    }
    return image;
}

/// The solution to second order: `curves` and `close`. With x_c the curve, C G(x_c) = (1 − (1 − C ∂G))(x_c − x(p)) for
/// some slope ∂G between the two, so that |x_c − x(p)| ≤ |C G(x_c)| + |1 − C ∂G| |x_c − x(p)|.
void curve(const CellEquations& equations, SolutionBranch& branch) {
    branch.close = branch.near;  // of the straight line
    const auto whole = Curving(static_cast<double>(branch.j));
    const auto at = [&](const SolutionBranch& line) {
        return equations.curved(line.set, on_curved_branch(equations.cell(), line, 0, 0),
                                on_curved_branch(equations.cell(), line, 1, 0));
    };
    SolutionBranch curved = branch;
    const CurvedEquations straight = at(branch);
    const auto first = slopes_over(equations, branch, branch.near);
    if (!first || !is_finite(straight.f) || !is_finite(straight.j)) return;
    std::array<double, 2> off{};
    for (std::size_t i = 0; i < 2; ++i) {
        off[i] = branch.near[i];
        for (std::size_t k = 0; k < 3; ++k) {
            curved.curves[i][k] =
                -(first->inverse[i][0] * straight.f.two[k] + first->inverse[i][1] * straight.j.two[k]);
            off[i] += std::abs(curved.curves[i][k]);
        }
        off[i] = intervals::detail::at_least(off[i]);
    }
    const auto slopes = slopes_over(equations, branch, off);
    if (!slopes) return;
    const CurvedEquations left = at(curved);
    const Curving j = left.j - whole;
    for (int round = 0; round < 3; ++round) {
        std::array<double, 2> closer{};
        for (std::size_t i = 0; i < 2; ++i) {
            const Curving moved = Curving(slopes->inverse[i][0]) * left.f + Curving(slopes->inverse[i][1]) * j;
            const double size = std::max(std::abs(lower(moved)), std::abs(upper(moved)));
            closer[i] = std::min(
                off[i], intervals::detail::at_least(size + slopes->left[i][0] * off[0] + slopes->left[i][1] * off[1]));
            if (!std::isfinite(closer[i])) return;
        }
        off = closer;
    }
    if (!(off[0] < branch.near[0] && off[1] < branch.near[1])) return;
    branch.curves = curved.curves;
    branch.close = off;
}

bool is_inside(const std::array<double, 2>& image, const std::array<double, 2>& reach) {
    return image[0] < reach[0] && image[1] < reach[1];
}

/// How far the unknowns move if both equations are off by their largest slopes: a domain's sides are in proportion.
std::array<double, 2> scales_of(const CellEquations& equations, const SolutionBranch& branch) {
    const LinearEquations at = at_middle(equations, branch);
    const auto inverse = inverse_of(at);
    if (!inverse) return {1, 1};
    std::array<double, 2> scales{};
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t row = 0; row < 2; ++row)
            scales[i] += std::abs((*inverse)[i][row]) * std::hypot(at.by[row][0].mid, at.by[row][1].mid);
    return scales;
}

/// A whole turn, −1, 0 or 1 of them.
Ranged turns(int count) {
    return Ranged(Ball(2 * count) * intervals::pi_ball());
}

}  // namespace

Ranged side(const UnknownBox& box, std::size_t i) {
    return Ranged::variable(box.low[i], box.high[i], i);
}

BoxSight look_at(const CellEquations& equations, const UnknownBox& box) {
    BoxSight sight;
    const Ranged tau = side(box, 0), x = side(box, 1);
    sight.excluded = equations.is_excluded(box.set, tau, x);
    if (sight.excluded) return sight;
    const Equations at = equations.values(box.set, tau, x);
    sight.f = at.f;
    sight.j = at.j;
    const double first = std::ceil(lower(at.j)), last = std::floor(upper(at.j));
    sight.excluded = is_positive(at.f) || is_negative(at.f) || first > last;
    if (first == last && std::abs(first) < 1e9 && box.low[0] > 0) sight.whole = static_cast<long>(first);
    return sight;
}

std::optional<SolutionBranch> branch_near(const CellEquations& equations, int set, long j,
                                          const std::array<double, 2>& start) {
    SolutionBranch branch;
    branch.set = set;
    branch.j = j;
    branch.middle = start;
    if (!settle(equations, branch)) return std::nullopt;
    std::array<double, 2> reach{1e-12, 1e-12};
    bool found = false;
    for (int i = 0; i < 4 && !found; ++i) {
        const auto image = image_of(equations, branch, reach);
        if (!image) return std::nullopt;
        found = is_inside(*image, reach);
        if (found) branch.near = *image;
        for (std::size_t k = 0; k < 2 && !found; ++k) reach[k] = 2 * (*image)[k] + 1e-13;
    }
    if (!found) return std::nullopt;
    branch.domain = reach;
    curve(equations, branch);
    const std::array<double, 2> scales = scales_of(equations, branch);
    for (double size = 0.25; size > 1e-6; size *= 0.5) {  // the widest that holds one solution alone
        const std::array<double, 2> wide{size * scales[0], size * scales[1]};
        if (!(wide[0] > reach[0] && wide[1] > reach[1])) break;
        const auto image = image_of(equations, branch, wide);
        if (!image || !is_inside(*image, wide)) continue;
        branch.domain = wide;
        break;
    }
    return branch;
}

Relation relation_of(const CellEquations& equations, const SolutionBranch& known, const SolutionBranch& found) {
    if (known.set != found.set || known.j != found.j) return Relation::different;
    bool apart = true;
    for (const int turn : {0, -1, 1}) {
        bool inside = true, outside = false;
        for (std::size_t i = 0; i < 2; ++i) {
            Ranged at = Ranged(found.middle[i]) - Ranged(known.middle[i]);
            if (i == 1) at += turns(turn);
            for (std::size_t k = 0; k < 2; ++k)
                at -= Ranged(known.slopes[i][k]) * (Ranged(equations.cell().middle(k)) - Ranged(known.parameters[k]));
            inside = inside && intervals::detail::at_least(largest(at) + found.near[i]) < known.domain[i];
            outside = outside || lower(abs(at)) > intervals::detail::at_least(known.near[i] + found.near[i]);
        }
        if (inside) return Relation::same;
        apart = apart && outside;
    }
    return apart ? Relation::different : Relation::unclear;
}

bool covers(const CellEquations& equations, const SolutionBranch& branch, const UnknownBox& box) {
    if (branch.set != box.set) return false;
    for (const int turn : {0, -1, 1}) {
        bool inside = true;
        for (std::size_t i = 0; i < 2 && inside; ++i) {
            Ranged at = side(box, i);
            if (i == 1) at += turns(turn);
            inside = largest(at - on_branch<Ranged>(equations.cell(), branch, i, 2, 0)) < branch.domain[i];
        }
        if (inside) return true;
    }
    return false;
}

}  // namespace swirl::cells
