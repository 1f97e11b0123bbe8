// The collision map over a floor with dry friction, in double: flight and first contact are its own, the impact is
// CollisionMap's. map/dry/README.md
#pragma once

#include "map/collision_map.hpp"
#include "map/contact/release.hpp"
#include "map/dry/dry_contact.hpp"
#include "map/dry/riding.hpp"
#include "map/dry/wall_contact.hpp"
#include "map/map_list.hpp"

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace swirl {

namespace detail {

/// The scene that impacts know.
template <class T>
Scene<T> over_smooth_floor(Scene<T> scene) {
    scene.floor_friction = T(0);
    scene.floor = Floor::dish;
    return scene;
}

}  // namespace detail

/// The flight of a body that has stopped in the laboratory: without friction, which holds it.
template <class T>
Flight<T> resting(const DryFlight<T>& flight, const DryMoment<T>& moment) {
    Flight<T> rest = flight.start;
    rest.centre = moment.at.centre;
    rest.velocity = {T(0), T(0)};
    rest.phase = moment.at.phase;
    rest.spin = T(0);
    if (flight.body->sides != disk_sides) rest.arm = moment.at.arm;
    rest.struck = flight.start.struck && plain(moment.at.time) == 0;
    return rest;
}

/// F over a floor whose friction is dry (Coulomb), with uniform pressure under the body; a_f = 0 gives CollisionMap's
/// to rounding. Contact with the wall is followed beside it (wall_contact.hpp).
template <class T, Shape shape_, ImpactRule rule_>
class DryMap {
public:
    static constexpr Shape shape = shape_;
    static constexpr ImpactRule rule = rule_;
    static constexpr bool has_dry_floor = true;
    using Number = T;
    using Impacts = CollisionMap<T, shape, rule>;

    ///   similar   as in `make_body`
    ///   pressure  that of a body of the same N, which is worked out in some 50 µs
    /// @throws std::invalid_argument if a parameter is out of range, sides > UniformPressure::most_sides, the floor
    /// drags or corners are rounded
    explicit DryMap(const Scene<T>& scene, const Body<T>* similar = nullptr,
                    std::shared_ptr<const UniformPressure> pressure = nullptr)
        : scene_(validated(scene)),
          impacts_(detail::over_smooth_floor(scene), similar),
          pressure_(pressure ? std::move(pressure) : std::make_shared<const UniformPressure>(scene.sides)) {}

    const Scene<T>& scene() const { return scene_; }
    const Body<T>& body() const { return impacts_.body(); }
    const Impacts& impacts() const { return impacts_; }
    const std::shared_ptr<const UniformPressure>& pressure() const { return pressure_; }

    /// `start` with what acts on it; refers to this map.
    DryFlight<T> dry_flight(const Flight<T>& start) const {
        return {start, &body(), pressure_.get(), scene_.floor_deceleration(), scene_.floor == Floor::dish};
    }

    /// F, from just after an impact. Cost: some 100 means over the body's area.
    Collision<T> advance(const PostImpactState<T>& post_impact) const {
        return advance(flight_from(body(), post_impact));
    }
    /// The first impact of any flight.
    Collision<T> advance(const Flight<T>& flight) const {
        Collision<T> collision;
        advance(flight, collision);
        return collision;
    }
    /// F, written into an existing collision; `post_impact` may be its own `after`, which stays as it is if no contact
    /// is found.
    void advance(const PostImpactState<T>& post_impact, Collision<T>& collision) const {
        advance(flight_from(body(), post_impact), collision);
    }
    void advance(const Flight<T>& start, Collision<T>& collision) const {
        static_assert(std::is_same_v<T, double>, "in Jets flights are followed along one in double");
        const DryFlight<T> flight = dry_flight(start);
        end(flight, first_contact<shape>(flight), collision);
    }

    /// The first impact of a body that the wall has released.
    Collision<T> advance_after_release(const Flight<T>& start) const {
        const DryFlight<T> flight = dry_flight(start);
        Collision<T> collision;
        end(flight, first_contact_after_release<shape>(flight), collision);
        return collision;
    }

    /// What contact needs; refers to this map.
    DryWall<T> wall() const {
        return {contact_scene(body(), scene_.mu, scene_.restitution, rule), pressure_.get(),
                scene_.floor_deceleration(), scene_.floor == Floor::dish};
    }

    /// It rests in the laboratory, on a table, until the wall comes. A body that the wall has pushed as far as it comes
    /// is touched by it once a turn, along the wall and at rest against it: nothing moves it any more.
    void advance_from_rest(const DryFlight<T>& flight, const DryMoment<T>& moment, Collision<T>& collision) const {
        constexpr double rounding = 1e-11;  // what many steps on the wall leave of its place
        const Vec2<double> place = moment.at.centre + moment.at.swirl;
        if (body().beta + farthest_point(body(), place, moment.at.arm) <= 1 + rounding) {
            collision.outcome = FirstContactOutcome::no_contact;
            return;
        }
        const Flight<T> rest = resting(flight, moment);
        const bool leaves_wall = rest.struck;  // which has brought it to rest
        const auto contact = leaves_wall ? contact_after_release<shape>(body(), rest) : std::nullopt;
        if (contact) {
            collide(rest, *contact, contact->at, collision);
        } else {
            impacts_.advance(rest, collision);
        }
        collision.flight_time = collision.flight_time + moment.at.time;
    }

    /// ∫ S dt of a flight until `time`.
    double turned(const Flight<double>& start, double time) const {
        const DryFlight<double> flight = dry_flight(start);
        DryCourse course(flight);
        while (!course.has_stopped() && course.station().time < time) course.advance();
        const bool is_after = course.station().time > time;
        const Station<double>& at = is_after ? course.before() : course.station();
        const double until = is_after ? time : at.time;
        const double slowed = is_after ? slowing_after(flight, at, time - at.time)[4] : at.y[4];
        return start.spin * until + slowed;
    }

private:
    void end(const DryFlight<T>& flight, const DryContact& contact, Collision<T>& collision) const {
        if (contact.has_stopped) return advance_from_rest(flight, contact.moment, collision);
        collide(arriving(flight, contact.moment), contact.found, contact.moment.at, collision);
    }

    void collide(const Flight<T>& flight, const FirstContact<T>& found, const Instant<T>& at,
                 Collision<T>& collision) const {
        if (found.outcome == FirstContactOutcome::contact)
            impacts_.strike(flight, at, found.arm, found.vertex, collision);
        collision.outcome = found.outcome;
        collision.steps = found.steps;
        collision.vertex_step = found.vertex;
        collision.simultaneous = found.simultaneous;
    }

    Scene<T> scene_;
    Impacts impacts_;
    std::shared_ptr<const UniformPressure> pressure_;
};

/// Calls `use(map)` with the map specialised for the scene.
template <class T, class Use>
auto with_dry_map(const Scene<T>& scene, Use&& use) {
    return with_map<DryMap>(scene, use);
}

}  // namespace swirl
