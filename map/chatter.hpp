// When collision-only following has come to its end: impacts that accumulate (Zeno). Design, section 5.
#pragma once

#include "map/collision_map.hpp"

#include <cmath>

namespace swirl {

/// Watches an orbit for chatter. With e < 1 successive flights along the wall shrink geometrically; once several in a
/// row have lifted the struck vertex by less than the rounding of its position, the accumulation point is reached to
/// working precision and the map can't follow further. The depth of a flight is at most |u_n| τ, so there is no speed
/// threshold: the test is ε itself. It ends within about ln(1/ε)/(1 − e) impacts of the first small flight.
template <class T>
class ChatterWatch {
public:
    explicit ChatterWatch(const T& restitution) : dissipative_(restitution < T(1)) {}

    /// `launch`: the state the flight began with; `flight_time`: how long it lasted. True if it was chatter's end.
    bool is_over(const Body<T>& body, const Launch<T>& launch, const T& flight_time) {
        using std::fabs;
        if (!dissipative_) return false;
        const T lift = fabs(approach_of(body, launch).un) * flight_time;
        invisible_ = lift <= T(4) * epsilon<T>() ? invisible_ + 1 : 0;
        return invisible_ >= invisible_flights;
    }

private:
    static constexpr int invisible_flights = 4;

    bool dissipative_;
    int invisible_ = 0;
};

}  // namespace swirl
