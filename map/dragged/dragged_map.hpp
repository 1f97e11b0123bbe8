// The collision map over a floor that drags: flight and first contact are its own, the impact is CollisionMap's.
// map/dragged/README.md
#pragma once

#include "map/collision_map.hpp"
#include "map/dragged/dragged_contact.hpp"
#include "map/map_list.hpp"

namespace swirl {

namespace detail {

/// The scene that impacts know: a floor does not act in them.
template <class T>
Scene<T> over_still_floor(Scene<T> scene) {
    scene.drag = T(0);
    scene.spin_drag = T(-1);
    scene.floor = Floor::dish;
    return scene;
}

}  // namespace detail

/// F over a floor that drags; all γ, γ_r ≥ 0 are allowed, and γ = γ_r = 0 gives CollisionMap's to rounding.
template <class T, Shape shape_, ImpactRule rule_>
class DraggedMap {
public:
    static constexpr Shape shape = shape_;
    static constexpr ImpactRule rule = rule_;
    using Number = T;
    using Impacts = CollisionMap<T, shape, rule>;

    ///   similar  as in `make_body`
    /// @throws std::invalid_argument if a parameter is out of range
    explicit DraggedMap(const Scene<T>& scene, const Body<T>* similar = nullptr)
        : scene_(validated(scene)), floor_(floor_drag(scene)), impacts_(detail::over_still_floor(scene), similar) {}

    const Scene<T>& scene() const { return scene_; }
    const Body<T>& body() const { return impacts_.body(); }
    const FloorDrag<T>& floor() const { return floor_; }

    /// F, from just after an impact.
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
        const DraggedFlight<T> flight = dragged_flight(floor_, start);
        DraggedContact<T> contact;
        first_contact<shape>(body(), flight, contact);
        if (contact.found.outcome == FirstContactOutcome::contact)
            strike(flight, contact.moment, contact.found.arm, contact.found.vertex, collision);
        collision.outcome = contact.found.outcome;
        collision.steps = contact.found.steps;
        collision.vertex_step = contact.found.vertex;
        collision.simultaneous = contact.found.simultaneous;
    }

    /// As CollisionMap::strike.
    void strike(const DraggedFlight<T>& flight, const DraggedInstant<T>& moment, const Vec2<T>& arm, int vertex,
                Collision<T>& collision) const {
        impacts_.strike(arriving(flight, moment), moment.at, arm, vertex, collision);
    }

    /// ∫ S dt of a flight.
    T turned(const T& spin, const T& time) const { return spin * decayed_time(floor_.spin_drag, time); }

private:
    Scene<T> scene_;
    FloorDrag<T> floor_;
    Impacts impacts_;
};

template <class T, class Use>
auto with_dragged_map(const Scene<T>& scene, Use&& use) {
    return with_map<DraggedMap>(scene, use);
}

}  // namespace swirl
