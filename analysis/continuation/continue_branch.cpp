#include "analysis/continuation/continue_branch.hpp"

#include "analysis/continuation/border.hpp"
#include "analysis/continuation/locate.hpp"
#include "analysis/continuation/step_length.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swirl::analysis {

double parameter_of(const ContinuationOptions& options, bool has_parameter, const CurvePoint& point) {
    return !has_parameter && options.label ? options.label(point) : point.p;
}

namespace {

constexpr double shortest_to_locate = 1e-5;  // a special point that can't be located is known to this

/// One way along a branch: the state of the walk.
class Walk {
public:
    Walk(const ShootingMap& map, const CurvePoint& start, const ContinuationOptions& options, Branch& branch)
        : map_(map),
          options_(options),
          branch_(branch),
          start_(start),
          h_(options.first_step, options.longest_step, options.shortest_step) {
        branch_.points.push_back(branch_point_at(start));
    }

    void run() {
        while (!ended_) step();  // ends: every step goes on, or halves h down to the shortest
    }

private:
    const CurvePoint& here() const { return branch_.points.back().at; }
    double value(const CurvePoint& point) const { return parameter_of(options_, map_.has_parameter, point); }

    void end(BranchEnd why) {
        branch_.end = why;
        ended_ = true;
    }

    void step() {
        if (options_.stop && options_.stop()) return end(BranchEnd::stopped);
        if (static_cast<int>(branch_.points.size()) >= options_.most_points) return end(BranchEnd::most_points);
        if (is_at_range() && leads_out()) return finish_at_range();
        CurvePoint next;
        failure_ = correct(map_, here(), h_.value(), next);
        if (failure_ == Correction::converged && !goes_straight_to(next)) failure_ = Correction::failed;
        if (failure_ != Correction::converged) return shorten();
        if (const double p = value(next); p < options_.low || p > options_.high) return reach_range(next);
        if (is_halved(next)) return end(BranchEnd::halved);
        if (joins_family(next)) return end(BranchEnd::family);
        if (!accept(next, h_.value(), shortest_to_locate)) return shorten();
        h_.succeed();
        if (has_closed()) end(BranchEnd::closed);
    }

    bool goes_straight_to(const CurvePoint& next) const {
        return curve_product(here().tangent, next.tangent, map_.has_parameter, here().points.size()) > least_cosine;
    }

    void shorten() {
        if (!h_.shorten()) meet_border();
    }

