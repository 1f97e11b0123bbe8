#include "analysis/continuation/on_branch.hpp"
#include "analysis/cycles/multi_shooting.hpp"
#include "apps/bifurcate/bifurcate_command.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl::apps::bifurcate {

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

class Search {
public:
    Search(const BifurcateOptions& options, Diagram& diagram)
        : options_(options),
          diagram_(diagram),
          scene_(scene_branches(column_scene(options, diagram.along, diagram.along.low), diagram.along,
                                options.settings.accuracy)) {}

    void look_at(double p, const Attractor& attractor) {
        if (!is_on_cycle(attractor) || attractor.period > options_.longest_branch) return;
        for (const auto& branch : diagram_.branches)
            if (const auto cycle = analysis::find_on_branch(scene_.map, branch, p, attractor.states))
                return compare(*cycle, attractor);
        const auto shot = analysis::solve_shooting(scene_.map, attractor.states, p, 1e-10);
        if (shot.converged && is_in_family(shot.points, p)) {
            ++diagram_.agreement.in_families;
            return;
        }
        const bool found = shot.converged &&
                           analysis::distance_between(scene_.map, shot.points, attractor.states) < analysis::same_cycle;
        analysis::Branch branch;
        if (found && analysis::continue_branch(scene_.map, shot.points, p, scene_.options, branch)) {
            if (const auto cycle = analysis::find_on_branch(scene_.map, branch, p, attractor.states))
                compare(*cycle, attractor);
            else
                ++diagram_.agreement.without;
            diagram_.branches.push_back(std::move(branch));
            return;
        }
        ++diagram_.agreement.without;
    }

    /// The branches that flips and branch points of those lead to, unstable ones too.
    void switch_branches() {
        follow_switches(scene_, diagram_.branches, 1, static_cast<std::size_t>(options_.longest_branch));
    }

private:
    bool is_in_family(const analysis::CyclePoints& points, double p) const {
        const auto shooting = analysis::shooting_residual(scene_.map, points, p);
        return shooting.alive && analysis::family_directions(shooting, scene_.map.dimension).cols() > 0;
    }

    void compare(const analysis::BranchPoint& cycle, const Attractor& attractor) {
        if (!(std::abs(cycle.multipliers.front()) < 0.99)) return;
        ++diagram_.agreement.compared;
        diagram_.agreement.largest =
            std::max(diagram_.agreement.largest, spin_difference(cycle.at.points, attractor.states));
        diagram_.agreement.distance = std::max(diagram_.agreement.distance, attractor.distance);
    }

    const BifurcateOptions& options_;
    Diagram& diagram_;
    SceneBranches scene_;
};

}  // namespace

void continue_attractors(const BifurcateOptions& options, Diagram& diagram) {
    Search search(options, diagram);
    Progress progress("branches", static_cast<double>(diagram.columns.size()), options.output.quiet);
    std::size_t seen = 0;
    for (const auto& column : diagram.columns) {
        for (const auto& attractor : column.attractors) {
            if (is_interrupted()) return;
            search.look_at(column.parameter, attractor);
        }
        progress.at(static_cast<double>(++seen));
    }
    search.switch_branches();
}

}  // namespace swirl::apps::bifurcate
