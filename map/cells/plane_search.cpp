#include "map/cells/cell_solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::cells {

namespace {

double seconds_of_core() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The longer side, in units of what it may not fall below; nothing if neither may be halved.
std::optional<std::size_t> side_to_halve(const ParameterCell& cell, const PlaneLimits& limits) {
    const auto width = [&](std::size_t i) { return (cell.high[i] - cell.low[i]) / limits.least[i]; };
    const std::size_t longer = width(1) > width(0) * (1 + 1e-9) ? 1 : 0;
    if (!(width(longer) >= 2 * (1 - 1e-9))) return std::nullopt;
    return longer;
}

}  // namespace

PlanePiece prove_piece(const PlaneProblem& problem, const ParameterCell& piece, const PlaneLimits& limits,
                       const std::function<bool()>& stop) {
    PlanePiece result;
    std::vector<Node> waiting{{piece, limits.depth, problem.unknowns, {}}};
    while (!waiting.empty()) {
        Node node = std::move(waiting.back());
        waiting.pop_back();
        if (stop()) {
            result.cells.push_back(PlaneCell::not_looked_at(node.cell, node.depth));
            continue;
        }
        const double start = seconds_of_core();
        CellSolver(problem, node).run();
        const PlaneCell cell = judged(node);
        const auto depth = static_cast<std::size_t>(node.depth);
        if (result.costs.size() <= depth) result.costs.resize(depth + 1);
        ++result.costs[depth].cells;
        result.costs[depth].seconds += seconds_of_core() - start;
        const auto side = cell.proven ? std::nullopt : side_to_halve(node.cell, limits);
        if (!side) {
            result.cells.push_back(cell);
            continue;
        }
        for (const bool upper : {true, false}) waiting.push_back(node.half(*side, upper));
    }
    return result;
}

}  // namespace swirl::cells
