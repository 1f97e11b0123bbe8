#include "map/dragged/riding.hpp"

#include "map/dragged/dragged_flight.hpp"
#include "map/first_contact/bounds.hpp"
#include "map/first_contact/vertices.hpp"
#include "map/model/body.hpp"

namespace swirl {

namespace {

/// The distance of the farthest vertex from the container's centre.
double reach_of(const Body<double>& body, const Vec2<double>& place, const Vec2<double>& arm) {
    detail::Candidate<double> nearest;
    nearest.arm = arm;
    detail::turn_to_nearest(body, place, arm, nearest);
    return detail::magnitude(Vec2<double>(place + nearest.arm));
}

}  // namespace

std::optional<Riding> riding_of(const Scene<double>& scene, const Flight<double>& flight) {
    const Body<double> body = make_body(validated(scene));
    const FloorDrag<double> floor = floor_drag(scene);
    if (!(floor.drag > 0)) return {};
    const DraggedFlight<double> dragged = dragged_flight(floor, flight);
    Riding riding;
    riding.radius = detail::magnitude(dragged.ridden);
    riding.place = (flight.centre + dragged.ridden) + (1 / floor.drag) * dragged.stream;
    const bool turns_on = flight.spin != 0 && !(floor.spin_drag > 0);
    riding.spin = turns_on ? flight.spin : 0;
    double reach = detail::magnitude(riding.place) + body.alpha;
    if (!scene.is_disk() && !turns_on) {
        const double turn = flight.spin == 0 ? 0 : flight.spin / floor.spin_drag;
        reach = reach_of(body, riding.place, turned(flight.arm, cis_minus_one(turn)));
    }
    riding.room = 1 - riding.radius - reach;
    return riding;
}

}  // namespace swirl
