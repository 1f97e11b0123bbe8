#include "analysis/boundaries/plane_curve.hpp"

#include "analysis/special_values.hpp"

#include <cstddef>
#include <optional>
#include <utility>

namespace swirl::analysis {

namespace {

class PlaneCurveWalk final : public CurveWalk {
public:
    PlaneCurveWalk(const CurveProblem& of, const CurvePoint& start, const PlaneCurveOptions& options, PlaneCurve& curve)
        : CurveWalk(of, options.steps, options.stop), options_(options), curve_(curve), start_(start) {
        curve_.points.push_back(start);
    }

private:
    const CurvePoint& here() const override { return curve_.points.back(); }
    std::size_t count() const override { return curve_.points.size(); }

    bool go_to(CurvePoint next) override {
        refusal_ = options_.accepts ? options_.accepts(next) : "";
        if (!refusal_.empty()) return false;
        if (const auto first = start_ahead()) {
            append(*first);
            end(CurveEnd::closed);
        } else if (outside(next) > 0) {
            reach_edge(next);
        } else {
            append(std::move(next));
        }
        return true;
    }

    void meet_end(Correction why) override {
        if (why != Correction::converged) return end(CurveEnd::not_converged);
        curve_.end.border = refusal_;
        end(CurveEnd::border);
    }

    /// How far outside the plane, in its widths; negative inside.
    double outside(const CurvePoint& point) const {
        return outside_plane(options_.low, options_.high, point.y.segment<2>(options_.parameters));
    }

    void reach_edge(const CurvePoint& beyond) {
        const auto value = [this](const CurvePoint& at) { return outside(at); };
        CurvePoint last;
        if (locate(problem_, here(), step_length(), outside(here()), outside(beyond), value, last))
            append(std::move(last));
        end(CurveEnd::plane);
    }

    void append(CurvePoint next) {
        for (const auto& test : options_.tests) {
            CurvePoint at;
            if (locate(problem_, here(), step_length(), test.value(here()), test.value(next), test.value, at))
                curve_.special.push_back({test.kind, at, curve_.points.size() - 1});
        }
        curve_.points.push_back(std::move(next));
    }

    /// The first point, if the curve is back there within the step.
    std::optional<CurvePoint> start_ahead() const {
        if (curve_.points.size() < 3) return std::nullopt;
        CurvePoint start = start_;
        if (options_.turned_to) start.y = options_.turned_to(here().y, start.y);
        if (!passes(problem_, here(), step_length(), start)) return std::nullopt;
        return start;
    }

    const PlaneCurveOptions& options_;
    PlaneCurve& curve_;
    CurvePoint start_;
    std::string refusal_;
};

}  // namespace

double outside_plane(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Eigen::Vector2d& p) {
    if (!p.allFinite()) return infinity;
    const Eigen::Array2d width = (high - low).array();
    return ((low - p).array() / width).max((p - high).array() / width).maxCoeff();
}

void turn(PlaneSpecial& special) {
    turn(special.at);
}

PlaneCurve follow_plane_curve(const CurveProblem& problem, const CurvePoint& start, const PlaneCurveOptions& options) {
    return both_ways(start, [&](const CurvePoint& from) {
        PlaneCurve curve;
        curve.end.why = PlaneCurveWalk(problem, from, options, curve).run();
        return curve;
    });
}

}  // namespace swirl::analysis
