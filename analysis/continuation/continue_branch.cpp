#include "analysis/continuation/continue_branch.hpp"

#include "analysis/continuation/border.hpp"
#include "analysis/continuation/locate.hpp"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace swirl::analysis {

double parameter_of(const ContinuationOptions& options, bool has_parameter, const CurvePoint& point) {
    return !has_parameter && options.label ? options.label(point) : point.p;
}

namespace {

constexpr double shortest_to_locate = 1e-5;  // a special point that can't be located is known to this
constexpr double least_cosine = 0.97;  // between tangents a step apart: a bend of 14 degrees

/// One way along a branch: the state of the walk.
class Walk {
public:
    Walk(const ShootingMap& map, const CurvePoint& start, const ContinuationOptions& options, Branch& branch)
        : map_(map), options_(options), branch_(branch), start_(start), h_(options.first_step) {
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
        CurvePoint next;
        failure_ = correct(map_, here(), h_, next);
        if (failure_ == Correction::converged && !goes_straight_to(next)) failure_ = Correction::failed;
        if (failure_ != Correction::converged) return shorten();
        if (const double p = value(next); p < options_.low || p > options_.high) return reach_range(next);
        if (is_halved(next)) return end(BranchEnd::halved);
        if (!accept(next, h_, shortest_to_locate)) return shorten();
        if (++successes_ > 1) h_ = std::min(1.4 * h_, options_.longest_step);
        if (has_closed()) end(BranchEnd::closed);
    }

    bool goes_straight_to(const CurvePoint& next) const {
        return curve_product(here().tangent, next.tangent, map_.has_parameter, here().points.size()) > least_cosine;
    }

    void shorten() {
        h_ *= 0.5;
        successes_ = 0;
        if (h_ < options_.shortest_step) meet_border();
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
        branch_.points.push_back(std::move(point));
        if (options_.progress) options_.progress(value(next));
        return true;
    }

    /// The last point is that at the end of the range itself.
    void reach_range(const CurvePoint& beyond) {
        const double bound = value(beyond) < options_.low ? options_.low : options_.high;
        CurvePoint last;
        const auto gap = [&](const CurvePoint& point) { return value(point) - bound; };
        if (value(here()) != bound && locate(map_, here(), h_, gap(here()), gap(beyond), gap, last)) {
            if (map_.has_parameter) last.p = bound;
            accept(last, h_, h_);
        }
        end(BranchEnd::range);
    }

    /// The map itself ends at the end of the range (e = 1), so that no step leads beyond: the cycle there, if there is one.
    void finish_at_range() {
        const double p = value(here());
        const double bound = std::abs(p - options_.low) < std::abs(p - options_.high) ? options_.low : options_.high;
        CurvePoint last;
        CyclePoints points = here().points;
        const double residual = map_.has_parameter && p != bound ? polish_cycle(map_, points, bound) : 1;
        if (residual < CorrectorOptions{}.accept && begin_curve(map_, points, bound, here().tangent, last) &&
            distance_between(map_, points, here().points) < 1e-6)
            accept(last, std::abs(p - bound), 1);
        end(BranchEnd::range);
    }

    /// Did the two halves of the cycle change places on the way? Then it went through a cycle of half the period.
    bool is_halved(const CurvePoint& next) const {
        const std::size_t k = next.points.size();
        double product = 0;
        for (std::size_t i = 0; k % 2 == 0 && i < k / 2; ++i)
            product += map_.difference(here().points[i], here().points[i + k / 2])
                           .dot(map_.difference(next.points[i], next.points[i + k / 2]));
        return product < 0;
    }

    /// Back where it began, after it had been away.
    bool has_closed() {
        const double away = std::max(std::abs(here().p - start_.p), distance_between(map_, here().points, start_.points));
        has_left_ = has_left_ || away > 3 * options_.longest_step;
        return has_left_ && away < options_.longest_step && has_start_direction();
    }

    /// The tangents agree, whichever of the cycle's points is called the first.
    bool has_start_direction() const {
        const std::size_t k = start_.points.size();
        const Eigen::Index d = map_.dimension, size = here().closing.gap.size();
        Eigen::VectorXd turned = here().tangent;
        for (std::size_t shift = 0; shift < k; ++shift) {
            for (std::size_t i = 0; i < k; ++i)
                turned.segment(static_cast<Eigen::Index>(i) * d, d) =
                    here().tangent.segment(static_cast<Eigen::Index>((i + shift) % k) * d, d);
            double away = 0;
            for (std::size_t i = 0; i < k; ++i)
                away = std::max(away, map_.distance(here().points[(i + shift) % k], start_.points[i]));
            if (away < options_.longest_step &&
                curve_product(turned, start_.tangent, turned.size() > size, k) > 0.9)
                return true;
        }
        return false;
    }

    bool is_at_range() const {
        const double p = value(here());
        return std::min(std::abs(p - options_.low), std::abs(p - options_.high)) < 1e-9 * (1 + std::abs(p));
    }

