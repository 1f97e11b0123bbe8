#include "analysis/boundaries/boundary_walk.hpp"

#include "analysis/continuation/step_length.hpp"
#include "analysis/cycles/cycle.hpp"
#include "analysis/cycles/stability.hpp"
#include "analysis/special_values.hpp"
#include "analysis/within_period.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace swirl::analysis {

namespace {

/// a − b of coordinates of points, and whatever comes after them; angles as angles.
Eigen::VectorXd angles_apart(const AugmentedSystem& system, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    Eigen::VectorXd d = a - b;
    const Eigen::Index dimension = system.map.dimension;
    for (Eigen::Index i = 0; i < std::min(system.coordinates(), d.size()); ++i)
        d[i] = within_period(d[i], system.map.angle_periods[static_cast<std::size_t>(i % dimension)]);
    return d;
}

/// Halves of a cycle that are nearer may meet ahead; and then the curve's multiplier is that much off at most.
constexpr double nearly_halved = 0.02;

class BoundaryWalk {
public:
    BoundaryWalk(AugmentedSystem system, const ArcPoint& start, const BoundaryOptions& options, Boundary& boundary)
        : system_(std::move(system)),
          arc_(equations_of(system_)),
          options_(options),
          boundary_(boundary),
          start_(start),
          h_(options.first_step, options.longest_step, options.shortest_step) {
        boundary_.points.push_back(boundary_point_at(system_, start));
    }

    void run() {
        while (!ended_) step();  // ends: every step goes on, or halves h down to the shortest
    }

private:
    const ArcPoint& here() const { return boundary_.points.back().at; }
    Eigen::Vector2d parameters(const ArcPoint& point) const { return point.y.segment<2>(system_.coordinates()); }

    void end(BoundaryEnd why) {
        boundary_.end.why = why;
        ended_ = true;
    }

    void step() {
        if (options_.stop && options_.stop()) return end(BoundaryEnd::stopped);
        if (static_cast<int>(boundary_.points.size()) >= options_.most_points) return end(BoundaryEnd::most_points);
        ArcPoint next;
        failure_ = correct(arc_, here(), h_.value(), next);
        if (failure_ == Correction::word_changed) word_behind_ = next.at.word;
        if (failure_ == Correction::converged && arc_.product(here().tangent, next.tangent) < least_cosine_along)
            failure_ = Correction::failed;
        if (failure_ != Correction::converged) return shorten();
        if (const auto first = start_ahead()) {
            accept(*first);
            return end(BoundaryEnd::closed);
        }
        if (leaves_plane(next)) return reach_edge(next);
        if (halves(next) < 0) return reach_half(next);
        if (becomes_real(next)) return reach_real(next);
        accept(next);
        h_.succeed();
    }

    void shorten() {
        if (h_.shorten()) return;
        // A border across which the map jumps stops the corrector itself: it is asked for its name, too.
        if (word_behind_.empty()) look_behind();
        if (options_.name_border)
            boundary_.end.border =
                options_.name_border(unstacked(here().y.head(system_.coordinates()), system_.map.dimension),
                                     parameters(here()), word_behind_);
        if (failure_ != Correction::failed || !boundary_.end.border.empty()) return end(BoundaryEnd::border);
        end(meets_halved() ? BoundaryEnd::halved : BoundaryEnd::not_converged);
    }

    /// The word a little farther along the tangent: where DF jumps the corrector finds no point behind.
    void look_behind() {
        for (const double h : {1e-8, 1e-7, 1e-6, 1e-5}) {
            const PlaneShooting behind = system_.shooting(here().y + h * here().tangent);
            if (!behind.alive || behind.word == here().at.word) continue;
            word_behind_ = behind.word;
            return;
        }
    }

    /// How far outside the plane, in its widths; negative inside.
    double outside(const ArcPoint& point) const {
        return outside_plane(options_.low, options_.high, parameters(point));
    }
    bool leaves_plane(const ArcPoint& next) const { return outside(next) > 0; }

    /// The last point is that on the plane's edge itself.
    void reach_edge(const ArcPoint& beyond) {
        finish_between(outside(here()), outside(beyond), [this](const ArcPoint& at) { return outside(at); });
        end(BoundaryEnd::plane);
    }

