// The motion of a body on the wall over a floor with dry friction, step by step. map/dry/README.md, "Contact".
#pragma once

#include "map/contact/contact_run.hpp"
#include "map/contact/contact_watch.hpp"
#include "map/dry/rest_on_wall.hpp"
#include "map/dry/runge_kutta.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace swirl {

/// ψ, χ, u_t, S, ∫ S dt and ∫ f (u_t − 1) dt.
template <class T>
using DryPlace = std::array<T, 6>;

template <class T>
ContactState<T> contact_of(const DryPlace<T>& y) {
    return {y[0], y[1], y[2], y[3]};
}

/// A place of the integration, with the rate there.
template <class T>
struct DryStation {
    T time{};
    DryPlace<T> y{};
    DryPlace<T> rate{};
};

namespace detail {

template <class T>
DryPlace<T> dry_rate(const DryWall<T>& wall, const DryMotion& motion, const DryPlace<T>& y) {
    if (motion.rests) return {T(-1), T(0), T(0), T(0), T(0), T(0)};
    const ContactState<T> z = contact_of(y);
    const Reaction<T> r = reaction_over(wall, motion, z);
    const Body<T>& body = wall.contact.body;
    const T along = motion.support == Support::rim      ? T((z.ut - body.alpha * z.spin) * body.inverse_inner)
                    : motion.support == Support::vertex ? z.ut
                                                        : z.spin;
    const T swings = motion.support == Support::vertex ? T(z.spin - z.ut) : T(0);
    return {along - T(1), swings, r.ut_rate, r.spin_rate, z.spin, r.friction * (z.ut - T(1))};
}

}  // namespace detail

template <class T>
DryStation<T> dry_station(const DryWall<T>& wall, const DryMotion& motion, const T& time, const DryPlace<T>& y) {
    return {time, y, detail::dry_rate(wall, motion, y)};
}

/// The place a time h after a station.
template <class T>
DryPlace<T> dry_place_after(const DryWall<T>& wall, const DryMotion& motion, const DryStation<T>& station, const T& h) {
    const auto rate = [&](const T&, const DryPlace<T>& y) { return detail::dry_rate(wall, motion, y); };
    return detail::runge_kutta_step(rate, station.time, station.y, station.rate, h).place;
}

/// What holds along a motion and ends it where it falls below zero: `conditions_of` contact, and that a motion in one
/// line goes on in its sense; where that ends the body has come to rest.
inline constexpr std::size_t dry_conditions = contact_detail::most_conditions + 1;
inline constexpr std::size_t line_condition = contact_detail::most_conditions;

/// The steps of a motion in double: what they are depends on its start alone. Local errors are below 10⁻¹⁴, of
/// velocities relative to 1 + speed.
class WallCourse {
public:
    static constexpr double longest_step = 0.125;  ///< in 1/ω_s

    /// A slip from rest begins with its creep: the first station is at its end, or after `most` of it.
    WallCourse(const DryWall<double>& wall, const DryMotion& motion, const ContactState<double>& start,
               double most = std::numeric_limits<double>::infinity());

    const DryMotion& motion() const { return motion_; }
    const DryStation<double>& station() const { return station_; }
    /// The step that was taken to it, and the station before.
    const DryStation<double>& before() const { return before_; }
    double step() const { return step_; }

    /// The next station, by no more than `most`.
    void advance(double most);

    struct Failure {
        double time;  ///< after the station before, on the side where the condition fails
        ContactEvent event;
        bool first_lifts = false;
        bool at_rest = false;  ///< a motion in one line has ended
    };
    /// The first condition that fails on the last step. Looked at in eight parts: a dip below zero that is over within
    /// one, and not seen by the slopes at its ends, is missed.
    std::optional<Failure> failure() const;

    /// A body that slips and turns on a dish has come to rest: what is left is rounding, and friction holds it.
    bool has_stopped() const;

private:
    using Conditions = std::array<double, dry_conditions>;

    DryPlace<double> after(double h) const { return h == 0 ? before_.y : dry_place_after(wall_, motion_, before_, h); }
    DryPlace<double> about(double h) const;
    contact_detail::Conditions<double> events(const ContactScene<double>& pushed, const ContactState<double>& z) const;
    Conditions conditions(const DryPlace<double>& y) const;
    double locate(std::size_t which, double from, double to) const;
    double longest() const;
    void end_spin();

    const DryWall<double>& wall_;
    DryMotion motion_;
    DryStation<double> station_, before_;
    double step_ = 0;
    double proposed_ = longest_step;
    double scale_ = 1;  ///< of accelerations
    double stiff_ = 0;  ///< a quarter of the rate at which S comes to nothing, by |U|
};

}  // namespace swirl
