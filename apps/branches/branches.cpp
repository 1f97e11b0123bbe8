#include "apps/branches/branches.hpp"

#include "analysis/continuation/on_branch.hpp"
#include "analysis/continuation/switch_branch.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/system/shooting_map.hpp"

#include <algorithm>

namespace swirl::apps {

double value_of(const Scene<double>& scene, const ParameterRange& along) {
    Scene<double> copy = scene;
    return along.parameter ? number_of(copy, *along.parameter) : 0;
}

SceneBranches scene_branches(const Scene<double>& scene, const ParameterRange& along, Accuracy accuracy) {
    SceneBranches branches;
    branches.options.low = along.low;
    branches.options.high = along.high;
    branches.options.stop = is_interrupted;
    if (along.parameter) {
        const Parameter parameter = *along.parameter;
        branches.map = shooting_map_of(scene, parameter, accuracy);
        branches.options.forms = [scene, parameter](const analysis::CyclePoints& points, double p) {
            return scene_forms(scene, parameter, points, p);
        };
        branches.options.name_border = [scene, parameter, accuracy](const auto& last, const auto& after, bool goes_on) {
            return border_name(with_parameter(scene, parameter, last.p), last, after, goes_on, accuracy);
        };
        return branches;
    }
    branches.map = shooting_map_of(scene, accuracy);
    const bool by_time = along.name == "tau";
    branches.options.label = [by_time](const analysis::CurvePoint& point) {
        return by_time ? point.shooting.duration : point.points.front()[point.points.front().size() - 1];
    };
    branches.options.name_border = [scene, accuracy](const auto& last, const auto& after, bool goes_on) {
        return border_name(scene, last, after, goes_on, accuracy);
    };
    return branches;
}

std::string kind_of(const analysis::SpecialPoint& special) {
    return special.kind == analysis::SpecialKind::border ? special.border
                                                         : std::string(analysis::name_of(special.kind));
}

void follow_switches(const SceneBranches& scene, std::vector<analysis::Branch>& branches, int depth,
                     std::size_t longest) {
    std::size_t begin = 0;
    for (int level = 0; level < depth && scene.map.has_parameter; ++level) {
        const std::size_t end = branches.size();
        for (std::size_t b = begin; b < end; ++b) {
            for (std::size_t s = 0; s < branches[b].special.size() && !is_interrupted(); ++s) {
                const auto special = branches[b].special[s];
                if (special.kind != analysis::SpecialKind::flip && special.kind != analysis::SpecialKind::branch_point)
                    continue;
                if (special.kind == analysis::SpecialKind::flip && branches[b].parent >= 0 &&
                    branches[static_cast<std::size_t>(branches[b].parent)].period() == 2 * branches[b].period())
                    continue;
                const bool doubles = special.kind == analysis::SpecialKind::flip;
                if ((doubles ? 2 : 1) * branches[b].period() > longest) continue;
                analysis::Branch branch;
                const auto is_known = [&](const analysis::CurvePoint& start) {
                    return std::any_of(branches.begin(), branches.end(), [&](const analysis::Branch& known) {
                        return analysis::find_on_branch(scene.map, known, start.p, start.points).has_value();
                    });
                };
                if (!analysis::switch_branch(scene.map, special, scene.options, branch, is_known)) continue;
                branch.parent = static_cast<int>(b);
                branch.parent_special = static_cast<int>(s);
                branches.push_back(std::move(branch));
            }
        }
        begin = end;
    }
}

}  // namespace swirl::apps
