#include "map/sustained/chatter_completion.hpp"

#include "map/map_list.hpp"
#include "map/sustained/contact_jets.hpp"
#include "map/sustained/edge_landing.hpp"
#include "map/sustained/end_of_chatter.hpp"
#include "map/sustained/landing_error.hpp"
#include "map/sustained/reaction.hpp"
#include "map/sustained/removal.hpp"
#include "map/sustained/sticking_chatter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl {

namespace {

using std::abs, std::atan2, std::copysign, std::cos, std::isnan, std::sin;

/// Removes v by the impulses p and q, the differences of chatter's from contact's.
template <class T>
ContactState<T> without_normal_velocity(const ContactScene<T>& scene, const PostImpactState<T>& post_impact,
                                        const Slip<T>& slip, T& jacobi) {
    const ContactKinematics<T> u = contact_kinematics(scene.body, post_impact);
    ContactState<T> state = contact_state(scene, post_impact);
    const Removal<T> removal = removal_of(scene, u, slip);
    const T &p = removal.normal, &q = removal.tangential;
    state.ut += u.b3() * p + u.b1() * q;
    state.spin += (u.rn * q + u.rt * p) / u.inertia;
    jacobi = -p * T(0.5) * u.un + q * (T(0.5) * (u.ut + state.ut) - T(1));
    return state;
}

/// Where the impacts of the rest bring u_t to zero, sooner or later. Their sum has one acceleration a towards the wall
/// all along, that at rest. A slip that changes a by more than 10⁻³ is not of the order of v, and is not stopped by
/// them: where a is nearly 0 at rest, but not in the slip, the sum would have flights that are far too long.
template <class T>
void move_to_rest(const ContactScene<T>& scene, const PostImpactState<T>& post_impact, const Slip<T>& slip,
                  ContactState<T>& state) {
    constexpr double most_change = 1e-3;
    if (!(scene.mu > T(0))) return;
    const T at_rest = free_acceleration(scene, post_impact, T(0));
    const T in_slip = free_acceleration(scene, post_impact, contact_kinematics(scene.body, post_impact).ut);
    if (abs(plain(T(in_slip - at_rest))) <= most_change * plain(at_rest))
        move_along_wall(scene, post_impact, at_rest, slip, state);
}

template <class T>
ContactState<T> landed(const ContactScene<T>& scene, const PostImpactState<T>& post_impact, T& jacobi) {
    const Slip<T> slip = slip_of(scene, post_impact);
    ContactState<T> state = without_normal_velocity(scene, post_impact, slip, jacobi);
    if (scene.mu > 0 && (!slip.slides || state.ut * slip.sign <= 0)) state.ut = 0;
    const T before = jacobi_of(scene.body, post_impact_state(scene, state));
    move_to_rest(scene, post_impact, slip, state);
    jacobi += jacobi_of(scene.body, post_impact_state(scene, state)) - before;
    return state;
}

/// |c′|/c: how fast the impulse that removes v changes with χ; c = B₂ − sμB₃ while the vertex slides, B₂ − B₃²/B₁ while
/// it sticks. Here and below with the magnitudes of all terms, since a sum may be small by chance.
template <class T>
T impulse_change(const ContactScene<T>& scene, const Slip<T>& slip, const T& chi) {
    const T kappa = scene.inertia_factor(), c = cos(chi), s = sin(chi);
    if (sticks(scene, slip)) return abs(2 * s * c) / (kappa + c * c);
    return (abs(2 * s * c) + scene.mu * abs(c * c - s * s)) / abs(kappa + s * (s - scene.mu * slip.sign * c));
}

/// (r(r + |a′|/a) + r′)(1 + |c′|/c) of chatter_completion.hpp, each with the magnitudes of its terms, since a sum may
/// be small by chance.
///   before, contact  velocities just after the impact, and with u_n removed
template <class T>
T second_order(const ContactScene<T>& scene, const Slip<T>& slip, const ContactState<T>& before,
               const ContactState<T>& contact) {
    const Body<T>& body = scene.body;
    const ContactMotion motion = sticks(scene, slip)             ? ContactMotion::sticking
                                 : scene.mu > 0 && slip.sign < 0 ? ContactMotion::sliding_backward
                                                                 : ContactMotion::sliding_forward;
    const Support support = scene.is_disk() ? Support::rim : Support::vertex;
    const Reaction<T> change = reaction_of(scene, support, motion, contact);
    const T wn = body.beta * cos(contact.psi), wt = body.beta * abs(sin(contact.psi));
    if (scene.is_disk()) {
        const T rate = 1 + abs(normal_rate(scene, support, before));
        const T turning = normal_rate(scene, support, contact);
        const T faster = abs(change.ut_rate - body.alpha * change.spin_rate) * body.inverse_inner;
        const T a = wn + body.inner * turning * turning;
        const T a_rate = wt * abs(turning - 1) + 2 * body.inner * abs(turning) * faster;
        return rate * (rate + a_rate / abs(a)) + faster;
    }
    const T rate = 1 + abs(before.ut) + abs(before.spin);
    const T faster = abs(change.ut_rate) + abs(change.spin_rate);
    const T rn = body.alpha * abs(cos(contact.chi)), rt = body.alpha * abs(sin(contact.chi));
    const T spin2 = contact.spin * contact.spin;
    const T a = wn + contact.ut * contact.ut - spin2 * body.alpha * cos(contact.chi);
    const T a_rate = wt * abs(contact.ut - 1) + 2 * abs(contact.ut * change.ut_rate) +
                     2 * abs(contact.spin * change.spin_rate) * rn + spin2 * abs(contact.spin - contact.ut) * rt;
    return (rate * (rate + a_rate / abs(a)) + faster) * (1 + impulse_change(scene, slip, contact.chi));
}

/// The distance an edge slides after landing until friction holds it; infinite if friction does not. Where no sliding
/// is consistent the edge jams at once.
template <class T>
T slide_of(const ContactScene<T>& scene, const ContactState<T>& landed) {
    ContactState<T> z = landed;
    z.ut = z.spin = 0;
    const Reaction<T> held = reaction_of(scene, Support::edge, ContactMotion::sticking, z);
    if (scene.mu == 0 || held.reserve < 0) return std::numeric_limits<T>::infinity();
    z.ut = z.spin = landed.ut;
    const auto motion = landed.ut > 0 ? ContactMotion::sliding_forward : ContactMotion::sliding_backward;
    const Reaction<T> slips = reaction_of(scene, Support::edge, motion, z);
    const bool pushes = slips.stiffness > 0 && slips.normal >= 0 && slips.second >= 0;
    const T slowing =
        pushes ? (landed.ut > 0 ? T(-slips.ut_rate) : slips.ut_rate) : T(scene.mu * (held.normal + held.second));
    return slowing > 0 ? T(landed.ut * landed.ut / (2 * slowing)) : std::numeric_limits<T>::infinity();
}

/// An edge of which `first` is the clockwise vertex: it slides as its impulses leave it, or friction stops it at once.
template <class T>
ChatterCompletion<T> landed_edge(const ContactScene<T>& scene, const PostImpactState<T>& first) {
    ContactState<T> state = contact_state(scene, first);
    state.chi = -scene.widest_chi;
    state.ut = edge_rate(scene, first);
    const bool still = scene.mu > 0 && (abs(state.ut) <= velocity_rounding(scene, first) ||
                                        slide_of(scene, state) <= chatter_tolerance<T>());
    state.ut = state.spin = still ? T(0) : state.ut;
    return {true, Support::edge, state, 0, T(0), T(0)};
}

/// Sets χ to ±χ_m if it is less than `apart` inside of it, or outside, where the rest of chatter may have moved the
/// vertex (`move_along_wall`): the neighbour touches, too. Left an ulp inside, the neighbour would fall by an ulp and
/// gain a velocity of order √ε = 10⁻⁸ that it did not have: where two vertices strike in turn, this gain balances the
/// loss at each strike and the alternation does not end.
template <class T>
void keep_neighbour_at_wall(const ContactScene<T>& scene, const T& apart, ContactState<T>& state) {
    if (scene.is_disk() || scene.widest_chi - abs(state.chi) > apart) return;
    state.chi = copysign(scene.widest_chi, state.chi);
}

}  // namespace

