#include "map/dry/riding.hpp"

#include "map/dry/dry_map.hpp"
#include "map/first_contact/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace swirl {

namespace {

/// The circle that it would come to, about Q in the axes of the flight.
struct Circle {
    Vec2<double> factor;  ///< c: U = c w
    double radius;        ///< |c|β = |U|
    Vec2<double> middle;  ///< Q = X + i c w
};

/// i c = 1 − (a_f/β) c/|c|
Circle circle_of(const DryFlight<double>& flight, const DryMoment<double>& moment) {
    const double part = flight.deceleration / flight.start.beta, size = std::sqrt((1 - part) * (1 + part));
    const Vec2<double> c{size * part, -size * size};
    return {c, size * flight.start.beta, moment.at.centre + quarter_turned(times(c, moment.at.swirl))};
}

}  // namespace

double farthest_point(const Body<double>& body, const Vec2<double>& place, const Vec2<double>& arm) {
    if (body.sides == disk_sides) return detail::magnitude(place) + body.alpha;
    double most = 0;
    for (int k = 0; k < body.sides; ++k)
        most = std::max(most, detail::magnitude(Vec2<double>(place + body.turned_to_vertex(arm, k))));
    return most;
}

bool rides(const DryFlight<double>& flight, const DryMoment<double>& moment) {
    const double beta = flight.start.beta, a = flight.deceleration;
    if (!flight.is_dish || !(beta > a) || !(a > 0)) return false;
    const Circle circle = circle_of(flight, moment);
    const Vec2<double> slip = moment.velocity - quarter_turned(moment.at.swirl);
    const double speed = circle.radius;
    const double apart = detail::magnitude(Vec2<double>(slip - times(circle.factor, moment.at.swirl)));
    const Body<double>& body = *flight.body;
    const double turning = body.alpha * std::fabs(moment.spin);
    if (!(apart + turning <= 1e-3 * speed)) return false;  // linear order is 10⁻³ of itself off
    // What is apart falls as λ² + (a/|U|)λ + 1 = 0, spin at half of a_f ⟨|ρ|²⟩/(I |U|).
    const double damping = a / speed;
    const double slowest = damping < 2 ? 0.5 * damping : 0.5 * (damping - std::sqrt(damping * damping - 4));
    const double spin_damping =
        0.5 * damping * flight.pressure->square() * body.alpha * body.alpha * body.inverse_inertia;
    // Its way is at most |δ|/λ times the condition of the two eigenvectors, below 4 but near damping = 2: bounded by 8.
    const double left = 8 * (apart / slowest + turning / spin_damping);
    return farthest_point(body, circle.middle, moment.at.arm) + speed + left < 1;
}

std::optional<Riding> riding_over_dry_floor(const Scene<double>& scene, const Flight<double>& start, bool released) {
    return with_dry_map(scene, [&](const auto& map) -> std::optional<Riding> {
        constexpr Shape shape = std::decay_t<decltype(map)>::shape;
        const DryFlight<double> flight = map.dry_flight(start);
        const DryContact end = released ? first_contact_after_release<shape>(flight) : first_contact<shape>(flight);
        const DryMoment<double>& moment = end.moment;
        FirstContactOutcome outcome = end.found.outcome;
        if (end.has_stopped) {
            Collision<double> collision;
            map.advance_from_rest(flight, moment, collision);
            outcome = collision.outcome;
        }
        if (outcome != FirstContactOutcome::no_contact) return {};
        const Body<double>& body = map.body();
        if (!flight.is_dish) {
            const Vec2<double> place = moment.at.centre + moment.at.swirl;
            return Riding{place, body.beta, 1 - body.beta - farthest_point(body, place, moment.at.arm), 0};
        }
        if (body.beta > flight.deceleration) {
            const Circle circle = circle_of(flight, moment);
            return Riding{circle.middle, circle.radius,
                          1 - circle.radius - farthest_point(body, circle.middle, moment.at.arm), 0};
        }
        const Vec2<double>& place = moment.at.centre;
        return Riding{place, 0, 1 - farthest_point(body, place, moment.at.arm), 0};
    });
}

}  // namespace swirl
