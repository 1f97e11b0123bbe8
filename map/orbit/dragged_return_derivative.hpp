// The derivative of the return map over a floor that drags, through contact: return_derivative.hpp, with its flights.
#pragma once

#include "map/dragged/dragged_derivative.hpp"
#include "map/orbit/dragged_return.hpp"
#include "map/orbit/return_derivative.hpp"

namespace swirl {

/// After a flight from the wall that is known.
template <class J, Shape shape, ImpactRule rule>
Collision<J> strike_along(const DraggedMap<J, shape, rule>& map, const Flight<J>& flight, const Plain<J>& time,
                          int vertex) {
    return strike_along(map, dragged_flight(map.floor(), flight), time, vertex);
}

namespace detail {

template <class T, Shape shape, ImpactRule rule, class J>
struct InJets<DraggedMap<T, shape, rule>, J> {
    using Collisions = DraggedMap<J, shape, rule>;
    static constexpr bool over_floor = true;
};

}  // namespace detail

}  // namespace swirl
