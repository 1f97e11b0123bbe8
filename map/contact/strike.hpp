// A vertex strikes while its neighbour is in contact: alternating impulses, until both are at rest or separate.
#pragma once

#include "map/contact/contact_state.hpp"

namespace swirl {

template <class T>
struct Strike {
    PostImpactState<T> after;  ///< on the vertex that struck
    Impulse<T> impulse;        ///< its total impulse, and the mode of the first one
    T jacobi_restitution{};    ///< Σ −p ū_n over all impulses, the neighbour's too
    T jacobi_friction{};       ///< Σ q (ū_t − 1)
    bool resolved = false;     ///< false: the impulses did not come to an end
};

/// The impact at one contact by the scene's law, with restitution e: changes the post-impact state (that of the
/// contact) and adds to the changes of J. Returns the impulse.
template <class T>
Impulse<T> strike_once(const ContactScene<T>& scene, PostImpactState<T>& post_impact, const T& restitution,
                       Strike<T>& strike);

/// The impulse at zero normal velocity (jam) of a vertex that slides where B₂ − sμB₃ ≤ 0: compression lasts until the
/// slip has stopped, then restitution follows by the scene's law. A motion reaches that border only where the numerator
/// of λ vanishes with it (Génot & Brogliato, Eur. J. Mech. A/Solids 18 (1999) 653); B₂ − sμB₃ within rounding of zero
/// (`painleve_margin`) is zero, of which Stronge's law would take a root.
template <class T>
Impulse<T> jam_once(const ContactScene<T>& scene, PostImpactState<T>& post_impact, Strike<T>& strike);

/// The neighbour of a vertex in contact (u_n = 0, |χ| = χ_m) strikes. Impulses alternate between the two, each by the
/// scene's law, as long as one approaches. None creates energy under Poisson's and Stronge's law, hence neither does
/// their sum. With e < 1 an infinite alternation decreases geometrically; it is ended where both are at rest within
/// rounding.
///   plastic  the striking vertex' own chatter has ended: e = 0
template <class T>
Strike<T> strike_in_contact(const ContactScene<T>& scene, const PostImpactState<T>& completion, bool plastic);

}  // namespace swirl
