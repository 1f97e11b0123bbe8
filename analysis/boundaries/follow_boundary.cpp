#include "analysis/boundaries/follow_boundary.hpp"

#include "analysis/boundaries/codimension_two.hpp"
#include "analysis/boundaries/plane_curve.hpp"
#include "analysis/cycles/cycle.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::analysis {

namespace {

/// Smallest distance, over cyclic shifts, of two points of a curve's unknowns in its arclength; angles as angles.
///   turned  b's unknowns, shifted and with whole turns added, so that they lie nearest to a's
///   tangent  if given: a direction at b, shifted likewise
double distance_between(const AugmentedSystem& system, const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                        Eigen::VectorXd& turned, Eigen::VectorXd* tangent = nullptr) {
    const Eigen::Index n = system.coordinates(), d = system.map.dimension;
    const Eigen::VectorXd weights = system.weights();
    const auto begun_at = [n](Eigen::VectorXd y, Eigen::Index place) {
        std::rotate(y.begin(), y.begin() + place, y.begin() + n);
        return y;
    };
    double least = infinity;
    Eigen::Index nearest = 0;
    for (Eigen::Index shift = 0; shift < n; shift += d) {
        const Eigen::VectorXd shifted = begun_at(b, shift);
        const Eigen::VectorXd across = system.map.difference(shifted, a, n);
        const double away = std::sqrt(across.cwiseAbs2().dot(weights));
        if (!(away < least)) continue;
        least = away;
        nearest = shift;
        turned = a + across;
    }
    if (tangent != nullptr) *tangent = begun_at(*tangent, nearest);
    return least;
}

/// Halves of a cycle that are nearer may meet ahead; and then the curve's multiplier is that much off at most.
constexpr double nearly_halved = 0.02;

class BoundaryWalk final : public CurveWalk {
public:
    BoundaryWalk(AugmentedSystem system, const CurvePoint& start, const BoundaryOptions& options, Boundary& boundary)
        : CurveWalk(problem_of(system),
                    {options.first_step, options.longest_step, options.shortest_step, options.most_points},
                    options.stop),
          system_(std::move(system)),
          options_(options),
          boundary_(boundary),
          start_(start) {
        boundary_.points.push_back(boundary_point_at(system_, start));
    }

private:
    const CurvePoint& here() const override { return boundary_.points.back().at; }
    std::size_t count() const override { return boundary_.points.size(); }
    Eigen::Vector2d parameters(const CurvePoint& point) const { return point.y.segment<2>(system_.coordinates()); }

    bool go_to(CurvePoint next) override {
        if (const auto first = start_ahead()) {
            accept(*first);
            end(CurveEnd::closed);
        } else if (outside(next) > 0) {  // the last point is that on the plane's edge itself
            finish_between(outside(here()), outside(next), [this](const CurvePoint& at) { return outside(at); });
            end(CurveEnd::plane);
        } else if (halves(next) < 0) {
            finish_between(halves(here()), halves(next), [this](const CurvePoint& at) { return halves(at); });
            end(CurveEnd::halved);
        } else if (system_.kind == BoundaryKind::neimark_sacker && std::abs(cosine(next)) > 1) {
            reach_real(next);
        } else {
            accept(next);
        }
        return true;
    }

    void meet_end(Correction why) override {
        // A border across which the map jumps stops the corrector itself: it is asked for its name, too.
        const auto itinerary = itinerary_behind().empty() ? seen_behind() : itinerary_behind();
        if (options_.name_border)
            boundary_.end.border = options_.name_border(here().points(), parameters(here()), itinerary);
        if (why != Correction::failed || !boundary_.end.border.empty()) return end(CurveEnd::border);
        end(meets_halved() ? CurveEnd::halved : CurveEnd::not_converged);
    }

    /// The itinerary a little farther along the tangent: where DF jumps the corrector finds no point behind.
    std::vector<std::int64_t> seen_behind() const {
        for (const double h : {1e-8, 1e-7, 1e-6, 1e-5}) {
            const ShootingResidual behind = system_.shooting(here().y + h * here().tangent);
            if (behind.alive && behind.itinerary != here().shooting.itinerary) return behind.itinerary;
        }
        return {};
    }

    /// How far outside the plane, in its widths; negative inside.
    double outside(const CurvePoint& point) const {
        return outside_plane(options_.low, options_.high, parameters(point));
    }

