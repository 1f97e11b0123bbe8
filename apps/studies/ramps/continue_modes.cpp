#include "analysis/continuation/branch.hpp"
#include "analysis/continuation/continue_branch.hpp"
#include "analysis/cycles/multi_shooting.hpp"
#include "analysis/ramps/fold_delay.hpp"
#include "analysis/special_values.hpp"
#include "apps/studies/ramps/ramp.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace swirl::studies::ramps {

namespace {

/// A place on a branch: between points `after` and `after` + 1, in the direction of rising or falling numbers.
struct Way {
    std::size_t from = 0;
    bool forward = true;
};

/// The branch's point that is nearest to the cycle, and which way the parameter goes on from there.
Way way_from(const SceneBranches& scene, const analysis::Branch& branch, double p, const analysis::CyclePoints& cycle,
             bool rising) {
    Way way;
    double nearest = analysis::infinity;
    for (std::size_t i = 0; i < branch.points.size(); ++i) {
        const analysis::CurvePoint& at = branch.points[i].at;
        const double away = std::hypot(analysis::distance_between(scene.map, at.points(), cycle),
                                       analysis::parameter_of(scene.options, at) - p);
        if (away >= nearest) continue;
        nearest = away;
        way.from = i;
    }
    way.forward = (branch.points[way.from].at.parameter_slope() > 0) == rising;
    return way;
}

/// Does the mode end there? A border that a cycle crosses, stable on both sides, does not end it.
bool ends_at(const analysis::Branch& branch, const analysis::SpecialPoint& special) {
    if (special.kind != analysis::SpecialKind::border || !special.goes_on) return true;
    const auto stable = [&](std::size_t i) {
        return i < branch.points.size() && branch.points[i].stability == analysis::Stability::stable;
    };
    return !(stable(special.after) && stable(special.after + 1));
}

/// The first special point on the way at which the mode ends.
const analysis::SpecialPoint* first_end(const analysis::Branch& branch, const Way& way) {
    if (way.forward) {
        for (const analysis::SpecialPoint& special : branch.special)
            if (special.after >= way.from && ends_at(branch, special)) return &special;
    } else {
        for (auto special = branch.special.rbegin(); special != branch.special.rend(); ++special)
            if (special->after < way.from && ends_at(branch, *special)) return &*special;
    }
    return nullptr;
}

/// The largest coordinate, over all points of the cycle, of its fold's critical direction, whose length is 1 at the
/// first point. The branch's tangent there is that direction.
double largest_part(const analysis::SpecialPoint& fold) {
    const analysis::CurvePoint& at = fold.cycle.at;
    const Eigen::Index dimension = at.points().front().size();
    const Eigen::VectorXd direction = at.tangent.head(at.shooting.coordinates());
    return direction.lpNorm<Eigen::Infinity>() / direction.head(dimension).norm();
}

BranchEnd end_of(const RampSettings& settings, const SceneBranches& scene, const analysis::Branch& branch,
                 const RampMode& mode, double p, const analysis::CyclePoints& cycle) {
    const Way way = way_from(scene, branch, p, cycle, mode.rising);
    BranchEnd end;
    bool goes_on = false;  // beyond the range, whose end is no place to be left at
    end.delay = end.predicted = analysis::nan;
    if (const analysis::SpecialPoint* special = first_end(branch, way)) {
        end.kind = kind_of(*special);
        end.parameter = analysis::parameter_of(scene.options, special->cycle.at);
        if (special->kind == analysis::SpecialKind::fold && special->normal_form)
            end.predicted =
                analysis::fold_delay(special->normal_form->parameter.real(), special->normal_form->nonlinear.real(),
                                     settings.rate() * mode.round, settings.period.tolerance / largest_part(*special));
    } else {
        const analysis::CurveEnd ending = way.forward ? branch.end : branch.begin;
        goes_on = ending == analysis::CurveEnd::range;
        end.kind = name_of(ending);
        const auto& last = way.forward ? branch.points.back() : branch.points.front();
        end.parameter = analysis::parameter_of(scene.options, last.at);
    }
    if (mode.left && !goes_on) end.delay = (mode.rising ? 1 : -1) * (mode.left_at - end.parameter);
    return end;
}

double kept_for(const RampMode& mode, const Ramp& ramp) {
    return (mode.left ? mode.time : ramp.time) - mode.kept_at;
}

/// For how long a mode was kept, at least, that is among those that are continued: chaos passes unstable cycles often.
double least_kept(const Ramp& ramp) {
    constexpr std::ptrdiff_t most = 50;
    std::vector<double> times;
    for (const RampMode& mode : ramp.modes) times.push_back(kept_for(mode, ramp));
    if (std::ssize(times) <= most) return 0;
    std::nth_element(times.begin(), times.begin() + most, times.end(), std::greater<>());
    return times[static_cast<std::size_t>(most)];
}

}  // namespace

RampBranches continue_modes(const RampSettings& settings, const RunControl& control, const Ramp& ramp) {
    RampBranches found;
    const Scene<double> scene =
        with_parameter(settings.scene, *settings.along.parameter, (settings.begin() + settings.end()) / 2);
    found.scene = scene_branches(scene, settings.along, settings.accuracy, control.stop);
    const ReportDone done = control.begin("branches", static_cast<double>(ramp.modes.size()));
    const double least = least_kept(ramp);
    for (const RampMode& mode : ramp.modes) {
        if (control.is_stopped()) break;
        BranchEnd none;
        none.parameter = none.delay = none.predicted = analysis::nan;
        found.ends.push_back(none);
        if (kept_for(mode, ramp) < least) continue;
        const auto shot = analysis::solve_shooting(found.scene.map, mode.points, mode.seen_at, 1e-10);
        if (!shot.converged) continue;
        const auto known = std::find_if(found.branches.begin(), found.branches.end(), [&](const auto& branch) {
            return branch.period() == shot.points.size() &&
                   analysis::find_on_branch(found.scene.map, branch, mode.seen_at, shot.points).has_value();
        });
        if (known != found.branches.end()) {
            found.ends.back() = end_of(settings, found.scene, *known, mode, mode.seen_at, shot.points);
            continue;
        }
        analysis::Branch branch;
        if (!analysis::continue_branch(found.scene.map, shot.points, mode.seen_at, found.scene.options, branch))
            continue;
        found.ends.back() = end_of(settings, found.scene, branch, mode, mode.seen_at, shot.points);
        found.branches.push_back(std::move(branch));
        done(static_cast<double>(found.ends.size()));
    }
    found.ends.resize(ramp.modes.size(), {"", analysis::nan, analysis::nan, analysis::nan});
    return found;
}

}  // namespace swirl::studies::ramps
