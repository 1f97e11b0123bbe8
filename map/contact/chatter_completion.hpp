// Chatter completion: whether an impact ends complete chattering, and the state and support in which contact begins.
//
// After an impact that leaves the wall at v = −u_n ≥ 0 with the free normal acceleration a > 0 (towards the wall) the
// remaining flights last 2v/a, 2ve/a, 2ve²/a …: they end after T = 2v/(a(1 − e)). To first order in T their impulses
// add up to those of contact over the same time, less v: the rest of the sequence equals the removal of v, with
// friction, at its beginning, followed by contact (complete chattering: Nordmark & Piiroinen, Nonlinear Dyn. 58 (2009)
// 85). Meanwhile the two motions differ by at most vT in position: contact begins once that is below 16 ε of R_c, ε
// that of the number type; T by the rebound e′ of impacts that stick, where that makes it much longer, and not for e′ ≥
// 1
// (`longer_by_sticking`). There is no speed threshold. At the end of chattering they differ in position and velocities
// by the second order in T, which `ChatterError::estimate` estimates (the first order cancels: the tangential
// displacement is proportional to the normal one, which is zero at the end; what chatter that sticks, or comes to
// stick, has of second order is added, end_of_chatter.hpp):
//
//     ½ Δu T² (r(r + |a′|/a) + r′)(1 + |c′|/c)
//
// Δu the velocities removed, r = 1 + the rates at which n and r turn, r′ the rates at which contact changes these (S′ ≈
// λ/αI), a′/a the change of the flights' lengths, and c′/c, c = B₂ − sμB₃ by χ, that of the impulse v/c which removes
// v. (Close to Painlevé's border, c = 0, both r′ and c′/c are large.) README.md, "Chattering", has what was measured.
#pragma once

#include "map/contact/contact_state.hpp"

#include <cmath>

namespace swirl {

template <class T>
struct ChatterCompletion {
    bool in_contact = false;
    Support support = Support::vertex;
    ContactState<T> state;  ///< u_n removed
    int vertex_step = 0;    ///< from the vertex that struck to the one that the state belongs to: −1, 0 or 1
    T error{};              ///< of replacing the rest of chatter by contact (ChatterError::estimate)
    T jacobi{};             ///< change of J by the removal of u_n (the rest of chatter), −p ū_n + q (ū_t − 1)
    bool struck = false;    ///< not in contact: the vertex would leave, but its neighbour is at the wall and approaches
};

/// Chatter is replaced by contact once vT, the bound of the displacement by its remaining flights, is below this, in
/// R_c. In more digits chatter is followed further down, so that its error falls with ε.
template <class T>
inline Plain<T> chatter_tolerance() {
    return 16 * epsilon<T>();
}

/// The neighbour counts as touching if |χ| is this close to χ_m: the rounding of an impact of both vertices.
template <class T>
inline Plain<T> neighbour_tolerance() {
    return tolerance<T>(1e-12);
}

/// Normal velocities up to this are rounding and count as zero.
template <class T>
inline T velocity_rounding(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    using std::abs;
    return 64 * epsilon<T>() *
           (abs(post_impact.vn) + abs(post_impact.vt) + scene.body.beta + scene.body.alpha * abs(post_impact.spin));
}

/// A quick sufficient test: false (as after nearly every impact) implies that `chatter_completion` finds no contact.
/// The body leaves if vT exceeds `chatter_tolerance` by a factor of 2 (for rounding) even with the bound a ≤ β + (u_t −
/// αS)²/ρ (a disk) or β + u_t² (a vertex), with what a floor adds, and the neighbour is away from the wall. Cost: some
/// ten products.
template <class T>
[[gnu::always_inline]] inline bool may_chatter(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    using std::abs;
    const ContactKinematics<T> u = contact_kinematics(scene.body, post_impact);
    const T along = scene.is_disk() ? T(u.ut - scene.body.alpha * post_impact.spin) : u.ut;
    const T nearer = scene.is_disk() ? scene.body.inverse_inner : T(1);
    T acceleration = scene.body.beta + along * along * nearer;
    if (scene.floor.drags) {
        const ContactFloor<T>& floor = scene.floor;
        acceleration += floor.tilt * scene.body.beta + floor.drag * abs(u.un) + abs(floor.push.x) + abs(floor.push.y);
        if (!scene.is_disk())
            acceleration +=
                scene.body.alpha * (abs(floor.drag - floor.spin_drag) * abs(post_impact.spin) + abs(floor.turning));
    }
    if (!(u.un * u.un > chatter_tolerance<T>() * (1 - scene.restitution) * acceleration &&
          abs(u.un) > velocity_rounding(scene, post_impact)))
        return true;
    return !scene.is_disk() && !(abs(T(abs(post_impact.chi.y) - scene.widest_sine)) > 2 * neighbour_tolerance<T>());
}

/// Whether and how contact begins just after an impact.
template <class T>
ChatterCompletion<T> chatter_completion(const ContactScene<T>& scene, const PostImpactState<T>& post_impact);

/// The errors of replacing chatter after an impact by contact.
template <class T>
struct ChatterError {
    T moved;     ///< vT: bounds the displacement between the two motions during chatter, in R_c
    T estimate;  ///< of the error of position (R_c) and velocities (R_c ω_s) at its end
};

/// Infinite if the vertex (rim) does not come back to the wall.
template <class T>
ChatterError<T> chatter_error(const ContactScene<T>& scene, const PostImpactState<T>& post_impact);

/// True for an edge that friction holds at rest.
template <class T>
bool rests_still(const ContactScene<T>& scene, const ChatterCompletion<T>& completion);

/// The state in contact of a post-impact state `near` to `base`, whose completion is given: u_n is removed with the
/// same friction on the same support, for either sign of u_n. Smooth in `near` as long as the same impact stops the
/// slip, so that it can be differentiated; so is an edge (`edge_rate`).
template <class T>
ContactState<T> landed_like(const ContactScene<T>& scene, const PostImpactState<T>& base,
                            const ChatterCompletion<T>& completion, const PostImpactState<T>& near);

}  // namespace swirl
