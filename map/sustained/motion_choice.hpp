// Which contact motion begins at a state: the one whose forces are consistent with it.
#pragma once

#include "map/sustained/contact_run.hpp"

#include <optional>

namespace swirl {

/// The contact motion that begins, or the event that ends contact at once.
template <class T>
struct MotionChoice {
    bool stays = false;
    Support support = Support::vertex;
    ContactMotion motion = ContactMotion::sticking;
    ContactState<T> state;
    int vertex_step = 0;                        ///< an edge may lift: −1, 0 or 1
    ContactEvent ends = ContactEvent::release;  ///< if it does not stay: release or jam
};

/// Sliding where u_t ≠ 0; from rest sticking where friction can hold it, else the slip that its own forces drive. Where
/// none is consistent an edge lifts one of its vertices.
///   broken  friction has just stopped holding: not sticking
template <class T>
MotionChoice<T> choose_motion(const ContactScene<T>& scene, Support support, const ContactState<T>& state,
                              int vertex_step, bool broken = false);

}  // namespace swirl
