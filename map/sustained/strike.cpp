#include "map/sustained/strike.hpp"

#include "map/sustained/chatter_completion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl {

namespace {

constexpr int most_impulses = 100'000;

Impulse<double> impulse_by(const ContactScene& scene, const ContactKinematics<double>& approach, double restitution) {
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

void receive(const ContactScene& scene, const ContactKinematics<double>& before, const Impulse<double>& j,
             PostImpactState<double>& post_impact, Strike& strike) {
    post_impact.vn -= j.normal;
    post_impact.vt += j.tangential;
    post_impact.spin += (before.rn * j.tangential + before.rt * j.normal) / before.inertia;
    const ContactKinematics<double> after = contact_kinematics(scene.body, post_impact);
    strike.jacobi_restitution -= j.normal * 0.5 * (before.un + after.un);
    strike.jacobi_friction += j.tangential * (0.5 * (before.ut + after.ut) - 1);
}

}  // namespace

Impulse<double> strike_once(const ContactScene& scene, PostImpactState<double>& post_impact, double restitution,
                            Strike& strike) {
    const ContactKinematics<double> before = contact_kinematics(scene.body, post_impact);
    const Impulse<double> j = impulse_by(scene, before, restitution);
    receive(scene, before, j, post_impact, strike);
    return j;
}

Impulse<double> jam_once(const ContactScene& scene, PostImpactState<double>& post_impact, Strike& strike) {
    const ContactKinematics<double> before = contact_kinematics(scene.body, post_impact);
    const double sign = before.ut > 0 ? 1 : -1;
    const double stiffness = before.b2() - sign * scene.mu * before.b3();
    const double stop = std::abs(before.ut) / (scene.mu * before.b1() - sign * before.b3());  // p where slip ends
    ContactKinematics<double> pressed = before;
    pressed.un = std::max(2 * stiffness * stop, 0.0);
    const Impulse<double> j = impulse_by(scene, pressed, scene.restitution);
    receive(scene, before, j, post_impact, strike);
    return j;
}

Strike strike_in_contact(const ContactScene& scene, const PostImpactState<double>& completion, bool plastic) {
    const double restitution = plastic ? 0 : scene.restitution;
    const double rounding = velocity_rounding(scene, completion);
    const double rest = rounding / 16;
    Strike strike;
    PostImpactState<double> striking = seen_from_neighbour(scene, completion);
    double previous = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_impulses; ++i) {
        const Impulse<double> j = strike_once(scene, striking, restitution, strike);
        strike.impulse.normal += j.normal;
        strike.impulse.tangential += j.tangential;
        if (i == 0) strike.impulse.mode = j.mode;
        PostImpactState<double> other = seen_from_neighbour(scene, striking);
        if (contact_kinematics(scene.body, other).un > rest) {
            strike_once(scene, other, restitution, strike);
            striking = seen_from_neighbour(scene, other);
        }
        // Alternating impulses that fall by a factor r each gather the rounding of 1/(1 − r) of them: they end there.
        const double un = contact_kinematics(scene.body, striking).un;
        if (!(un > rest) || (un <= rounding && un >= previous)) {
            strike.after = striking;
            strike.resolved = true;
            return strike;
        }
        previous = un;
    }
    strike.after = striking;
    return strike;
}

}  // namespace swirl
