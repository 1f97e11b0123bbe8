// An orbit, impact by impact: in the section, and with its position in the laboratory.
#pragma once

#include "map/orbit/laboratory.hpp"
#include "map/orbit/return_map.hpp"
#include "map/orbit/speed_limits.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace swirl {

/// Checks that z can be the state just after an impact: finite, leaving the wall (u_n ≤ 0 to rounding: an impact
/// without restitution leaves 0 but for that), no other vertex outside.
/// @throws std::invalid_argument
template <class T>
void require_leaving(const Body<T>& body, const SectionPoint<T>& z) {
    const T* values[] = {&z.psi, &z.chi, &z.vn, &z.vt, &z.spin};
    const char* names[] = {"psi", "chi", "vn", "vt", "S"};
    for (int i = 0; i < 5; ++i) detail::require_finite(names[i], *values[i]);
    const T speed = speed_of(body, z.vn, z.vt, z.spin);
    detail::require_speed(speed);
    const PostImpactState<T> post_impact = post_impact_state(z);
    const ContactKinematics<T> slip = kinematics_of(body, post_impact);
    if (slip.un > T(16) * epsilon<T>() * (body.beta + speed))
        detail::out_of_range("point: normal velocity u_n", slip.un, "at most 0, leaving the wall");
    if (body.sides == disk_sides) return;
    const Flight<T> flight = flight_of(body, post_impact);
    detail::NearestTwo<T> pair;
    detail::look_around(body, flight, instant_at_start(flight), pair);
    const T excess = std::max(pair.first.gap.value, pair.second.gap.value);
    if (excess > T(16) * epsilon<T>())
        detail::out_of_range("point: gap of the farthest vertex", excess, "at most 0, all vertices inside");
}

/// Follows F from a start, in the section alone. The scene's map must outlive it.
template <class Map>
class ReducedOrbit {
public:
    using T = typename Map::Number;

    /// @throws std::invalid_argument if the start is not inside the container
    ReducedOrbit(const Map& map, const LabStart<T>& start) : return_(map), flight_(flight_from(map.body(), start)) {}

    /// Vertex 0 has just struck at t = 0. @throws std::invalid_argument if z is not leaving or another vertex is
    /// outside
    ReducedOrbit(const Map& map, const SectionPoint<T>& z) : return_(map) {
        require_leaving(map.body(), z);
        return_step_.collision.after = post_impact_state(z);
    }

    /// To just after the next impact. False if there is none: `outcome()` is the reason, and `contacts()` then holds
    /// the contact after the last impact.
    ///   horizon  for how long contact without an impact is followed
    bool advance(double horizon = contact_horizon, const ContactSink& sink = {}) {
        if (outcome_ != Outcome::completed) return false;
        if (flight_) {
            return_step_ = return_.advance(*flight_);
            outcome_ = return_step_.outcome;
            flight_.reset();
        } else {
            outcome_ = return_.advance(return_step_, horizon, sink);
        }
        if (outcome_ != Outcome::completed) return false;
        ++impacts_;
        if (has_come_to_rest(map().body(), post_impact())) outcome_ = Outcome::resting;
        if (has_diverged(map().body(), post_impact())) outcome_ = Outcome::diverged;
        return true;
    }

    const Map& map() const { return return_.map(); }
    const Collision<T>& collision() const { return return_step_.collision; }
    const PostImpactState<T>& post_impact() const { return return_step_.collision.after; }
    /// Sustained contact on the way to the last impact, or after it if there was no other. Times count from the impact
    /// before.
    const std::vector<ContactSegment>& contacts() const { return return_step_.contacts; }
    /// The last return step: ∫S dt over it, and what friction in contact added to J.
    const ReturnStep<T>& return_step() const { return return_step_; }
    Outcome outcome() const { return outcome_; }
    long long impacts() const { return impacts_; }

private:
    ReturnMap<Map> return_;
    std::optional<Flight<T>> flight_;  ///< of a start in the laboratory, until the first impact
    ReturnStep<T> return_step_;
    Outcome outcome_ = Outcome::completed;
    long long impacts_ = 0;
};

/// An orbit with its position in the laboratory. Cost: two angles more an impact.
template <class Map>
class Orbit {
public:
    using T = typename Map::Number;

    /// @throws std::invalid_argument if the start is not inside the container
    Orbit(const Map& map, const LabStart<T>& start)
        : reduced_(map, start), frame_(LabFrame<T>::at_start(start.angle)) {}
    /// @throws std::invalid_argument if z is not leaving or another vertex is outside
    Orbit(const Map& map, const SectionPoint<T>& z) : reduced_(map, z), frame_(LabFrame<T>::at_section(z)) {}

    /// As ReducedOrbit::advance, and so are those below.
    bool advance(double horizon = contact_horizon, const ContactSink& sink = {}) {
        if (!reduced_.advance(horizon, sink)) return false;
        frame_.follow(map(), collision(), return_step().turned);
        return true;
    }

    const Map& map() const { return reduced_.map(); }
    const Body<T>& body() const { return map().body(); }
    const Collision<T>& collision() const { return reduced_.collision(); }
    const PostImpactState<T>& post_impact() const { return reduced_.post_impact(); }
    const std::vector<ContactSegment>& contacts() const { return reduced_.contacts(); }
    const ReturnStep<T>& return_step() const { return reduced_.return_step(); }
    Outcome outcome() const { return reduced_.outcome(); }
    long long impacts() const { return reduced_.impacts(); }
    const LabFrame<T>& frame() const { return frame_; }
    LabState<T> lab() const { return lab_state(map().body(), frame_, post_impact()); }

private:
    ReducedOrbit<Map> reduced_;
    LabFrame<T> frame_;
};

}  // namespace swirl
