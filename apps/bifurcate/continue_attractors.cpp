#include "analysis/continuation/locate.hpp"
#include "analysis/orbits/multi_shooting.hpp"
#include "apps/bifurcate/bifurcate_command.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace swirl::apps {

namespace {

constexpr double same_cycle = 1e-6;

/// The branch's cycles at one value of the parameter.
std::vector<analysis::BranchPoint> cycles_at(const SceneBranches& scene, const analysis::Branch& branch, double p) {
    std::vector<analysis::BranchPoint> found;
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
        const auto& a = branch.points[i].at;
        const auto& b = branch.points[i + 1].at;
        if (a.p == p) found.push_back(branch.points[i]);
        if (!((a.p - p) * (b.p - p) < 0)) continue;
        Eigen::VectorXd across(a.tangent.size());
        for (std::size_t j = 0; j < a.points.size(); ++j)
            across.segment(static_cast<Eigen::Index>(j) * scene.map.dimension, scene.map.dimension) =
                scene.map.difference(b.points[j], a.points[j]);
        across[across.size() - 1] = b.p - a.p;
        const double h = analysis::curve_product(a.tangent, across, true, a.points.size());
        analysis::CurvePoint at;
        const auto gap = [&](const analysis::CurvePoint& point) { return point.p - p; };
        if (analysis::locate(scene.map, a, h, a.p - p, b.p - p, gap, at)) found.push_back(analysis::branch_point_at(at));
    }
    if (!branch.points.empty() && branch.points.back().at.p == p) found.push_back(branch.points.back());
    return found;
}

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

/// The branch's cycle that is the attractor's, if it is on the branch.
std::optional<analysis::BranchPoint> on_branch(const SceneBranches& scene, const analysis::Branch& branch, double p,
                                               const Attractor& attractor) {
    if (static_cast<std::int64_t>(branch.period()) != attractor.period) return std::nullopt;
    for (const auto& cycle : cycles_at(scene, branch, p))
        if (analysis::distance_between(scene.map, cycle.at.points, attractor.states) < same_cycle) return cycle;
    return std::nullopt;
}

class Search {
public:
    Search(const BifurcateOptions& options, Diagram& diagram)
        : options_(options), diagram_(diagram),
          scene_(scene_branches(column_scene(options, diagram.along, diagram.along.low), diagram.along)) {}

    void look_at(const DiagramColumn& column, const Attractor& attractor) {
        if (attractor.period == 0 || attractor.period > options_.longest_branch) return;
        for (const auto& branch : diagram_.branches)
            if (const auto cycle = on_branch(scene_, branch, column.parameter, attractor))
                return compare(*cycle, attractor);
        analysis::Branch branch;
        const auto shot = analysis::solve_shooting(scene_.map, attractor.states, column.parameter, 1e-10);
        const bool found = shot.converged &&
                           analysis::distance_between(scene_.map, shot.points, attractor.states) < same_cycle &&
                           analysis::continue_branch(scene_.map, shot.points, column.parameter, scene_.options, branch);
        if (!found) {
            ++diagram_.agreement.without;
            return;
        }
        diagram_.branches.push_back(std::move(branch));
        if (const auto cycle = on_branch(scene_, diagram_.branches.back(), column.parameter, attractor))
            compare(*cycle, attractor);
        else
            ++diagram_.agreement.without;
    }

private:
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
            search.look_at(column, attractor);
        }
        progress.at(static_cast<double>(++seen));
    }
}

}  // namespace swirl::apps
