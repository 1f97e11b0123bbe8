#include "analysis/boundaries/arc_walk.hpp"

#include "analysis/continuation/put_before.hpp"
#include "analysis/continuation/step_length.hpp"

#include <optional>
#include <utility>

namespace swirl::analysis {

namespace {

class ArcWalk {
public:
    ArcWalk(const ArcSystem& system, const ArcPoint& start, const ArcOptions& options, Arc& arc)
        : system_(system),
          options_(options),
          arc_(arc),
          start_(start),
          h_(options.first_step, options.longest_step, options.shortest_step) {
        arc_.points.push_back(start);
    }

    void run() {
        while (!ended_) step();  // ends: every step goes on, or halves h down to the shortest
    }

private:
    const ArcPoint& here() const { return arc_.points.back(); }

    void end(ArcEnd why) {
        arc_.end = why;
        ended_ = true;
    }

    void step() {
        if (options_.stop && options_.stop()) return end(ArcEnd::stopped);
        if (static_cast<int>(arc_.points.size()) >= options_.most_points) return end(ArcEnd::most_points);
        ArcPoint next;
        refusal_.clear();
        bool found = correct(system_, here(), h_.value(), next, false) == Correction::converged &&
                     system_.product(here().tangent, next.tangent) > least_cosine_along;
        if (found && options_.accepts) {
            refusal_ = options_.accepts(next);
            found = refusal_.empty();
        }
        if (!found) return shorten();
        if (const auto first = start_ahead()) {
            append(*first, h_.value());
            return end(ArcEnd::closed);
        }
        if (outside(next) > 0) return reach_edge(next);
        append(std::move(next), h_.value());
        h_.succeed();
    }

    void shorten() {
        if (h_.shorten()) return;
        arc_.end_why = refusal_;
        end(refusal_.empty() ? ArcEnd::failed : ArcEnd::refused);
    }

    /// How far outside the plane, in its widths; negative inside.
    double outside(const ArcPoint& point) const {
        return outside_plane(options_.low, options_.high, point.y.segment<2>(options_.parameters));
    }

    void reach_edge(const ArcPoint& beyond) {
        const auto value = [this](const ArcPoint& at) { return outside(at); };
        ArcPoint last;
        const double f0 = outside(here()), h = h_.value();
        if (f0 < 0 && locate(system_, here(), h, f0, outside(beyond), value, last, false)) append(std::move(last), h);
        end(ArcEnd::plane);
    }

    void append(ArcPoint next, double h) {
        for (const auto& test : options_.tests) {
            const double f0 = test.value(here()), f1 = test.value(next);
            ArcPoint at;
            if (f0 * f1 < 0 && locate(system_, here(), h, f0, f1, test.value, at, false))
                arc_.special.push_back({test.kind, at, arc_.points.size() - 1});
        }
        arc_.points.push_back(std::move(next));
    }

    /// The first point, if the curve is back there within the step.
    std::optional<ArcPoint> start_ahead() const {
        if (arc_.points.size() < 3) return std::nullopt;
        ArcPoint start = start_;
        if (options_.turned_to) start.y = options_.turned_to(here().y, start.y);
        if (!passes(system_, here(), h_.value(), start, false)) return std::nullopt;
        return start;
    }

    const ArcSystem& system_;
    const ArcOptions& options_;
    Arc& arc_;
    ArcPoint start_;
    StepLength h_;
    std::string refusal_;
    bool ended_ = false;
};

}  // namespace

Arc follow_arc(const ArcSystem& system, const ArcPoint& start, const ArcOptions& options) {
    Arc arc, back;
    ArcWalk(system, start, options, arc).run();
    if (arc.end == ArcEnd::closed || arc.end == ArcEnd::stopped) {
        arc.begin = arc.end;
        return arc;
    }
    ArcPoint turned = start;
    turned.tangent *= -1;
    ArcWalk(system, turned, options, back).run();
    arc.begin_why = back.end_why;
    put_before(
        std::move(back), arc, [](ArcPoint& point) { point.tangent *= -1; },
        [](ArcSpecial& special) { special.at.tangent *= -1; });
    return arc;
}

}  // namespace swirl::analysis
