// Sustained contact: the body on the wall, on a vertex, on the two of an edge, or (a disk) on its rim.
// map/contact/README.md, "Motion".
//
// The section's coordinates serve here too, with u_n = 0: ψ = arg n − t, χ = arg r − arg n (a vertex), the slip
// velocity u_t and S. The container does not rotate, so a vertex that touches moves along the wall at u_t = dν/dt, ν =
// arg n. An edge's state is that of its clockwise vertex, χ = −χ_m; a disk has χ = 0.
#pragma once

#include "map/model/impact.hpp"
#include "map/model/scene.hpp"
#include "map/model/section.hpp"

#include <string_view>

namespace swirl {

/// The part of the body in contact.
enum class Support { rim, vertex, edge };

/// How it moves in contact. Without friction there is only `sliding_forward`, whatever the sign of u_t.
enum class ContactMotion { sliding_forward, sliding_backward, sticking };

inline std::string_view name_of(Support support, ContactMotion motion) {
    if (motion != ContactMotion::sticking) return "sliding";
    return support == Support::rim ? "rolling" : "sticking";
}

/// A state in contact. Angles in radians, u_t in R_c ω_s, S in ω_s.
template <class T>
struct ContactState {
    T psi{};
    T chi{};
    T ut{};
    T spin{};
};

/// A state for a report: records and figures are made in double.
template <class T>
ContactState<double> in_double(const ContactState<T>& z) {
    return {static_cast<double>(z.psi), static_cast<double>(z.chi), static_cast<double>(z.ut),
            static_cast<double>(z.spin)};
}

/// What a floor adds to the motion in contact. One that drags (map/dragged/README.md): −γX′ and −γ_r S, and of a table
/// −iγ times the swirl's arm. X′ of the centre is, in the axes n and t, (S r_t, u_t − S r_n) of a vertex that is in
/// contact. One with dry friction (map/dry/README.md): what it pushes at a moment.
template <class T>
struct ContactFloor {
    bool drags = false;     ///< or pushes: else there is none
    T drag{}, spin_drag{};  ///< γ, γ_r
    T tilt{};               ///< γ of a table, 0 of a dish: the swirl's force is (1 − iγ[table]) w
    Vec2<T> push{};         ///< of dry friction, on the centre, in the axes of the swirl's arm
    T turning{};            ///< of dry friction: its torque by I
};

/// What sustained contact needs of a scene.
template <class T>
struct ContactScene {
    Body<T> body;
    T mu{};
    T restitution{};
    ImpactRule rule = ImpactRule::frictionless;
    T widest_chi{};   ///< χ_m = π/N − asin(α sin(π/N)): at |χ| = χ_m the neighbour touches too
    T widest_sine{};  ///< sin χ_m
    T half_chord{};   ///< asin(α sin(π/N)): half the angle between the two contacts of an edge
    ContactFloor<T> floor{};

    bool is_disk() const { return body.sides == disk_sides; }
    T inertia_factor() const { return body.inertia / (body.alpha * body.alpha); }
};

/// A contact's scene in double.
template <class T>
ContactScene<double> in_double(const ContactScene<T>& scene);

// Compiled once for every number of map_list.hpp, as all of sustained contact.

/// Over a floor that does not drag.
template <class T>
ContactScene<T> contact_scene(const Body<T>& body, const T& mu, const T& restitution, ImpactRule rule);
/// That of a scene, with its floor.
///   over_floor  with drag of 0, too, along which it is differentiated
template <class T>
ContactScene<T> contact_scene(const Body<T>& body, const Scene<T>& scene, ImpactRule rule, bool over_floor = false) {
    ContactScene<T> contact = contact_scene(body, scene.mu, scene.restitution, rule);
    if (!over_floor && !scene.has_drag()) return contact;
    contact.floor = {true, scene.drag, scene.turning_drag(), scene.floor == Floor::table ? scene.drag : T(0), {}, {}};
    return contact;
}

/// The swirl's force on the body along n and t: β(cos ψ, −sin ψ), turned by the table's drag, with the floor's push.
template <class T>
Vec2<T> swirl_force(const ContactScene<T>& scene, const Vec2<T>& psi) {
    const T wn = scene.body.beta * psi.x, wt = -scene.body.beta * psi.y;
    if (!scene.floor.drags) return {wn, wt};
    const Vec2<T>& push = scene.floor.push;
    return {wn + scene.floor.tilt * wt + (push.x * psi.x + push.y * psi.y),
            wt - scene.floor.tilt * wn + (push.y * psi.x - push.x * psi.y)};
}

/// The state in contact just after an impact that left no normal velocity.
template <class T>
ContactState<T> contact_state(const ContactScene<T>& scene, const PostImpactState<T>& post_impact);

/// The state just after an impact, u_n = 0, on the vertex (rim) that the contact's coordinates belong to.
template <class T>
PostImpactState<T> post_impact_state(const ContactScene<T>& scene, const ContactState<T>& state);

/// The state seen from the neighbour that touches too (|χ| = χ_m): one number up if χ < 0, one down if χ > 0.
template <class T>
PostImpactState<T> seen_from_neighbour(const ContactScene<T>& scene, const PostImpactState<T>& post_impact);

/// `impulse` (map/model/impact.hpp) by the scene's law, with its μ.
///   approach     velocities and lever arms at the contact
///   restitution  e, the scene's or 0
template <class T>
Impulse<T> impulse_by_law(const ContactScene<T>& scene, const ContactKinematics<T>& approach, const T& restitution) {
    if (scene.body.tangential_restitution != T(0) && scene.rule != ImpactRule::frictionless)  // a disk
        return disk_impulse(approach.un, approach.ut, scene.body.disk_grip, scene.mu, restitution);
    switch (scene.rule) {
        case ImpactRule::frictionless:
            return impulse<ImpactRule::frictionless>(approach, scene.mu, restitution);
        case ImpactRule::poisson:
            return impulse<ImpactRule::poisson>(approach, scene.mu, restitution);
        case ImpactRule::newton:
            return impulse<ImpactRule::newton>(approach, scene.mu, restitution);
        case ImpactRule::stronge:
            return impulse<ImpactRule::stronge>(approach, scene.mu, restitution);
    }
    return {};
}

}  // namespace swirl
