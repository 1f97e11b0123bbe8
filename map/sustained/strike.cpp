#include "map/sustained/strike.hpp"

#include "map/sustained/standing.hpp"

#include <algorithm>
#include <cmath>

namespace swirl {

namespace {

constexpr int most_impulses = 100'000;

Impulse<double> impulse_by(const ContactScene& scene, const Approach<double>& approach, double restitution) {
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

void receive(const ContactScene& scene, const Approach<double>& before, const Impulse<double>& j,
             Launch<double>& launch, Strike& strike) {
    launch.vn -= j.normal;
    launch.vt += j.tangential;
    launch.spin += (before.rn * j.tangential + before.rt * j.normal) / before.inertia;
    const Approach<double> after = approach_of(scene.body, launch);
    strike.jacobi_restitution -= j.normal * 0.5 * (before.un + after.un);
    strike.jacobi_friction += j.tangential * (0.5 * (before.ut + after.ut) - 1);
}

}  // namespace

Impulse<double> strike_once(const ContactScene& scene, Launch<double>& launch, double restitution, Strike& strike) {
    const Approach<double> before = approach_of(scene.body, launch);
    const Impulse<double> j = impulse_by(scene, before, restitution);
    receive(scene, before, j, launch, strike);
    return j;
}

Impulse<double> jam_once(const ContactScene& scene, Launch<double>& launch, Strike& strike) {
    const Approach<double> before = approach_of(scene.body, launch);
    const double sign = before.ut > 0 ? 1 : -1;
    const double stiffness = before.b2() - sign * scene.mu * before.b3();
    const double stop = std::abs(before.ut) / (scene.mu * before.b1() - sign * before.b3());  // p where slip ends
    Approach<double> pressed = before;
    pressed.un = std::max(2 * stiffness * stop, 0.0);
    const Impulse<double> j = impulse_by(scene, pressed, scene.restitution);
    receive(scene, before, j, launch, strike);
    return j;
}

Strike strike_while_standing(const ContactScene& scene, const Launch<double>& standing, bool plastic) {
    const double restitution = plastic ? 0 : scene.restitution;
    const double rest = velocity_rounding(scene, standing) / 16;
    Strike strike;
    Launch<double> striking = seen_from_neighbour(scene, standing);
    for (int i = 0; i < most_impulses; ++i) {
        const Impulse<double> j = strike_once(scene, striking, restitution, strike);
        strike.impulse.normal += j.normal;
        strike.impulse.tangential += j.tangential;
        if (i == 0) strike.impulse.mode = j.mode;
        Launch<double> other = seen_from_neighbour(scene, striking);
        if (approach_of(scene.body, other).un > rest) {
            strike_once(scene, other, restitution, strike);
            striking = seen_from_neighbour(scene, other);
        }
        if (!(approach_of(scene.body, striking).un > rest)) {
            strike.after = striking;
            strike.resolved = true;
            return strike;
        }
    }
    strike.after = striking;
    return strike;
}

}  // namespace swirl
