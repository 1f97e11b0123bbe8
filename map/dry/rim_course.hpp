// The motion of a disk on the wall over a floor with dry friction, step by step. map/dry/README.md, "Contact".
#pragma once

#include "map/contact/contact_run.hpp"
#include "map/dry/rim_motion.hpp"
#include "map/dry/runge_kutta.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace swirl {

/// ψ, u_t, S, ∫ S dt and ∫ f (u_t − 1) dt.
template <class T>
using RimPlace = std::array<T, 5>;

template <class T>
ContactState<T> contact_of(const RimPlace<T>& y) {
    return {y[0], T(0), y[1], y[2]};
}

/// A place of the integration, with the rate there.
template <class T>
struct RimStation {
    T time{};
    RimPlace<T> y{};
    RimPlace<T> rate{};
};

namespace detail {

template <class T>
RimPlace<T> rim_rate(const RimScene<T>& scene, const RimMotion& motion, const RimPlace<T>& y) {
    const ContactState<T> z = contact_of(y);
    if (motion.rests) return {T(-1), T(0), T(0), T(0), T(0)};
    const RimForces<T> forces = rim_forces(scene, motion, z);
    return {along_wall(scene, z) * scene.body->inverse_inner - T(1), forces.ut_rate, forces.spin_rate, z.spin,
            forces.friction * (z.ut - T(1))};
}

}  // namespace detail

template <class T>
RimStation<T> rim_station(const RimScene<T>& scene, const RimMotion& motion, const T& time, const RimPlace<T>& y) {
    return {time, y, detail::rim_rate(scene, motion, y)};
}

/// The place a time h after a station.
template <class T>
RimPlace<T> rim_place_after(const RimScene<T>& scene, const RimMotion& motion, const RimStation<T>& station,
                            const T& h) {
    const auto rate = [&](const T&, const RimPlace<T>& y) { return detail::rim_rate(scene, motion, y); };
    return detail::runge_kutta_step(rate, station.time, station.y, station.rate, h).place;
}

/// What holds along a motion and ends it where it falls below zero.
///     0  λ          release
///     1  rolling: μλ − |f|, slip       sliding: s u_t, stick
///     2  in line on a dish: ρν′ by `heading`; at 0 the disk has come to rest
inline constexpr std::size_t rim_conditions = 3;

template <class T>
T rim_condition(const RimScene<T>& scene, const RimMotion& motion, const ContactState<T>& z, std::size_t which) {
    using std::abs;
    if (which == 2)
        return detail::goes_in_line(scene, motion, z.spin) ? T(T(motion.heading) * along_wall(scene, z)) : T(1);
    if (which == 1 && plain(scene.mu) == 0) return T(1);
    if (which == 1 && !motion.rolls()) return T(motion.sense()) * z.ut;
    const RimForces<T> forces = rim_forces(scene, motion, z);
    return which == 0 ? forces.normal : T(scene.mu * forces.normal - abs(forces.friction));
}

inline ContactEvent rim_event(const RimMotion& motion, std::size_t which) {
    if (which == 0) return ContactEvent::release;
    return which == 1 && motion.rolls() ? ContactEvent::slip : ContactEvent::stick;
}

/// The steps of a motion in double: what they are depends on its start alone. Local errors are below 10⁻¹⁴, of
/// velocities relative to 1 + speed.
class RimCourse {
public:
    static constexpr double longest_step = 0.125;  ///< in 1/ω_s

    /// A slip from rest begins with its creep: the first station is at its end, or after `most` of it.
    RimCourse(const RimScene<double>& scene, const RimMotion& motion, const ContactState<double>& start,
              double most = std::numeric_limits<double>::infinity());

    const RimMotion& motion() const { return motion_; }
    const RimStation<double>& station() const { return station_; }
    /// The step that was taken to it, and the station before.
    const RimStation<double>& before() const { return before_; }
    double step() const { return step_; }

    /// The next station, by no more than `most`.
    void advance(double most);

    struct Failure {
        double time;  ///< after the station before, on the side where the condition fails
        std::size_t which;
    };
    /// The first condition that fails on the last step. Looked at in eight parts: a dip below zero that is over within
    /// one, and not seen by the slopes at its ends, is missed.
    std::optional<Failure> failure() const;

    /// A disk that slides and spins on a dish has come to rest: what is left is rounding, and friction holds it.
    bool has_stopped() const;

private:
    using Conditions = std::array<double, rim_conditions>;

    RimPlace<double> after(double h) const { return h == 0 ? before_.y : rim_place_after(scene_, motion_, before_, h); }
    RimPlace<double> about(double h) const;
    Conditions conditions(const RimPlace<double>& y) const;
    double condition(double h, std::size_t which) const;
    double locate(std::size_t which, double from, double to) const;
    double longest() const;
    void end_spin();

    const RimScene<double>& scene_;
    RimMotion motion_;
    RimStation<double> station_, before_;
    double step_ = 0;
    double proposed_ = longest_step;
    double scale_ = 1;  ///< of accelerations
    double stiff_ = 0;  ///< a quarter of the rate at which S comes to nothing, by |ρν′|
};

}  // namespace swirl