template <class T>
ChatterError<T> chatter_error(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    const ContactKinematics<T> u = contact_kinematics(scene.body, post_impact);
    const T acceleration = free_acceleration(scene, post_impact, u.ut);
    const T v = abs(u.un);
    if (!(acceleration > 0)) return {std::numeric_limits<T>::infinity(), std::numeric_limits<T>::infinity()};
    const T lasts = 2 * v / (acceleration * (1 - scene.restitution));
    const Slip<T> slip = slip_of(scene, post_impact);
    T unused;
    const ContactState<T> taken = without_normal_velocity(scene, post_impact, slip, unused);
    const T removed = velocities_removed(scene, post_impact, taken);
    const T order = second_order(scene, slip, contact_state(scene, post_impact), taken);
    const T estimate = 0.5 * removed * lasts * lasts * order + unheld_error(scene, post_impact, taken, lasts);
    return {v * lasts, isnan(estimate) ? std::numeric_limits<T>::infinity() : estimate};  // a or c is 0
}

template <class T>
bool rests_still(const ContactScene<T>& scene, const ChatterCompletion<T>& completion) {
    return scene.mu > T(0) && completion.support == Support::edge && completion.state.ut == T(0) &&
           completion.state.spin == T(0);
}

template <class T>
ContactState<T> landed_like(const ContactScene<T>& scene, const PostImpactState<T>& base,
                            const ChatterCompletion<T>& completion, const PostImpactState<T>& near) {
    const auto seen = [&](const PostImpactState<T>& post_impact) {
        return completion.vertex_step == 0 ? post_impact : seen_from_neighbour(scene, post_impact);
    };
    if (completion.support == Support::edge) {
        ContactState<T> state = contact_state(scene, seen(near));
        state.chi = -scene.widest_chi;
        state.spin = state.ut = rests_still(scene, completion) ? T(0) : edge_rate(scene, seen(near));
        return state;
    }
    T jacobi(0);
    const Slip<T> slip = slip_of(scene, seen(base));
    ContactState<T> state = without_normal_velocity(scene, seen(near), slip, jacobi);
    move_to_rest(scene, seen(near), slip, state);
    return state;
}

