#include "apps/studies/bifurcation_curves/starting_points.hpp"
#include "analysis/continuation/branch.hpp"
#include "analysis/cycles/cycle.hpp"
#include "analysis/cycles/multi_shooting.hpp"
#include "apps/studies/branches/branches.hpp"
#include "apps/studies/cycles/find_orbits.hpp"
#include "apps/studies/diagrams/attractor.hpp"
#include "apps/studies/parallel/pieces.hpp"
#include "apps/studies/scene_map/itinerary_map.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"
#include "map/steady/steady_modes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

namespace swirl::studies::bifurcation_curves {

namespace {

using analysis::Branch;

constexpr double golden_mean = 0.6180339887498949;  // its multiples are spread most evenly

/// The branches of one line, each once.
class LineSearch {
public:
    LineSearch(const Scene<double>& scene, const Plane& plane, const Line& line, const LineOptions& options)
        : options_(options),
          offset_(line.offset),
          range_(plane.axes[static_cast<std::size_t>(line.axis)]),
          scene_(scene_at(scene, plane, line.p)),
          branches_(scene_branches(scene_, range_, Accuracy::double_precision, options.control.stop)) {
        branches_.options.forms = nullptr;  // a curve has its own
    }

    /// The branches of the cycle that one start comes to.
    std::vector<Branch> find_from(double value, const MapRun& run, const MapStarts& starts) {
        const Scene<double> scene = with_parameter(scene_, *range_.parameter, value);
        look_from(value, random_start(scene.beta, starts.speed, starts.seed + run.run, 0),
                  {starts.transient, starts.collisions});
        return finish();
    }

    /// Those of one cycle.
    std::vector<Branch> find_from(double value, const analysis::CyclePoints& cycle) {
        follow(cycle, value);
        return finish();
    }

    std::vector<Branch> find() {
        if (options_.cycles == LineCycles::all && options_.max_period > 1) {
            for (int i = 0; i < options_.search_columns && !options_.control.is_stopped(); ++i)
                look_at_longer(range_.low + (i + offset_) / options_.search_columns * (range_.high - range_.low));
        }
        for (int i = 0; i < options_.columns; ++i) {
            const double value = range_.low + (i + offset_) / options_.columns * (range_.high - range_.low);
            if (options_.cycles == LineCycles::all) {
                look_at_all(value);
                continue;
            }
            const double beta = with_parameter(scene_, *range_.parameter, value).beta;
            for (int run = 0; run < options_.starts && !options_.control.is_stopped(); ++run)
                look_from(value, random_start(beta, paper_speed, 1 + static_cast<std::uint64_t>(run), 0), {});
        }
        return finish();
    }

    const std::vector<CycleSearches>& searches() const { return searches_; }

private:
    std::vector<Branch> finish() {
        follow_switches(branches_, found_, 1, static_cast<std::size_t>(options_.max_period));
        return std::move(found_);
    }

    void look_from(double value, const Start<double>& start, const diagrams::SampleSettings& settings) {
        const Scene<double> scene = with_parameter(scene_, *range_.parameter, value);
        const auto attractor = diagrams::settle(scene, start, settings, options_.control.stop);
        if (!attractor.finished || !diagrams::is_on_cycle(attractor) || attractor.period > options_.max_period) return;
        follow(diagrams::points_of(attractor), value);
    }

    /// Members of families are no start: `continue_branch` follows isolated cycles.
    void look_at_all(double value) {
        const Scene<double> scene = with_parameter(scene_, *range_.parameter, value);
        SteadyOptions steady;
        steady.longest_flight = options_.max_time;
        for (const SteadyMode& mode : steady_modes(scene, steady).modes) {
            if (options_.control.is_stopped()) return;
            follow({coordinates_of(mode.point, scene.is_disk())}, value);
        }
    }

    void look_at_longer(double value) {
        const Scene<double> scene = with_parameter(scene_, *range_.parameter, value);
        cycles::FindOptions find;
        find.candidates.starts = options_.search_starts;
        find.candidates.trajectories = options_.search_orbits;
        find.first_period = 2;
        find.last_period = options_.max_period;
        find.control = {options_.control.stop, 1};
        const auto found = cycles::find_orbits(scene, shooting_map_of(scene), find);
        for (const analysis::Cycle& cycle : found.cycles) {
            if (options_.control.is_stopped()) return;
            follow(cycle.points, value);
        }
        for (const cycles::PeriodSearch& search : found.searches)
            add_search(searches_, {search.period, 1, search.unseen.found, search.unseen.missed});
    }

    void follow(const analysis::CyclePoints& states, double value) {
        for (const auto& branch : found_)
            if (analysis::find_on_branch(branches_.map, branch, value, states)) return;
        const auto shot = analysis::solve_shooting(branches_.map, states, value, 1e-10);
        Branch branch;
        if (shot.converged && analysis::continue_branch(branches_.map, shot.points, value, branches_.options, branch))
            found_.push_back(std::move(branch));
    }

