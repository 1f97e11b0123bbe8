#include "apps/studies/bifurcation_curves/border_curve.hpp"

#include "analysis/continuation/normal_form.hpp"
#include "analysis/cycles/cycle.hpp"
#include "analysis/linear_algebra/dense.hpp"
#include "analysis/within_period.hpp"
#include "apps/studies/bifurcation_curves/border_system.hpp"
#include "apps/studies/bifurcation_curves/born_curves.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::studies::bifurcation_curves {

namespace {

std::vector<analysis::TestFunction> tests_of(const ItineraryMap& map, const BorderCycle& like) {
    const std::string border(name_of(like.touch));
    const auto shifted = [map, like](double by) {
        return [map, like, by](const analysis::CurvePoint& at) {
            const Eigen::MatrixXd a = monodromy_of(map, like, at.y);
            return analysis::determinant_of(a + by * Eigen::MatrixXd::Identity(a.rows(), a.cols()));
        };
    };
    const auto pairs = [map, like](const analysis::CurvePoint& at) {
        return analysis::neimark_sacker_function(analysis::sorted_multipliers(monodromy_of(map, like, at.y)));
    };
    std::vector<analysis::TestFunction> tests{
        {"fold-" + border, shifted(-1)}, {"flip-" + border, shifted(1)}, {"neimark-sacker-" + border, pairs}};
    if (like.touch != Touch::grazing) return tests;
    const auto with_impact = [map, like](double multiplier) {
        return [map, like, multiplier](const analysis::CurvePoint& at) {
            return grazing_determinant(map, border_cycle_at(map, like, at.y), multiplier);
        };
    };
    tests.push_back({fold_of_impact, with_impact(1)});
    tests.push_back({flip_of_impact, with_impact(-1)});
    return tests;
}

/// b's unknowns with whole turns added to its angles, so that they lie nearest to a's.
Eigen::VectorXd turned_to(const ItineraryMap& map, const Eigen::VectorXd& a, Eigen::VectorXd b,
                          Eigen::Index coordinates) {
    for (Eigen::Index i = 0; i < coordinates; ++i)
        if (const double period = map.angle_periods[static_cast<std::size_t>(i % map.dimension)]; period > 0)
            b[i] = a[i] + analysis::within_period(b[i] - a[i], period);
    return b;
}

analysis::PlaneCurveOptions options_of(const ItineraryMap& map, const Plane& plane, const BorderCycle& cycle,
                                       const BorderOptions& options) {
    analysis::PlaneCurveOptions arc;
    arc.low = plane.low();
    arc.high = plane.high();
    arc.parameters = layout_of(map, cycle).parameters();
    arc.steps.longest = options.longest_step;
    arc.steps.first = std::min(arc.steps.first, options.longest_step);
    arc.tests = tests_of(map, cycle);
    arc.accepts = [map, cycle](const analysis::CurvePoint& at) { return refusal_of(map, cycle, at.y); };
    arc.turned_to = [map, n = arc.parameters](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
        return turned_to(map, a, b, n);
    };
    arc.stop = options.stop;
    return arc;
}

/// The cycle, solved, on the border itself; false if it is none.
bool begin(const ItineraryMap& map, const Plane& plane, const BorderCycle& cycle, const analysis::CurveProblem& problem,
           analysis::CurvePoint& start) {
    constexpr double farthest = 0.05;  // starting points lie within 10⁻³, times of grazing within their samples
    const Eigen::VectorXd y = unknowns_of(map, cycle);
    Eigen::VectorXd along = Eigen::VectorXd::Zero(y.size());
    along[layout_of(map, cycle).parameters()] = 1;
    if (!analysis::find_point(problem, y, along, farthest, start)) return false;
    if (!is_in(plane, start.y.segment<2>(layout_of(map, cycle).parameters()))) return false;
    return refusal_of(map, cycle, start.y).empty();
}

/// Are the two turns of the cycle the same, but for the way that a step leads beyond? There its curve ends at a flip.
bool is_halved(const ItineraryMap& map, const BorderCycle& like, const Eigen::VectorXd& y) {
    constexpr double same = 1e-3;
    const BorderLayout layout = layout_of(map, like);
    if (layout.period % 2 != 0) return false;
    const Eigen::Index half = layout.parameters() / 2, turn = layout.period / 2;
    const Eigen::VectorXd first = y.head(half);
    const Eigen::VectorXd second = turned_to(map, first, y.segment(half, half), half);
    const Eigen::VectorXd times = y.segment(layout.time(0), turn) - y.segment(layout.time(turn), turn);
    return (second - first).lpNorm<Eigen::Infinity>() < same && times.lpNorm<Eigen::Infinity>() < same;
}

std::string ending_of(const analysis::CurveEnding& ending, bool halved) {
    const bool fails = ending == analysis::CurveEnd::border || ending == analysis::CurveEnd::not_converged;
    return halved && fails ? "halved" : name_of(ending);
}

CurveCycle cycle_at(const ItineraryMap& map, const BorderCycle& like, const Eigen::VectorXd& y) {
    const BorderLayout layout = layout_of(map, like);
    CurveCycle cycle;
    cycle.parameters = y.segment<2>(layout.parameters());
    const Eigen::VectorXd z = turned_to(map, Eigen::VectorXd::Zero(y.size()), y, layout.parameters());
    cycle.points = analysis::unstacked(z.head(layout.parameters()), map.dimension);
    cycle.multipliers = analysis::sorted_multipliers(monodromy_of(map, like, y));
    cycle.border = border_cycle_at(map, like, y);
    cycle.border->points = cycle.points;
    return cycle;
}

}  // namespace

