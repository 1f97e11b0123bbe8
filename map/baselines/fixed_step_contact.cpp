#include "map/baselines/baseline_contact.hpp"
#include "map/baselines/touching_points.hpp"

namespace swirl {

namespace {

/// The deepest of the points that are outside and move outward; −1 if there is none.
int deepest_point(const Body<double>& body, const Flight<double>& flight, const Instant<double>& at) {
    int deepest = -1;
    double depth = 0;
    for (int k = 0; k < detail::touching_points(body); ++k) {
        const detail::TouchingPoint point = detail::touching_point(body, flight, at, k);
        if (!(point.gap > depth && dot(point.position, point.rate) > 0)) continue;
        deepest = k;
        depth = point.gap;
    }
    return deepest;
}

/// Moves the body so that the point is on the wall.
void put_back(const Body<double>& body, const Flight<double>& flight, int k, Instant<double>& at) {
    const Vec2<double> position = detail::touching_point(body, flight, at, k).position;
    const double scale = body.sides == disk_sides ? body.inner : 1;
    const Vec2<double> back = scale * ((1 / detail::magnitude(position) - 1) * position);
    at.moved = at.moved + back;
    at.centre = at.centre + back;
}

}  // namespace

FirstContact<double> fixed_step_contact(const Body<double>& body, const Flight<double>& flight, double step) {
    if (const auto decided = detail::decided_at_start(body, flight)) return *decided;
    long gaps = 0;
    for (int steps = 1; steps <= detail::most_moments && gaps <= detail::most_gaps; ++steps) {
        Instant<double> at = detail::moment_of(body, flight, steps * step);
        if (detail::all_inside(body, at)) continue;
        const int k = deepest_point(body, flight, at);
        gaps += detail::touching_points(body);
        if (k < 0) continue;
        put_back(body, flight, k, at);
        return detail::contact_of(body, at, k, steps);
    }
    return detail::given_up(detail::most_moments);
}

}  // namespace swirl
