#include "apps/studies/bifurcation_curves/curves_of_kind.hpp"

#include "analysis/boundaries/follow_boundary.hpp"
#include "analysis/cycles/cycle.hpp"
#include "apps/studies/bifurcation_curves/border_system.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::studies::bifurcation_curves {

using analysis::Boundary;

namespace {

Followed on_known(std::size_t number) {
    Followed followed;
    followed.on = number;
    return followed;
}

Followed none_found() {
    Followed followed;
    followed.without = true;
    return followed;
}

}  // namespace

std::optional<CurveKind> curve_kind_of(const StartingPoint& start) {
    if (smooth_kind(start.kind)) return CurveKind{start.kind, start.points.size()};
    if (is_on_border(start.kind)) return CurveKind{start.kind, 0};
    return std::nullopt;
}

std::optional<Followed> CurvesOfKind::follow(std::size_t number, const StartingPoint& start) {
    if (is_stopped()) return std::nullopt;
    const auto kind = smooth_kind(start.kind);
    return kind ? follow_smooth(number, start, *kind) : follow_touch(number, start);
}

std::optional<Followed> CurvesOfKind::follow_smooth(std::size_t number, const StartingPoint& start,
                                                    analysis::BoundaryKind kind) {
    const SearchEquations& use = *equations_;
    for (const auto& known : smooth_)
        if (analysis::is_on_boundary(use.map, kind, start.points, start.p, start.multiplier, use.smooth,
                                     {known.curve.get(), 1}))
            return on_known(known.number);
    Boundary boundary;
    const bool found =
        analysis::follow_boundary(use.map, kind, start.points, start.p, start.multiplier, use.smooth, boundary);
    if (is_stopped()) return std::nullopt;  // cut short: not finished
    if (!found) return none_found();
    const auto listed = std::make_shared<const Curve>(curve_of(boundary, use.coordinates));
    return add({std::make_shared<const Boundary>(std::move(boundary)), listed, number}, smooth_);
}

std::optional<Followed> CurvesOfKind::follow_touch(std::size_t number, const StartingPoint& start) {
    const SearchEquations& use = *equations_;
    const auto cycle = border_cycle_of(use.words, start);
    if (!cycle) return none_found();
    const auto solved = solved_on_border(use.words, use.plane, *cycle);
    if (!solved) return none_found();
    for (const auto& known : borders_)
        if (is_on(use.words, use.plane, *cycle, *solved, use.border, *known.curve)) return on_known(known.number);
    auto curve = follow_border(use.words, use.plane, *cycle, use.border);
    if (is_stopped()) return std::nullopt;
    if (!curve) return none_found();
    const auto listed = std::make_shared<const Curve>(curve_of(use.words, *curve));
    const auto shared = std::make_shared<const BorderCurve>(std::move(*curve));
    Followed followed = add({shared, listed, number}, borders_);
    if (followed.curve) followed.border = shared;
    return followed;
}

/// A curve on which Newton's method failed is met again from beyond, and then followed back over itself.
template <class Equations>
Followed CurvesOfKind::add(Known<Equations> found, std::vector<Known<Equations>>& known) const {
    const auto whole =
        std::find_if(known.begin(), known.end(), [&](const auto& other) { return is_part(found, other); });
    if (whole != known.end()) return on_known(whole->number);
    Followed followed = on_known(found.number);
    followed.curve = found.listed;
    std::erase_if(known, [&](const auto& other) {
        if (!is_part(other, found)) return false;
        followed.parts.push_back(other.number);
        return true;
    });
    known.push_back(std::move(found));
    return followed;
}

/// At ten of eleven places along it, or all.
template <class Equations>
bool CurvesOfKind::is_part(const Known<Equations>& part, const Known<Equations>& whole) const {
    const Curve &listed = *part.listed, &whole_listed = *whole.listed;
    if (listed.kind != whole_listed.kind || listed.period != whole_listed.period) return false;
    constexpr std::size_t places = 11;
    std::size_t elsewhere = 0;
    for (std::size_t k = 1; k <= places && elsewhere < 2; ++k) {
        const std::size_t i = k * (listed.points.size() - 1) / (places + 1);
        if (!runs_along(listed.points[i], whole_listed) && !is_at(*part.curve, i, *whole.curve)) ++elsewhere;
    }
    return elsewhere < 2;
}

/// Between two neighbours of a curve's points, where these are so dense that a straight line tells. (Near the place
/// where Newton's method fails it is no judge.)
bool CurvesOfKind::runs_along(const CurveCycle& at, const Curve& curve) const {
    constexpr double beside = 1e-6;  // of the plane
    const Eigen::Vector2d width = equations_->plane.high() - equations_->plane.low();
    const auto place = [&](std::size_t i) -> Eigen::Vector2d {
        return (curve.points[i].parameters - at.parameters).cwiseQuotient(width);
    };
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
        const Eigen::Vector2d from = place(i - 1), step = place(i) - from;
        const double share = std::clamp(-from.dot(step) / std::max(step.squaredNorm(), 1e-300), 0.0, 1.0);
        if ((from + share * step).norm() > beside) continue;
        const auto& near = curve.points[share < 0.5 ? i - 1 : i].points;
        if (analysis::distance_between(equations_->coordinates, near, at.points) < equations_->follow.longest_step)
            return true;
    }
    return false;
}

bool CurvesOfKind::is_at(const Boundary& part, std::size_t i, const Boundary& whole) const {
    const Eigen::VectorXd& y = part.points[i].at.y;
    const double cosine = part.kind == analysis::BoundaryKind::neimark_sacker ? y[y.size() - 1] : 1;
    const std::complex<double> multiplier(cosine, std::sqrt(std::max(0.0, 1 - cosine * cosine)));
    return analysis::is_on_boundary(equations_->map, part.kind, part.points[i].at.points(),
                                    analysis::parameters_of(part, y), multiplier, equations_->smooth, {&whole, 1});
}

bool CurvesOfKind::is_at(const BorderCurve& part, std::size_t i, const BorderCurve& whole) const {
    const BorderCycle cycle = border_cycle_at(equations_->words, part.like, part.arc.points[i].y);
    const auto solved = solved_on_border(equations_->words, equations_->plane, cycle);
    return solved && is_on(equations_->words, equations_->plane, cycle, *solved, equations_->border, whole);
}

}  // namespace swirl::studies::bifurcation_curves
