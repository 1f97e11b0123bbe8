// Contact with the wall over a floor with dry friction, from a landing to a release, a strike or a jam.
// map/dry/README.md, "Contact".
#pragma once

#include "map/contact/contact_phase.hpp"
#include "map/dry/wall_course.hpp"

namespace swirl {

/// As `follow_contact`, with the floor's friction. A piece's motion is `sticking` also where the body rests against a
/// dish (S = 0), which ends as `slip`; `stick` ends a slip and a body that comes to rest. While it rests f, which is
/// not unique, is left out of `work`.
/// Cost: some 5 µs a step of a disk, at least eight steps per 1/ω_s; of a polygon it grows with N.
ContactPhase<double> follow_dry_contact(const DryWall<double>& wall, const ChatterCompletion<double>& completion,
                                        double horizon, const ContactSink& sink = {},
                                        long most_steps = most_contact_steps);

/// Whether and how contact begins just after an impact: as without floor, with what the floor pushes there. In the rest
/// of chatter that is constant: what its change makes is of second order in the time that chatter would have gone on.
ChatterCompletion<double> dry_completion(const DryWall<double>& wall, const PostImpactState<double>& post_impact);

}  // namespace swirl