    /// False, and nothing is added, if a special point on the way could not be located and the step is longer than
    /// `tolerated`: a shorter one may. Where two branches cross the corrector has no curve to stay on.
    bool accept(CurvePoint next, double h, double tolerated) {
        for (auto& z : next.points) z = map_.normalised(z);
        BranchPoint point = branch_point_at(next);
        auto found = special_points_between(map_, branch_.points.back(), h, point, options_);
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
    void reach_range(const CurvePoint& beyond) {
        const double bound = value(beyond) < options_.low ? options_.low : options_.high;
        CurvePoint last;
        const auto gap = [&](const CurvePoint& point) { return value(point) - bound; };
        if (value(here()) != bound) {
            if (!locate(map_, here(), h_.value(), gap(here()), gap(beyond), gap, last)) return shorten();
            if (map_.has_parameter) last.p = bound;
            accept(last, h_.value(), h_.value());
        }
        end(BranchEnd::range);
    }

    /// The map itself ends at the end of the range (e = 1), so that no step leads beyond: the cycle there, if there is
    /// one.
    void finish_at_range() {
        const double p = value(here());
        const double bound = std::abs(p - options_.low) < std::abs(p - options_.high) ? options_.low : options_.high;
        CurvePoint last;
        CyclePoints points = here().points;
        const double residual = map_.has_parameter && p != bound ? polish_cycle(map_, points, bound) : 1;
        if (residual < CorrectorOptions{}.accept && begin_curve(map_, points, bound, here().tangent, last) &&
            distance_between(map_, points, here().points) < same_cycle) {
            if (is_smooth_to(last))
                accept(last, std::abs(p - bound), 1);
            else
                append(branch_point_at(last));
        }
        end(BranchEnd::range);
    }

    /// At the end of a parameter's range the impact rule may change (μ → 0) or cycles become families (β = 0): test
    /// functions are not meaningful there.
    bool is_smooth_to(const CurvePoint& last) const {
        const Eigen::MatrixXd& before = here().shooting.by_points;
        return word_of(last.shooting) == word_of(here().shooting) && is_on_curve(map_, last.shooting) &&
               (last.shooting.by_points - before).norm() <= 1e-3 * before.norm();
    }

    /// True if the two halves of the cycle were exchanged on the way: the branch then passed a cycle of half the
    /// period.
    bool is_halved(const CurvePoint& next) const {
        const std::size_t k = next.points.size();
        double product = 0;
        for (std::size_t i = 0; k % 2 == 0 && i < k / 2; ++i)
            product += map_.difference(here().points[i], here().points[i + k / 2])
                           .dot(map_.difference(next.points[i], next.points[i + k / 2]));
        return product < 0;
    }

    /// True if the solutions from here on form more than a curve, or a curve at one value of the parameter. Branch
    /// points and folds are isolated, so two successive points decide.
    bool joins_family(const CurvePoint& next) {
        if (!map_.has_parameter) return false;
        constexpr double level = 1e-9;
        const bool is_level = std::abs(next.parameter_slope()) < level && std::abs(here().parameter_slope()) < level &&
                              std::abs(next.p - here().p) < level * h_.value();
        const bool was_on_curve = std::exchange(on_curve_, is_on_curve(map_, next.shooting));
        return is_level || (!was_on_curve && !on_curve_);
    }

    /// True if the branch is back at its first point after having left its neighbourhood.
    bool has_closed() {
        const double away =
            std::max(std::abs(here().p - start_.p), distance_between(map_, here().points, start_.points));
        has_left_ = has_left_ || away > 3 * options_.longest_step;
        return has_left_ && away < options_.longest_step && has_start_direction();
    }

    /// True if the tangents agree up to a cyclic shift of the cycle's points.
    bool has_start_direction() const {
        const std::size_t k = start_.points.size();
        const Eigen::Index d = map_.dimension, size = here().shooting.gap.size();
        Eigen::VectorXd turned = here().tangent;
        for (std::size_t shift = 0; shift < k; ++shift) {
            for (std::size_t i = 0; i < k; ++i)
                turned.segment(static_cast<Eigen::Index>(i) * d, d) =
                    here().tangent.segment(static_cast<Eigen::Index>((i + shift) % k) * d, d);
            double away = 0;
            for (std::size_t i = 0; i < k; ++i)
                away = std::max(away, map_.distance(here().points[(i + shift) % k], start_.points[i]));
            if (away < options_.longest_step && curve_product(turned, start_.tangent, turned.size() > size, k) > 0.9)
                return true;
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
        const bool low = std::abs(here().p - options_.low) < std::abs(here().p - options_.high);
        return (low ? 1 : -1) * here().parameter_slope() < 1e-9;
    }

    /// No cycle with this itinerary follows: names the border, and continues behind it if a cycle with another
    /// itinerary does.
    void meet_border() {
        if (is_at_range()) return finish_at_range();
        SpecialPoint special;
        special.kind = SpecialKind::border;
        special.cycle = branch_.points.back();
        special.word_before = word_of(here().shooting);
        special.after = branch_.points.size() - 1;
        CurvePoint behind;
        special.goes_on = find_behind(map_, here(), special.word_after, behind);
        special.border =
            options_.name_border ? options_.name_border(here(), special.word_after, special.goes_on) : nameless_border;
        if (failure_ == Correction::failed && special.word_after.empty() && special.border == nameless_border)
            return end(BranchEnd::not_converged);
        if (!special.goes_on) extrapolate_to_border(map_, special.cycle.at);
        branch_.special.push_back(special);
        if (!special.goes_on) return end(BranchEnd::border);
        branch_.points.push_back(branch_point_at(behind));
        h_.begin_anew();
    }

    const ShootingMap& map_;
    const ContinuationOptions& options_;
    Branch& branch_;
    CurvePoint start_;
    StepLength h_;
    Correction failure_ = Correction::converged;  ///< how the last step failed
    bool has_left_ = false;
    bool on_curve_ = true;  ///< whether the last point that was tried was on a curve
    bool ended_ = false;
};

CurvePoint turned_back(CurvePoint point) {
    point.tangent *= -1;
    return point;
}

}  // namespace

void follow_one_way(const ShootingMap& map, const CurvePoint& start, const ContinuationOptions& options,
                    Branch& branch) {
    branch = {};
    Walk(map, start, options, branch).run();
}

bool continue_branch(const ShootingMap& map, const CyclePoints& cycle, double p, const ContinuationOptions& options,
                     Branch& branch) {
    if (map.has_parameter && (p < options.low || p > options.high)) return false;
    CyclePoints points = cycle;
    polish_cycle(map, points, p);
    CurvePoint start;
    if (!begin_curve(map, points, p, {}, start) || !is_on_curve(map, start.shooting)) return false;
    const double value = parameter_of(options, map.has_parameter, start);
    if (value < options.low || value > options.high) return false;
    follow_one_way(map, start, options, branch);
    if (branch.end == BranchEnd::closed || branch.end == BranchEnd::stopped) {
        branch.begin = branch.end;
        return true;
    }
    Branch back;
    follow_one_way(map, turned_back(start), options, back);
    put_before(std::move(back), branch);
    return true;
}

}  // namespace swirl::analysis
