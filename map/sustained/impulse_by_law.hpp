// The impulse of one impact by the law of a scene in contact, where the law is known only as the program runs.
#pragma once

#include "map/model/impact.hpp"
#include "map/sustained/contact_state.hpp"

namespace swirl {

/// `impulse` (map/model/impact.hpp) by the scene's law, with its μ.
///   approach     velocities and lever arms at the contact
///   restitution  e, the scene's or 0
template <class T>
Impulse<T> impulse_by_law(const ContactScene<T>& scene, const ContactKinematics<T>& approach, const T& restitution) {
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
