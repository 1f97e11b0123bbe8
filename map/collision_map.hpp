// The collision map F: from just after one impact to just after the next. map/README.md, "Collision map".
#pragma once

#include "map/first_contact/first_contact.hpp"
#include "map/map_list.hpp"
#include "map/model/body.hpp"
#include "map/model/section.hpp"

#include <type_traits>

namespace swirl {

/// One application of the map. Everything but `contact` and `steps` is meaningless unless a contact was found.
template <class T>
struct Collision {
    FirstContactOutcome outcome = FirstContactOutcome::no_contact;
    PostImpactState<T> after;  ///< the state just after the impact
    T flight_time{};           ///< τ
    Vec2<T> normal;            ///< the new n in the axes of the start: the wall advance is its direction
    int vertex_step = 0;       ///< the vertex that struck, counted from the one before
    Impulse<T> impulse;        ///< p, q and the contact mode
    T jacobi_restitution{};    ///< −p ū_n
    T jacobi_friction{};       ///< q (ū_t − 1)
    bool simultaneous = false;
    int steps = 0;  ///< moments at which the search evaluated the flight
};

/// The map of one scene, specialised once: shape and impact rule are template parameters, so that a disk carries no
/// orientation of vertices and a frictionless scene runs no friction code.
template <class T, Shape shape_, ImpactRule rule_>
class CollisionMap {
public:
    static constexpr Shape shape = shape_;
    static constexpr ImpactRule rule = rule_;
    using Number = T;

    ///   similar  as in `make_body`
    /// @throws std::invalid_argument if a parameter is out of range, the floor drags (map/dragged has that map), or
    /// corners are rounded (map/corners)
    explicit CollisionMap(const Scene<T>& scene, const Body<T>* similar = nullptr)
        : scene_(without_rounding(without_floor(validated(scene), "this computation"), "this computation")),
          body_(make_body(scene, similar)) {}

    const Scene<T>& scene() const { return scene_; }
    const Body<T>& body() const { return body_; }

    /// F, from just after an impact. Cost: one certified search for the contact, one impact.
    Collision<T> advance(const PostImpactState<T>& post_impact) const;

    /// The first impact of any flight.
    Collision<T> advance(const Flight<T>& flight) const;

    /// F, written into an existing collision; `post_impact` may be its own `after`. For long orbits: no copy is
    /// made between two impacts (copying a struct just after its members were written is slow).
    [[gnu::always_inline]] void advance(const PostImpactState<T>& post_impact, Collision<T>& collision) const {
        advance(flight_from(body_, post_impact), collision);
    }
    [[gnu::always_inline]] void advance(const Flight<T>& flight, Collision<T>& collision) const {
        FirstContact<T> contact;
        if (detail::direct_contact<shape>(body_, flight, contact)) [[likely]]
            arrive(flight, contact, collision);
        else
            advance_with_certainty(flight, collision);
    }

    /// Does what `advance` does where the direct search is known to find nothing, or is not for these polygons: without
    /// it.
    [[gnu::noinline]] void advance_with_certainty(const Flight<T>& flight, Collision<T>& collision) const {
        take(flight, detail::undecided_contact<shape>(body_, flight), collision);
    }

    /// Does what `advance` does where no search from the circle's return is known to find anything: without these.
    [[gnu::noinline]] void advance_without_return(const Flight<T>& flight, Collision<T>& collision) const {
        take(flight, detail::contact_without_return<shape>(body_, flight), collision);
    }

    /// The impact at a moment known to be the contact of the vertex at X + `arm`; fills all that depends on it.
    ///   vertex  its number: what rounding left out of its tabled direction is made up for (0: nothing is)
    [[gnu::always_inline]] void strike(const Flight<T>& flight, const Instant<T>& at, const Vec2<T>& arm, int vertex,
                                       Collision<T>& collision) const {
        const Vec2<T> x = shape == Shape::disk ? body_.unbiased_inverse_inner * at.centre : at.centre + arm;
        const T longer = missing_length(x);  // at a contact |x| = 1 but for rounding
        if constexpr (shape == Shape::disk) {
            turn_to_contact(x, longer, at.phase, flight, collision.after);
            collision.normal = x + longer * x;
        } else {
            const T turn = cross(x, body_.residual_of_vertex(at.arm, vertex));  // from x to the true n
            turn_to_contact(x, longer, turn, body_.residual_angle(vertex), at.phase, arm, body_, flight,
                            collision.after);
            collision.normal = x + times(Vec2<T>{longer, turn}, x);
        }
        collision.outcome = FirstContactOutcome::contact;
        collision.flight_time = at.time;
        apply_impact(collision);
    }

    /// The impact itself: `collision.after` holds the state before and then the state after.
    [[gnu::always_inline]] void apply_impact(Collision<T>& collision) const {
        if constexpr (shape == Shape::disk)
            apply_to_disk(collision);
        else
            apply_to_polygon(collision);
    }

private:
    [[gnu::always_inline]] void arrive(const Flight<T>& flight, const FirstContact<T>& contact,
                                       Collision<T>& collision) const {
        strike(flight, contact.at, contact.arm, contact.vertex, collision);
        collision.steps = contact.steps;
        collision.vertex_step = contact.vertex;
        collision.simultaneous = contact.simultaneous;
    }

