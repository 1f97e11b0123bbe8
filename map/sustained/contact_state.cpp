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

ContactState contact_state(const ContactScene& scene, const PostImpactState<double>& post_impact) {
    return {std::atan2(post_impact.psi.y, post_impact.psi.x), std::atan2(post_impact.chi.y, post_impact.chi.x),
            contact_kinematics(scene.body, post_impact).ut, post_impact.spin};
}

PostImpactState<double> post_impact_state(const ContactScene& scene, const ContactState& state) {
    PostImpactState<double> post_impact{cis(state.psi), cis(state.chi), 0, 0, state.spin};
    const ContactKinematics<double> still =
        contact_kinematics(scene.body, post_impact);  // u of a body whose centre is at rest
    post_impact.vn = -still.un;
    post_impact.vt = state.ut - still.ut;
    return post_impact;
}

PostImpactState<double> seen_from_neighbour(const ContactScene& scene, const PostImpactState<double>& post_impact) {
    const double side = post_impact.chi.y > 0 ? -1 : 1;
    const Vec2<double> turn = cis(side * 2 * scene.half_chord);  // from this contact to the other
    const Vec2<double> velocity = seen_from(turn, Vec2<double>{post_impact.vn, post_impact.vt});
    return {times(turn, post_impact.psi), cis(side * scene.widest_chi), velocity.x, velocity.y, post_impact.spin};
}

}  // namespace swirl
