#include "map/dry/dry_flight.hpp"

#include <algorithm>
#include <limits>

namespace swirl {

namespace {

struct Slip {
    double sliding, spinning;  ///< |U|, α|S|
    Vec2<double> velocity;     ///< U
    double spin;               ///< S
};

Slip slip_of(const DryFlight<double>& flight, const Station<double>& station) {
    const Flight<double>& start = flight.start;
    const Vec2<double> velocity{start.velocity.x + station.y[2], start.velocity.y + station.y[3]};
    const Vec2<double> slip = detail::against_floor(flight, velocity, turned(start.phase, cis_minus_one(station.time)));
    const double spin = start.spin + station.y[5];
    return {std::hypot(slip.x, slip.y), flight.body->alpha * std::fabs(spin), slip, spin};
}

}  // namespace

DryCourse::DryCourse(const DryFlight<double>& flight) : flight_(flight), station_(first_station(flight)) {
    const Body<double>& body = *flight.body;
    const Flight<double>& start = flight.start;
    speed_scale_ = std::hypot(start.velocity.x, start.velocity.y) + (flight.is_dish ? start.beta : 0) +
                   body.alpha * std::fabs(start.spin);
    sliding_change_ = (flight.is_dish ? start.beta : 0) + flight.deceleration;
    spinning_change_ =
        flight.deceleration * flight.pressure->distance() * body.alpha * body.alpha * body.inverse_inertia;
    has_stopped_ = is_held(station_);
}

bool DryCourse::is_held(const Station<double>& station) const {
    if (flight_.is_dish && flight_.start.beta > flight_.deceleration) return false;
    const Slip slip = slip_of(flight_, station);
    const double rounding = 64 * epsilon<double>() * speed_scale_;
    const double sliding = speed_left_at_stop(flight_.deceleration);
    const double spinning = time_left_at_stop * spinning_change_;
    return slip.sliding <= std::max(rounding, sliding) && slip.spinning <= std::max(rounding, spinning);
}

/// Near U = 0, S = 0 the direction of friction turns within the time in which the body comes there; and the body's
/// border turns with it.
double DryCourse::longest() const {
    const Slip slip = slip_of(flight_, station_);
    double change = sliding_change_ + spinning_change_;
    const double to_stop = std::max(detail::shortest_step, 0.5 * (slip.sliding + slip.spinning) / change);
    const Body<double>& body = *flight_.body;
    Vec2<double> arm{body.alpha, 0};
    double along_rate = 0;
    if (body.sides != disk_sides) {
        arm = turned(flight_.start.arm, cis_minus_one(flight_.start.spin * station_.time + station_.y[4]));
        change += std::fabs(slip.spin) * slip.sliding;
        Vec2<double> rate{station_.rate[2], station_.rate[3]};
        if (flight_.is_dish)  // i w turns
            rate = rate + flight_.start.beta * turned(flight_.start.phase, cis_minus_one(station_.time));
        along_rate = (dot(rate, arm) + slip.spin * dot(slip.velocity, quarter_turned(arm))) / body.alpha;
    }
    const double to_border =
        flight_.pressure->step_to_border(body, slip.velocity, slip.spin, arm, flight_.deceleration, change, along_rate);
    return std::min({to_stop, to_border, longest_step});
}

void DryCourse::advance() {
    const auto rate = [this](double t, const Slowing<double>& y) { return detail::slowing_rate(flight_, t, y); };
    const Flight<double>& start = flight_.start;
    const double slide = tolerance * (1 + std::hypot(start.velocity.x, start.velocity.y));
    const double spin = tolerance * (1 + std::fabs(start.spin));
    const auto taken = detail::step_within<6>({slide, slide, slide, slide, spin, spin}, rate, station_.time, station_.y,
                                              station_.rate, std::min(proposed_, longest()));
    before_ = station_;
    step_ = taken.length;
    proposed_ = taken.proposed;
    station_.time += step_;
    station_.y = taken.place;
    station_.rate = rate(station_.time, station_.y);
    has_stopped_ = is_held(station_);
}

}  // namespace swirl