    /// No cycle with this word goes on: names the border, and goes on behind it if a cycle with another word does.
    void meet_border() {
        if (is_at_range()) return finish_at_range();
        SpecialPoint special;
        special.kind = SpecialKind::border;
        special.cycle = branch_.points.back();
        special.after = branch_.points.size() - 1;
        CurvePoint behind;
        special.goes_on = find_behind(map_, here(), special.word_after, behind);
        special.border = options_.name_border ? options_.name_border(here(), special.word_after, special.goes_on)
                                              : nameless_border;
        if (failure_ == Correction::failed && special.word_after.empty() && special.border == nameless_border)
            return end(BranchEnd::not_converged);
        branch_.special.push_back(special);
        if (!special.goes_on) return end(BranchEnd::border);
        branch_.points.push_back(branch_point_at(behind));
        h_ = options_.first_step;
        successes_ = 0;
    }

    const ShootingMap& map_;
    const ContinuationOptions& options_;
    Branch& branch_;
    CurvePoint start_;
    double h_;
    int successes_ = 0;
    Correction failure_ = Correction::converged;  ///< how the last step failed
    bool has_left_ = false;
    bool ended_ = false;
};

CurvePoint turned_back(CurvePoint point) {
    point.tangent *= -1;
    return point;
}

/// The branch walked the other way, as the first part of one.
void put_before(Branch back, Branch& forth) {
    const std::size_t count = back.points.size();  // its first is the other's first
    std::reverse(back.points.begin(), back.points.end());
    for (auto& point : back.points) point.at.tangent *= -1;
    std::reverse(back.special.begin(), back.special.end());
    for (auto& special : back.special) {
        special.cycle.at.tangent *= -1;
        special.after = count < 2 ? 0 : count - 2 - std::min(special.after, count - 2);
    }
    for (auto& special : forth.special) special.after += count - 1;
    back.points.insert(back.points.end(), forth.points.begin() + 1, forth.points.end());
    back.special.insert(back.special.end(), forth.special.begin(), forth.special.end());
    back.begin = back.end;
    back.end = forth.end;
    forth = std::move(back);
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
    if (!begin_curve(map, points, p, {}, start)) return false;
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

namespace {

/// At a flip: the cycle run through twice, and the direction in which the two rounds part.
bool doubled(const ShootingMap& map, const SpecialPoint& flip, CurvePoint& base) {
    const CurvePoint& at = flip.cycle.at;
    Eigen::VectorXd q = eigen_pair(monodromy(at.closing), -1).right.real();
    std::vector<Eigen::VectorXd> directions;
    for (int round = 0; round < 2; ++round)
        for (const auto& step : at.closing.steps) {
            directions.push_back(q);
            q = step.by_state * q;
        }
    base.p = at.p;
    base.points = at.points;
    base.points.insert(base.points.end(), at.points.begin(), at.points.end());
    base.closing = close_cycle(map, base.points, base.p);
    if (!base.closing.alive) return false;
    base.tangent = Eigen::VectorXd::Zero(base.closing.gap.size() + 1);
    base.tangent.head(base.closing.gap.size()) = stacked(directions);
    return true;
}

/// At a branch point ∂G/∂(Z, p) has two null vectors: the direction in their plane across the known branch.
bool crossing(const ShootingMap& map, const SpecialPoint& special, CurvePoint& base) {
    base = special.cycle.at;
    const Eigen::MatrixXd full = bordered(map, base.closing, base.tangent);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(full.topRows(full.rows() - 1), Eigen::ComputeFullV);
    const Eigen::MatrixXd plane = svd.matrixV().rightCols(2);
    const Eigen::Vector2d known = plane.transpose() * base.tangent;
    base.tangent = plane * Eigen::Vector2d(-known[1], known[0]);
    return base.tangent.norm() > 0;
}

}  // namespace

bool switch_branch(const ShootingMap& map, const SpecialPoint& special, const ContinuationOptions& options,
                   Branch& branch) {
    CurvePoint base;
    const bool flip = special.kind == SpecialKind::flip;
    if (flip ? !doubled(map, special, base) : !crossing(map, special, base)) return false;
    base.tangent /= std::sqrt(curve_product(base.tangent, base.tangent, true, base.points.size()));
    bool any = false;
    for (const double sign : {1.0, -1.0}) {
        // Far enough to leave the neighbourhood where both branches solve the equations to rounding.
        for (double h = options.first_step; h > 1e-6; h *= 0.25) {
            CurvePoint start;
            CorrectorOptions corrector;
            corrector.most_iterations = 20;
            corrector.farthest = 10;  // the direction lies across the known branch, not along the one sought
            if (correct(map, base, sign * h, start, corrector) != Correction::converged) continue;
            if (!flip && std::abs(curve_product(start.tangent, special.cycle.at.tangent, true, base.points.size())) >
                             least_cosine)
                continue;  // the known branch again
            if (flip && minimal_cycle(map, start.points, 0.1 * h).size() < start.points.size()) continue;
            if (curve_product(start.tangent, base.tangent, true, base.points.size()) * sign < 0) start.tangent *= -1;
            Branch half;
            follow_one_way(map, start, options, half);
            half.begin = BranchEnd::switched;
            if (!any) branch = std::move(half);
            else put_before(std::move(half), branch);
            any = true;
            break;
        }
        if (flip && any) return true;  // the other way is the same cycle begun half a period later
    }
    return any;
}

}  // namespace swirl::analysis
