#include "analysis/continuation/continue_branch.hpp"

#include "analysis/continuation/border.hpp"
#include "analysis/continuation/special_points.hpp"
#include "analysis/cycles/family.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace swirl::analysis {

double parameter_of(const ContinuationOptions& options, const CurvePoint& point) {
    return !point.has_parameter() && options.label ? options.label(point) : point.p();
}

namespace {

constexpr double shortest_to_locate = 1e-5;  // a special point that can't be located is known to this

class BranchWalk final : public CurveWalk {
public:
    BranchWalk(const ShootingMap& map, const CurvePoint& start, const ContinuationOptions& options, Branch& branch)
        : CurveWalk(cycle_problem(map, start.shooting.period, start.p()), step_rule(options), options.stop),
          map_(map),
          options_(options),
          branch_(branch),
          start_(start) {
        branch_.points.push_back(branch_point_at(start));
    }

private:
    static StepRule step_rule(const ContinuationOptions& options) {
        return {options.first_step, options.longest_step, options.shortest_step, options.most_points};
    }

    const CurvePoint& here() const override { return branch_.points.back().at; }
    std::size_t count() const override { return branch_.points.size(); }
    double value(const CurvePoint& point) const { return parameter_of(options_, point); }

    void look_ahead() override {
        if (is_at_range() && leads_out()) finish_at_range();
    }

    bool go_to(CurvePoint next) override {
        if (const double p = value(next); p < options_.low || p > options_.high) return reach_range(next);
        if (is_halved(next)) {
            end(CurveEnd::halved);
            return true;
        }
        if (joins_family(next)) {
            end(CurveEnd::family);
            return true;
        }
        return accept(std::move(next), step_length(), shortest_to_locate);
    }

    void look_back() override {
        if (has_closed()) end(CurveEnd::closed);
    }

    /// False, and nothing is added, if a special point on the way could not be located and the step is longer than
    /// `tolerated`: a shorter one may. Where two branches cross the corrector has no curve to stay on.
    bool accept(CurvePoint next, double h, double tolerated) {
        next.y = map_.normalised(next.y, next.shooting.coordinates());
        BranchPoint point = branch_point_at(next);
        auto found = special_points_between(problem_, branch_.points.back(), h, point, options_);
        const bool all = std::all_of(found.begin(), found.end(), [](const SpecialPoint& s) { return s.located; });
        if (!all && h > tolerated) return false;
        for (auto& special : found) {
            special.after = branch_.points.size() - 1;
            branch_.special.push_back(std::move(special));
        }
        append(std::move(point));
        return true;
    }

    void append(BranchPoint point) {
        branch_.points.push_back(std::move(point));
        if (options_.progress) options_.progress(value(here()));
    }

    /// The last point is that at the end of the range itself; where no cycle is found there, a shorter step may end
    /// before it.
    bool reach_range(const CurvePoint& beyond) {
        const double bound = value(beyond) < options_.low ? options_.low : options_.high, h = step_length();
        CurvePoint last;
        const auto gap = [&](const CurvePoint& point) { return value(point) - bound; };
        if (value(here()) != bound) {
            if (!locate(problem_, here(), h, gap(here()), gap(beyond), gap, last)) return false;
            if (last.has_parameter()) last.y[last.shooting.coordinates()] = bound;
            accept(last, h, h);
        }
        end(CurveEnd::range);
        return true;
    }

    /// The map itself ends at the end of the range (e = 1), so that no step leads beyond: the cycle there, if there is
    /// one.
    void finish_at_range() {
        const double p = value(here());
        const double bound = std::abs(p - options_.low) < std::abs(p - options_.high) ? options_.low : options_.high;
        CurvePoint last;
        const CyclePoints before = here().points();
        CyclePoints points = before;
        const double residual = map_.has_parameter && p != bound ? polish_cycle(map_, points, bound) : 1;
        if (residual < problem_.newton.accept && begin_curve(map_, points, bound, here().tangent, last) &&
            distance_between(map_, points, before) < same_cycle) {
            if (is_smooth_to(last))
                accept(last, std::abs(p - bound), 1);
            else
                append(branch_point_at(last));
        }
        end(CurveEnd::range);
    }

    /// At the end of a parameter's range the impact rule may change (μ → 0) or cycles become families (β = 0): test
    /// functions are not meaningful there.
    bool is_smooth_to(const CurvePoint& last) const {
        const Eigen::MatrixXd before = here().shooting.by_points();
        return last.shooting.itinerary == here().shooting.itinerary && is_on_curve(last.shooting) &&
               (last.shooting.by_points() - before).norm() <= 1e-3 * before.norm();
    }