template <class T>
ChatterCompletion<T> chatter_completion(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    ChatterCompletion<T> completion;
    bool there_approaches = false;
    PostImpactState<T> neighbour;
    EdgeTouch<T> edge;
    const T apart = scene.is_disk() ? std::numeric_limits<T>::infinity()
                                    : T(abs(abs(atan2(post_impact.chi.y, post_impact.chi.x)) - scene.widest_chi));
    if (apart <= neighbour_tolerance<T>()) {
        neighbour = seen_from_neighbour(scene, post_impact);
        edge = edge_touch(scene, post_impact, neighbour);
        there_approaches =
            !edge.there.rests && apart <= chatter_tolerance<T>() && contact_kinematics(scene.body, neighbour).un > 0;
    } else {
        edge.here = touch_of(scene, post_impact, {});
    }
    const int step = post_impact.chi.y > 0 ? -1 : 1;
    const bool lands_there = edge.there.rests && edge.there.pressed;
    if (edge.lies) {
        const bool clockwise = post_impact.chi.y < 0;
        completion = landed_edge(scene, clockwise ? post_impact : neighbour);
        completion.vertex_step = clockwise ? 0 : step;
        completion.error =
            std::max(edge.here.error, edge.there.error) +
            edge_error(scene, post_impact, completion.state, std::max(edge.here.lasts, edge.there.lasts));
        completion.jacobi =
            jacobi_of(scene.body, post_impact_state(scene, completion.state)) - jacobi_of(scene.body, post_impact);
    } else if (edge.here.rests && edge.here.pressed && !(lands_there && edge.there_lasts)) {
        completion = {true, scene.is_disk() ? Support::rim : Support::vertex, {}, 0, edge.here.error, T(0)};
        completion.state = landed(scene, post_impact, completion.jacobi);
        keep_neighbour_at_wall(scene, chatter_tolerance<T>(), completion.state);
        completion.error +=
            neighbour_error(scene, post_impact, completion.state, edge.here.lasts, T(chatter_tolerance<T>()));
    } else if (lands_there) {
        completion = {true, Support::vertex, {}, step, edge.there.error, T(0)};
        completion.state = landed(scene, neighbour, completion.jacobi);
        keep_neighbour_at_wall(scene, neighbour_tolerance<T>(), completion.state);  // known only to its rebound
        completion.error += apart + neighbour_error(scene, neighbour, completion.state, edge.there.lasts,
                                                    T(apart + chatter_tolerance<T>()));
    } else {
        completion.struck = edge.here.rests && there_approaches;
    }
    return completion;
}

#define SWIRL_COMPILE_CHATTER(T)                                                               \
    template ChatterError<T> chatter_error(const ContactScene<T>&, const PostImpactState<T>&); \
    template bool rests_still(const ContactScene<T>&, const ChatterCompletion<T>&);            \
    template ChatterCompletion<T> chatter_completion(const ContactScene<T>&, const PostImpactState<T>&);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_CHATTER)
#define SWIRL_COMPILE_LANDED_LIKE(T)                                                        \
    template ContactState<T> landed_like(const ContactScene<T>&, const PostImpactState<T>&, \
                                         const ChatterCompletion<T>&, const PostImpactState<T>&);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_LANDED_LIKE)
SWIRL_EVERY_CONTACT_JET(SWIRL_COMPILE_LANDED_LIKE)

}  // namespace swirl
