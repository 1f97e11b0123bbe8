#include "map/proof/plane_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace swirl::proof {

namespace {

using intervals::BallVector;
using intervals::between;
using intervals::overlap;

using Value = intervals::Dual<2>;

/// Values over a cell, by the mean value theorem where that is narrower.
Ball narrower(const Value& over, const Value& middle, const BallVector& away) {
    Ball mean = middle.value;
    for (std::size_t i = 0; i < away.size(); ++i) mean.add_product(over.by[i], away[i]);
    if (!is_finite(mean)) return over.value;
    if (!is_finite(over.value) || !overlap(mean, over.value)) return mean;
    return intersection(mean, over.value);
}

/// The system f = 0, j = `whole`, or the second alone.
intervals::BallSystem system_of(const PlaneProblem& problem, const Ball& phi, long whole) {
    return [&problem, phi, whole](const BallVector& at) {
        const bool two = problem.unknowns == 2;
        const auto values = problem.evaluate(at[0], two ? at[1] : phi);
        intervals::Linearisation result;
        const auto add = [&](const Value& value, const Ball& less) {
            result.values.push_back(value.value - less);
            result.rows.emplace_back();
            for (std::size_t i = 0; i < at.size(); ++i) result.rows.back().emplace_back(i, value.by[i]);
        };
        if (two) add(values.f, Ball(0));
        add(values.j, Ball(static_cast<double>(whole)));
        return result;
    };
}

enum class Closed { no, excluded, solved };

/// Krawczyk's operator on the cell, enlarged so that a solution on its edge is inside.
Closed close(const PlaneProblem& problem, const Cell& cell, long whole, PlaneResult& result) {
    const auto n = static_cast<std::size_t>(problem.unknowns);
    const Ball phi = between(cell.low[1], cell.high[1]);
    const auto system = system_of(problem, phi, whole);
    Cell wide = cell;
    BallVector box, inner;
    for (std::size_t i = 0; i < n; ++i) {
        const double more = 0.25 * (cell.high[i] - cell.low[i]);
        wide.low[i] -= more;
        wide.high[i] += more;
        if (i == 0) wide.low[0] = std::max(wide.low[0], 0.5 * cell.low[0]);
        box.push_back(between(wide.low[i], wide.high[i]));
        inner.push_back(between(cell.low[i], cell.high[i]));
    }
    const BallVector middle = intervals::middles(box);
    const Eigen::MatrixXd inverse = intervals::approximate_inverse(system(middle));
    if (!inverse.allFinite()) return Closed::no;
    const BallVector image = intervals::krawczyk_image(system, middle, box, inverse);
    for (std::size_t i = 0; i < n; ++i) {
        if (!is_finite(image[i])) return Closed::no;
        if (!overlap(image[i], inner[i])) return Closed::excluded;
    }
    if (!intervals::lies_inside(image, box)) return Closed::no;
    const BallVector close_by = intervals::narrowed(system, image);
    const Ball at_phi = n == 2 ? close_by[1] : phi;
    for (const PlaneSolution& known : result.solutions) {
        // The only solution of that cell: this one, found from its neighbour.
        const bool same =
            known.j == whole && contains(between(known.cell.low[0], known.cell.high[0]), close_by[0]) &&
            (n == 1 ? overlap(known.phi, at_phi) : contains(between(known.cell.low[1], known.cell.high[1]), at_phi));
        if (same) return Closed::solved;
    }
    result.solutions.push_back({whole, wide, close_by[0], at_phi});
    return Closed::solved;
}

void halve(const PlaneProblem& problem, const Cell& cell, const PlaneProblem::Values& over,
           std::vector<Cell>& waiting) {
    int along = 0;
    if (problem.unknowns == 2) {
        const auto reach = [&](int i) {
            const double f = std::max(std::abs(lower(over.f.by[i])), std::abs(upper(over.f.by[i])));
            const double j = std::max(std::abs(lower(over.j.by[i])), std::abs(upper(over.j.by[i])));
            const double both = (f + 0.1 * j) * cell.width(i);
            return std::isfinite(both) ? both : cell.width(i) * 1e6;
        };
        if (reach(1) > reach(0)) along = 1;
    }
    Cell left = cell, right = cell;
    left.high[along] = right.low[along] = 0.5 * (cell.low[along] + cell.high[along]);
    waiting.push_back(right);
    waiting.push_back(left);
}

}  // namespace

void solve(const PlaneProblem& problem, const Cell& start, const std::function<bool()>& stop, PlaneResult& result) {
    constexpr double smallest = 1e-9;
    constexpr std::size_t most = 5'000'000;
    std::vector<Cell> waiting{start};
    while (!waiting.empty()) {
        const Cell cell = waiting.back();
        waiting.pop_back();
        if ((++result.cells & 255U) == 0 && (stop() || result.cells > most)) {
            result.open.push_back(cell);
            result.open.insert(result.open.end(), waiting.begin(), waiting.end());
            return;
        }
        const Ball tau = between(cell.low[0], cell.high[0]), phi = between(cell.low[1], cell.high[1]);
        if (problem.excluded(tau, phi)) continue;
        const auto over = problem.evaluate(tau, phi);
        const auto middle = problem.evaluate(exact_middle(tau), problem.unknowns == 2 ? exact_middle(phi) : phi);
        BallVector away{tau - exact_middle(tau)};
        if (problem.unknowns == 2) {
            away.push_back(phi - exact_middle(phi));
            const Ball f = narrower(over.f, middle.f, away);
            if (is_positive(f) || is_negative(f)) continue;
        }
        const Ball j = narrower(over.j, middle.j, away);
        const double first = std::ceil(lower(j)), last = std::floor(upper(j));
        if (first > last) continue;
        const bool at_start = cell.low[0] <= 0;  // there j = 0 is no solution: `excluded` decides
        if (first == last && std::abs(first) < 1e9 && !at_start) {
            const Closed closed = close(problem, cell, static_cast<long>(first), result);
            if (closed != Closed::no) continue;
        }
        if (cell.width(0) < smallest && (problem.unknowns == 1 || cell.width(1) < smallest))
            result.open.push_back(cell);
        else
            halve(problem, cell, over, waiting);
    }
}

}  // namespace swirl::proof
