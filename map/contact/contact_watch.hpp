// What ends a motion in contact, looked for along a step. Internal to the integration of contact.
#pragma once

#include "map/contact/contact_run.hpp"
#include "map/contact/contact_series.hpp"

#include <array>
#include <cstddef>

namespace swirl::contact_detail {

/// A condition that holds along the motion, and the event when it no longer does.
template <class T>
struct Condition {
    T value;  ///< ≥ 0 while it holds
    ContactEvent event;
    bool first_lifts = false;
};

inline constexpr std::size_t most_conditions = 4;
inline constexpr std::size_t hold_condition = 1;    ///< friction's: sticking holds, a slip goes on
inline constexpr std::size_t strike_condition = 2;  ///< the neighbour's
template <class T>
using Conditions = std::array<Condition<T>, most_conditions>;

template <class T>
Conditions<T> conditions_of(const Problem<T>& problem, const State<T>& y);

/// True if the neighbour's chatter, while a vertex is in contact, has ended: its remaining rebounds move it by less
/// than rounding (vT as in chatter_completion.hpp), with L|χ″| its acceleration towards the wall.
template <class T>
bool ends_second_chatter(const ContactScene<T>& scene, ContactMotion motion, const ContactState<T>& z);

/// The first condition that fails within a step, and when.
template <class T>
struct Failure {
    T time{};
    std::size_t which = 0;
    bool found = false;
};

/// Examines the parts of a step on which an event is not excluded: the series, also where a condition is lowest between
/// two moments, and the forces themselves where a condition is close to zero. A condition that starts at zero (λ = 0
/// after a release that did not happen, |χ| = χ_m after a strike) and increases holds: only a negative value fails.
template <class T>
Failure<T> first_failure(const Problem<T>& problem, const Step<T>& step, const T& h);

}  // namespace swirl::contact_detail
