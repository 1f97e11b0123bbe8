#include "map/dry/dry_flight.hpp"

#include <algorithm>
#include <limits>

namespace swirl {

namespace {

constexpr double least_step = 0x1p-44;
/// A body that stops within such a time, and moves by less than 10⁻²⁰ in it, or that slides by rounding, has stopped.
constexpr double time_left_at_stop = 0x1p-36;

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
    border_turns_ = body.sides == disk_sides ? 0 : 1;
    has_stopped_ = is_held(station_);
}

bool DryCourse::is_held(const Station<double>& station) const {
    if (flight_.is_dish && flight_.start.beta > flight_.deceleration) return false;
    const Slip slip = slip_of(flight_, station);
    const double rounding = 64 * epsilon<double>() * speed_scale_;
    const double a = flight_.deceleration;
    // By what is left it moves by |U|²/2a and turns by at most S times the time that is left.
    const double sliding = std::min(time_left_at_stop * a, std::sqrt(2e-20 * a));
    const double spinning = time_left_at_stop * spinning_change_;
    return slip.sliding <= std::max(rounding, sliding) && slip.spinning <= std::max(rounding, spinning);
}

/// Near U = 0, S = 0 the direction of friction turns within the time in which the body comes there; and the body's
/// border turns with it.
double DryCourse::longest() const {
    const Slip slip = slip_of(flight_, station_);
    const double change = sliding_change_ + spinning_change_;
    const double to_stop = std::max(least_step, 0.5 * (slip.sliding + slip.spinning) / change);
    const Body<double>& body = *flight_.body;
    Vec2<double> arm{body.alpha, 0};
    if (body.sides != disk_sides)
        arm = turned(flight_.start.arm, cis_minus_one(flight_.start.spin * station_.time + station_.y[4]));
    const double to_border = flight_.pressure->step_to_border(
        body, slip.velocity, slip.spin, arm, change + border_turns_ * std::fabs(slip.spin) * slip.sliding);
    return std::min({to_stop, to_border, longest_step});
}

void DryCourse::advance() {
    const auto rate = [this](double t, const Slowing<double>& y) { return detail::slowing_rate(flight_, t, y); };
    const Flight<double>& start = flight_.start;
    double h = std::min(proposed_, longest());
    while (true) {  // ends: the shortest step is taken whatever its error
        const auto tried = detail::runge_kutta_step(rate, station_.time, station_.y, station_.rate, h);
        const double slide = tolerance * (1 + std::hypot(start.velocity.x, start.velocity.y));
        const double spin = tolerance * (1 + std::fabs(start.spin));
        const double error = detail::error_of<double, 6>(tried, h, {slide, slide, slide, slide, spin, spin});
        const double factor = error > 0 ? 0.9 * std::pow(error, -0.125) : 6.0;
        if (error <= 1 || h <= least_step) {
            before_ = station_;
            step_ = h;
            station_.time += h;
            station_.y = tried.place;
            station_.rate = rate(station_.time, station_.y);
            proposed_ = h * std::clamp(factor, 0.333, 6.0);
            break;
        }
        h = std::max(least_step, h * std::clamp(factor, 0.1, 0.9));
    }
    has_stopped_ = is_held(station_);
}

}  // namespace swirl
