// The return map: from one impact to the next, through chatter and sustained contact where there is any.
#pragma once

#include "map/collision_map.hpp"
#include "map/outcome.hpp"
#include "map/sustained/contact_phase.hpp"
#include "map/sustained/release.hpp"

#include <optional>

namespace swirl {

/// From just after an impact to just after the next.
template <class T>
struct Passage {
    Outcome outcome = Outcome::completed;  ///< completed: `collision` is the next impact
    Collision<T> collision;                ///< its flight_time, normal and vertex_step are those of the whole passage
    T turned{};                            ///< ∫ S dt on the way
    T contact_work{};  ///< ∫ f (u_t − 1) dt: what friction in contact and the end of chatter added to J
    std::vector<ContactSegment> contacts;
};

/// How long contact may last without an impact before the orbit ends as `in_contact`, in 1/ω_s (less where the body
/// swings very fast: `most_contact_steps`).
inline constexpr double contact_horizon = 1000;

/// F with sustained contact. For e = 1 it is the collision map itself, but for one thing: where friction holds a
/// polygon's vertex its normal velocity may fall with every impact (Poisson, Stronge: B₃ couples it to friction), and
/// from the impact at which it is lost in rounding the orbit goes on in contact. A disk and a frictionless body at e =
/// 1 keep |u_n|, and need none of it. Contact is integrated in double, whatever T is.
template <class Map>
class ReturnMap {
public:
    using T = typename Map::Number;
    static constexpr Shape shape = Map::shape;

    /// The map must outlive it.
    explicit ReturnMap(const Map& map) : map_(map) {
        const auto& s = map.scene();
        sums_chatter_ = s.restitution < T(1);
        if (!sums_chatter_ && (shape == Shape::disk || Map::rule == ImpactRule::frictionless)) return;
        Scene<double> scene{s.sides,
                            static_cast<double>(s.alpha),
                            static_cast<double>(s.beta),
                            static_cast<double>(s.mu),
                            static_cast<double>(s.restitution),
                            s.law,
                            static_cast<double>(s.inertia_factor)};
        contact_ = contact_scene(make_body(scene), scene.mu, scene.restitution, Map::rule);
    }

    const Map& map() const { return map_; }
    /// What contact needs of the scene; only for e < 1, or a polygon with friction.
    const ContactScene& contact() const { return *contact_; }

    /// The first impact of a flight in the laboratory.
    Passage<T> advance(const Flight<T>& flight) const {
        Passage<T> passage;
        map_.advance(flight, passage.collision);
        passage.turned = flight.spin * passage.collision.flight_time;
        passage.outcome = outcome_of(passage.collision.contact);
        return passage;
    }

    /// From just after an impact.
    ///   horizon  for how long contact without an impact is followed
    ///   sink     looks at contact on its way
    Passage<T> advance(const Launch<T>& launch, double horizon = contact_horizon, const ContactSink& sink = {}) const {
        if (sums_chatter_ && may_stand(*contact_, plain_launch(launch)))
            if (const Standing standing = standing_of(*contact_, plain_launch(launch));
                standing.in_contact || standing.struck)
                return advance_standing(launch, standing, horizon, sink);
        Passage<T> passage = advance(flight_from(map_.body(), launch));
        if (contact_ && passage.collision.contact == ContactOutcome::sustained)
            return advance_standing(launch, held(launch), horizon, sink);
        if (passage.outcome == Outcome::completed && changes_nothing(passage.collision))
            passage.outcome = Outcome::unresolved;
        return passage;
    }

    /// The same from the end of a passage, in place: for long orbits, where a copy of what has just been written costs
    /// more than many a calculation. Unless `completed`, only `contacts` changes, to those after its impact.
    Outcome advance(Passage<T>& passage, double horizon = contact_horizon, const ContactSink& sink = {}) const {
        Collision<T>& collision = passage.collision;
        if (!sums_chatter_ || !may_stand(*contact_, plain_launch(collision.after))) [[likely]] {
            const T spin = collision.after.spin;
            map_.advance(collision.after, collision);
            if (collision.contact == ContactOutcome::contact && !changes_nothing(collision)) [[likely]] {
                passage.turned = spin * collision.flight_time;
                passage.contact_work = T(0);
                passage.contacts.clear();
                return passage.outcome = Outcome::completed;
            }
        }
        const Launch<T> launch = collision.after;  // unless there was a contact it is what it was
        Passage<T> next = advance(launch, horizon, sink);
        if (next.outcome != Outcome::completed) {
            passage.contacts = std::move(next.contacts);
            return next.outcome;
        }
        passage = std::move(next);
        return Outcome::completed;
    }

    /// How the body stands just after an impact from which `advance` led through contact.
    Standing standing(const Launch<T>& launch) const {
        if (!sums_chatter_) return held(launch);
        const Standing standing = standing_of(*contact_, plain_launch(launch));
        return standing.in_contact ? standing : held(launch);
    }

