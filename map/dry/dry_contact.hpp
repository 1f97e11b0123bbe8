// The first contact of a flight over a floor with dry friction, certified: between two stations of the integration
// friction's acceleration, which is bounded, bounds g″. map/dry/README.md, "First contact".
#pragma once

#include "map/dry/dry_flight.hpp"
#include "map/first_contact/bounds.hpp"

namespace swirl {

/// How a flight ends.
struct DryContact {
    FirstContact<double> found;  ///< `found.at` is not set: `moment.at` is
    DryMoment<double> moment;    ///< of the contact, or where the body has stopped
    bool has_stopped = false;    ///< it stopped and rests in the laboratory until the wall comes: `found` is not set
};

/// The first time at which the rim or a vertex reaches the wall, or at which the body stops. `no_contact`: it goes
/// along with a dish, by README, "Riding".
template <Shape shape>
DryContact first_contact(const DryFlight<double>& flight);

extern template DryContact first_contact<Shape::disk>(const DryFlight<double>&);
extern template DryContact first_contact<Shape::polygon>(const DryFlight<double>&);

/// That of a body which the wall has released: g and g′ of what was on the wall are zero at the start, g″ too or below.
/// The search begins at a moment up to which g was seen to fall, at ten moments of the last step (of the first, but
/// from rest against the floor: 10⁻⁶/ω_s are passed over there), not proven to; `unresolved` if there is none. Of a
/// polygon the neighbours of the vertex that leaves are seen to fall, too, where they are on the wall, else to stay
/// inside.
template <Shape shape>
DryContact first_contact_after_release(const DryFlight<double>& flight);

extern template DryContact first_contact_after_release<Shape::disk>(const DryFlight<double>&);
extern template DryContact first_contact_after_release<Shape::polygon>(const DryFlight<double>&);

/// g′ and g″ at the start of the vertex (disk: of the rim) that is on the wall; without g‴.
Gap<double> struck_gap_at_start(const DryFlight<double>& flight);

}  // namespace swirl
