#include "analysis/cycles/family.hpp"

#include "analysis/curves/walk.hpp"
#include "analysis/cycles/multi_shooting.hpp"
#include "analysis/linear_algebra/dense.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace swirl::analysis {

namespace {

Equations equations_of(const ShootingMap& map, const std::function<ShootingStep(const Eigen::VectorXd&, double)>& step,
                       double p) {
    return [&map, &step, p](const Eigen::VectorXd& y) { return shooting_residual(map, step, y, p); };
}

/// A direction that the curve has a part of: the null vector of the Jacobian's smallest singular value.
Eigen::VectorXd null_direction(const ShootingResidual& shooting, bool has_parameter) {
    const SingularVectors svd = right_singular_vectors(shooting.jacobian);
    Eigen::VectorXd direction = svd.right.rightCols(1);
    Eigen::Index lead = direction.size() - 1;
    if (!has_parameter || std::abs(direction[lead]) < 1e-6) direction.cwiseAbs().maxCoeff(&lead);
    if (direction[lead] < 0) direction *= -1;
    return direction;
}

}  // namespace

CurveProblem cycle_problem(const ShootingMap& map, std::size_t k, double p) {
    const Eigen::Index coordinates = map.dimension * static_cast<Eigen::Index>(k);
    CurveProblem problem;
    problem.weights =
        Eigen::VectorXd::Constant(coordinates + (map.has_parameter ? 1 : 0), 1.0 / static_cast<double>(k));
    if (map.has_parameter) problem.weights[coordinates] = 1;
    problem.equations = equations_of(map, map.step, p);
    if (map.step_from_surface) problem.equations_from_surface = equations_of(map, map.step_from_surface, p);
    problem.newton.goal = 1e-14;
    problem.newton.accept = 1e-12;
    problem.newton.most_iterations = 10;
    problem.locate.bits = 52;
    problem.locate.most_trials = 100;
    return problem;
}

bool is_on_curve(const ShootingResidual& shooting) {
    Eigen::MatrixXd scaled = shooting.jacobian;
    equilibrate(scaled);
    return rank_of(scaled, null_margin) == scaled.cols() - 1;
}

bool begin_curve(const ShootingMap& map, const CyclePoints& points, double p, const Eigen::VectorXd& previous,
                 CurvePoint& point) {
    const CurveProblem problem = cycle_problem(map, points.size(), p);
    point.y.resize(problem.weights.size());
    point.y.head(problem.weights.size() - (map.has_parameter ? 1 : 0)) = stacked(points);
    if (map.has_parameter) point.y[point.y.size() - 1] = p;
    point.shooting = problem.equations(point.y);
    if (!point.shooting.alive) return false;
    return find_tangent(problem, previous.size() > 0 ? previous : null_direction(point.shooting, map.has_parameter),
                        point);
}

Eigen::VectorXd across(const ShootingMap& map, const CurvePoint& from, const CyclePoints& to, double p) {
    const Eigen::Index coordinates = from.shooting.coordinates();
    Eigen::VectorXd y(from.y.size());
    y.head(coordinates) = stacked(to);
    if (map.has_parameter) y[coordinates] = p;
    return map.difference(y, from.y, coordinates);
}

namespace {

/// Of a cycle's family at p. It goes on where sticking becomes sliding, with a kink at most.
CurveProblem family_problem(const ShootingMap& map, std::size_t k, double p) {
    CurveProblem problem = cycle_problem(map, k, p);
    problem.keeps_itinerary = false;
    problem.locate.takes_middle = false;
    return problem;
}

/// One way, the start excluded.
class FamilyWalk final : public CurveWalk {
public:
    FamilyWalk(const ShootingMap& map, double p, const CurvePoint& start, const FamilyOptions& options)
        : CurveWalk(family_problem(map, start.shooting.period, p), step_rule(options), {}),
          map_(map),
          options_(options),
          start_(start) {}

    std::vector<CurvePoint> members;

private:
    static StepRule step_rule(const FamilyOptions& options) {
        return {options.step, options.step, options.shortest, options.most_steps, 1.5, 0, family_cosine};
    }

    const CurvePoint& here() const override { return members.empty() ? start_ : members.back(); }
    std::size_t count() const override { return members.size(); }
    void meet_end(Correction) override { end(CurveEnd::border); }