    /// From a landing on, `launch` being the impact before it.
    Passage<T> advance_standing(const Launch<T>& launch, const Standing& standing, double horizon = contact_horizon,
                                const ContactSink& sink = {}) const {
        const ContactPhase phase = standing.struck ? struck_at_once(*contact_, plain_launch(launch))
                                                   : follow_contact(*contact_, standing, horizon, sink);
        Passage<T> passage = after_contact(launch, phase);
        passage.contact_work = T(phase.sums.work + standing.jacobi);
        return passage;
    }

private:
    /// An impact without time and without impulse would come again for ever.
    bool changes_nothing(const Collision<T>& c) const {
        return contact_ && c.flight_time == T(0) && c.impulse.normal == T(0);
    }

    /// The search found the body held that `standing_of` saw leave: on the border between the two.
    Standing held(const Launch<T>& launch) const {
        Standing standing;
        standing.support = shape == Shape::disk ? Support::rim : Support::vertex;
        standing.state = contact_state(*contact_, plain_launch(launch));
        return standing;
    }

    static Launch<double> plain_launch(const Launch<T>& l) {
        const auto d = [](const T& x) { return static_cast<double>(x); };
        return {{d(l.psi.x), d(l.psi.y)}, {d(l.chi.x), d(l.chi.y)}, d(l.vn), d(l.vt), d(l.spin)};
    }
    /// Contact ends in double's digits; the directions are of length 1 in T's, so that the body touches in these too.
    static Launch<T> launch_of(const Launch<double>& l) {
        return {renormalised(Vec2<T>{T(l.psi.x), T(l.psi.y)}), renormalised(Vec2<T>{T(l.chi.x), T(l.chi.y)}), T(l.vn),
                T(l.vt), T(l.spin)};
    }
    Outcome outcome_of(ContactOutcome contact) const {
        switch (contact) {
            case ContactOutcome::contact:
                return Outcome::completed;
            case ContactOutcome::no_contact:
                return Outcome::no_contact;
            case ContactOutcome::sustained:
                return contact_ ? Outcome::unresolved : Outcome::resting;
            case ContactOutcome::unresolved:
                return Outcome::unresolved;
        }
        return Outcome::unresolved;
    }

    /// The first impact after a release.
    Collision<T> fly_off(const Flight<T>& flight) const {
        const auto contact = contact_after_release<shape>(map_.body(), flight);
        if (!contact) return map_.advance(flight);
        Collision<T> collision;
        if (contact->outcome == ContactOutcome::contact) map_.strike(flight, contact->at, contact->arm, collision);
        collision.contact = contact->outcome;
        collision.steps = contact->steps;
        collision.vertex_step = contact->vertex;
        collision.simultaneous = contact->simultaneous;
        return collision;
    }

    Passage<T> after_contact(const Launch<T>& launch, const ContactPhase& phase) const {
        Passage<T> passage;
        const Launch<T> end = launch_of(phase.strike.after);
        Collision<T>& collision = passage.collision;
        T flight_time{}, flight_turned{};
        Vec2<T> flight_normal{T(1), T(0)};
        if (!phase.resolved) {
            passage.outcome = Outcome::unresolved;
        } else if (phase.finish == ContactEvent::horizon) {
            passage.outcome = Outcome::in_contact;
        } else if (phase.finish == ContactEvent::release) {
            Launch<T> leaving = end;  // a release has u_n = 0, in T's digits too
            leaving.vn = leaving.vn - approach_of(map_.body(), leaving).un;
            const Flight<T> flight = flight_from(map_.body(), leaving);
            collision = fly_off(flight);
            flight_time = collision.flight_time;
            flight_turned = flight.spin * flight_time;
            flight_normal = collision.normal;
            passage.outcome = outcome_of(collision.contact);
        } else {
            collision.contact = ContactOutcome::contact;
            const Impulse<double>& j = phase.strike.impulse;
            collision.impulse = {T(j.normal), T(j.tangential), j.mode};
            collision.jacobi_restitution = T(phase.strike.jacobi_restitution);
            collision.jacobi_friction = T(phase.strike.jacobi_friction);
        }
        if (phase.finish != ContactEvent::release) collision.after = end;
        // The whole passage: arg n has gone on by Δψ + t in contact, and by the flight's own turn after it.
        const T duration(phase.sums.time);
        const Vec2<T> advance = times(seen_from(launch.psi, end.psi), cis(duration));
        collision.normal = times(advance, flight_normal);
        collision.flight_time = duration + flight_time;
        if constexpr (shape == Shape::polygon)
            collision.vertex_step =
                map_.body().vertex_number(static_cast<long long>(collision.vertex_step) + phase.vertex_step);
        passage.turned = T(phase.sums.turned) + flight_turned;
        passage.contacts = phase.segments;
        return passage;
    }

    const Map& map_;
    std::optional<ContactScene> contact_;
    bool sums_chatter_ = false;  ///< e < 1: chatter is looked for after every impact
};

}  // namespace swirl
