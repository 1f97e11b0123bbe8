#include "apps/studies/fits/impact_laws.hpp"

#include "map/model/impact.hpp"
#include "map/model/scene.hpp"
#include "map/numbers/jets.hpp"

#include <string>

namespace swirl::studies {

namespace {

/// The wall along x with y towards the body: n = −y, t = x.
template <ImpactRule rule>
analysis::PredictedImpulse impulse_by(const Eigen::Vector2d& offset, double inertia, const Eigen::Vector2d& velocity,
                                      const analysis::LawParameters& parameters) {
    using Jet = ceres::Jet<double, 4>;
    ContactKinematics<Jet> contact;
    contact.un = -Jet(velocity[1], 1);
    contact.ut = Jet(velocity[0], 0);
    contact.rn = Jet(-offset[1]);
    contact.rt = Jet(offset[0]);
    contact.inertia = Jet(inertia);
    contact.inverse_inertia = Jet(1 / inertia);
    const Impulse<Jet> found = impulse<rule>(contact, Jet(parameters.friction, 3), Jet(parameters.restitution, 2));
    analysis::PredictedImpulse predicted;
    predicted.impulse << found.tangential.a, found.normal.a;
    predicted.slopes << found.tangential.v.transpose(), found.normal.v.transpose();
    return predicted;
}

}  // namespace

std::vector<analysis::NamedImpactLaw> impact_laws() {
    return {{std::string(name_of(Law::poisson)), impulse_by<ImpactRule::poisson>},
            {std::string(name_of(Law::newton)), impulse_by<ImpactRule::newton>},
            {std::string(name_of(Law::stronge)), impulse_by<ImpactRule::stronge>}};
}

}  // namespace swirl::studies
