#include "map/cells/cell_solver.hpp"
#include "map/cells/plane_search.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::cells {

namespace {

constexpr int most_further = 16;  ///< halvings of a stated cell

/// A part of the plane with the stated cells in it; or within one of them, whose counts it must have.
struct Part {
    Node node;
    std::vector<const PlaneCell*> inside;
    int further = 0;
};

std::string in_words(const PlaneCell& cell, const char* what) {
    char text[200];
    std::snprintf(text, sizeof text, "the cell %.10g to %.10g, %.10g to %.10g %s", cell.low[0], cell.high[0],
                  cell.low[1], cell.high[1], what);
    return text;
}

bool is_the_same(const PlaneCell& stated, const ParameterCell& cell) {
    return stated.low == cell.low && stated.high == cell.high;
}

bool has_counts_of(const PlaneCell& found, const PlaneCell& stated) {
    return found.fixed_points == stated.fixed_points && found.attracting == stated.attracting &&
           found.saddles == stated.saddles && found.repelling == stated.repelling;
}

/// Both halves with the cells in them; nothing if a cell lies across the middle.
std::optional<std::pair<Part, Part>> halves(const Part& part, std::size_t side) {
    const double middle = part.node.cell.middle(side);
    std::pair<Part, Part> both{{part.node.half(side, false), {}, part.further},
                               {part.node.half(side, true), {}, part.further}};
    for (const PlaneCell* cell : part.inside) {
        if (cell->high[side] <= middle)
            both.first.inside.push_back(cell);
        else if (cell->low[side] >= middle)
            both.second.inside.push_back(cell);
        else
            return std::nullopt;
    }
    return both;
}

std::size_t longer_side(const ParameterCell& cell, const ParameterCell& plane) {
    const auto share = [&](std::size_t i) { return (cell.high[i] - cell.low[i]) / (plane.high[i] - plane.low[i]); };
    return share(1) > share(0) * (1 + 1e-9) ? 1 : 0;
}

}  // namespace

std::string what_fails(const PlaneProblem& problem, const ParameterCell& plane, const std::vector<PlaneCell>& stated,
                       const std::function<bool()>& stop) {
    std::vector<const PlaneCell*> all;
    for (const PlaneCell& cell : stated) all.push_back(&cell);
    std::vector<Part> waiting{{{plane, 0, problem.unknowns, {}}, std::move(all), 0}};
    while (!waiting.empty()) {
        Part part = std::move(waiting.back());
        waiting.pop_back();
        if (part.inside.empty()) continue;
        if (stop()) return "the check was stopped";
        const PlaneCell& first = *part.inside.front();
        const bool is_cell = part.further > 0 || is_the_same(first, part.node.cell);
        if (is_cell && part.inside.size() > 1) return in_words(first, "is stated twice, or with another within it");
        CellSolver(problem, part.node).run();
        if (is_cell) {
            const PlaneCell found = judged(part.node);
            if (found.proven) {
                if (!has_counts_of(found, first)) return in_words(first, "has other fixed points than stated");
                continue;
            }
            if (++part.further > most_further) return in_words(first, "could not be proven");
            const std::size_t side = longer_side(part.node.cell, plane);
            for (const bool upper : {true, false})
                waiting.push_back({part.node.half(side, upper), part.inside, part.further});
            continue;
        }
        const std::size_t side = longer_side(part.node.cell, plane);
        auto both = halves(part, side);
        if (!both) both = halves(part, 1 - side);
        if (!both || part.node.depth > 60) return in_words(first, "is no half of halves of the plane");
        waiting.push_back(std::move(both->second));
        waiting.push_back(std::move(both->first));
    }
    return {};
}

}  // namespace swirl::cells
