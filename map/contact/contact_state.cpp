#include "map/contact/contact_state.hpp"

#include "map/contact/contact_jets.hpp"
#include "map/map_list.hpp"
#include "map/numbers/quad.hpp"

#include <cmath>

namespace swirl {

template <class T>
ContactScene<T> contact_scene(const Body<T>& body, const T& mu, const T& restitution, ImpactRule rule) {
    using std::asin;
    using std::sin;
    ContactScene<T> scene{body, mu, restitution, rule, T(0), T(0), T(0), {}};
    if (!scene.is_disk()) {
        scene.half_chord = asin(body.alpha * sin(T(0.5) * body.spacing));
        scene.widest_chi = T(0.5) * body.spacing - scene.half_chord;
        scene.widest_sine = sin(scene.widest_chi);
    }
    return scene;
}

template <class T>
ContactScene<double> in_double(const ContactScene<T>& scene) {
    const auto number = [](const T& x) { return static_cast<double>(x); };
    Scene<double> rounded{scene.body.sides,
                          number(scene.body.alpha),
                          number(scene.body.beta),
                          number(scene.mu),
                          number(scene.restitution),
                          Law::poisson,  // `rule` stays
                          number(scene.inertia_factor())};
    rounded.tangential_restitution = number(scene.body.tangential_restitution);
    ContactScene<double> contact = contact_scene(make_body(rounded), rounded.mu, rounded.restitution, scene.rule);
    const ContactFloor<T>& floor = scene.floor;
    contact.floor = {floor.drags,
                     number(floor.drag),
                     number(floor.spin_drag),
                     number(floor.tilt),
                     {number(floor.push.x), number(floor.push.y)},
                     number(floor.turning)};
    return contact;
}

template <class T>
ContactState<T> contact_state(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    using std::atan2;
    return {atan2(post_impact.psi.y, post_impact.psi.x), atan2(post_impact.chi.y, post_impact.chi.x),
            contact_kinematics(scene.body, post_impact).ut, post_impact.spin};
}

template <class T>
PostImpactState<T> post_impact_state(const ContactScene<T>& scene, const ContactState<T>& state) {
    PostImpactState<T> post_impact{cis(state.psi), cis(state.chi), T(0), T(0), state.spin};
    const ContactKinematics<T> still =
        contact_kinematics(scene.body, post_impact);  // u of a body whose centre is at rest
    post_impact.vn = -still.un;
    post_impact.vt = state.ut - still.ut;
    return post_impact;
}

template <class T>
PostImpactState<T> seen_from_neighbour(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    const T side = post_impact.chi.y > T(0) ? T(-1) : T(1);
    const Vec2<T> turn = cis(T(side * T(2) * scene.half_chord));  // from this contact to the other
    const Vec2<T> velocity = seen_from(turn, Vec2<T>{post_impact.vn, post_impact.vt});
    return {times(turn, post_impact.psi), cis(T(side * scene.widest_chi)), velocity.x, velocity.y, post_impact.spin};
}

#define SWIRL_COMPILE_CONTACT_STATE(T)                                                             \
    template ContactScene<T> contact_scene(const Body<T>&, const T&, const T&, ImpactRule);        \
    template ContactState<T> contact_state(const ContactScene<T>&, const PostImpactState<T>&);     \
    template PostImpactState<T> post_impact_state(const ContactScene<T>&, const ContactState<T>&); \
    template PostImpactState<T> seen_from_neighbour(const ContactScene<T>&, const PostImpactState<T>&);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_CONTACT_STATE)
SWIRL_EVERY_CONTACT_JET(SWIRL_COMPILE_CONTACT_STATE)
#define SWIRL_COMPILE_IN_DOUBLE(T) template ContactScene<double> in_double(const ContactScene<T>&);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_IN_DOUBLE)

}  // namespace swirl