    /// From the cycle's first half to its second; infinite for an odd period.
    Eigen::VectorXd apart(const Eigen::VectorXd& y) const {
        const Eigen::Index half = system_.coordinates() / 2;
        if (system_.period % 2 != 0) return Eigen::VectorXd::Constant(1, infinity);
        return system_.map.difference(y.segment(half, half), y.head(half), half);
    }
    /// How the two halves lie to each other, against how they lie here: negative if they were exchanged on the way,
    /// through a cycle of half the period (the fold curve of doubled cycles ends so, at a generalised flip).
    double halves(const CurvePoint& point) const {
        return system_.period % 2 != 0 ? 1 : apart(here().y).dot(apart(point.y));
    }
    /// Where the corrector fails: do the halves meet a little ahead along the tangent, in a cycle of half the period
    /// that run through twice has the curve's multiplier, too?
    bool meets_halved() const {
        if (system_.period % 2 != 0) return false;
        const Eigen::Index n = system_.coordinates(), half = n / 2;
        const Eigen::VectorXd here_apart = apart(here().y);
        const double closing = here_apart.dot(here().tangent.segment(half, half) - here().tangent.head(half));
        const double ahead = -here_apart.squaredNorm() / closing;
        if (!(here_apart.norm() < nearly_halved) || !(ahead > 0) || !(ahead < nearly_halved)) return false;
        const Eigen::VectorXd there = here().y + ahead * here().tangent;
        const Eigen::VectorXd middle = there.segment(half, half) - 0.5 * apart(there);
        CyclePoints points = unstacked(middle, system_.map.dimension);
        const Eigen::Vector2d p = there.segment<2>(n);
        polish_cycle(on_line(system_.map, 0, p), points, p[0]);
        if (!((stacked(points) - middle).norm() < here_apart.norm())) return false;
        const ShootingResidual shooting = shooting_residual(system_.map, stacked(points), p);
        if (!shooting.alive || !(shooting.gap.norm() < 1e-9)) return false;
        const auto multipliers = sorted_multipliers(monodromy(shooting));
        const std::complex<double> critical = system_.multiplier(here().y);
        return std::any_of(multipliers.begin(), multipliers.end(),
                           [&](const auto& m) { return std::abs(m * m - critical) < nearly_halved; });
    }

    double cosine(const CurvePoint& point) const { return point.y[system_.coordinates() + 2]; }

    /// A pair meets at ±1: the curve of the bifurcation ends there, its equations don't.
    void reach_real(const CurvePoint& beyond) {
        const double one = std::copysign(1.0, cosine(beyond));
        find_special(boundary_point_at(system_, beyond));  // 1:1 or 1:2 among others
        finish_between(1 - std::abs(cosine(here())), 1 - std::abs(cosine(beyond)),
                       [this, one](const CurvePoint& at) { return 1 - one * cosine(at); });
        end(one > 0 ? CurveEnd::one_to_one : CurveEnd::one_to_two);
    }

    template <class Value>
    void finish_between(double f0, double f1, const Value& value) {
        CurvePoint last;
        if (f0 == 0 || !locate(problem_, here(), step_length(), f0, f1, value, last)) return;
        BoundaryPoint point = boundary_point_at(system_, last);
        if (system_.kind != BoundaryKind::neimark_sacker || std::abs(cosine(last)) < 1 - 1e-12) find_special(point);
        append(std::move(point));
    }

    void accept(const CurvePoint& next) {
        BoundaryPoint point = boundary_point_at(system_, next);
        find_special(point);
        append(std::move(point));
    }

    void append(BoundaryPoint next) {
        if (is_beside_last(next.at)) boundary_.points.pop_back();
        boundary_.points.push_back(std::move(next));
        // Borders are taken anew at each point, so that the matrix stays well conditioned along the curve.
        system_.borders = borders_at(here().shooting, system_.multiplier(here().y), system_.borders);
        problem_ = problem_of(system_);
        if (options_.progress) options_.progress(parameters(here()));
    }

    /// Points of codimension 2 on the way to `next`, in order.
    void find_special(const BoundaryPoint& next) {
        const double h = problem_.product(here().tangent, next.at.y - here().y);
        if (!(h > 0)) return;
        std::vector<std::pair<double, BoundarySpecial>> found;
        for (const auto& test : tests_of(system_, options_.forms)) {
            const auto seen = [&test](const BoundaryPoint& point) {
                return test.seen ? test.seen(point) : test.value(point.at);
            };
            const double f0 = seen(boundary_.points.back()), f1 = seen(next);
            if (!(f0 * f1 <= 0) || f0 == 0 || std::max(std::abs(f0), std::abs(f1)) <= test.noise) continue;
            CurvePoint at = next.at;
            if (f1 != 0 && !locate(problem_, here(), h, test.value(here()), test.value(next.at), test.value, at))
                continue;
            if (outside(at) > 1e-9 || !is_what_it_seems(system_, test.kind, at)) continue;
            BoundarySpecial special{test.kind, boundary_point_at(system_, at, options_.forms),
                                    boundary_.points.size() - 1};
            if (!has_coefficient(system_.kind, test.kind)) special.cycle.coefficient = nan;
            found.emplace_back(problem_.product(here().tangent, at.y - here().y), std::move(special));
        }
        std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (auto& [s, special] : found) boundary_.special.push_back(std::move(special));
    }

    /// Short steps towards a border are no points of interest: the last stands for them.
    bool is_beside_last(const CurvePoint& next) const {
        constexpr double beside = 1e-5;
        const std::size_t count = boundary_.points.size();
        if (count < 2 || (!boundary_.special.empty() && boundary_.special.back().after + 1 >= count)) return false;
        const Eigen::VectorXd step = next.y - boundary_.points[count - 2].at.y;
        return problem_.product(step, step) < beside * beside;
    }

