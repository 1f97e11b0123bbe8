// The collision map of a polygon with rounded corners: flight and first contact are those of the sharp polygon of the
// corners' centres, the impact has the lever arm of the corner. map/corners/README.md
#pragma once

#include "map/collision_map.hpp"
#include "map/contact/chatter_completion.hpp"
#include "map/map_list.hpp"

#include <cmath>
#include <limits>

namespace swirl {

/// F of a polygon whose corners have the radius r ≥ 0; r = 0 gives CollisionMap's to rounding.
///
/// A container is concave: the body first touches it where the centre of a corner is R_c − r from the container's. So
/// in R_c − r flights and their contacts are those of the sharp polygon of these centres, and states differ from
/// CollisionMap's in the unit of v_n and v_t, here R_c ω_s throughout. The wall is touched at r beyond the centre along
/// n: r_n = (α − r) cos χ + r, r_t = (α − r) sin χ, χ = arg of the corner's centre − arg n.
///
/// Where a corner comes to stay on the wall the orbit ends (`FirstContactOutcome::sustained`): it would roll or slide
/// there, whose equations are not those of a sharp vertex. That is after an impact that leaves at v with the free
/// acceleration a > 0 back to the wall if 2v² ≤ 16 ε a (1 − e), as chatter of sharp polygons ends
/// (chatter_completion.hpp), or if v is rounding.
template <class T, Shape shape_, ImpactRule rule_>
class CornerMap {
public:
    static constexpr Shape shape = shape_;
    static constexpr ImpactRule rule = rule_;
    static constexpr bool has_round_corners = true;
    using Number = T;
    static_assert(shape == Shape::polygon, "the disk has no corners");

    ///   similar  as in `make_body`
    /// @throws std::invalid_argument if a parameter is out of range
    explicit CornerMap(const Scene<T>& scene, const Body<T>* similar = nullptr)
        : scene_(without_floor(validated(scene), "a body with rounded corners")), body_(rounded_body(scene, similar)) {}

    const Scene<T>& scene() const { return scene_; }
    const Body<T>& body() const { return body_; }

    /// F, from just after an impact.
    Collision<T> advance(const PostImpactState<T>& post_impact) const { return advance(flight_after(post_impact)); }
    /// The first impact of any flight, which is in the body's units (Body::unit).
    Collision<T> advance(const Flight<T>& flight) const {
        Collision<T> collision;
        advance(flight, collision);
        return collision;
    }
    /// F, written into an existing collision; `post_impact` may be its own `after`, which stays as it is if no contact
    /// is found.
    void advance(const PostImpactState<T>& post_impact, Collision<T>& collision) const {
        advance(flight_after(post_impact), collision);
    }
    void advance(const Flight<T>& flight, Collision<T>& collision) const {
        if (stays_on_wall(flight)) {
            collision.outcome = FirstContactOutcome::sustained;
            return;
        }
        const FirstContact<T> contact = first_contact<shape>(body_, flight);
        if (contact.outcome == FirstContactOutcome::contact)
            strike(flight, contact.at, contact.arm, contact.vertex, collision);
        collision.outcome = contact.outcome;
        collision.steps = contact.steps;
        collision.vertex_step = contact.vertex;
        collision.simultaneous = contact.simultaneous;
    }
    void advance_without_return(const Flight<T>& flight, Collision<T>& collision) const { advance(flight, collision); }

    /// As CollisionMap::strike.
    void strike(const Flight<T>& flight, const Instant<T>& at, const Vec2<T>& arm, int vertex,
                Collision<T>& collision) const {
        const Vec2<T> x = at.centre + arm;
        const T longer = missing_length(x);
        const T turn = cross(x, body_.residual_of_vertex(at.arm, vertex));
        turn_to_contact(x, longer, turn, body_.residual_angle(vertex), at.phase, arm, body_, flight, collision.after);
        collision.normal = x + times(Vec2<T>{longer, turn}, x);
        collision.outcome = FirstContactOutcome::contact;
        collision.flight_time = at.time;
        apply_impact(collision);
    }

    /// The flight after an impact, whether or not r is 0: where it is a number with derivatives.
    Flight<T> flight_after(const PostImpactState<T>& post_impact) const {
        Flight<T> flight = flight_from(body_, post_impact);
        flight.velocity = {post_impact.vn / body_.unit, post_impact.vt / body_.unit};
        return flight;
    }

private:
    /// From the body's units to R_c.
    void apply_impact(Collision<T>& collision) const {
        PostImpactState<T>& state = collision.after;
        const ContactKinematics<T> before = rounded_kinematics(body_, state);
        const Impulse<T> j = impulse<rule>(before, scene_.mu, scene_.restitution);
        const T &p = j.normal, &q = j.tangential;
        apply_impulse(before, p, q, state);
        const T half(0.5), square = body_.unit * body_.unit;
        // R_c ω_s, the speed at which the wall turns in the swirling frame, is 1 + r in these units.
        const T wall = T(1) + body_.corner;
        collision.jacobi_restitution = square * (-p * (before.un - half * (before.b2() * p + before.b3() * q)));
        collision.jacobi_friction = square * (q * (before.ut + half * (before.b3() * p + before.b1() * q) - wall));
        state.vn = body_.unit * state.vn;
        state.vt = body_.unit * state.vt;
        collision.impulse = {body_.unit * p, body_.unit * q, j.mode};
    }

    bool stays_on_wall(const Flight<T>& flight) const {
        using std::fabs;
        if (!flight.struck) return false;
        const Gap<T> gap = struck_gap_at_start(flight);  // g′ = 2u_n, g″ = 2a
        const T v = T(-0.5) * gap.rate, acceleration = T(0.5) * gap.curvature;
        if (!(plain(acceleration) > 0)) return false;
        const T speed =
            fabs(flight.velocity.x) + fabs(flight.velocity.y) + flight.beta + body_.alpha * fabs(flight.spin);
        return plain(v) <= 64 * epsilon<T>() * plain(speed) ||
               2 * plain(v) * plain(v) <=
                   chatter_tolerance<T>() * plain(acceleration) * (1 - plain(scene_.restitution));
    }

    Scene<T> scene_;
    Body<T> body_;
};

/// Calls `use(map)` with the map specialised for the scene.
template <class T, class Use>
auto with_corner_map(const Scene<T>& scene, Use&& use) {
    return with_rule<Shape::polygon>(scene,
                                     [&](auto rule) { return use(CornerMap<T, Shape::polygon, rule()>(scene)); });
}

}  // namespace swirl
