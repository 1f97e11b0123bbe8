#include "apps/studies/bifurcation_curves/born_curves.hpp"

#include "analysis/boundaries/follow_boundary.hpp"
#include "analysis/cycles/cycle.hpp"
#include "analysis/linear_algebra/dense.hpp"
#include "apps/studies/bifurcation_curves/border_system.hpp"

#include <complex>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace swirl::studies::bifurcation_curves {

namespace {

/// Both turns the same.
BorderCycle twice(const BorderCycle& cycle) {
    BorderCycle both = cycle;
    both.points.insert(both.points.end(), cycle.points.begin(), cycle.points.end());
    both.times.insert(both.times.end(), cycle.times.begin(), cycle.times.end());
    both.vertices.insert(both.vertices.end(), cycle.vertices.begin(), cycle.vertices.end());
    return both;
}

/// The unknowns of both turns moved by the eigenvector at −1 of one of them, one forwards and one back.
Eigen::VectorXd apart_by(const ItineraryMap& map, const BorderCycle& flip, const BorderCycle& both) {
    const BorderLayout one = layout_of(map, flip), two = layout_of(map, both);
    const Eigen::MatrixXd vectors = analysis::right_singular_vectors(itinerary_matrix(map, flip, -1)).right;
    const Eigen::VectorXd null = vectors.col(vectors.cols() - 1);
    Eigen::VectorXd apart = Eigen::VectorXd::Zero(unknowns_of(map, both).size());
    const Eigen::Index n = one.parameters();
    apart.head(n) = null.head(n);
    apart.segment(n, n) = -null.head(n);
    apart.segment(two.time(0), one.period) = null.tail(one.period);
    apart.segment(two.time(one.period), one.period) = -null.tail(one.period);
    return apart.normalized();
}

}  // namespace

std::optional<BorderCycle> doubled_on_border(const ItineraryMap& map, const Plane& plane, const BorderCycle& flip) {
    const BorderCycle both = twice(flip);
    const analysis::CurveProblem problem = border_problem(map, plane, both);
    const Eigen::VectorXd middle = unknowns_of(map, both);
    const Eigen::VectorXd apart = apart_by(map, flip, both);
    for (const double amplitude : {1e-2, -1e-2, 1e-3, -1e-3, 1e-4, -1e-4}) {
        const auto equations = [&](const Eigen::VectorXd& y) {
            analysis::ShootingResidual at = problem.equations(y);
            if (!at.alive) return at;
            at.gap.conservativeResize(y.size());
            at.jacobian.conservativeResize(y.size(), y.size());
            at.gap[y.size() - 1] = apart.dot(y - middle) - amplitude;
            at.jacobian.row(y.size() - 1) = apart.transpose();
            return at;
        };
        const auto y = analysis::solve_square_system(equations, middle + amplitude * apart);
        if (y && refusal_of(map, both, *y).empty()) return border_cycle_at(map, both, *y);
    }
    return std::nullopt;
}

namespace {

/// As many equations as unknowns: the cycle of an itinerary, how far it is from the border, and its multiplier 1 or −1;
/// where a pair is on the circle, that it lies beside the special point (the curve is then sought from there).
struct BornSystem {
    const ItineraryMap& map;
    const Plane& plane;
    BorderCycle like;
    bool strikes;                     ///< with the impact that vanishes on the border, the first of the cycle
    std::complex<double> multiplier;  ///< 1, −1 or one of the pair
    Eigen::VectorXd along;            ///< the border curve's direction at the special point
    double off;                       ///< what touches, off the border

    double determinant(const Eigen::VectorXd& y) const {
        return itinerary_determinant(map, border_cycle_at(map, like, y), multiplier.real());
    }

    analysis::ShootingResidual equations(const Eigen::VectorXd& y) const {
        const BorderLayout layout = layout_of(map, like);
        analysis::ShootingResidual at;
        if (!is_in_range(plane, y.segment<2>(layout.parameters()))) return at;
        const Eigen::Index row = layout.parameters() + layout.period;
        at.gap = Eigen::VectorXd::Zero(y.size());
        at.jacobian = Eigen::MatrixXd::Zero(y.size(), y.size());
        add_cycle(map, like, layout, y, at);
        if (strikes)
            add_approach(map, like, layout, y, at);
        else
            add_touch(map, like, layout, y, at);
        at.gap[row] -= off;
        if (multiplier.imag() == 0)
            add_multiplier(layout, y, at);
        else
            add_place(y, at);
        at.alive = at.gap.allFinite() && at.jacobian.allFinite();
        return at;
    }

    void add_place(const Eigen::VectorXd& y, analysis::ShootingResidual& at) const {
        at.gap[y.size() - 1] = along.dot(y - unknowns_of(map, like));
        at.jacobian.row(y.size() - 1) = along.transpose();
    }