bool has_pair_on_circle(const std::vector<std::complex<double>>& multipliers) {
    return std::any_of(multipliers.begin(), multipliers.end(),
                       [](const auto& m) { return m.imag() > 1e-6 && std::abs(std::abs(m) - 1) < 1e-6; });
}

std::optional<BorderCurve> follow_border(const ItineraryMap& map, const Plane& plane, const BorderCycle& cycle,
                                         const BorderOptions& options) {
    const analysis::CurveProblem problem = border_problem(map, plane, cycle);
    analysis::CurvePoint start;
    if (!begin(map, plane, cycle, problem, start)) return std::nullopt;
    return BorderCurve{cycle, analysis::follow_plane_curve(problem, start, options_of(map, plane, cycle, options))};
}

std::optional<Eigen::VectorXd> solved_on_border(const ItineraryMap& map, const Plane& plane, const BorderCycle& cycle) {
    analysis::CurvePoint start;
    if (!begin(map, plane, cycle, border_problem(map, plane, cycle), start)) return std::nullopt;
    return start.y;
}

bool is_on(const ItineraryMap& map, const Plane& plane, const BorderCycle& cycle, const Eigen::VectorXd& solved,
           const BorderOptions& options, const BorderCurve& curve) {
    if (curve.like.touch != cycle.touch || curve.like.vertices != cycle.vertices) return false;
    const bool touches = cycle.touch == Touch::grazing || cycle.touch == Touch::two_vertices;
    if (touches && curve.like.vertex != cycle.vertex) return false;
    const analysis::CurveProblem problem = border_problem(map, plane, cycle);
    analysis::CurvePoint at;
    for (const auto& point : curve.arc.points) {
        const Eigen::VectorXd y = turned_to(map, point.y, solved, layout_of(map, cycle).parameters());
        const Eigen::VectorXd apart = y - point.y;
        if (problem.product(apart, apart) > 4 * options.longest_step * options.longest_step) continue;
        const double along = problem.product(point.tangent, apart);
        if (analysis::correct(problem, point, along, at) != analysis::Correction::converged) continue;
        if ((at.y - y).lpNorm<Eigen::Infinity>() < 1e-6) return true;
    }
    return false;
}

Curve curve_of(const ItineraryMap& map, const BorderCurve& border) {
    const BorderCycle& like = border.like;
    const auto& points = border.arc.points;
    Curve curve{std::string(name_of(like.touch)),
                like.points.size(),
                {},
                {},
                ending_of(border.arc.begin, is_halved(map, like, points.front().y)),
                ending_of(border.arc.end, is_halved(map, like, points.back().y))};
    for (const auto& point : points) curve.points.push_back(cycle_at(map, like, point.y));
    for (const auto& special : border.arc.special) {
        CurveSpecial found{special.kind, cycle_at(map, like, special.at.y), special.after};
        const bool pair = special.kind.rfind("neimark-sacker", 0) == 0;
        if (!pair || has_pair_on_circle(found.cycle.multipliers)) curve.special.push_back(std::move(found));
    }
    return curve;
}

}  // namespace swirl::studies::bifurcation_curves
