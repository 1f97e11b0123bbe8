// The return map over a floor that drags. Contact with drag is not followed: where it begins the orbit ends, by name.
#pragma once

#include "map/dragged/dragged_map.hpp"
#include "map/orbit/return_map.hpp"

#include <cmath>

namespace swirl {

/// F over a floor that drags, with the interface of every return map. Beside the collision map it ends an orbit where
/// the rest of chattering moves the body by less than `chatter_tolerance` (contact begins), and says of a flight
/// without end what becomes of it.
template <class T, Shape shape_, ImpactRule rule_>
class ReturnMap<DraggedMap<T, shape_, rule_>> {
public:
    using Map = DraggedMap<T, shape_, rule_>;
    static constexpr Shape shape = shape_;

    /// The map must outlive it.
    explicit ReturnMap(const Map& map) : map_(map) {}

    const Map& map() const { return map_; }

    /// The first impact of a flight in the laboratory.
    ReturnStep<T> advance(const Flight<T>& flight) const {
        ReturnStep<T> step;
        map_.advance(flight, step.collision);
        step.turned = map_.turned(flight.spin, step.collision.flight_time);
        step.outcome = outcome_of(step.collision);
        return step;
    }

    /// From just after an impact. There is no contact for a horizon or a sink.
    ReturnStep<T> advance(const PostImpactState<T>& post_impact, double = contact_horizon,
                          const ContactSink& = {}) const {
        if (contact_begins(post_impact)) {
            ReturnStep<T> step;
            step.outcome = Outcome::contact_with_drag;
            return step;
        }
        return advance(flight_from(map_.body(), post_impact));
    }

    /// In place: if what is returned is not `completed`, `collision.after` is what it was.
    Outcome advance(ReturnStep<T>& return_step, double = contact_horizon, const ContactSink& = {}) const {
        const PostImpactState<T> post_impact = return_step.collision.after;
        return_step.contacts.clear();
        if (contact_begins(post_impact)) return Outcome::contact_with_drag;
        map_.advance(post_impact, return_step.collision);
        const Outcome outcome = outcome_of(return_step.collision);
        if (outcome != Outcome::completed) {
            return_step.collision.after = post_impact;
            return outcome;
        }
        return_step.turned = map_.turned(post_impact.spin, return_step.collision.flight_time);
        return_step.contact_work = T(0);
        return return_step.outcome = outcome;
    }

private:
    Outcome outcome_of(const Collision<T>& collision) const {
        switch (collision.outcome) {
            case FirstContactOutcome::contact:
                if (is_out_of_range(collision.after, collision.impulse.normal)) return Outcome::diverged;
                if (collision.flight_time == T(0) && collision.impulse.normal == T(0)) return Outcome::unresolved;
                return Outcome::completed;
            case FirstContactOutcome::no_contact:
                return map_.floor().drag > T(0) && map_.scene().floor == Floor::dish ? Outcome::riding
                                                                                     : Outcome::no_contact;
            case FirstContactOutcome::sustained:
                return Outcome::contact_with_drag;
            case FirstContactOutcome::unresolved:
                break;
        }
        return Outcome::unresolved;
    }

    /// Chattering with normal velocity v and acceleration a towards the wall takes T = 2v/(a(1 − e)) from here on, in
    /// which the body moves off the wall by less than vT.
    bool contact_begins(const PostImpactState<T>& z) const {
        const T& e = map_.scene().restitution;
        if (!(e < T(1))) return false;
        const Body<T>& body = map_.body();
        const T leaving = -contact_kinematics(body, z).un;
        if (leaving > T(0x1p-16) * (T(1) + body.beta + speed_of(body, z.vn, z.vt, z.spin))) return false;
        const DraggedFlight<T> flight = dragged_flight(map_.floor(), flight_from(body, z));
        const DraggedInstant<T> start = dragged_instant<shape>(flight, T(0));
        T pressing;
        if constexpr (shape == Shape::disk)
            pressing = centre_gap(body, flight, start).curvature / (T(2) * body.inner);
        else
            pressing = T(0.5) * vertex_gap(flight, start, start.at.arm, T(0)).curvature;
        return pressing > T(0) && T(2) * leaving * leaving <= chatter_tolerance<T>() * (T(1) - e) * pressing;
    }

    const Map& map_;
};

}  // namespace swirl
