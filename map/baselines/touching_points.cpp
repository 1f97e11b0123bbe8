#include "map/baselines/touching_points.hpp"

#include <limits>

namespace swirl::detail {

std::optional<FirstContact<double>> decided_at_start(const Body<double>& body, const Flight<double>& flight) {
    const Instant<double> at = instant_at_start(flight);
    FirstContact<double> contact;
    contact.at = at;
    contact.steps = 1;
    if (flight.struck) {
        Gap<double> gap = body.sides == disk_sides ? centre_gap(body, flight, at) : struck_gap_at_start(flight);
        contact.outcome = FirstContactOutcome::sustained;
        if (stays(body, flight, gap)) return contact;
    }
    contact.outcome = FirstContactOutcome::no_contact;
    const bool at_rest = dot(flight.velocity, flight.velocity) == 0;
    if (at_rest && sheltered_time(body, flight, at) == std::numeric_limits<double>::infinity()) return contact;
    return {};
}

}  // namespace swirl::detail
