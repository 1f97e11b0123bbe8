#include "analysis/boundaries/follow_boundary.hpp"
#include "analysis/cycles/cycle.hpp"
#include "apps/studies/bifurcation_curves/border_system.hpp"
#include "apps/studies/bifurcation_curves/born_curves.hpp"
#include "apps/studies/bifurcation_curves/smooth_curve.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::studies::bifurcation_curves {

using analysis::Boundary;

/// Its state.
class CurveSearch::Walk {
public:
    Walk(const Scene<double>& scene, const Plane& plane, const FollowOptions& follow)
        : scene_(scene),
          plane_(plane),
          map_(plane_map_of(scene, plane.parameter(0), plane.parameter(1))),
          coordinates_(analysis::on_line(map_, 0, plane.low())),
          words_(word_map_of(scene, plane.parameter(0), plane.parameter(1))),
          options_(smooth_options(scene, plane, follow.longest_step, follow.control.stop)),
          border_options_{follow.longest_step, follow.control.stop},
          follow_(follow) {}

    void follow(const StartingPoint& start) {
        ++result_.starting_points;
        if (const auto kind = smooth_kind(start.kind)) return follow_smooth(start, *kind);
        if (is_on_border(start.kind)) return follow_touch(start);
        if (std::find(result_.left_out.begin(), result_.left_out.end(), start.kind) == result_.left_out.end())
            result_.left_out.push_back(start.kind);
    }

    /// Where curves that were followed since lead to others.
    std::vector<StartingPoint> take_ends() { return std::exchange(ends_, {}); }
    PlaneCurves result() const {
        PlaneCurves found = result_;
        std::erase_if(found.curves, [](const Curve& curve) { return curve.points.empty(); });
        return found;
    }
    const RunControl& control() const { return follow_.control; }

private:
    /// A curve, and its place among the result's.
    template <class Followed>
    struct Known {
        Followed curve;
        std::size_t place = 0;
    };

    void follow_smooth(const StartingPoint& start, analysis::BoundaryKind kind) {
        for (const auto& known : known_)
            if (analysis::is_on_boundary(map_, kind, start.points, start.p, start.multiplier, options_,
                                         {&known.curve, 1}))
                return;
        Boundary boundary;
        if (!analysis::follow_boundary(map_, kind, start.points, start.p, start.multiplier, options_, boundary)) {
            ++result_.without;
            return;
        }
        if (follow_.control.is_stopped()) return;  // cut short: not finished
        const Curve curve = curve_of(boundary, coordinates_);
        if (any_holds(known_, boundary, curve)) return;
        leave_out_parts(known_, boundary, curve);
        keep_end(curve.points.front(), curve.begins);
        keep_end(curve.points.back(), curve.ends);
        for (const CurveSpecial& special : curve.special) keep_crossing(curve, special);
        known_.push_back({std::move(boundary), result_.curves.size()});
        result_.curves.push_back(curve);
    }

    /// A curve on which Newton's method failed is met again from beyond, and then followed back over itself.
    template <class Followed>
    bool any_holds(const std::vector<Known<Followed>>& known, const Followed& part, const Curve& listed) const {
        return std::any_of(known.begin(), known.end(), [&](const Known<Followed>& other) {
            return is_part(part, listed, other.curve, result_.curves[other.place]);
        });
    }
    template <class Followed>
    void leave_out_parts(std::vector<Known<Followed>>& known, const Followed& whole, const Curve& listed) {
        std::erase_if(known, [&](const Known<Followed>& other) {
            if (!is_part(other.curve, result_.curves[other.place], whole, listed)) return false;
            result_.curves[other.place].points.clear();  // dropped by `result`
            return true;
        });
    }

    /// At ten of eleven places along it, or all.
    template <class Followed>
    bool is_part(const Followed& part, const Curve& listed, const Followed& whole, const Curve& whole_listed) const {
        if (listed.kind != whole_listed.kind || listed.period != whole_listed.period) return false;
        constexpr std::size_t places = 11;
        std::size_t elsewhere = 0;
        for (std::size_t k = 1; k <= places && elsewhere < 2; ++k) {
            const std::size_t i = k * (listed.points.size() - 1) / (places + 1);
            if (!runs_along(listed.points[i], whole_listed) && !is_at(part, i, whole)) ++elsewhere;
        }
        return elsewhere < 2;
    }

    /// Between two neighbours of a curve's points, where these are so dense that a straight line tells. (Near the place
    /// where Newton's method fails it is no judge.)
    bool runs_along(const CurveCycle& at, const Curve& curve) const {
        constexpr double beside = 1e-6;  // of the plane
        const Eigen::Vector2d width = plane_.high() - plane_.low();
        const auto place = [&](std::size_t i) -> Eigen::Vector2d {
            return (curve.points[i].parameters - at.parameters).cwiseQuotient(width);
        };
        for (std::size_t i = 1; i < curve.points.size(); ++i) {
            const Eigen::Vector2d from = place(i - 1), step = place(i) - from;
            const double share = std::clamp(-from.dot(step) / std::max(step.squaredNorm(), 1e-300), 0.0, 1.0);
            if ((from + share * step).norm() > beside) continue;
            const auto& near = curve.points[share < 0.5 ? i - 1 : i].points;
            if (analysis::distance_between(coordinates_, near, at.points) < follow_.longest_step) return true;
        }
        return false;
    }

