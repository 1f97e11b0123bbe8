#include "map/baselines/baseline_contact.hpp"
#include "map/baselines/touching_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace swirl {

namespace {

constexpr int bisections = 10;
constexpr int most_newton_steps = 50;

/// The points of a flight, and the counts of moments looked at and of gaps.
struct Points {
    const Body<double>& body;
    const Flight<double>& flight;
    int steps = 0;
    long gaps = 0;

    detail::TouchingPoint at(int k, double time) {
        ++steps;
        ++gaps;
        return detail::touching_point(body, flight, detail::moment_of(body, flight, time), k);
    }
    /// The appendix' R_c − ‖X_i − O‖ < ε.
    bool is_out(int k, double time) {
        return time > 0 && 1 - detail::magnitude(at(k, time).position) < paper_tolerance;
    }
};

/// When the centre, from `position` relative to the swirl's centre, leaves the circle of a radius about it; 0 if never.
double leaves_circle(const Vec2<double>& position, const Vec2<double>& velocity, double radius) {
    const double speed2 = dot(velocity, velocity);
    if (!(radius > 0 && speed2 > 0)) return 0;
    const double along = dot(position, velocity);
    const double depth = dot(position, position) - radius * radius;
    const double discriminant = along * along - speed2 * depth;
    if (!(discriminant >= 0)) return 0;
    const double root = std::sqrt(discriminant);
    const double time = along > 0 ? -depth / (along + root) : (root - along) / speed2;
    return time > 0 && std::isfinite(time) ? time : 0;
}

/// 0 and the four guesses in their order; those that do not exist are 0.
std::array<double, 5> guesses(const Body<double>& body, const Flight<double>& flight) {
    const Vec2<double> position = flight.centre + flight.beta * flight.phase;
    std::array<double, 5> times{};
    auto time = times.begin() + 1;
    for (const double circle : {1 - flight.beta, 1 + flight.beta}) {
        const double half_side = 0.5 * body.side;
        const double apothem =
            body.sides == disk_sides ? body.alpha : std::sqrt(body.alpha * body.alpha - half_side * half_side);
        const double two_touch = circle > half_side ? std::sqrt(circle * circle - half_side * half_side) - apothem : 0;
        *time++ = leaves_circle(position, flight.velocity, circle - body.alpha);
        *time++ = leaves_circle(position, flight.velocity, two_touch);
    }
    std::sort(times.begin(), times.end());
    return times;
}

/// Where Newton's method is to begin in an interval; negative if bisection sees no change of sign.
double bisected(Points& points, int k, double from, double to) {
    bool out_from = points.is_out(k, from), out_to = points.is_out(k, to);
    for (int i = 0; i < bisections; ++i) {
        const double middle = 0.5 * (from + to);
        const bool out = points.is_out(k, middle);
        if (out != out_from) {  // the earlier half
            to = middle;
            out_to = out;
        } else if (out != out_to) {
            from = middle;
            out_from = out;
        } else {
            return -1;
        }
    }
    return 0.5 * (from + to);
}

/// Newton's method on |x| − 1; not positive if it does not arrive.
double newton(Points& points, int k, double time) {
    for (int i = 0; i < most_newton_steps && std::isfinite(time); ++i) {
        const detail::TouchingPoint point = points.at(k, time);
        const double distance = detail::magnitude(point.position);
        if (std::fabs(1 - distance) < paper_tolerance) return time;
        time -= (distance - 1) * distance / dot(point.position, point.rate);
    }
    return -1;
}

/// The two checks of the report: the vertex moves outward, and no vertex is outside.
bool is_physical(Points& points, int k, double time) {
    const Instant<double> at = detail::moment_of(points.body, points.flight, time);
    const detail::TouchingPoint point = detail::touching_point(points.body, points.flight, at, k);
    if (!(dot(point.position, point.rate) > 0)) return false;
    if (detail::all_inside(points.body, at)) return true;
    for (int j = 0; j < detail::touching_points(points.body); ++j, ++points.gaps) {
        const detail::TouchingPoint other = detail::touching_point(points.body, points.flight, at, j);
        if (detail::magnitude(other.position) - 1 > paper_tolerance) return false;
    }
    return true;
}

}  // namespace

FirstContact<double> paper_contact(const Body<double>& body, const Flight<double>& flight) {
    if (const auto decided = detail::decided_at_start(body, flight)) return *decided;
    Points points{body, flight};
    const std::array<double, 5> times = guesses(body, flight);
    double earliest = 0;
    int vertex = -1;
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (!(times[i] > times[i - 1])) continue;
        for (int k = 0; k < detail::touching_points(body); ++k) {
            if (points.gaps > detail::most_gaps) return detail::given_up(points.steps);
            const double near = bisected(points, k, times[i - 1], times[i]);
            const double time = near > 0 ? newton(points, k, near) : -1;
            if (!(time > 0) || (vertex >= 0 && time >= earliest) || !is_physical(points, k, time)) continue;
            earliest = time;
            vertex = k;
        }
    }
    if (vertex < 0) return detail::given_up(points.steps);
    return detail::contact_of(body, detail::moment_of(body, flight, earliest), vertex, points.steps);
}

}  // namespace swirl
