// Which contact motion begins at a state: the one whose forces are consistent with it.
#pragma once

#include "map/contact/contact_run.hpp"

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
    bool resolved = true;                       ///< false: no motion agrees with the forces of its own
};

/// The state on an edge's other vertex.
template <class T>
ContactState<T> other_end(const ContactScene<T>& scene, const ContactState<T>& z) {
    return {z.psi + 2 * scene.half_chord, scene.widest_chi, z.ut, z.spin};
}

/// Sliding where u_t ≠ 0; from rest sticking where friction can hold it, else the slip that its own forces drive. Of an
/// edge all motions are looked at that are consistent with λ ≥ 0, friction and no acceleration into the wall: each
/// vertex sticks, slips either way or lifts. With large friction there may be several. Contact that goes on then keeps
/// both vertices; contact that begins has as few as it can, flight first, then one vertex (that in flight would not
/// leave the wall), as the limit e → 0 has it, where the last impacts leave at a velocity that nothing takes back.
/// README.md, "Which motion".
///   before  what ended the motion before: `slip` where friction has just stopped holding (not sticking), `landing` and
///           `strike` where contact begins; else it goes on
template <class T>
MotionChoice<T> choose_motion(const ContactScene<T>& scene, Support support, const ContactState<T>& state,
                              int vertex_step, ContactEvent before = ContactEvent::horizon);

}  // namespace swirl