    LineOptions options_;
    double offset_;
    ParameterRange range_;
    Scene<double> scene_;
    SceneBranches branches_;
    std::vector<Branch> found_;
    std::vector<CycleSearches> searches_;
};

std::complex<double> critical_multiplier(const analysis::SpecialPoint& special) {
    if (special.kind == analysis::SpecialKind::fold) return 1;
    if (special.kind == analysis::SpecialKind::flip) return -1;
    return critical_pair(special.cycle.multipliers);
}

std::vector<StartingPoint> starting_points_of(const std::vector<Branch>& branches, const Line& line,
                                              LineCycles cycles) {
    std::vector<StartingPoint> starting_points;
    for (const auto& branch : branches) {
        for (const auto& special : branch.special) {
            if (special.kind == analysis::SpecialKind::branch_point || !special.located) continue;
            StartingPoint start{kind_of(special), special.cycle.at.points(), line.p, critical_multiplier(special)};
            name_flights(start, special.cycle.at.shooting.steps);
            for (const auto letter : special.itinerary_before) start.modes_before.push_back(letter_from(letter).mode);
            for (const auto letter : special.itinerary_after) start.modes_behind.push_back(letter_from(letter).mode);
            start.p[line.axis] = special.cycle.at.p();
            if (cycles == LineCycles::all && special.kind == analysis::SpecialKind::border &&
                has_vanishing_impact(special.cycle.at.shooting))
                start.kind = vanishing_kind;
            starting_points.push_back(std::move(start));
        }
    }
    return starting_points;
}

}  // namespace

void add_search(std::vector<CycleSearches>& all, const CycleSearches& search) {
    const auto same =
        std::find_if(all.begin(), all.end(), [&](const CycleSearches& other) { return other.period == search.period; });
    if (same == all.end()) {
        all.push_back(search);
        return;
    }
    same->places += search.places;
    same->found += search.found;
    same->missed += search.missed;
}

double offset_of_line(int i) {
    return std::fmod((i + 1) * golden_mean, 1.0);
}

std::vector<Line> lines_through(const Plane& plane, int count) {
    std::vector<Line> lines;
    for (int axis = 0; axis < 2; ++axis) {
        for (int i = 0; i < count; ++i) {
            const Eigen::Vector2d low = plane.low(), width = plane.high() - low;
            lines.push_back({axis, low + (i + 0.5) / count * width, offset_of_line(i)});
        }
    }
    return lines;
}

std::complex<double> critical_pair(const std::vector<std::complex<double>>& multipliers) {
    std::complex<double> best(std::numeric_limits<double>::quiet_NaN(), 0);
    for (const auto& m : multipliers)
        if (m.imag() > 0 && !(std::abs(std::abs(m) - 1) >= std::abs(std::abs(best) - 1))) best = m;
    return best;
}

bool has_vanishing_impact(const analysis::ShootingResidual& shooting) {
    constexpr double vanishing = 1e-4;  // of u_n, which at the last cycles before is some 10⁻⁶
    return shooting.period == 1 && shooting.steps.front().margin < vanishing;
}

void name_flights(StartingPoint& start, const std::vector<analysis::ShootingStep>& steps) {
    for (const auto& step : steps) {
        const Letter letter = letter_from(step.letter);
        if (letter.through_contact) {
            start.times.clear();
            start.vertices.clear();
            return;
        }
        start.times.push_back(step.duration);
        start.vertices.push_back(letter.vertex_step);
    }
}

std::vector<StartingPoint> starting_points_of_runs(const Scene<double>& scene, const Plane& plane,
                                                   const std::vector<MapRun>& runs, const MapStarts& starts,
                                                   const LineOptions& options) {
    std::vector<std::vector<StartingPoint>> of_runs(2 * runs.size());
    // A piece that a stop leaves alone may outlive the call: it has what it reads.
    const auto look = [scene, plane, runs, starts, options, &of_runs](std::size_t i) -> KeepResult {
        const MapRun& run = runs[i / 2];
        const Line line{static_cast<int>(i % 2), run.p};
        const auto found = std::make_shared<std::vector<StartingPoint>>(
            starting_points_of(LineSearch(scene, plane, line, options).find_from(run.p[line.axis], run, starts), line,
                               LineCycles::settled_on));
        if (options.control.is_stopped()) return {};
        return [&of_runs, i, found] { of_runs[i] = std::move(*found); };
    };
    run_pieces(of_runs.size(), "runs of the map", options.control, look);
    std::vector<StartingPoint> starting_points;
    for (auto& of_run : of_runs) starting_points.insert(starting_points.end(), of_run.begin(), of_run.end());
    return starting_points;
}

std::vector<StartingPoint> starting_points_about(const Scene<double>& scene, const Plane& plane,
                                                 const analysis::CyclePoints& cycle, const Eigen::Vector2d& p, int axis,
                                                 const LineOptions& options) {
    constexpr double reach = 0.1;
    if (options.control.is_stopped()) return {};
    const Line line{axis, p};
    Plane near = plane;
    auto& range = near.axes[static_cast<std::size_t>(axis)];
    const double width = range.high - range.low;
    range.low = std::max(range.low, p[axis] - reach * width);
    range.high = std::min(range.high, p[axis] + reach * width);
    return starting_points_of(LineSearch(scene, near, line, options).find_from(p[axis], cycle), line, options.cycles);
}

std::vector<LineStarts> starting_points_of_lines(const Scene<double>& scene, const Plane& plane,
                                                 const std::vector<Line>& lines, const LineOptions& options) {
    std::vector<LineStarts> of_lines(lines.size());
    const auto look = [scene, plane, lines, options, &of_lines](std::size_t i) -> KeepResult {
        LineSearch line(scene, plane, lines[i], options);
        const auto found = std::make_shared<LineStarts>();
        found->points = starting_points_of(line.find(), lines[i], options.cycles);
        found->searches = line.searches();
        if (options.control.is_stopped()) return {};
        return [&of_lines, i, found] { of_lines[i] = std::move(*found); };
    };
    run_pieces(lines.size(), "lines", options.control, look);
    return of_lines;
}

std::vector<StartingPoint> starting_points_on_lines(const Scene<double>& scene, const Plane& plane,
                                                    const LineOptions& options) {
    std::vector<StartingPoint> starting_points;
    for (auto& of_line : starting_points_of_lines(scene, plane, lines_through(plane, options.lines), options))
        std::move(of_line.points.begin(), of_line.points.end(), std::back_inserter(starting_points));
    return starting_points;
}

}  // namespace swirl::studies::bifurcation_curves
