#include "map/cells/cell_solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swirl::cells {

namespace {

constexpr int most_boxes = 20'000;  ///< that are looked at; what is left goes to the cell's halves

void widen(SolutionBranch& known, const SolutionBranch& found) {
    if (found.domain[0] >= known.domain[0] && found.domain[1] >= known.domain[1]) known = found;
}

/// Where both equations hold to first order, if that is in the box or next to it.
std::optional<std::array<double, 2>> predicted(const UnknownBox& box, const BoxSight& sight) {
    const double det = sight.f.by[0] * sight.j.by[1] - sight.f.by[1] * sight.j.by[0];
    const double f = sight.f.mid, j = sight.j.mid - static_cast<double>(*sight.whole);
    const std::array<double, 2> e{(sight.f.by[1] * j - sight.j.by[1] * f) / det,
                                  (sight.j.by[0] * f - sight.f.by[0] * j) / det};
    std::array<double, 2> start{};
    for (std::size_t i = 0; i < 2; ++i) {
        if (!(std::abs(e[i]) <= 3)) return std::nullopt;
        start[i] = 0.5 * (box.low[i] + box.high[i]) + e[i] * 0.5 * (box.high[i] - box.low[i]);
    }
    if (!(start[0] > 0)) return std::nullopt;
    return start;
}

/// In the side by which the equations change more.
void halve(const UnknownBox& box, const BoxSight& sight, double weight_f, double weight_j,
           std::vector<UnknownBox>& waiting) {
    std::array<double, 2> share{};
    for (std::size_t i = 0; i < 2; ++i) {
        const double width = box.high[i] - box.low[i];
        share[i] = weight_f * (std::abs(sight.f.by[i]) + sight.f.rest * width) +
                   weight_j * (std::abs(sight.j.by[i]) + sight.j.rest * width);
        if (!std::isfinite(share[i])) share[i] = 1e6 * width;
    }
    const std::size_t i = share[1] > share[0] ? 1 : 0;
    UnknownBox left = box, right = box;
    left.high[i] = right.low[i] = 0.5 * (box.low[i] + box.high[i]);
    waiting.push_back(right);
    waiting.push_back(left);
}

}  // namespace

void CellSolver::run() {
    for (Tracked& tracked : node_.branches)
        if (!tracked.standing.decided) follow(tracked);
    std::vector<UnknownBox> waiting = std::move(node_.boxes);
    node_.boxes.clear();
    for (int looked = 0; !waiting.empty(); ++looked) {
        const UnknownBox box = waiting.back();
        waiting.pop_back();
        if (looked < most_boxes)
            take(box, waiting);
        else
            node_.boxes.push_back(box);
    }
}

/// The branch, enclosed on this cell alone.
void CellSolver::follow(Tracked& tracked) {
    SolutionBranch& known = tracked.branch;
    const auto found = branch_near(
        *equations_, known.set, known.j,
        {on_branch<Ranged>(node_.cell, known, 0, 2, 0).mid, on_branch<Ranged>(node_.cell, known, 1, 2, 0).mid});
    if (!found || relation_of(*equations_, known, *found) != Relation::same) return;
    tracked.standing = equations_->standing_of(*found);
    widen(known, *found);
}

void CellSolver::take(const UnknownBox& box, std::vector<UnknownBox>& waiting) {
    const BoxSight sight = look_at(*equations_, box);
    if (sight.excluded) return;
    if (sight.whole && (is_covered(box, *sight.whole) || is_closed(box, sight))) return;
    // Halving the box tells nothing where the cell's own width hides what it would.
    const Equations middle =
        equations_->values(box.set, Ranged(0.5 * (box.low[0] + box.high[0])), Ranged(0.5 * (box.low[1] + box.high[1])));
    const bool hidden_f = sight.f.reach() <= 2 * middle.f.reach();
    const bool hidden_j = sight.j.reach() <= std::max(2 * middle.j.reach(), 1e-3);
    const bool wait = hidden_f && hidden_j;
    const bool narrow = box.high[0] - box.low[0] < 1e-9 && box.high[1] - box.low[1] < 1e-9;
    if (wait || narrow) {
        if (!sight.whole || !equations_->is_met_earlier(box.set, *sight.whole, side(box, 0), side(box, 1)))
            node_.boxes.push_back(box);
        return;
    }
    halve(box, sight, hidden_f ? 0 : 1, hidden_j ? 0 : 0.1, waiting);
}

bool CellSolver::is_covered(const UnknownBox& box, long j) const {
    return std::any_of(node_.branches.begin(), node_.branches.end(), [&](const Tracked& tracked) {
        return tracked.branch.j == j && covers(*equations_, tracked.branch, box);
    });
}

/// True if a branch is found whose solutions are all that the box has.
bool CellSolver::is_closed(const UnknownBox& box, const BoxSight& sight) {
    const auto start = predicted(box, sight);
    if (!start) return false;
    const auto failed = [&](const auto& other) {
        return other.set == box.set && other.j == *sight.whole &&
               std::abs(other.at[0] - (*start)[0]) <= other.reach[0] &&
               std::abs(other.at[1] - (*start)[1]) <= other.reach[1];
    };
    if (std::any_of(failures_.begin(), failures_.end(), failed)) return false;
    const auto found = branch_near(*equations_, box.set, *sight.whole, *start);
    if (!found) {
        failures_.push_back({box.set, *sight.whole, *start, {box.high[0] - box.low[0], box.high[1] - box.low[1]}});
        return false;
    }
    for (Tracked& tracked : node_.branches) {
        const Relation relation = relation_of(*equations_, tracked.branch, *found);
        if (relation == Relation::unclear) return false;
        if (relation != Relation::same) continue;
        const bool closed = covers(*equations_, *found, box);
        widen(tracked.branch, *found);
        return closed;
    }
    node_.branches.push_back({*found, equations_->standing_of(*found)});
    return covers(*equations_, *found, box);
}

PlaneCell judged(const Node& node) {
    PlaneCell cell{node.cell.low, node.cell.high, node.depth, false, 0, 0, 0, 0, Doubt::none};
    cell.proven = node.boxes.empty();
    if (!cell.proven) cell.doubt = Doubt::equations;
    for (const Tracked& tracked : node.branches) {
        const BranchStanding& standing = tracked.standing;
        if (!standing.decided && cell.proven) {
            cell.proven = false;
            cell.doubt = standing.doubt;
        }
        if (!standing.exists) continue;
        ++cell.fixed_points;
        ++(standing.outside == 0 ? cell.attracting : standing.inside == 0 ? cell.repelling : cell.saddles);
    }
    if (!cell.proven) cell.fixed_points = cell.attracting = cell.saddles = cell.repelling = 0;
    return cell;
}

}  // namespace swirl::cells