    /// From the cycle's first half to its second; infinite for an odd period.
    Eigen::VectorXd apart(const ArcPoint& point) const {
        const Eigen::Index half = system_.coordinates() / 2;
        if (system_.period % 2 != 0) return Eigen::VectorXd::Constant(1, infinity);
        return angles_apart(system_, point.y.segment(half, half), point.y.head(half));
    }
    /// How the two halves lie to each other, against how they lie here: negative if they were exchanged on the way,
    /// through a cycle of half the period (the fold curve of doubled cycles ends so, at a generalised flip).
    double halves(const ArcPoint& point) const { return system_.period % 2 != 0 ? 1 : apart(here()).dot(apart(point)); }
    /// Where the corrector fails: do the halves meet a little ahead along the tangent, in a cycle of half the period
    /// that run through twice has the curve's multiplier, too?
    bool meets_halved() const {
        if (system_.period % 2 != 0) return false;
        const Eigen::Index n = system_.coordinates(), half = n / 2;
        const Eigen::VectorXd here_apart = apart(here());
        const double closing = here_apart.dot(here().tangent.segment(half, half) - here().tangent.head(half));
        const double ahead = -here_apart.squaredNorm() / closing;
        if (!(here_apart.norm() < nearly_halved) || !(ahead > 0) || !(ahead < nearly_halved)) return false;
        const Eigen::VectorXd there = here().y + ahead * here().tangent;
        const Eigen::VectorXd middle =
            there.segment(half, half) - 0.5 * angles_apart(system_, there.segment(half, half), there.head(half));
        CyclePoints points = unstacked(middle, system_.map.dimension);
        const Eigen::Vector2d p = there.segment<2>(n);
        polish_cycle(on_line(system_.map, 0, p), points, p[0]);
        if (!((stacked(points) - middle).norm() < here_apart.norm())) return false;
        const PlaneShooting shooting = plane_shooting(system_.map, stacked(points), p);
        if (!shooting.alive || !(shooting.gap.norm() < 1e-9)) return false;
        const auto multipliers = sorted_multipliers(monodromy(shooting));
        const std::complex<double> critical = system_.multiplier(here().y);
        return std::any_of(multipliers.begin(), multipliers.end(),
                           [&](const auto& m) { return std::abs(m * m - critical) < nearly_halved; });
    }
    void reach_half(const ArcPoint& beyond) {
        finish_between(halves(here()), halves(beyond), [this](const ArcPoint& at) { return halves(at); });
        end(BoundaryEnd::halved);
    }

    double cosine(const ArcPoint& point) const { return point.y[system_.coordinates() + 2]; }
    bool becomes_real(const ArcPoint& next) const {
        return system_.kind == BoundaryKind::neimark_sacker && std::abs(cosine(next)) > 1;
    }

    /// A pair meets at ±1: the curve of the bifurcation ends there, its equations don't.
    void reach_real(const ArcPoint& beyond) {
        const double one = std::copysign(1.0, cosine(beyond));
        find_special(boundary_point_at(system_, beyond));  // 1:1 or 1:2 among others
        finish_between(1 - std::abs(cosine(here())), 1 - std::abs(cosine(beyond)),
                       [this, one](const ArcPoint& at) { return 1 - one * cosine(at); });
        end(one > 0 ? BoundaryEnd::one_to_one : BoundaryEnd::one_to_two);
    }

    template <class Value>
    void finish_between(double f0, double f1, const Value& value) {
        ArcPoint last;
        if (f0 == 0 || !locate(arc_, here(), h_.value(), f0, f1, value, last)) return;
        BoundaryPoint point = boundary_point_at(system_, last);
        if (system_.kind != BoundaryKind::neimark_sacker || std::abs(cosine(last)) < 1 - 1e-12) find_special(point);
        append(std::move(point));
    }

    void accept(const ArcPoint& next) {
        BoundaryPoint point = boundary_point_at(system_, next);
        find_special(point);
        append(std::move(point));
    }

    void append(BoundaryPoint next) {
        word_behind_.clear();
        if (is_beside_last(next.at)) boundary_.points.pop_back();
        boundary_.points.push_back(std::move(next));
        renew_borders(system_, here().y);
        arc_ = equations_of(system_);
        if (options_.progress) options_.progress(parameters(here()));
    }

