// What the rest of chatter removes of the velocity of the point that touches, and the slip that goes with it.
// README.md, "Chattering".
#pragma once

#include "map/sustained/chatter_completion.hpp"
#include "map/sustained/reaction.hpp"

#include <cmath>

namespace swirl {

/// The slip in which the rest of chatter goes on, which decides the friction of its impulses.
template <class T>
struct Slip {
    bool slides;
    T sign;  ///< of u_t
};

/// Normal and tangential impulse, p and q, that remove u_n: q is −μ sign p while it slides, and what removes u_t as
/// well while it sticks.
template <class T>
struct Removal {
    T normal, tangential;
};

template <class T>
Removal<T> removal_of(const ContactScene<T>& scene, const ContactKinematics<T>& u, const Slip<T>& slip) {
    const T along = scene.mu == T(0) ? T(0) : slip.slides ? T(-scene.mu * slip.sign) : T(-u.b3() / u.b1());  // q/p
    const T c = u.b2() + u.b3() * along;
    const bool stops = scene.mu > T(0) && !slip.slides;
    const T still = stops ? T(-u.ut / u.b1()) : T(0);  // q at p = 0
    const T p = c > T(0) ? T((u.un - u.b3() * still) / c) : T(0);
    return {p, still + along * p};
}

/// Whether friction holds the vertex (rim) at u_t = 0.
template <class T>
bool can_stick(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    ContactState<T> still = contact_state(scene, post_impact);
    still.ut = T(0);
    const Support support = scene.is_disk() ? Support::rim : Support::vertex;
    return reaction_of(scene, support, ContactMotion::sticking, still).reserve >= T(0);
}

/// It sticks also where the removal of u_n would turn so slow a slip round, and friction holds it: the flights between
/// the impacts that are left bring it to an end.
template <class T>
Slip<T> slip_of(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    using std::abs;
    const ContactKinematics<T> u = contact_kinematics(scene.body, post_impact);
    const Slip<T> slip{scene.mu > T(0) && abs(u.ut) > velocity_rounding(scene, post_impact),
                       u.ut > T(0) ? T(1) : T(-1)};
    if (!slip.slides) return slip;
    const Removal<T> j = removal_of(scene, u, slip);
    const bool goes_on = (u.ut + u.b3() * j.normal + u.b1() * j.tangential) * slip.sign > T(0);
    return {goes_on || !can_stick(scene, post_impact), slip.sign};
}

template <class T>
bool sticks(const ContactScene<T>& scene, const Slip<T>& slip) {
    return scene.mu > T(0) && !slip.slides;
}

}  // namespace swirl
