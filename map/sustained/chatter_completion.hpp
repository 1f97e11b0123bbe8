// Does the body stand on the wall just after an impact, and on what? Where chatter ends and contact begins.
//
// After an impact that leaves the wall at v = −u_n ≥ 0 with the free normal acceleration a > 0 (towards the wall) the
// remaining flights last 2v/a, 2ve/a, 2ve²/a …: they end after T = 2v/(a(1 − e)). To first order in T their impulses
// add up to what contact would have given in the same time, less v: the rest of the sequence equals the removal of v,
// with friction, at its beginning, followed by contact (complete chatter: Nordmark & Piiroinen, Nonlinear Dyn. 58
// (2009) 85). On the way the body is elsewhere by at most vT: contact begins once that is below 16 ε of R_c. There is
// no speed threshold. In the end less is left, as what the impulses move along the wall goes with what they move across
// it, and that is nothing: of the velocities Δu taken out, some (rT)², with r = 1 + the rates at which the body turns
// (in the tests never more than 3 Δu (rT)²).
#pragma once

#include "map/sustained/contact_state.hpp"

#include <cmath>
#include <limits>

namespace swirl {

struct ChatterCompletion {
    bool in_contact = false;
    Support support = Support::vertex;
    ContactState state;   ///< u_n removed
    int vertex_step = 0;  ///< from the vertex that struck to the one that the state belongs to: −1, 0 or 1
    double error = 0;     ///< of ending chatter here (ChatterError::estimate)
    double jacobi = 0;    ///< what taking u_n out (the rest of chatter) adds to J, −p ū_n + q (ū_t − 1)
    bool struck =
        false;  ///< not in contact: it is about to leave, but its neighbour is at the wall, too, and approaches
};

/// Chatter has come to its end once what is left moves the body by less than this, in R_c.
inline constexpr double chatter_tolerance = 16 * std::numeric_limits<double>::epsilon();

/// A neighbour touches too if χ is this close to χ_m: the rounding of an arrival on both.
inline constexpr double neighbour_tolerance = 1e-12;

/// The largest normal velocity that is rounding only.
inline double velocity_rounding(const ContactScene& scene, const PostImpactState<double>& post_impact) {
    return 64 * std::numeric_limits<double>::epsilon() *
           (std::abs(post_impact.vn) + std::abs(post_impact.vt) + scene.body.beta +
            scene.body.alpha * std::abs(post_impact.spin));
}

/// False for a body that plainly leaves, as after nearly every impact; `chatter_completion` then says so too. It leaves
/// if vT is above its bound with a ≤ β + (u_t − αS)²/ρ (a disk) or β + u_t² (a vertex), by a factor 2 for rounding, and
/// the neighbour is away from the wall. Cost: some ten products.
[[gnu::always_inline]] inline bool may_chatter(const ContactScene& scene, const PostImpactState<double>& post_impact) {
    const ContactKinematics<double> u = contact_kinematics(scene.body, post_impact);
    const double along = scene.is_disk() ? u.ut - scene.body.alpha * post_impact.spin : u.ut;
    const double nearer = scene.is_disk() ? scene.body.per_inner : 1;
    const double acceleration = scene.body.beta + along * along * nearer;
    if (!(u.un * u.un > chatter_tolerance * (1 - scene.restitution) * acceleration &&
          std::abs(u.un) > velocity_rounding(scene, post_impact)))
        return true;
    return !scene.is_disk() && !(std::abs(std::abs(post_impact.chi.y) - scene.widest_sine) > 2 * neighbour_tolerance);
}

/// The standing of a body just after an impact.
ChatterCompletion chatter_completion(const ContactScene& scene, const PostImpactState<double>& post_impact);

/// What ending chatter after an impact does.
struct ChatterError {
    double moved;     ///< vT: by how much the body moves on the way in one of the two and not in the other; in R_c
    double estimate;  ///< 4 Δu (rT)², of the error of place and velocities when it is over, in R_c and R_c ω_s
};

/// Infinite if the vertex (rim) does not come back to the wall.
ChatterError chatter_error(const ContactScene& scene, const PostImpactState<double>& post_impact);

/// True for an edge that friction holds at rest.
bool rests_still(const ContactScene& scene, const ChatterCompletion& completion);

/// The state in contact of a post-impact state near one that stands: u_n removed with the same friction on the same
/// support, whatever its own u_n. Smooth in `near`, so that it can be differentiated. On an edge the friction of the
/// rocking that dies there is left out.
ContactState landed_like(const ContactScene& scene, const PostImpactState<double>& base,
                         const ChatterCompletion& completion, const PostImpactState<double>& near);

}  // namespace swirl