    /// Points of codimension 2 on the way to `next`, in order.
    void find_special(const BoundaryPoint& next) {
        const double h = arc_.product(here().tangent, next.at.y - here().y);
        if (!(h > 0)) return;
        std::vector<std::pair<double, BoundarySpecial>> found;
        for (const auto& test : tests_of(system_, options_.forms)) {
            const auto seen = [&test](const BoundaryPoint& point) {
                return test.seen ? test.seen(point) : test.value(point.at);
            };
            const double f0 = seen(boundary_.points.back()), f1 = seen(next);
            if (!(f0 * f1 <= 0) || f0 == 0 || std::max(std::abs(f0), std::abs(f1)) <= test.noise) continue;
            ArcPoint at = next.at;
            if (f1 != 0 && !locate(arc_, here(), h, test.value(here()), test.value(next.at), test.value, at)) continue;
            if (outside(at) > 1e-9 || !is_what_it_seems(system_, test.kind, at)) continue;
            BoundarySpecial special{test.kind, boundary_point_at(system_, at, options_.forms),
                                    boundary_.points.size() - 1};
            if (!has_coefficient(system_.kind, test.kind)) special.cycle.coefficient = nan;
            found.emplace_back(arc_.product(here().tangent, at.y - here().y), std::move(special));
        }
        std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (auto& [s, special] : found) boundary_.special.push_back(std::move(special));
    }

    /// Short steps towards a border are no points of interest: the last stands for them.
    bool is_beside_last(const ArcPoint& next) const {
        constexpr double beside = 1e-5;
        const std::size_t count = boundary_.points.size();
        if (count < 2 || (!boundary_.special.empty() && boundary_.special.back().after + 1 >= count)) return false;
        const Eigen::VectorXd step = next.y - boundary_.points[count - 2].at.y;
        return arc_.product(step, step) < beside * beside;
    }

    /// The first point, its cycle begun wherever that lies nearest, if the curve is back there within the step.
    std::optional<ArcPoint> start_ahead() const {
        if (boundary_.points.size() < 3) return std::nullopt;
        ArcPoint start = start_;
        const double away = distance_between(system_, here().y, start_.y, &start.y, &start.tangent);
        if (away > 2 * h_.value() || !passes(arc_, here(), h_.value(), start)) return std::nullopt;
        if (!arc_.equations(start.y, start.at)) return std::nullopt;
        return start;
    }

    AugmentedSystem system_;
    ArcSystem arc_;
    const BoundaryOptions& options_;
    Boundary& boundary_;
    ArcPoint start_;
    StepLength h_;
    Correction failure_ = Correction::converged;  ///< how the last step failed
    std::vector<std::int64_t> word_behind_;       ///< seen since the last point, if any
    bool ended_ = false;
};

}  // namespace

double distance_between(const AugmentedSystem& system, const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                        Eigen::VectorXd* turned, Eigen::VectorXd* tangent) {
    const Eigen::Index n = system.coordinates(), d = system.map.dimension;
    const Eigen::VectorXd weights = equations_of(system).weights;
    const auto begun_at = [n](Eigen::VectorXd y, Eigen::Index place) {
        std::rotate(y.begin(), y.begin() + place, y.begin() + n);
        return y;
    };
    double least = infinity;
    Eigen::Index nearest = 0;
    for (Eigen::Index shift = 0; shift < n; shift += d) {
        const Eigen::VectorXd shifted = begun_at(b, shift);
        const Eigen::VectorXd across = angles_apart(system, shifted, a);
        const double away = std::sqrt(across.cwiseAbs2().dot(weights));
        if (!(away < least)) continue;
        least = away;
        nearest = shift;
        if (turned != nullptr) *turned = a + across;
    }
    if (tangent != nullptr) *tangent = begun_at(*tangent, nearest);
    return least;
}

Eigen::VectorXd normalised(const AugmentedSystem& system, const Eigen::VectorXd& y) {
    return angles_apart(system, y, Eigen::VectorXd::Zero(y.size()));
}

void walk_boundary(AugmentedSystem system, const ArcPoint& start, const BoundaryOptions& options, Boundary& boundary) {
    boundary.kind = system.kind;
    boundary.period = system.period;
    BoundaryWalk(std::move(system), start, options, boundary).run();
}

}  // namespace swirl::analysis
