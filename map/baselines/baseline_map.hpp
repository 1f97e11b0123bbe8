// The collision map with another search for the contact: flight and impact are CollisionMap's, so that what differs is
// the search alone.
#pragma once

#include "map/baselines/baseline_contact.hpp"
#include "map/collision_map.hpp"
#include "map/orbit/return_map.hpp"

namespace swirl {

/// F with a baseline's contact, in double. Outcomes as CollisionMap's; none of them is proven.
template <Shape shape_, ImpactRule rule_>
class BaselineMap {
public:
    static constexpr Shape shape = shape_;
    static constexpr ImpactRule rule = rule_;
    using Number = double;
    using Exact = CollisionMap<double, shape, rule>;

    BaselineMap(const Exact& exact, BaselineSearch search) : exact_(exact), search_(search) {}
    /// @throws std::invalid_argument if a parameter is out of range
    BaselineMap(const Scene<double>& scene, BaselineSearch search) : BaselineMap(Exact(scene), search) {}

    const Scene<double>& scene() const { return exact_.scene(); }
    const Body<double>& body() const { return exact_.body(); }
    BaselineSearch search() const { return search_; }

    /// F, from just after an impact.
    Collision<double> advance(const PostImpactState<double>& post_impact) const {
        return advance(flight_from(body(), post_impact));
    }
    /// The first impact of any flight.
    Collision<double> advance(const Flight<double>& flight) const {
        Collision<double> collision;
        advance(flight, collision);
        return collision;
    }
    /// F, written into an existing collision; `post_impact` may be its own `after`, which stays as it is if no
    /// contact is found.
    void advance(const PostImpactState<double>& post_impact, Collision<double>& collision) const {
        advance(flight_from(body(), post_impact), collision);
    }
    void advance(const Flight<double>& flight, Collision<double>& collision) const {
        const FirstContact<double> contact = baseline_contact(search_, body(), flight);
        if (contact.outcome == FirstContactOutcome::contact)
            strike(flight, contact.at, contact.arm, contact.vertex, collision);
        collision.outcome = contact.outcome;
        collision.steps = contact.steps;
        collision.vertex_step = contact.vertex;
        collision.simultaneous = contact.simultaneous;
    }

    /// As CollisionMap's; here there is one search alone.
    void advance_without_return(const Flight<double>& flight, Collision<double>& collision) const {
        advance(flight, collision);
    }

    /// As CollisionMap::strike.
    void strike(const Flight<double>& flight, const Instant<double>& at, const Vec2<double>& arm, int vertex,
                Collision<double>& collision) const {
        exact_.strike(flight, at, arm, vertex, collision);
    }

private:
    Exact exact_;
    BaselineSearch search_;
};

// Their return maps, compiled once, in baseline_map.cpp.
#define SWIRL_DECLARE_BASELINE(T, SHAPE, RULE) extern template class ReturnMap<BaselineMap<SHAPE, RULE>>;
#define SWIRL_COMPILE_BASELINE(T, SHAPE, RULE) template class ReturnMap<BaselineMap<SHAPE, RULE>>;
SWIRL_EVERY_MAP(SWIRL_DECLARE_BASELINE, double)

}  // namespace swirl
