// Sustained contact: the body on the wall, on a vertex, on the two of an edge, or (a disk) on its rim.
// map/sustained/README.md, "Motion".
//
// The section's coordinates serve here too, with u_n = 0: ψ = arg n − t, χ = arg r − arg n (a vertex), the slip
// velocity u_t and S. The container does not rotate, so a vertex that touches moves along the wall at u_t = dν/dt, ν =
// arg n. An edge's state is that of its clockwise vertex, χ = −χ_m; a disk has χ = 0.
#pragma once

#include "map/model/section.hpp"

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
struct ContactState {
    double psi = 0;
    double chi = 0;
    double ut = 0;
    double spin = 0;
};

/// What sustained contact needs of a scene.
struct ContactScene {
    Body<double> body;
    double mu = 0;
    double restitution = 0;
    ImpactRule rule = ImpactRule::frictionless;
    double widest_chi = 0;   ///< χ_m = π/N − asin(α sin(π/N)): at |χ| = χ_m the neighbour touches too
    double widest_sine = 0;  ///< sin χ_m
    double half_chord = 0;   ///< asin(α sin(π/N)): half the angle between the two contacts of an edge

    bool is_disk() const { return body.sides == disk_sides; }
    double inertia_factor() const { return body.inertia / (body.alpha * body.alpha); }
};

ContactScene contact_scene(const Body<double>& body, double mu, double restitution, ImpactRule rule);

/// The state in contact just after an impact that left no normal velocity.
ContactState contact_state(const ContactScene& scene, const PostImpactState<double>& post_impact);

/// The state just after an impact, u_n = 0, on the vertex (rim) that the contact's coordinates belong to.
PostImpactState<double> post_impact_state(const ContactScene& scene, const ContactState& state);

/// The same state seen from the neighbour that touches too (|χ| = χ_m): one number up if χ < 0, one down if χ > 0.
PostImpactState<double> seen_from_neighbour(const ContactScene& scene, const PostImpactState<double>& post_impact);

}  // namespace swirl