    bool is_at(const Boundary& part, std::size_t i, const Boundary& whole) const {
        const Eigen::VectorXd& y = part.points[i].at.y;
        const double cosine = part.kind == analysis::BoundaryKind::neimark_sacker ? y[y.size() - 1] : 1;
        const std::complex<double> multiplier(cosine, std::sqrt(std::max(0.0, 1 - cosine * cosine)));
        return analysis::is_on_boundary(map_, part.kind, part.points[i].at.points(), analysis::parameters_of(part, y),
                                        multiplier, options_, {&whole, 1});
    }
    bool is_at(const BorderCurve& part, std::size_t i, const BorderCurve& whole) const {
        return is_on(words_, plane_, border_cycle_at(words_, part.like, part.arc.points[i].y), border_options_, whole);
    }

    /// Where a curve meets one of another kind. At 1:1 and 1:2 a Neimark–Sacker curve begins, which branches through
    /// the curve's points beside them cross; at the others it is the cycle itself that has both multipliers.
    void keep_crossing(const Curve& curve, const CurveSpecial& special) {
        if (special.kind == "1:1" || special.kind == "1:2") {
            LineOptions lines;
            lines.control.stop = follow_.control.stop;
            lines.max_period = static_cast<int>(std::max(follow_.longest_period, curve.period));
            for (const std::size_t i : {special.after, special.after + 1}) {
                if (i >= curve.points.size()) continue;
                const CurveCycle& beside = curve.points[i];
                for (StartingPoint& start :
                     starting_points_about(scene_, plane_, beside.points, beside.parameters, lines))
                    ends_.push_back(std::move(start));
            }
            return;
        }
        const auto meets = [&](const std::string& kind, std::complex<double> multiplier) {
            if (kind != curve.kind) ends_.push_back({kind, special.cycle.points, special.cycle.parameters, multiplier});
        };
        const bool fold_flip = special.kind == "fold-flip", fold_pair = special.kind == "fold-neimark-sacker",
                   flip_pair = special.kind == "flip-neimark-sacker";
        if (fold_flip || fold_pair) meets("fold", 1);
        if (fold_flip || flip_pair) meets("flip", -1);
        if (fold_pair || flip_pair) meets("neimark-sacker", critical_pair(special.cycle.multipliers));
    }

    void follow_touch(const StartingPoint& start) {
        const auto cycle = border_cycle_of(words_, start);
        if (!cycle) {
            ++result_.without;
            return;
        }
        for (const auto& known : borders_)
            if (is_on(words_, plane_, *cycle, border_options_, known.curve)) return;
        auto curve = follow_border(words_, plane_, *cycle, border_options_);
        if (!curve) {
            ++result_.without;
            return;
        }
        if (follow_.control.is_stopped()) return;
        const Curve listed = curve_of(words_, *curve);
        if (any_holds(borders_, *curve, listed)) return;
        leave_out_parts(borders_, *curve, listed);
        BornPoints born = points_born_on(words_, map_, plane_, options_, follow_.longest_period, *curve);
        result_.starting_points += born.not_found;
        result_.without += born.not_found;
        for (StartingPoint& start_there : born.starting_points) ends_.push_back(std::move(start_there));
        borders_.push_back({std::move(*curve), result_.curves.size()});
        result_.curves.push_back(listed);
    }

    /// A smooth curve that ends on a border is a place to begin at on that border.
    void keep_end(const CurveCycle& last, const std::string& why) {
        if (!is_on_border(why)) return;
        StartingPoint start{why, last.points, last.parameters, 1};
        const auto shooting =
            analysis::shooting_residual(shooting_map_of(scene_at(scene_, plane_, last.parameters)), last.points, 0);
        if (!shooting.alive) return;
        name_flights(start, shooting.steps);
        ends_.push_back(std::move(start));
    }

    Scene<double> scene_;
    Plane plane_;
    analysis::PlaneMap map_;
    analysis::ShootingMap coordinates_;
    WordMap words_;
    analysis::BoundaryOptions options_;
    BorderOptions border_options_;
    FollowOptions follow_;
    PlaneCurves result_;
    std::vector<Known<Boundary>> known_;
    std::vector<Known<BorderCurve>> borders_;
    std::vector<StartingPoint> ends_;
};

CurveSearch::CurveSearch(const Scene<double>& scene, const Plane& plane, const FollowOptions& options)
    : walk_(std::make_unique<Walk>(scene, plane, options)) {}

CurveSearch::~CurveSearch() = default;

void CurveSearch::follow(const std::vector<StartingPoint>& starting_points) {
    const RunControl& control = walk_->control();
    const ReportDone report = control.begin("curves", static_cast<double>(starting_points.size()));
    double done = 0;
    for (const StartingPoint& start : starting_points) {
        if (control.is_stopped()) return;
        walk_->follow(start);
        report(++done);
    }
    for (auto met = walk_->take_ends(); !met.empty(); met = walk_->take_ends())
        for (const StartingPoint& start : met)
            if (!control.is_stopped()) walk_->follow(start);
}

PlaneCurves CurveSearch::found() const {
    return walk_->result();
}

}  // namespace swirl::studies::bifurcation_curves
