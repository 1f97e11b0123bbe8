// A phase of contact, known in plain numbers, once more in Jets: the derivative of its end.
//
// The motion's power series carries the derivatives; the moment of an event is differentiated by the implicit function
// theorem, dτ = −∂g/g′ with g what vanishes there, which is one Newton step in Jets. What follows are the events of the
// phase itself: on the border between two ways it is the derivative of its own side.
#pragma once

#include "map/contact/contact_jets.hpp"
#include "map/contact/contact_phase.hpp"

namespace swirl {

/// The post-impact state at the end of the phase: leaving, or just after the impact.
///   plain    the scene in plain numbers
///   landing  the state in contact where the phase begins, with its derivatives
///   vertex_step  of the vertex that it belongs to, counted as the phase's are
///   steps    is added the number of power series, if it is given
template <class J>
PostImpactState<J> contact_along(const ContactScene<double>& plain, const ContactScene<J>& scene,
                                 const ContactPhase<double>& phase, const ContactState<J>& landing, int vertex_step,
                                 long* steps = nullptr);

}  // namespace swirl
