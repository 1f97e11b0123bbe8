#include "tests/map/follow_contact.hpp"

#include "tests/map/contact_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace swirl::tests {

namespace {

/// A contact that outlasts the horizon of orbits, but takes too many series to be followed to a later one, is in
/// contact, too; one whose pieces become ever shorter is not.
bool lasts(const std::vector<ContactSegment>& contacts) {
    if (contacts.empty()) return false;
    const double end = contacts.back().end;
    return end >= contact_horizon && static_cast<double>(contacts.size()) <= 10 * end;
}

}  // namespace

Tally follow(const Scene<double>& scene, const LabStart<double>& start, double until, long most, bool looks) {
    return with_collision_map(scene, [&](const auto& map) {
        Tally tally;
        const ContactScene<double> contact = contact_of(scene);
        const auto& body = map.body();
        const auto look = [&](const ContactSums<double>&, Support support, ContactMotion,
                              const ContactState<double>& z) {
            if (support == Support::vertex)
                tally.outside = std::max(tally.outside, std::abs(z.chi) - contact.widest_chi);
        };
        Orbit orbit(map, start);
        double jacobi = 0;
        bool known = false;
        const ContactSink sink =
            looks && body.sides != disk_sides ? look : ContactSink{};  // a disk has no vertex to look at
        while (tally.time < until && orbit.impacts() < most) {
            const bool went_on = orbit.advance(until - tally.time, sink);
            tally.pieces += static_cast<long>(orbit.contacts().size());
            for (const ContactSegment& segment : orbit.contacts()) tally.steps += segment.steps;
            if (!went_on) {
                tally.outcome = orbit.outcome();
                if (tally.outcome == Outcome::contact_cut && lasts(orbit.contacts()))
                    tally.outcome = Outcome::in_contact;
                if (tally.outcome == Outcome::in_contact) tally.time = until;
                break;
            }
            tally.time = orbit.frame().time.unwound();
            const double now = jacobi_of(body, orbit.post_impact());
            const auto& c = orbit.collision();
            tally.fastest =
                std::max(tally.fastest, std::abs(c.after.spin) + std::abs(c.after.vt) + static_cast<double>(body.beta));
            tally.moments += c.steps;
            const double change = c.jacobi_restitution + c.jacobi_friction + orbit.return_step().contact_work;
            if (known) tally.balance += now - jacobi - change;
            tally.exchanged += std::abs(c.jacobi_restitution) + std::abs(c.jacobi_friction) +
                               std::abs(orbit.return_step().contact_work);
            jacobi = now;
            known = true;
            if (body.sides == disk_sides) continue;
            const Flight<double> flight = flight_from(body, orbit.post_impact());
            detail::NearestTwo<double> pair;
            detail::look_around(body, flight, instant_at_start(flight), pair);
            tally.outside = std::max({tally.outside, pair.first.gap.value, pair.second.gap.value});
        }
        tally.impacts = orbit.impacts();
        return tally;
    });
}

}  // namespace swirl::tests