    void add_multiplier(const BorderLayout& layout, const Eigen::VectorXd& y, analysis::ShootingResidual& at) const {
        const Eigen::Index last = y.size() - 1;
        at.gap[last] = determinant(y);
        constexpr double h = 1e-6;  // steers only
        for (Eigen::Index i = 0; i < y.size(); ++i) {
            Eigen::VectorXd above = y, below = y;
            above[i] += h;
            below[i] -= h;
            // At the end of a parameter's range (μ = 0) from one side.
            if (!is_in_range(plane, above.segment<2>(layout.parameters()))) above = y;
            if (!is_in_range(plane, below.segment<2>(layout.parameters()))) below = y;
            at.jacobian(last, i) = (determinant(above) - determinant(below)) / (above[i] - below[i]);
        }
        const double size = at.jacobian.row(last).norm();
        at.gap[last] /= size;
        at.jacobian.row(last) /= size;
    }

    /// By Newton's method from the cycle on the border.
    std::optional<BorderCycle> solve() const {
        const Eigen::VectorXd all = unknowns_of(map, like);
        const auto y =
            analysis::solve_square_system([this](const Eigen::VectorXd& at_y) { return equations(at_y); },
                                          strikes ? Eigen::VectorXd(all.head(layout_of(map, like).touch_time())) : all);
        return y ? std::optional(border_cycle_at(map, like, *y)) : std::nullopt;
    }
};

/// The side on which there is such a cycle: what touches is inside, a flight takes time, an impact has a rate. Across a
/// stick-slip border there is one on either.
std::vector<double> signs_of(Touch touch, bool strikes) {
    if (strikes || touch == Touch::no_flight) return {1};
    if (touch == Touch::grazing || touch == Touch::two_vertices) return {-1};
    return {1, -1};
}

std::optional<StartingPoint> starting_point_of(const BornSystem& system, const analysis::PlaneMap& map,
                                               const analysis::BoundaryOptions& options) {
    const auto cycle = system.solve();
    if (!cycle) return std::nullopt;
    const auto shooting = analysis::shooting_residual(map, analysis::stacked(cycle->points), cycle->p);
    constexpr double closes = 1e-7;
    if (!shooting.alive || !(shooting.gap.lpNorm<Eigen::Infinity>() < closes)) return std::nullopt;
    if (system.multiplier.imag() == 0)
        return StartingPoint{system.multiplier.real() > 0 ? "fold" : "flip", cycle->points, cycle->p,
                             system.multiplier};
    const auto on_curve = analysis::critical_cycle_near(map, analysis::BoundaryKind::neimark_sacker, cycle->points,
                                                        cycle->p, system.multiplier, options);
    if (!on_curve) return std::nullopt;
    return StartingPoint{"neimark-sacker", on_curve->points, on_curve->p, on_curve->multiplier};
}

StartingPoint starting_point_on_border(const BorderCycle& cycle) {
    StartingPoint start{std::string(name_of(cycle.touch)), cycle.points, cycle.p, -1};
    start.border = cycle;
    return start;
}

/// The critical multiplier at a special point of a border curve; none if it is a neutral saddle's.
std::optional<std::complex<double>> multiplier_at(const ItineraryMap& itineraries, const BorderCurve& curve,
                                                  const analysis::PlaneSpecial& special) {
    if (special.kind.rfind("fold", 0) == 0) return 1;
    if (special.kind.rfind("flip", 0) == 0) return -1;
    const auto multipliers = analysis::sorted_multipliers(monodromy_of(itineraries, curve.like, special.at.y));
    if (!has_pair_on_circle(multipliers)) return std::nullopt;
    return critical_pair(multipliers);
}

}  // namespace

BornPoints points_born_on(const ItineraryMap& itineraries, const analysis::PlaneMap& map, const Plane& plane,
                          const analysis::BoundaryOptions& options, std::size_t longest_period,
                          const BorderCurve& curve) {
    BornPoints born;
    for (const auto& special : curve.arc.special) {
        const auto multiplier = multiplier_at(itineraries, curve, special);
        if (!multiplier) continue;
        const bool strikes = special.kind == fold_of_impact || special.kind == flip_of_impact;
        BorderCycle cycle = border_cycle_at(itineraries, curve.like, special.at.y);
        const std::size_t period = curve.like.points.size() + (strikes ? 1 : 0);
        if (*multiplier == -1.0 && !strikes && 2 * period <= longest_period) {
            if (const auto doubled = doubled_on_border(itineraries, plane, cycle))
                born.starting_points.push_back(starting_point_on_border(*doubled));
            else
                ++born.not_found;
        }
        if (period > longest_period) continue;
        if (strikes) cycle = with_impact(itineraries, cycle, 0);
        for (const double sign : signs_of(cycle.touch, strikes)) {
            std::optional<StartingPoint> start;
            for (const double off : {1e-3, 1e-4, 1e-5})
                if (!start)
                    start = starting_point_of(
                        {itineraries, plane, cycle, strikes, *multiplier, special.at.tangent, sign * off}, map,
                        options);
            if (start)
                born.starting_points.push_back(std::move(*start));
            else
                ++born.not_found;
        }
    }
    return born;
}

}  // namespace swirl::studies::bifurcation_curves
