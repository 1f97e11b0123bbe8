// Rest on the wall over a floor with dry friction, against the dish: how it is held, and what begins where it is not.
// map/dry/README.md, "Rest".
#pragma once

#include "map/dry/dry_wall.hpp"

namespace swirl {

/// The least push of the floor that rest needs, and the wall's force with it.
struct HeldAtRest {
    double least = 0;   ///< a_f that holds it just so: 0 where the wall's friction alone wedges it
    double normal = 0;  ///< λ; of an edge the sum of both
    double friction = 0;
};

/// A body at rest against the dish is held by forces of the wall within its friction cones and a push of the floor
/// within its limit surface; they are not unique. With ξ = (V, ω) a motion and w the swirl's arm these exist if and
/// only if
///
///     w·V ≤ a_f ⟨|V + iωρ|⟩ for all ξ in which each contact leaves the wall at least μ times as fast as it slips
///
/// (the limit surface's support function is the mean: Goyal, Ruina & Papadopoulos, Wear 143 (1991) 307). On w·V = 1 the
/// mean is convex in what is left of ξ, so that its least value there, 1/a_f, lies in the middle or on one of the
/// lines that bound these ξ. Cost: some 100 means.
///   z  of which ψ and χ are read
HeldAtRest held_at_rest(const DryWall<double>& wall, Support support, const ContactState<double>& z);

/// What is left of a_f while the body rests: it is held where ≥ 0.
inline double rest_reserve(const DryWall<double>& wall, Support support, const ContactState<double>& z) {
    return wall.deceleration - held_at_rest(wall, support, z).least;
}

/// The motion that begins in a state, or the event that ends contact at once.
struct DryChoice {
    MotionChoice<double> choice;
    DryMotion motion;
};

/// Where the body moves against the floor: that of `choose_motion`, with what the floor pushes. At rest against a dish:
/// rest where that is held; else flight where the swirl pulls it off the wall; else an edge that slides, or lifts one
/// of its vertices; a vertex (rim) that stays, about which the body turns; a slip in the ratio u_t : S of its own
/// rates.
///   before  as in `choose_motion`: no rest after a `slip`
DryChoice choose_dry_motion(const DryWall<double>& wall, Support support, const ContactState<double>& state,
                            int vertex_step, ContactEvent before);

/// A slip that has begun at rest a time ago. (u_t, S) goes at first in the ratio of its rates, which changes as ψ does:
/// ratios beside it come to it at a rate of a_f over the speed, faster than steps could follow.
struct Creep {
    double time = 0;
    ContactState<double> state;  ///< then
    double turned = 0;           ///< ∫ S dt
};

Creep creep_from_rest(const DryWall<double>& wall, const DryMotion& motion, const ContactState<double>& z, double time);

/// How long a slip from rest creeps so: until its speed is 10⁻⁶ a_f/ω_s, where the ratio is known to 10⁻⁶ of itself.
double creep_lasts(const DryWall<double>& wall, const DryMotion& motion, const ContactState<double>& z);

/// Does the motion begin at rest against a dish, with a slip?
inline bool creeps(const DryWall<double>& wall, const DryMotion& motion, const ContactState<double>& z) {
    return wall.is_dish && !motion.rests && !goes_in_line(wall, motion, z.spin) && z.ut == 0 && z.spin == 0;
}

/// The motion of a state on the way, as it was chosen when it began.
DryMotion dry_motion_at(const DryWall<double>& wall, Support support, ContactMotion motion,
                        const ContactState<double>& z);

}  // namespace swirl
