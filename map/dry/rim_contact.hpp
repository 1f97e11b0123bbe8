// A disk's contact with the wall over a floor with dry friction, from its landing to its release. map/dry/README.md,
// "Contact".
#pragma once

#include "map/contact/contact_phase.hpp"
#include "map/dry/rim_course.hpp"

#include <cmath>

namespace swirl {

/// Where contact begins after an impact that leaves with u_n ≤ 0, which is removed with the friction that goes with it:
/// as without floor (map/contact/README.md, "Chattering"), but for what is of second order in the time that chatter
/// would have gone on, below 10⁻¹⁵.
template <class T>
ContactState<T> landing_on_rim(const RimScene<T>& scene, const PostImpactState<T>& post_impact) {
    using std::atan2;
    const ContactKinematics<T> u = contact_kinematics(*scene.body, post_impact);
    const double rounding = 64 * epsilon<double>() *
                            (std::fabs(plain(post_impact.vn)) + std::fabs(plain(post_impact.vt)) +
                             plain(scene.body->beta) + plain(scene.body->alpha) * std::fabs(plain(post_impact.spin)));
    T friction(0);  // q
    T ut = u.ut;
    if (plain(scene.mu) > 0 && std::fabs(plain(u.ut)) <= rounding) {
        friction = -u.ut / u.b1();
        ut = T(0);
    } else if (plain(scene.mu) > 0) {
        friction = (plain(u.ut) > 0 ? -u.un : u.un) * scene.mu;  // −s μ p, p = u_n
        ut = u.ut + u.b1() * friction;
    }
    return {T(atan2(post_impact.psi.y, post_impact.psi.x)), T(0), ut,
            T(post_impact.spin + u.rn * friction * u.inverse_inertia)};
}

/// Follows contact until the disk leaves the wall, `horizon` is over, or so many steps were made. A segment's motion is
/// `sticking` where the disk rolls and where it rests against a dish (S = 0), which ends as `slip`; `stick` ends a slip
/// and a disk that comes to rest. While it rests f, which is not unique, is left out of `work`.
///   post_impact  just after the impact from which chatter has come to its end
/// Cost: some 5 µs a step, at least eight steps per 1/ω_s.
ContactPhase<double> follow_rim(const RimScene<double>& scene, const PostImpactState<double>& post_impact,
                                double horizon, const ContactSink& sink = {}, long most_steps = most_contact_steps);

/// The state just after a release, u_n = 0.
template <class T>
PostImpactState<T> leaving_rim(const RimScene<T>& scene, const ContactState<T>& z) {
    PostImpactState<T> leaving{cis(z.psi), {T(1), T(0)}, T(0), T(0), z.spin};
    const ContactKinematics<T> still = contact_kinematics(*scene.body, leaving);  // u of a centre at rest
    leaving.vn = -still.un;
    leaving.vt = z.ut - still.ut;
    return leaving;
}

}  // namespace swirl