    /// The first point, its cycle begun wherever that lies nearest, if the curve is back there within the step.
    std::optional<CurvePoint> start_ahead() const {
        if (boundary_.points.size() < 3) return std::nullopt;
        CurvePoint start = start_;
        const double away = distance_between(system_, here().y, start_.y, start.y, &start.tangent);
        if (away > 2 * step_length() || !passes(problem_, here(), step_length(), start)) return std::nullopt;
        start.shooting = problem_.equations(start.y);
        if (!start.shooting.alive) return std::nullopt;
        return start;
    }

    AugmentedSystem system_;
    const BoundaryOptions& options_;
    Boundary& boundary_;
    CurvePoint start_;
};

/// Where the guess lies along the tangent of a known curve's point, corrected: the same cycle?
bool is_beside(const AugmentedSystem& like, const CurvePoint& on_curve, const Eigen::VectorXd& y) {
    AugmentedSystem system = like;
    system.borders = borders_at(on_curve.shooting, system.multiplier(on_curve.y));
    const CurveProblem problem = problem_of(system);
    CurvePoint at;
    const double along = problem.product(on_curve.tangent, y - on_curve.y);
    if (correct(problem, on_curve, along, at) != Correction::converged) return false;
    constexpr double same = 1e-6;
    return problem.length(at.y - y) < same;
}

/// The point of the curve near a rough cycle, and its equations; false if there is none within the plane.
bool begin(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points, const Eigen::Vector2d& p,
           std::complex<double> multiplier, const BoundaryOptions& options, AugmentedSystem& system,
           CurvePoint& start) {
    if (outside_plane(options.low, options.high, p) > on_edge) return false;
    system = {kind, map, points.size(), options.high - options.low, {}, options.steep_below};
    const Eigen::VectorXd y = system.unknowns(points, p, multiplier);
    const ShootingResidual shooting = system.shooting(y);
    if (!shooting.alive) return false;
    system.borders = borders_at(shooting, system.multiplier(y));
    Eigen::VectorXd along = Eigen::VectorXd::Zero(y.size());
    along[system.coordinates()] = 1;   // the first parameter grows
    constexpr double farthest = 0.02;  // a rough cycle
    if (!find_point(problem_of(system), y, along, farthest, start) ||
        outside_plane(options.low, options.high, start.y.segment<2>(system.coordinates())) > on_edge)
        return false;
    return kind != BoundaryKind::neimark_sacker || std::abs(start.y[system.coordinates() + 2]) < 1;
}

}  // namespace

std::optional<CriticalCycle> critical_cycle_near(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points,
                                                 const Eigen::Vector2d& p, std::complex<double> multiplier,
                                                 const BoundaryOptions& options) {
    AugmentedSystem system;
    CurvePoint start;
    if (!begin(map, kind, points, p, multiplier, options, system, start)) return std::nullopt;
    const Eigen::Index n = system.coordinates();
    return CriticalCycle{start.points(), start.y.segment<2>(n), system.multiplier(start.y)};
}

bool follow_boundary(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points, const Eigen::Vector2d& p,
                     std::complex<double> multiplier, const BoundaryOptions& options, Boundary& boundary) {
    AugmentedSystem system;
    CurvePoint start;
    if (!begin(map, kind, points, p, multiplier, options, system, start)) return false;
    start.y = map.normalised(start.y, system.coordinates());
    start.shooting = problem_of(system).equations(start.y);
    if (!start.shooting.alive) return false;
    system.borders = borders_at(start.shooting, system.multiplier(start.y), system.borders);
    boundary = both_ways(start, [&](const CurvePoint& from) {
        Boundary one_way{kind, points.size(), {}, {}, {}, {}};
        one_way.end.why = BoundaryWalk(system, from, options, one_way).run();
        return one_way;
    });
    return true;
}

bool is_on_boundary(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points, const Eigen::Vector2d& p,
                    std::complex<double> multiplier, const BoundaryOptions& options, std::span<const Boundary> known) {
    AugmentedSystem system{kind, map, points.size(), options.high - options.low, {}, options.steep_below};
    const Eigen::VectorXd y = system.unknowns(points, p, multiplier);
    for (const Boundary& boundary : known) {
        if (boundary.kind != kind || boundary.period != points.size()) continue;
        for (const BoundaryPoint& point : boundary.points) {
            const Eigen::Vector2d apart = parameters_of(boundary, point.at.y) - p;
            if (apart.cwiseQuotient(options.high - options.low).norm() > 2 * options.longest_step) continue;
            Eigen::VectorXd turned;
            if (distance_between(system, point.at.y, y, turned) > 2 * options.longest_step) continue;
            if (is_beside(system, point.at, turned)) return true;
        }
    }
    return false;
}

}  // namespace swirl::analysis
