#include "analysis/boundaries/arc_walk.hpp"

#include "analysis/continuation/put_before.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swirl::analysis {

namespace {

class ArcWalk {
public:
    ArcWalk(const ArcSystem& system, const ArcPoint& start, const ArcOptions& options, Arc& arc)
        : system_(system), options_(options), arc_(arc), start_(start), h_(options.first_step) {
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
        bool found = correct(system_, here(), h_, next, false) == Correction::converged &&
                     system_.product(here().tangent, next.tangent) > least_cosine_along;
        if (found && options_.accepts) {
            refusal_ = options_.accepts(next);
            found = refusal_.empty();
        }
        if (!found) return shorten();
        if (outside(next) > 0) return reach_edge(next);
        append(std::move(next), h_);
        if (++successes_ > 1) h_ = std::min(1.4 * h_, options_.longest_step);
        if (has_closed()) end(ArcEnd::closed);
    }

    void shorten() {
        h_ *= 0.5;
        successes_ = 0;
        if (h_ >= options_.shortest_step) return;
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
        const double f0 = outside(here()), h = h_;
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

    bool has_closed() {
        const Eigen::VectorXd apart = here().y - start_.y;
        const double away = std::sqrt(system_.product(apart, apart));
        has_left_ = has_left_ || away > 3 * options_.longest_step;
        return has_left_ && away < options_.longest_step && system_.product(here().tangent, start_.tangent) > 0;
    }

    const ArcSystem& system_;
    const ArcOptions& options_;
    Arc& arc_;
    ArcPoint start_;
    double h_;
    int successes_ = 0;
    std::string refusal_;
    bool has_left_ = false;
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