    [[gnu::always_inline]] void take(const Flight<T>& flight, const FirstContact<T>& contact,
                                     Collision<T>& collision) const {
        if (contact.outcome == FirstContactOutcome::contact) return arrive(flight, contact, collision);
        collision.outcome = contact.outcome;
        collision.steps = contact.steps;
    }

    // In both, u changes linearly in (p, q), so the mean of before and after is the value at half the impulse.
    [[gnu::always_inline]] void apply_to_polygon(Collision<T>& collision) const {
        PostImpactState<T>& state = collision.after;
        const ContactKinematics<T> before = contact_kinematics(body_, state);
        const Impulse<T> j = impulse<rule>(before, scene_.mu, scene_.restitution);
        const T& p = j.normal;
        const T& q = j.tangential;
        apply_impulse(before, p, q, state);
        const T half(0.5);
        collision.jacobi_restitution = -p * (before.un - half * (before.b2() * p + before.b3() * q));
        collision.jacobi_friction = q * (before.ut + half * (before.b3() * p + before.b1() * q) - T(1));
        collision.impulse = j;
    }

    /// The disk's r_t = 0: B₂ = 1, B₃ = 0.
    [[gnu::always_inline]] void apply_to_disk(Collision<T>& collision) const {
        PostImpactState<T>& state = collision.after;
        const T un = state.vn - body_.beta * state.psi.y;
        const T half(0.5);
        if constexpr (rule == ImpactRule::frictionless) {
            const T p = (T(1) + scene_.restitution) * approaching(un);
            state.vn = state.vn - p;
            collision.jacobi_restitution = -p * (un - half * p);
            collision.jacobi_friction = T(0);
            collision.impulse = {p, T(0), ContactMode::frictionless};
        } else {
            const T ut = (state.vt + body_.alpha * state.spin) - body_.beta * state.psi.x;
            const Impulse<T> j = disk_impulse(un, ut, body_.disk_grip, scene_.mu, scene_.restitution);
            const T change = body_.alpha * body_.inverse_inertia * j.tangential;  // of the spin
            state.vn = state.vn - j.normal;
            state.vt = state.vt + j.tangential;
            state.spin = state.spin + change;
            collision.jacobi_restitution = -j.normal * (un - half * j.normal);
            collision.jacobi_friction = j.tangential * ((ut + half * (j.tangential + body_.alpha * change)) - T(1));
            collision.impulse = j;
        }
    }

    Scene<T> scene_;
    Body<T> body_;
};

/// Calls `use` with the scene's rule as a std::integral_constant: the one place where its options are branched on. The
/// disk's three laws coincide (B₃ = 0), so it has one rule with friction.
template <Shape shape, class T, class Use>
auto with_rule(const Scene<T>& scene, Use&& use) {
    using enum ImpactRule;
    if (scene.mu == T(0)) return use(std::integral_constant<ImpactRule, frictionless>());
    if constexpr (shape == Shape::polygon) {
        switch (scene.law) {
            case Law::newton:
                return use(std::integral_constant<ImpactRule, newton>());
            case Law::stronge:
                return use(std::integral_constant<ImpactRule, stronge>());
            case Law::poisson:
                break;
        }
    }
    return use(std::integral_constant<ImpactRule, poisson>());
}

/// Calls `use(map)` with the map specialised for the scene.
template <template <class, Shape, ImpactRule> class Map, class T, class Use>
auto with_map(const Scene<T>& scene, Use&& use) {
    if (scene.is_disk())
        return with_rule<Shape::disk>(scene, [&](auto rule) { return use(Map<T, Shape::disk, rule()>(scene)); });
    return with_rule<Shape::polygon>(scene, [&](auto rule) { return use(Map<T, Shape::polygon, rule()>(scene)); });
}

template <class T, class Use>
auto with_collision_map(const Scene<T>& scene, Use&& use) {
    return with_map<CollisionMap>(scene, use);
}

template <class T, Shape shape_, ImpactRule rule_>
auto CollisionMap<T, shape_, rule_>::advance(const PostImpactState<T>& post_impact) const -> Collision<T> {
    return advance(flight_from(body_, post_impact));
}

template <class T, Shape shape_, ImpactRule rule_>
auto CollisionMap<T, shape_, rule_>::advance(const Flight<T>& flight) const -> Collision<T> {
    Collision<T> collision;
    advance(flight, collision);
    return collision;
}

// Compiled once, in maps_in_*.cpp: the first contact takes a second to compile for each map. Those over Quad are
// declared in map/orbit/maps_in_quad.hpp.
SWIRL_EVERY_MAP(SWIRL_DECLARE_COLLISION_MAP, double)
SWIRL_EVERY_MAP(SWIRL_DECLARE_COLLISION_MAP, long double)

}  // namespace swirl
