#include "map/contact/strike.hpp"

#include "map/contact/chatter_completion.hpp"
#include "map/contact/contact_jets.hpp"
#include "map/contact/contact_state.hpp"
#include "map/contact/reaction.hpp"
#include "map/map_list.hpp"
#include "map/numbers/quad.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl {

namespace {

using std::abs;

constexpr int most_impulses = 100'000;

template <class T>
void receive(const ContactScene<T>& scene, const ContactKinematics<T>& before, const Impulse<T>& j,
             PostImpactState<T>& post_impact, Strike<T>& strike) {
    post_impact.vn -= j.normal;
    post_impact.vt += j.tangential;
    post_impact.spin += (before.rn * j.tangential + before.rt * j.normal) / before.inertia;
    const ContactKinematics<T> after = contact_kinematics(scene.body, post_impact);
    strike.jacobi_restitution -= j.normal * T(0.5) * (before.un + after.un);
    strike.jacobi_friction += j.tangential * (T(0.5) * (before.ut + after.ut) - T(1));
}

/// The impulse of a slip at u_n = 0 with c = B₂ − sμB₃ ≤ 0. On the border, c = 0, C is zero until the slip has stopped:
/// Newton's and Stronge's restitution have nothing to give back, Poisson's has the impulse p_k. There B₁ > B₂/μ² =
/// sB₃/μ, so that it sticks.
template <class T>
Impulse<T> jam_impulse(const ContactScene<T>& scene, ContactKinematics<T> u) {
    const T sign = u.ut > T(0) ? T(1) : T(-1);
    const T stiffness = u.b2() - sign * scene.mu * u.b3();
    u.un = T(0);
    // As many digits as the border is known to.
    if (plain(T(abs(stiffness))) > 16 * painleve_margin<Plain<T>>()) return impulse_by_law(scene, u, scene.restitution);
    const T stops = abs(u.ut) / (scene.mu * u.b1() - sign * u.b3());  // p_k
    const T more = scene.rule == ImpactRule::poisson ? T(scene.restitution * stops) : T(0);
    return {T(stops + more), T(-sign * scene.mu * stops - u.b3() / u.b1() * more), ContactMode::c_sticking};
}

}  // namespace

template <class T>
Impulse<T> strike_once(const ContactScene<T>& scene, PostImpactState<T>& post_impact, const T& restitution,
                       Strike<T>& strike) {
    const ContactKinematics<T> before = contact_kinematics(scene.body, post_impact);
    const Impulse<T> j = impulse_by_law(scene, before, restitution);
    receive(scene, before, j, post_impact, strike);
    return j;
}

template <class T>
Impulse<T> jam_once(const ContactScene<T>& scene, PostImpactState<T>& post_impact, Strike<T>& strike) {
    const ContactKinematics<T> before = contact_kinematics(scene.body, post_impact);
    const Impulse<T> j = jam_impulse(scene, before);
    receive(scene, before, j, post_impact, strike);
    return j;
}

template <class T>
Strike<T> strike_in_contact(const ContactScene<T>& scene, const PostImpactState<T>& completion, bool plastic) {
    const T restitution = plastic ? T(0) : scene.restitution;
    const T rounding = velocity_rounding(scene, completion);
    const T rest = rounding / T(16);
    Strike<T> strike;
    PostImpactState<T> striking = seen_from_neighbour(scene, completion);
    T previous = std::numeric_limits<T>::infinity();
    for (int i = 0; i < most_impulses; ++i) {
        const Impulse<T> j = strike_once(scene, striking, restitution, strike);
        strike.impulse.normal += j.normal;
        strike.impulse.tangential += j.tangential;
        if (i == 0) strike.impulse.mode = j.mode;
        PostImpactState<T> other = seen_from_neighbour(scene, striking);
        if (contact_kinematics(scene.body, other).un > rest) {
            strike_once(scene, other, restitution, strike);
            striking = seen_from_neighbour(scene, other);
        }
        // Alternating impulses that fall by a factor r each gather the rounding of 1/(1 − r) of them: they end there.
        const T un = contact_kinematics(scene.body, striking).un;
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

#define SWIRL_COMPILE_STRIKE(T)                                                                         \
    template Impulse<T> strike_once(const ContactScene<T>&, PostImpactState<T>&, const T&, Strike<T>&); \
    template Impulse<T> jam_once(const ContactScene<T>&, PostImpactState<T>&, Strike<T>&);              \
    template Strike<T> strike_in_contact(const ContactScene<T>&, const PostImpactState<T>&, bool);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_STRIKE)
SWIRL_EVERY_CONTACT_JET(SWIRL_COMPILE_STRIKE)

}  // namespace swirl
