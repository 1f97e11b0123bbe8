#include "map/sustained/contact_state.hpp"

#include <cmath>

namespace swirl {

ContactScene contact_scene(const Body<double>& body, double mu, double restitution, ImpactRule rule) {
    ContactScene scene{body, mu, restitution, rule, 0, 0, 0};
    if (!scene.is_disk()) {
        scene.half_chord = std::asin(body.alpha * std::sin(0.5 * body.spacing));
        scene.widest_chi = 0.5 * body.spacing - scene.half_chord;
        scene.widest_sine = std::sin(scene.widest_chi);
    }
    return scene;
}

ContactState contact_state(const ContactScene& scene, const Launch<double>& launch) {
    return {std::atan2(launch.psi.y, launch.psi.x), std::atan2(launch.chi.y, launch.chi.x),
            approach_of(scene.body, launch).ut, launch.spin};
}

Launch<double> launch_from(const ContactScene& scene, const ContactState& state) {
    Launch<double> launch{cis(state.psi), cis(state.chi), 0, 0, state.spin};
    const Approach<double> still = approach_of(scene.body, launch);  // u of a body whose centre is at rest
    launch.vn = -still.un;
    launch.vt = state.ut - still.ut;
    return launch;
}

Launch<double> seen_from_neighbour(const ContactScene& scene, const Launch<double>& launch) {
    const double side = launch.chi.y > 0 ? -1 : 1;
    const Vec2<double> turn = cis(side * 2 * scene.half_chord);  // from this contact to the other
    const Vec2<double> velocity = seen_from(turn, Vec2<double>{launch.vn, launch.vt});
    return {times(turn, launch.psi), cis(side * scene.widest_chi), velocity.x, velocity.y, launch.spin};
}

}  // namespace swirl
