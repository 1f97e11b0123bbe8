// The Jets that sustained contact is compiled for (contact_along.hpp).
#pragma once

#include "map/numbers/jets.hpp"

namespace swirl {

/// Derivatives by the section's coordinates, 4 of a disk, 5 of a polygon, or by one number of the scene.
template <int D>
using ContactJet = ceres::Jet<double, D>;

// DO(J) for each of them.
#define SWIRL_EVERY_CONTACT_JET(DO) \
    DO(ContactJet<1>)               \
    DO(ContactJet<4>)               \
    DO(ContactJet<5>)

}  // namespace swirl