    /// True if the two halves of the cycle were exchanged on the way: the branch then passed a cycle of half the
    /// period.
    bool is_halved(const CurvePoint& next) const {
        const CyclePoints a = here().points(), b = next.points();
        const std::size_t k = a.size();
        double product = 0;
        for (std::size_t i = 0; k % 2 == 0 && i < k / 2; ++i)
            product += map_.difference(a[i], a[i + k / 2]).dot(map_.difference(b[i], b[i + k / 2]));
        return product < 0;
    }

    /// True if the solutions from here on form more than a curve, or a curve at one value of the parameter. Branch
    /// points and folds are isolated, so two successive points decide.
    bool joins_family(const CurvePoint& next) {
        if (!map_.has_parameter) return false;
        constexpr double level = 1e-9;
        const bool is_level = std::abs(next.parameter_slope()) < level && std::abs(here().parameter_slope()) < level &&
                              std::abs(next.p() - here().p()) < level * step_length();
        const bool was_on_curve = std::exchange(on_curve_, is_on_curve(next.shooting));
        return is_level || (!was_on_curve && !on_curve_);
    }

    /// True if the branch is back at its first point after having left its neighbourhood.
    bool has_closed() {
        const double away =
            std::max(std::abs(here().p() - start_.p()), distance_between(map_, here().points(), start_.points()));
        has_left_ = has_left_ || away > 3 * options_.longest_step;
        return has_left_ && away < options_.longest_step && has_start_direction();
    }

    /// True if the tangents agree up to a cyclic shift of the cycle's points.
    bool has_start_direction() const {
        const CyclePoints start = start_.points();
        CyclePoints points = here().points();
        Eigen::VectorXd tangent = here().tangent;
        for (std::size_t shift = 0; shift < start.size(); ++shift) {
            double away = 0;
            for (std::size_t i = 0; i < start.size(); ++i) away = std::max(away, map_.distance(points[i], start[i]));
            if (away < options_.longest_step && problem_.product(tangent, start_.tangent) > 0.9) return true;
            std::rotate(points.begin(), points.begin() + 1, points.end());
            std::rotate(tangent.begin(), tangent.begin() + map_.dimension,
                        tangent.begin() + start_.shooting.coordinates());
        }
        return false;
    }

    bool is_at_range() const {
        const double p = value(here());
        return std::min(std::abs(p - options_.low), std::abs(p - options_.high)) < 1e-9 * (1 + std::abs(p));
    }

    /// True if the branch leaves the range at its end, or runs along it.
    bool leads_out() const {
        if (!map_.has_parameter) return false;
        const bool low = std::abs(here().p() - options_.low) < std::abs(here().p() - options_.high);
        return (low ? 1 : -1) * here().parameter_slope() < 1e-9;
    }

    /// No cycle with this itinerary follows: names the border, and continues behind it if a cycle with another
    /// itinerary does.
    void meet_end(Correction why) override {
        if (is_at_range()) return finish_at_range();
        SpecialPoint special;
        special.kind = SpecialKind::border;
        special.cycle = branch_.points.back();
        special.itinerary_before = here().shooting.itinerary;
        special.after = branch_.points.size() - 1;
        CurvePoint behind;
        special.goes_on = find_behind(map_, here(), special.itinerary_after, behind);
        special.border = options_.name_border ? options_.name_border(here(), special.itinerary_after, special.goes_on)
                                              : nameless_border;
        if (why == Correction::failed && special.itinerary_after.empty() && special.border == nameless_border)
            return end(CurveEnd::not_converged);
        if (!special.goes_on) extrapolate_to_border(map_, special.cycle.at);
        branch_.special.push_back(special);
        if (!special.goes_on) return end(CurveEnd::border);
        branch_.points.push_back(branch_point_at(behind));
        begin_anew();
    }

    const ShootingMap& map_;
    const ContinuationOptions& options_;
    Branch& branch_;
    CurvePoint start_;
    bool has_left_ = false;
    bool on_curve_ = true;  ///< whether the last point that was tried was on a curve
};

}  // namespace

Branch follow_one_way(const ShootingMap& map, const CurvePoint& start, const ContinuationOptions& options) {
    Branch branch;
    branch.end = BranchWalk(map, start, options, branch).run();
    return branch;
}

bool continue_branch(const ShootingMap& map, const CyclePoints& cycle, double p, const ContinuationOptions& options,
                     Branch& branch) {
    if (map.has_parameter && (p < options.low || p > options.high)) return false;
    CyclePoints points = cycle;
    polish_cycle(map, points, p);
    CurvePoint start;
    if (!begin_curve(map, points, p, {}, start) || !is_on_curve(start.shooting)) return false;
    const double value = parameter_of(options, start);
    if (value < options.low || value > options.high) return false;
    branch = both_ways(start, [&](const CurvePoint& from) { return follow_one_way(map, from, options); });
    return true;
}

}  // namespace swirl::analysis
