#include "apps/studies/branches/branches.hpp"

#include "analysis/continuation/branch.hpp"
#include "analysis/continuation/switch_branch.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace swirl::studies {

double value_of(const Scene<double>& scene, const ParameterRange& along) {
    Scene<double> copy = scene;
    return along.parameter ? number_of(copy, *along.parameter) : 0;
}

SceneBranches scene_branches(const Scene<double>& scene, const ParameterRange& along, Accuracy accuracy,
                             const analysis::Stop& stop) {
    SceneBranches branches;
    branches.options.low = along.low;
    branches.options.high = along.high;
    branches.options.stop = stop;
    if (along.parameter) {
        const Parameter parameter = *along.parameter;
        branches.map = shooting_map_of(scene, parameter, accuracy);
        // Normal forms are of the map without drag, of sharp polygons and disks.
        if (!scene.has_own_map() && parameter != Parameter::drag && parameter != Parameter::corner)
            branches.options.forms = [scene, parameter](const analysis::CyclePoints& points, double p) {
                return scene_forms(scene, parameter, points, p);
            };
        branches.options.name_border = [scene, parameter, accuracy](const auto& last, const auto& after, bool goes_on) {
            return border_name(with_parameter(scene, parameter, last.p()), last, after, goes_on, accuracy);
        };
        return branches;
    }
    branches.map = shooting_map_of(scene, accuracy);
    const bool by_time = along.name == "tau";
    branches.options.label = [by_time](const analysis::CurvePoint& point) {
        return by_time ? point.shooting.duration : point.points().front().tail(1)[0];
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

namespace {

bool is_stopped(const SceneBranches& scene) {
    return scene.options.stop && scene.options.stop();
}

/// A special point to switch at, and where it stands.
struct Switch {
    std::size_t branch = 0, place = 0;
    analysis::SpecialPoint special;
};

/// Switches to cycles of one period, and the branches of that period, which they may lead back to.
struct Switches {
    std::vector<analysis::Branch> known;
    std::vector<Switch> switches;
};

/// By period, of the branches from `begin` on.
std::map<std::size_t, Switches> switches_of(const std::vector<analysis::Branch>& branches, std::size_t begin,
                                            std::size_t longest) {
    std::map<std::size_t, Switches> all;
    for (std::size_t b = begin; b < branches.size(); ++b) {
        const std::size_t period = branches[b].period();
        const auto parent = static_cast<std::size_t>(std::max(branches[b].parent, 0));
        const bool is_doubled = branches[b].parent >= 0 && branches[parent].period() == 2 * period;
        for (std::size_t s = 0; s < branches[b].special.size(); ++s) {
            const auto& special = branches[b].special[s];
            const bool doubles = special.kind == analysis::SpecialKind::flip;
            if (doubles ? is_doubled : special.kind != analysis::SpecialKind::branch_point) continue;
            const std::size_t wanted = (doubles ? 2 : 1) * period;
            if (wanted <= longest) all[wanted].switches.push_back({b, s, special});
        }
    }
    for (const auto& branch : branches)
        if (const auto same = all.find(branch.period()); same != all.end()) same->second.known.push_back(branch);
    return all;
}

/// Gives the branches that they lead to and that are not known yet.
void follow(const SceneBranches& scene, const Switches& all, Gathered<analysis::Branch>& gathered) {
    std::vector<analysis::Branch> found;
    for (const Switch& at : all.switches) {
        if (is_stopped(scene)) break;
        const auto is_known = [&](const analysis::CurvePoint& start) {
            const auto lies_on = [&](const analysis::Branch& known) {
                return analysis::find_on_branch(scene.map, known, start.p(), start.points()).has_value();
            };
            return std::any_of(all.known.begin(), all.known.end(), lies_on) ||
                   std::any_of(found.begin(), found.end(), lies_on);
        };
        analysis::Branch branch;
        if (!analysis::switch_branch(scene.map, at.special, scene.options, branch, is_known)) continue;
        branch.parent = static_cast<int>(at.branch);
        branch.parent_special = static_cast<int>(at.place);
        gathered.add(branch);
        found.push_back(std::move(branch));
    }
}

}  // namespace

void follow_switches(const SceneBranches& scene, std::vector<analysis::Branch>& branches, int depth,
                     std::size_t longest, const RunPieces& run) {
    // Pieces that a stop leaves alone outlive this call: they own what they read and write.
    const auto of_scene = std::make_shared<const SceneBranches>(scene);
    const auto gathered = std::make_shared<Gathered<analysis::Branch>>();
    const auto in_turn = [&scene](std::size_t count, const std::function<KeepResult(std::size_t)>& work) {
        for (std::size_t i = 0; i < count && !is_stopped(scene); ++i)
            if (const KeepResult keep = work(i)) keep();
    };
    std::size_t begin = 0;
    for (int level = 0; level < depth && scene.map.has_parameter && !is_stopped(scene); ++level) {
        std::vector<std::shared_ptr<const Switches>> periods;
        for (auto& [period, switches] : switches_of(branches, begin, longest))
            periods.push_back(std::make_shared<const Switches>(std::move(switches)));
        (run ? run : RunPieces(in_turn))(periods.size(), [of_scene, periods, gathered](std::size_t i) -> KeepResult {
            follow(*of_scene, *periods[i], *gathered);
            return [] {};
        });
        auto found = gathered->take();
        std::sort(found.begin(), found.end(), [](const analysis::Branch& a, const analysis::Branch& b) {
            return std::pair(a.parent, a.parent_special) < std::pair(b.parent, b.parent_special);
        });
        begin = branches.size();
        std::move(found.begin(), found.end(), std::back_inserter(branches));
    }
}

}  // namespace swirl::studies