    bool go_to(CurvePoint next) override {
        next.y = map_.normalised(next.y, next.y.size());
        members.push_back(std::move(next));
        return true;
    }

    void look_back() override {
        const double away = distance_between(map_, here().points(), start_.points());
        has_left_ = has_left_ || away > 3 * options_.step;
        if (has_left_ && away < options_.step && problem_.product(here().tangent, start_.tangent) > 0.9)
            end(CurveEnd::closed);
    }

    const ShootingMap& map_;
    const FamilyOptions& options_;
    CurvePoint start_;
    bool has_left_ = false;
};

}  // namespace

FamilyCurve walk_family(const ShootingMap& map, double p, const Cycle& cycle, const FamilyOptions& options) {
    FamilyCurve family;
    family.p = p;
    CurvePoint start;
    if (!begin_curve(map, cycle.points, p, {}, start)) return family;
    CurvePoint backwards = start;
    turn(backwards);
    FamilyWalk back(map, p, backwards, options), forth(map, p, start, options);
    family.closed = back.run() == CurveEnd::closed;
    for (auto& member : back.members) turn(member);
    family.members.assign(back.members.rbegin(), back.members.rend());
    family.members.push_back(start);
    if (family.closed) return family;
    forth.run();
    family.members.insert(family.members.end(), forth.members.begin(), forth.members.end());
    return family;
}

std::vector<CyclePoints> pinned_members(const ShootingMap& map, const FamilyCurve& family,
                                        const std::function<double(const CurvePoint&)>& value, double goal) {
    std::vector<CyclePoints> found;
    const auto gap = [&](const CurvePoint& member) { return value(member) - goal; };
    for (std::size_t i = 0; i + 1 < family.members.size(); ++i) {
        const CurvePoint& a = family.members[i];
        const CurvePoint& b = family.members[i + 1];
        const double low = gap(a), high = gap(b);
        if (low == 0) found.push_back(a.points());
        const CurveProblem problem = family_problem(map, a.shooting.period, family.p);
        CurvePoint member;
        if (locate(problem, a, problem.product(a.tangent, across(map, a, b.points(), family.p)), low, high, gap,
                   member))
            found.push_back(member.points());
    }
    return found;
}

bool belongs_to(const ShootingMap& map, const FamilyCurve& curve, const CyclePoints& b) {
    const CurveProblem problem = family_problem(map, b.size(), curve.p);
    for (const CurvePoint& member : curve.members) {
        if (distance_between(map, member.points(), b) > 0.02) continue;
        // From the member along its tangent to where b should be: the curve is there exactly, or b is not on it.
        CyclePoints shifted = b;
        for (std::size_t shift = 0; shift < b.size(); ++shift) {
            CurvePoint there;
            const double h = problem.product(member.tangent, across(map, member, shifted, curve.p));
            // How far from b is asked next.
            if (std::abs(h) < 0.03 && correct(problem, member, h, there, infinity) == Correction::converged &&
                distance_between(map, there.points(), b) < same_cycle)
                return true;
            std::rotate(shifted.begin(), shifted.begin() + 1, shifted.end());
        }
    }
    return false;
}

bool is_reachable(const ShootingMap& map, double p, const CyclePoints& a, const CyclePoints& b) {
    constexpr double longest = 0.1;
    CyclePoints here = a;
    double left = infinity;
    for (int step = 0; step < 200; ++step) {
        Eigen::VectorXd across(static_cast<Eigen::Index>(here.size()) * map.dimension);
        for (std::size_t i = 0; i < here.size(); ++i)
            across.segment(static_cast<Eigen::Index>(i) * map.dimension, map.dimension) = map.difference(b[i], here[i]);
        const double distance = across.lpNorm<Eigen::Infinity>();
        if (distance < same_cycle) return true;
        if (!(distance < left - 0.1 * std::min(left, longest))) return false;  // it leads away
        left = distance;
        if (distance > longest) across *= longest / distance;
        for (std::size_t i = 0; i < here.size(); ++i)
            here[i] += across.segment(static_cast<Eigen::Index>(i) * map.dimension, map.dimension);
        if (!(polish_cycle(map, here, p, 1e-10) <= 1e-9)) return false;
    }
    return false;
}

}  // namespace swirl::analysis
