#include "analysis/continuation/branch.hpp"
#include "analysis/cycles/multi_shooting.hpp"
#include "apps/studies/diagrams/diagram.hpp"
#include "apps/studies/parallel/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::studies::diagrams {

namespace {

/// The largest difference of S between two cycles, for the shift that fits best.
double spin_difference(const analysis::CyclePoints& a, const analysis::CyclePoints& b) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t shift = 0; shift < a.size(); ++shift) {
        double largest = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            largest = std::max(largest, std::abs(a[i].tail(1)[0] - b[(i + shift) % b.size()].tail(1)[0]));
        best = std::min(best, largest);
    }
    return best;
}

/// An attractor and the column where it is.
struct Seen {
    std::size_t order = 0;  ///< in the diagram
    double parameter = 0;
    analysis::CyclePoints states;
    double distance = 0;
};

/// What an attractor adds.
struct Found {
    std::size_t order = 0;
    Agreement agreement;
    std::optional<analysis::Branch> branch;  ///< one that was not known
};

/// Branches of one period, in the order in which attractors lead to them. Attractors of another period lie on none of
/// them, so that each period has a search of its own.
class Search {
public:
    explicit Search(const SceneBranches& scene) : scene_(scene) {}

    Found look_at(const Seen& seen) {
        const double p = seen.parameter;
        Found result{seen.order, {}, {}};
        for (const auto& branch : branches_)
            if (const auto cycle = analysis::find_on_branch(scene_.map, branch, p, seen.states)) {
                result.agreement = compared(*cycle, seen);
                return result;
            }
        const auto shot = analysis::solve_shooting(scene_.map, seen.states, p, 1e-10);
        if (shot.converged && is_in_family(shot.points, p)) {
            result.agreement.in_families = 1;
            return result;
        }
        const bool found =
            shot.converged && analysis::distance_between(scene_.map, shot.points, seen.states) < analysis::same_cycle;
        result.agreement.without = 1;
        analysis::Branch branch;
        if (!found || !analysis::continue_branch(scene_.map, shot.points, p, scene_.options, branch)) return result;
        if (const auto cycle = analysis::find_on_branch(scene_.map, branch, p, seen.states))
            result.agreement = compared(*cycle, seen);
        branches_.push_back(branch);
        result.branch = std::move(branch);
        return result;
    }

private:
    bool is_in_family(const analysis::CyclePoints& points, double p) const {
        const auto shooting = analysis::shooting_residual(scene_.map, points, p);
        return shooting.alive && analysis::family_directions(shooting, scene_.map.dimension).cols() > 0;
    }

    static Agreement compared(const analysis::BranchPoint& cycle, const Seen& seen) {
        Agreement agreement;
        if (!(std::abs(cycle.multipliers.front()) < 0.99)) return agreement;
        agreement.compared = 1;
        agreement.largest = spin_difference(cycle.at.points(), seen.states);
        agreement.distance = seen.distance;
        return agreement;
    }

    const SceneBranches& scene_;
    std::vector<analysis::Branch> branches_;
};

void add(const Agreement& one, Agreement& all) {
    all.compared += one.compared;
    all.without += one.without;
    all.in_families += one.in_families;
    all.largest = std::max(all.largest, one.largest);
    all.distance = std::max(all.distance, one.distance);
}

/// What the searches read and what they find: those that a stop leaves alone outlive the call.
struct Searches {
    SceneBranches scene;
    std::vector<std::vector<Seen>> periods;  ///< the attractors of each
    Gathered<Found> found;
};

std::shared_ptr<Searches> searches_for(const DiagramSettings& settings, const analysis::Stop& stop,
                                       const Diagram& diagram) {
    const Scene<double> first = column_scene(settings, diagram.along.low);
    std::map<std::int64_t, std::vector<Seen>> by_period;
    std::size_t order = 0;
    for (const auto& column : diagram.columns)
        for (const auto& attractor : column.attractors) {
            ++order;
            if (!is_on_cycle(attractor) || attractor.period > settings.longest_branch) continue;
            by_period[attractor.period].push_back({order, column.parameter, points_of(attractor), attractor.distance});
        }
    auto searches = std::make_shared<Searches>();
    searches->scene = scene_branches(first, diagram.along, settings.samples.accuracy, stop);
    for (auto& [period, seen] : by_period) searches->periods.push_back(std::move(seen));
    return searches;
}

}  // namespace

void continue_attractors(const DiagramSettings& settings, const RunControl& control, Diagram& diagram) {
    const auto searches = searches_for(settings, control.stop, diagram);
    const RunPieces run = [&control](std::size_t count, const auto& work) {
        run_pieces(count, "branches", control, work);
    };
    run(searches->periods.size(), [searches, control](std::size_t i) -> KeepResult {
        Search search(searches->scene);
        for (const Seen& seen : searches->periods[i]) {
            if (control.is_stopped()) break;
            searches->found.add(search.look_at(seen));
        }
        return [] {};
    });
    std::vector<Found> all = searches->found.take();
    std::vector<Found*> in_order;  // branches are large, and stay where they are
    for (Found& found : all) in_order.push_back(&found);
    std::sort(in_order.begin(), in_order.end(), [](const Found* a, const Found* b) { return a->order < b->order; });
    for (Found* const next : in_order) {
        Found& found = *next;
        add(found.agreement, diagram.agreement);
        if (found.branch) diagram.branches.push_back(std::move(*found.branch));
    }
    // The branches that flips and branch points of those lead to, unstable ones too.
    follow_switches(searches->scene, diagram.branches, 1, static_cast<std::size_t>(settings.longest_branch), run);
}

}  // namespace swirl::studies::diagrams
