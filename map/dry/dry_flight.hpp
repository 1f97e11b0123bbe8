// Flight over a floor with dry friction: what friction adds to the free flight is integrated. map/dry/README.md,
// "Flight".
//
//     V = V₀ + v   X = X₀ + V₀τ + d − w₀ E(τ)   θ = S₀τ + δ   S = S₀ + s
//     d′ = v   v′ = −a_f ⟨û⟩   δ′ = s   s′ = −(a_f/I) ⟨ρ × û⟩   U = V − i w (dish), V (table)
#pragma once

#include "map/dry/runge_kutta.hpp"
#include "map/dry/uniform_pressure.hpp"
#include "map/model/flight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace swirl {

/// The start of a flight and what acts on it.
template <class T>
struct DryFlight {
    Flight<T> start;
    const Body<T>* body = nullptr;
    const UniformPressure* pressure = nullptr;
    T deceleration{};     ///< a_f
    bool is_dish = true;  ///< else the floor is at rest
};

/// (d, v, δ, s): what friction has changed.
template <class T>
using Slowing = std::array<T, 6>;

/// A moment of it.
template <class T>
struct DryMoment {
    Instant<T> at;
    Vec2<T> velocity;  ///< V
    T spin{};          ///< S
    T turned{};        ///< ∫ S dt
};

namespace detail {

/// U, against the floor.
template <class T>
Vec2<T> against_floor(const DryFlight<T>& flight, const Vec2<T>& velocity, const Vec2<T>& phase) {
    return flight.is_dish ? velocity - quarter_turned(Vec2<T>(flight.start.beta * phase)) : velocity;
}

/// The rate of what friction changes. Where nothing slides yet, it is against where the body is about to slide.
template <class T>
Slowing<T> slowing_rate(const DryFlight<T>& flight, const T& time, const Slowing<T>& y) {
    const Flight<T>& start = flight.start;
    const Vec2<T> velocity{start.velocity.x + y[2], start.velocity.y + y[3]};
    const T spin = start.spin + y[5];
    const Vec2<T> phase = turned(start.phase, cis_minus_one(time));
    Vec2<T> slip = against_floor(flight, velocity, phase);
    if (plain(slip.x) == 0 && plain(slip.y) == 0 && plain(spin) == 0) {
        if (!flight.is_dish || plain(start.beta) == 0) return {y[2], y[3], T(0), T(0), y[5], T(0)};
        slip = phase;
    }
    Vec2<T> arm{T(0), T(0)};
    if (flight.body->sides != disk_sides) arm = turned(start.arm, cis_minus_one(T(start.spin * time + y[4])));
    const MeanSlip<T> mean = flight.pressure->mean_slip(*flight.body, slip, spin, arm);
    const T& a = flight.deceleration;
    return {y[2],
            y[3],
            -a * mean.direction.x,
            -a * mean.direction.y,
            y[5],
            -a * mean.moment * flight.body->inverse_inertia};
}

}  // namespace detail

template <Shape shape, class T>
DryMoment<T> dry_moment(const DryFlight<T>& flight, const T& time, const Slowing<T>& y) {
    const Flight<T>& start = flight.start;
    DryMoment<T> moment;
    Instant<T>& at = moment.at;
    const Vec2<T> turn = cis_minus_one(time);
    at.time = time;
    at.moved = time * start.velocity + Vec2<T>{y[0], y[1]} - start.beta * times(start.phase, turn);
    at.phase = turned(start.phase, turn);
    at.centre = start.centre + at.moved;
    at.swirl = start.beta * at.phase;
    moment.velocity = {start.velocity.x + y[2], start.velocity.y + y[3]};
    moment.spin = start.spin + y[5];
    moment.turned = start.spin * time + y[4];
    at.drift = moment.velocity - quarter_turned(at.swirl);
    if constexpr (shape == Shape::polygon) {
        at.arm_moved = times(start.arm, cis_minus_one(moment.turned));
        at.arm = start.arm + at.arm_moved;
    }
    return moment;
}

/// The flight as the impact at its end needs it.
template <class T>
Flight<T> arriving(const DryFlight<T>& flight, const DryMoment<T>& moment) {
    Flight<T> end = flight.start;
    end.velocity = moment.velocity;
    end.spin = moment.spin;
    return end;
}

/// A place of the integration, with the rate there.
template <class T>
struct Station {
    T time{};
    Slowing<T> y{};
    Slowing<T> rate{};
};

template <class T>
Station<T> first_station(const DryFlight<T>& flight) {
    Station<T> station;
    station.rate = detail::slowing_rate(flight, T(0), station.y);
    return station;
}

/// What friction has changed a time h after a station.
template <class T>
Slowing<T> slowing_after(const DryFlight<T>& flight, const Station<T>& station, const T& h) {
    const auto rate = [&](const T& t, const Slowing<T>& y) { return detail::slowing_rate(flight, t, y); };
    return detail::runge_kutta_step(rate, station.time, station.y, station.rate, h).place;
}

/// A body that stops within such a time, in 1/ω_s, and moves by less than 10⁻²⁰ in it has stopped.
inline constexpr double time_left_at_stop = 0x1p-36;

/// |U| with which it does: it moves by |U|²/2a, and turns by at most S times the time that is left.
inline double speed_left_at_stop(double deceleration) {
    return std::min(time_left_at_stop * deceleration, std::sqrt(2e-20 * deceleration));
}

/// The steps by which a flight is integrated in double, one after the other: what they are depends on its start alone.
class DryCourse {
public:
    /// Local errors of a step are below it: of lengths in R_c, of angles in radians, relative to 1 + speed and 1 + |S|.
    static constexpr double tolerance = 1e-14;
    static constexpr double longest_step = 1;  ///< in 1/ω_s

    explicit DryCourse(const DryFlight<double>& flight);

    const Station<double>& station() const { return station_; }
    /// The step that was taken to it, and the station before.
    const Station<double>& before() const { return before_; }
    double step() const { return step_; }

    /// Neither slides nor turns against the floor, and friction holds it: U = 0, S = 0 to what follows within
    /// 10⁻¹¹/ω_s. Sliding and spinning end together (Farkas et al., PRL 90, 248302).
    bool has_stopped() const { return has_stopped_; }

    /// The next station. Not after it has stopped.
    void advance();

private:
    bool is_held(const Station<double>& station) const;
    double longest() const;

    const DryFlight<double>& flight_;
    Station<double> station_, before_;
    double step_ = 0;
    double proposed_ = 0.125;
    double speed_scale_ = 0;      ///< of which U and αS are differences
    double sliding_change_ = 0;   ///< |U|′ at most
    double spinning_change_ = 0;  ///< α|S|′ at most
    bool has_stopped_ = false;
};

}  // namespace swirl
