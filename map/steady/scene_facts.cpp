#include "map/steady/scene_facts.hpp"

#include "map/contact/rim_pendulum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace swirl {

std::string_view name_of(ImpactFate fate) {
    static constexpr std::string_view names[] = {"fade", "conserved", "can-last"};
    return names[static_cast<std::size_t>(fate)];
}

namespace {

/// This near to the separatrix on either side, in units of its height.
constexpr double beside_separatrix = 1e-12;

ImpactFate fate_of(const Scene<double>& scene) {
    if (is_dissipative_without_drive(scene)) return ImpactFate::fade;
    return scene.mu == 0 ? ImpactFate::conserved : ImpactFate::can_last;
}

double painleve_friction(double kappa, double widest_chi) {
    const double slope = std::min(std::sqrt(kappa / (1 + kappa)), std::tan(widest_chi));
    return kappa / slope + (1 + kappa) * slope;
}

/// The amplitude of a libration of height h above rest: 1 − cos ψ = h/k.
double amplitude_of(const RimPendulum& pendulum) {
    return 2 * std::asin(std::min(1.0, std::sqrt(pendulum.height / (2 * pendulum.strength))));
}

RimFacts rim_facts(const Scene<double>& scene, const ContactScene<double>& contact) {
    RimFacts facts;
    const double rho = 1 - scene.alpha;
    facts.rolls = scene.mu > 0;
    facts.strength = scene.beta / (rho * (facts.rolls ? 1 + scene.inertia_factor : 1));
    facts.small_frequency = std::sqrt(facts.strength);
    facts.circulation_energy = facts.strength;
    facts.rest_force = scene.beta + rho;
    if (facts.rolls) facts.mean_spin = -rho / scene.alpha;
    const double separatrix = 2 * facts.strength;
    if (separatrix > 0) {
        const RimPendulum widest{facts.rolls, facts.strength, separatrix * (1 - beside_separatrix), 1};
        if (const auto held = settled_pendulum(contact, widest)) facts.widest_libration = amplitude_of(*held);
    }
    const auto circulates = [&](double direction) {
        const RimPendulum slowest{facts.rolls, facts.strength, separatrix * (1 + beside_separatrix), direction};
        return least_hold(contact, slowest) >= 0;
    };
    facts.circulates_forward = circulates(1);
    facts.circulates_backward = circulates(-1);
    return facts;
}

}  // namespace

SceneFacts scene_facts(const Scene<double>& scene) {
    const Body<double> body = make_body(validated(scene));
    const ContactScene<double> contact = contact_scene(body, scene.mu, scene.restitution, ImpactRule::poisson);
    SceneFacts facts;
    facts.untouched_radius = body.unit * (body.inner - body.beta);  // in R_c; 1 of what has no rounded corners
    facts.untouched_room_turning = body.unit * (body.outer - body.beta);
    facts.impacts = fate_of(scene);
    if (scene.is_disk()) {
        facts.rim = rim_facts(scene, contact);
        return facts;
    }
    facts.widest_chi = contact.widest_chi;
    if (scene.is_rounded()) return facts;  // a rounded corner's B_3 is another
    facts.painleve_friction = painleve_friction(scene.inertia_factor, contact.widest_chi);
    facts.can_jam = scene.mu >= *facts.painleve_friction;
    return facts;
}

}  // namespace swirl
