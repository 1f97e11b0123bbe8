// An orbit, impact by impact, with its place in the laboratory.
#pragma once

#include "map/chatter.hpp"
#include "map/laboratory.hpp"
#include "map/outcome.hpp"

#include <algorithm>

namespace swirl {

/// What an ended search for a contact means for an orbit.
template <class T>
inline Outcome outcome_of(ContactOutcome contact, const T& restitution) {
    switch (contact) {
        case ContactOutcome::contact: return Outcome::completed;
        case ContactOutcome::no_contact: return Outcome::no_contact;
        case ContactOutcome::sustained: return restitution < T(1) ? Outcome::chatter : Outcome::resting;
        case ContactOutcome::unresolved: return Outcome::unresolved;
    }
    return Outcome::unresolved;
}

/// Checks that z can be the state just after an impact: finite, leaving the wall, no other vertex outside.
/// @throws std::invalid_argument
template <class T>
void require_leaving(const Body<T>& body, const SectionPoint<T>& z) {
    const T* values[] = {&z.psi, &z.chi, &z.vn, &z.vt, &z.spin};
    const char* names[] = {"psi", "chi", "vn", "vt", "S"};
    for (int i = 0; i < 5; ++i) detail::require_finite(names[i], *values[i]);
    detail::require_speed(speed_of(body, z.vn, z.vt, z.spin));
    const Launch<T> launch = launch_from(z);
    const Approach<T> slip = approach_of(body, launch);
    if (slip.un > T(0)) detail::out_of_range("point: normal velocity u_n", slip.un, "at most 0, leaving the wall");
    if (body.sides == disk_sides) return;
    const Flight<T> flight = flight_from(body, launch);
    detail::NearestTwo<T> pair;
    detail::look_around(body, flight, instant_at_start(flight), pair);
    const T excess = std::max(pair.first.gap.value, pair.second.gap.value);
    if (excess > T(16) * epsilon<T>())
        detail::out_of_range("point: gap of the farthest vertex", excess, "at most 0, all vertices inside");
}

/// Follows F from a start. The scene's map must outlive it.
template <class Map>
class Orbit {
public:
    using T = typename Map::Number;

    /// @throws std::invalid_argument if the start is not inside the container
    Orbit(const Map& map, const LabStart<T>& start)
        : map_(map), flight_(flight_from(map.body(), start)),
          frame_(LabFrame<T>::at_start(start.angle)), spin_(start.spin) {}

    /// Vertex 0 has just struck at t = 0. @throws std::invalid_argument if z is not leaving or another vertex is outside
    Orbit(const Map& map, const SectionPoint<T>& z)
        : map_(map), frame_(LabFrame<T>::at_section(z)), spin_(z.spin) {
        require_leaving(map.body(), z);
        collision_.after = launch_from(z);
        flight_ = flight_from(map.body(), collision_.after);
    }

    /// To just after the next impact. False if there is none: `outcome()` says why.
    bool advance() {
        if (outcome_ != Outcome::completed) return false;
        const Launch<T> before = collision_.after;
        const bool struck = flight_.struck;
        const Collision<T> next = map_.advance(flight_);
        outcome_ = outcome_of(next.contact, map_.scene().restitution);
        if (outcome_ != Outcome::completed) return false;
        collision_ = next;
        frame_.follow(map_, collision_, spin_);
        spin_ = collision_.after.spin;
        flight_ = flight_from(map_.body(), collision_.after);
        ++impacts_;
        if (struck && ends_chatter(map_.body(), map_.scene().restitution, before, collision_))
            outcome_ = Outcome::chatter;
        else if (has_died_away(map_.body(), collision_.after))
            outcome_ = Outcome::resting;
        return true;
    }

    const Map& map() const { return map_; }
    const Collision<T>& collision() const { return collision_; }
    const Launch<T>& launch() const { return collision_.after; }
    const LabFrame<T>& frame() const { return frame_; }
    Outcome outcome() const { return outcome_; }
    long long impacts() const { return impacts_; }
    LabState<T> lab() const { return lab_state(map_.body(), frame_, collision_.after); }

private:
    const Map& map_;
    Flight<T> flight_;
    LabFrame<T> frame_;
    T spin_;
    Collision<T> collision_;
    Outcome outcome_ = Outcome::completed;
    long long impacts_ = 0;
};

}  // namespace swirl
