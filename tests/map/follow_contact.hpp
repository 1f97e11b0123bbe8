// Whole orbits through contact, and what can be checked of them on the way.
#pragma once

#include "map/orbit/orbit.hpp"

namespace swirl::tests {

struct Tally {
    Outcome outcome = Outcome::completed;
    long impacts = 0, pieces = 0;
    double time = 0;
    double balance = 0;    ///< |ΔJ − the changes reported by contacts and impacts|
    double exchanged = 0;  ///< Σ |parts|
    long moments = 0;      ///< evaluated by the searches for contact
    long steps = 0;        ///< of contact motions
    double outside = 0;    ///< the farthest that a vertex was outside, at impacts and along contacts
    double fastest = 0;    ///< the largest |S| + |v_t| + β after an impact: nothing turns or slips faster
};

/// Follows an orbit until a time; contact that goes on counts as completed.
///   looks  into contact on its way, for `outside`: that takes a third of a polygon's time there
Tally follow(const Scene<double>& scene, const LabStart<double>& start, double until, long most = 1'000'000'000,
             bool looks = true);

}  // namespace swirl::tests
