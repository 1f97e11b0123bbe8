// Scenes and states in contact for the tests of sustained contact.
#pragma once

#include "map/collision_map.hpp"
#include "map/contact/contact_state.hpp"

namespace swirl::tests {

inline Scene<double> uniform_scene(int sides, double alpha, double beta, double mu, double e, Law law = Law::poisson) {
    return {sides, alpha, beta, mu, e, law, uniform_inertia_factor<double>(sides)};
}

/// A scene in another number type.
template <class T>
Scene<T> scene_in(const Scene<double>& s) {
    Scene<T> scene{s.sides, T(s.alpha), T(s.beta), T(s.mu), T(s.restitution), s.law, T(s.inertia_factor)};
    scene.tangential_restitution = T(s.tangential_restitution);
    return scene;
}

template <class T>
ContactScene<T> contact_of(const Scene<T>& s) {
    const ImpactRule rule = s.mu == 0               ? ImpactRule::frictionless
                            : s.law == Law::newton  ? ImpactRule::newton
                            : s.law == Law::stronge ? ImpactRule::stronge
                                                    : ImpactRule::poisson;
    return contact_scene(make_body(s), s.mu, s.restitution, rule);
}

}  // namespace swirl::tests
