#include "apps/studies/bifurcation_curves/all_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace swirl::studies::bifurcation_curves {

namespace {

constexpr int halvings = 2;  ///< of a gap between lines, at most

/// Which lines meet which curves.
class Meetings {
public:
    Meetings(CurveSearch& search, const Scene<double>& scene, const Plane& plane, const LineOptions& options)
        : search_(search), scene_(scene), plane_(plane), options_(options) {}

    /// Follows the curves of these lines.
    void add(const std::vector<Line>& lines) {
        const auto of_lines = starting_points_of_lines(scene_, plane_, lines, options_);
        std::vector<StartingPoint> all;
        std::vector<std::size_t> line_of;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::vector<StartingPoint>& points = of_lines[i].points;
            all.insert(all.end(), points.begin(), points.end());
            line_of.insert(line_of.end(), points.size(), lines_.size() + i);
            for (const CycleSearches& search : of_lines[i].searches) add_search(searches_, search);
        }
        const auto through = search_.follow(all);
        for (std::size_t i = 0; i < through.size(); ++i)
            if (through[i]) met_.emplace_back(line_of[i], *through[i]);
        lines_.insert(lines_.end(), lines.begin(), lines.end());
    }

    /// The lines, of the first `count` alone, that meet each curve.
    std::map<std::size_t, std::set<std::size_t>> of_curves(std::size_t count) const {
        std::map<std::size_t, std::set<std::size_t>> lines;
        for (const auto& [line, curve] : met_)
            if (line < count) lines[search_.whole_of(curve)].insert(line);
        return lines;
    }

    const std::vector<Line>& lines() const { return lines_; }
    const std::vector<CycleSearches>& searches() const { return searches_; }

private:
    CurveSearch& search_;
    const Scene<double>& scene_;
    const Plane& plane_;
    const LineOptions& options_;
    std::vector<Line> lines_;
    std::vector<CycleSearches> searches_;
    std::vector<std::pair<std::size_t, std::size_t>> met_;  ///< line, curve
};

/// The middles of the gaps, wider than `least` of the plane, on both sides of each line that alone meets some curve.
std::vector<Line> lines_beside(const Meetings& meetings, const Plane& plane, double least) {
    const std::vector<Line>& lines = meetings.lines();
    std::array<std::set<double>, 2> places;  // of the lines along an axis, and the plane's edges
    for (int axis = 0; axis < 2; ++axis)
        places[static_cast<std::size_t>(axis)] = {plane.low()[1 - axis], plane.high()[1 - axis]};
    for (const Line& line : lines) places[static_cast<std::size_t>(line.axis)].insert(line.p[1 - line.axis]);
    std::array<std::set<double>, 2> middles;
    for (const auto& [curve, by] : meetings.of_curves(lines.size())) {
        if (by.size() != 1) continue;
        const Line& line = lines[*by.begin()];
        const auto& all = places[static_cast<std::size_t>(line.axis)];
        const auto here = all.find(line.p[1 - line.axis]);
        const double width = plane.high()[1 - line.axis] - plane.low()[1 - line.axis];
        for (const double other : {*std::prev(here), *std::next(here)})
            if (std::abs(other - *here) > least * width)
                middles[static_cast<std::size_t>(line.axis)].insert(0.5 * (other + *here));
    }
    std::vector<Line> between;
    for (int axis = 0; axis < 2; ++axis) {
        for (const double place : middles[static_cast<std::size_t>(axis)]) {
            Line line{axis, plane.low(), offset_of_line(static_cast<int>(lines.size() + between.size()))};
            line.p[1 - axis] = place;
            between.push_back(line);
        }
    }
    return between;
}

std::vector<std::int64_t> times_of(const std::map<std::size_t, std::set<std::size_t>>& curves) {
    std::vector<std::int64_t> times;
    for (const auto& [curve, lines] : curves) times.push_back(static_cast<std::int64_t>(lines.size()));
    return times;
}

}  // namespace

LineSurvey follow_all_curves(CurveSearch& search, const Scene<double>& scene, const Plane& plane,
                             const LineOptions& options) {
    Meetings meetings(search, scene, plane, options);
    meetings.add(lines_through(plane, options.lines));
    LineSurvey survey;
    survey.even = meetings.lines().size();
    for (int level = 1; level <= halvings && !options.control.is_stopped(); ++level) {
        constexpr double rounding = 1e-6;  // gaps are compared with fractions of the even one
        const auto between = lines_beside(meetings, plane, (1 - rounding) * std::ldexp(1.0, 1 - level) / options.lines);
        if (between.empty()) continue;
        meetings.add(between);
    }
    const auto by_even = meetings.of_curves(survey.even), by_all = meetings.of_curves(meetings.lines().size());
    survey.between = meetings.lines().size() - survey.even;
    survey.met = by_all.size();
    survey.met_by_even = by_even.size();
    survey.lone = static_cast<std::size_t>(
        std::count_if(by_all.begin(), by_all.end(), [](const auto& curve) { return curve.second.size() == 1; }));
    survey.searches = meetings.searches();
    survey.by_even = analysis::unseen_cycles(times_of(by_even));
    return survey;
}

}  // namespace swirl::studies::bifurcation_curves
