// The collision map F: from just after one impact to just after the next. Design, section 4.
#pragma once

#include "map/body.hpp"
#include "map/contact_disk.hpp"
#include "map/contact_polygon.hpp"
#include "map/section.hpp"

namespace swirl {

/// One application of the map. Everything but `contact` and `steps` is meaningless unless a contact was found.
template <class T>
struct Collision {
    ContactOutcome contact = ContactOutcome::no_contact;
    Launch<T> after;        ///< the state just after the impact
    T flight_time{};        ///< τ
    Vec2<T> normal;         ///< the new n in the axes of the start: the wall advance is its direction
    int vertex_step = 0;    ///< the vertex that struck, counted from the one before
    Impulse<T> impulse;     ///< p, q and the contact mode
    T jacobi_restitution{}; ///< −p ū_n
    T jacobi_friction{};    ///< q (ū_t − 1)
    bool simultaneous = false;
    int steps = 0;          ///< moments looked at by the search for the contact
};

/// The map of one scene, specialised once: shape and impact rule are template parameters, so that a disk carries no
/// orientation of vertices and a frictionless scene runs no friction code.
template <class T, Shape shape_, ImpactRule rule_>
class CollisionMap {
public:
    static constexpr Shape shape = shape_;
    static constexpr ImpactRule rule = rule_;
    using Number = T;

    /// @throws std::invalid_argument if a parameter is out of range
    explicit CollisionMap(const Scene<T>& scene) : scene_(validated(scene)), body_(make_body(scene)) {}

    const Scene<T>& scene() const { return scene_; }
    const Body<T>& body() const { return body_; }

    /// F, from just after an impact. Cost: one certified search for the contact, one impact.
    Collision<T> advance(const Launch<T>& launch) const { return advance(flight_from(body_, launch)); }

    /// The first impact of any flight.
    Collision<T> advance(const Flight<T>& flight) const {
        const Contact<T> contact = first_contact<shape>(body_, flight);
        Collision<T> collision;
        collision.contact = contact.outcome;
        collision.steps = contact.steps;
        if (contact.outcome != ContactOutcome::contact) return collision;
        strike(flight, contact.at, contact.arm, collision);
        collision.vertex_step = contact.vertex;
        collision.simultaneous = contact.simultaneous;
        return collision;
    }

    /// The impact at a moment known to be the contact of the vertex at X + `arm`; fills all that depends on it.
    void strike(const Flight<T>& flight, const Instant<T>& at, const Vec2<T>& arm, Collision<T>& collision) const {
        const Vec2<T> n = renormalised(at.centre + arm);  // a contact: of length 1 already, but for rounding
        const Vec2<T> velocity = seen_from(n, flight.velocity);
        Launch<T>& after = collision.after;
        after.psi = renormalised(seen_from(at.phase, n));  // ψ = arg n − arg w
        after.chi = shape == Shape::disk ? Vec2<T>{T(1), T(0)} : renormalised((T(1) / body_.alpha) * seen_from(n, arm));
        after.vn = velocity.x;
        after.vt = velocity.y;
        after.spin = flight.spin;
        collision.contact = ContactOutcome::contact;
        collision.flight_time = at.time;
        collision.normal = n;
        apply_impact(collision);
    }

    /// The impact itself: `collision.after` holds the state before and then the state after.
    void apply_impact(Collision<T>& collision) const {
        Launch<T>& state = collision.after;
        const Approach<T> before = approach_of(body_, state);
        const Impulse<T> j = impulse_of(before);
        const T& p = j.normal;
        const T& q = j.tangential;
        state.vn = state.vn - p;
        state.vt = state.vt + q;
        if constexpr (!(shape == Shape::disk && rule == ImpactRule::frictionless))
            state.spin = state.spin + (before.rn * q + before.rt * p) / body_.inertia;
        // u changes linearly in (p, q), so the mean of before and after is the value at half the impulse.
        const T half(0.5);
        collision.jacobi_restitution = -p * (before.un - half * (before.b2() * p + before.b3() * q));
        collision.jacobi_friction = q * (before.ut + half * (before.b3() * p + before.b1() * q) - T(1));
        collision.impulse = j;
    }

private:
    Impulse<T> impulse_of(const Approach<T>& before) const {
        if constexpr (shape == Shape::disk && rule != ImpactRule::frictionless)
            return disk_impulse(before, scene_.mu, scene_.restitution);
        else
            return impulse<rule>(before, scene_.mu, scene_.restitution);
    }

    Scene<T> scene_;
    Body<T> body_;
};

/// Calls `use(map)` with the map specialised for the scene: the one place where a scene's choices are looked at.
/// The disk's three laws coincide (B₃ = 0), so it has one rule with friction.
template <class T, class Use>
auto with_collision_map(const Scene<T>& scene, Use&& use) {
    const bool frictionless = scene.mu == T(0);
    if (scene.is_disk()) {
        if (frictionless) return use(CollisionMap<T, Shape::disk, ImpactRule::frictionless>(scene));
        return use(CollisionMap<T, Shape::disk, ImpactRule::poisson>(scene));
    }
    if (frictionless) return use(CollisionMap<T, Shape::polygon, ImpactRule::frictionless>(scene));
    switch (scene.law) {
        case Law::newton: return use(CollisionMap<T, Shape::polygon, ImpactRule::newton>(scene));
        case Law::stronge: return use(CollisionMap<T, Shape::polygon, ImpactRule::stronge>(scene));
        case Law::poisson: break;
    }
    return use(CollisionMap<T, Shape::polygon, ImpactRule::poisson>(scene));
}

}  // namespace swirl
