#include "map/contact/chatter_completion.hpp"

#include "map/contact/contact_jets.hpp"
#include "map/contact/contact_state.hpp"
#include "map/contact/end_of_chatter.hpp"
#include "map/contact/motion_choice.hpp"
#include "map/contact/reaction.hpp"
#include "map/map_list.hpp"
#include "map/numbers/quad.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace swirl {

namespace {

using std::abs, std::atan2, std::copysign, std::cos, std::isnan, std::sin;

/// Velocities of an edge as two impulses change them: of either vertex towards the wall, and S.
template <class T>
struct EdgeVelocities {
    T here, there, spin;
};

template <class T>
EdgeVelocities<T> edge_velocities(const ContactScene<T>& scene, const PostImpactState<T>& z) {
    return {contact_kinematics(scene.body, z).un, contact_kinematics(scene.body, seen_from_neighbour(scene, z)).un,
            z.spin};
}

/// How velocities change by the impulse −n + ratio t at z's own vertex: of z at rest on a wall at rest, so that no
/// speed is so large that the change is lost beside it.
template <class T>
PostImpactState<T> struck_at_rest(const ContactScene<T>& at_rest, PostImpactState<T> z, const T& ratio) {
    z.vn = z.vt = z.spin = T(0);
    const ContactKinematics<T> u = contact_kinematics(at_rest.body, z);
    z.vn = T(-1);
    z.vt = ratio;
    z.spin = (u.rn * ratio + u.rt) / u.inertia;
    return z;
}

/// S = ν′ once as much of either vertex' normal impulse as removes both u_n has acted, with `ratio` of it along the
/// wall, by p₁ and p₂ with
///
///     u_n,1 + p₁ ∂u_n,1/∂p₁ + p₂ ∂u_n,1/∂p₂ = 0 = u_n,2 + p₁ ∂u_n,2/∂p₁ + p₂ ∂u_n,2/∂p₂;
///
/// nothing where their determinant is not positive: the slip would jam.
template <class T>
std::optional<T> edge_rate_with(const ContactScene<T>& scene, const PostImpactState<T>& z, const T& ratio) {
    ContactScene<T> at_rest = scene;
    at_rest.body.beta = T(0);
    const PostImpactState<T> other = struck_at_rest(at_rest, seen_from_neighbour(scene, z), ratio);
    const EdgeVelocities<T> before = edge_velocities(scene, z);
    const EdgeVelocities<T> a = edge_velocities(at_rest, struck_at_rest(at_rest, z, ratio));
    const EdgeVelocities<T> b = edge_velocities(at_rest, seen_from_neighbour(scene, other));
    const T determinant = a.here * b.there - a.there * b.here;
    if (!(plain(determinant) > 0)) return {};
    const T p = (b.here * before.there - b.there * before.here) / determinant;
    const T q = (a.there * before.here - a.here * before.there) / determinant;
    return T(before.spin + p * a.spin + q * b.spin);
}

/// S = ν′ with which an edge lands: chatter and rocking of the two vertices leave what contact does not, with −sμ of it
/// along the wall, s the sense in which the edge then slides: the one in which it did, or the other if friction does
/// not let that be; 0 where it lets neither. Without friction where the slip would jam; u_t of z's vertex where
/// rounding leaves no positive determinant without it either.
///   z  on either vertex, |χ| = χ_m
template <class T>
T edge_rate(const ContactScene<T>& scene, const PostImpactState<T>& z) {
    const T ut = contact_kinematics(scene.body, z).ut;
    const bool forward = plain(ut) > 0;
    for (const bool sense : {forward, !forward}) {
        const std::optional<T> rate = edge_rate_with(scene, z, sense ? T(-scene.mu) : scene.mu);
        if (!rate || scene.mu == T(0)) return edge_rate_with(scene, z, T(0)).value_or(ut);
        if (sense == (plain(*rate) > 0)) return *rate;
    }
    return T(0);
}

/// What S of a landed edge may be off by, in first order of v, where its slip is of that order: the rest of chatter may
/// stop the slip at any moment, or turn it, and friction acts by the sense that it then has. Both the impulses and, for
/// as long as chatter lasts, contact's forces differ by as much as between slips either way and none.
///   before  just after the impact, on either vertex
///   lasts   how long chatter goes on
template <class T>
T edge_error(const ContactScene<T>& scene, const PostImpactState<T>& before, const ContactState<T>& landed,
             const T& lasts) {
    ContactState<T> still = landed;
    still.ut = still.spin = T(0);
    const bool held = reaction_of(scene, Support::edge, ContactMotion::sticking, still).reserve >= T(0);
    using std::abs;
    if (!(scene.mu > T(0)) || (landed.ut == T(0) && held)) return T(0);
    const T ut = contact_kinematics(scene.body, before).ut;
    const T rounding = velocity_rounding(scene, before);
    T apart(0), rates(0);
    for (const T& ratio : {T(-scene.mu), T(0), scene.mu})
        if (const auto rate = edge_rate_with(scene, before, ratio)) apart = std::max(apart, T(abs(*rate - landed.ut)));
    for (const auto motion : {ContactMotion::sliding_forward, ContactMotion::sliding_backward})
        rates = std::max(rates, T(abs(reaction_of(scene, Support::edge, motion, landed).spin_rate)));
    const T may_change = apart + 2 * rates * lasts;
    if (apart <= rounding || abs(ut) > 2 * may_change) return T(0);  // or its slip goes on in the same sense
    return may_change;
}

/// The error of u_t of a vertex (rim) that friction does not hold: the rest of chatter may stop a slip of the order of
/// v, but contact slips.
///   taken  in contact, u_n removed
template <class T>
T unheld_error(const ContactScene<T>& scene, const PostImpactState<T>& post_impact, const ContactState<T>& taken,
               const T& lasts) {
    using std::abs;
    if (!(scene.mu > T(0)) || can_stick(scene, post_impact)) return T(0);
    const T ut = contact_kinematics(scene.body, post_impact).ut;
    const Support support = scene.is_disk() ? Support::rim : Support::vertex;
    T rate(0);
    for (const auto motion : {ContactMotion::sliding_forward, ContactMotion::sliding_backward})
        rate = std::max(rate, T(abs(reaction_of(scene, support, motion, taken).ut_rate)));
    const T may_change = abs(taken.ut - ut) + rate * lasts;
    return abs(ut) <= 2 * may_change ? may_change : T(0);
}

/// The velocities that a landing removes.
///   before  just after an impact
///   taken   in contact, u_n removed
template <class T>
T velocities_removed(const ContactScene<T>& scene, const PostImpactState<T>& before, const ContactState<T>& taken) {
    using std::abs;
    const ContactKinematics<T> u = contact_kinematics(scene.body, before);
    return abs(u.un) + abs(taken.ut - u.ut) + scene.body.alpha * abs(taken.spin - before.spin);
}

/// For how long a neighbour's strike may come too early or too late, its distance to the wall being known to `unsure`
/// only; 0 where it does not come within a time `lasts`.
///   room            χ_m − |χ|
///   closing, acceleration  rate at which the neighbour comes to the wall, and that of the rate
template <class T>
T moment_unsure(const T& room, const T& closing, const T& acceleration, const T& lasts, const T& unsure) {
    using std::abs, std::sqrt;
    const T most = unsure + closing * lasts + T(0.5) * std::max(T(0), acceleration) * lasts * lasts;
    if (room > most || !(closing > T(0) || acceleration > T(0))) return T(0);
    const T late = acceleration > T(0) ? T(sqrt(T(2) * unsure / acceleration)) : T(closing / abs(acceleration));
    return closing > T(0) ? std::min(T(unsure / closing), late) : late;
}

/// The error of a vertex whose neighbour comes to the wall before the rest of chatter is over: it strikes while the
/// vertex still leaves the wall at some of v, and in contact it strikes while the vertex rests. Where the neighbour is
/// at the wall within rounding the moment of its strike is unsure as well.
///   unsure  what its distance to the wall is known to
template <class T>
T neighbour_error(const ContactScene<T>& scene, const PostImpactState<T>& before, const ContactState<T>& taken,
                  const T& lasts, const T& unsure) {
    using std::abs;
    if (scene.is_disk()) return T(0);
    const MotionChoice<T> choice = choose_motion(scene, Support::vertex, taken, 0);
    const Reaction<T> r = reaction_of(scene, Support::vertex, choice.motion, taken);
    const T side = taken.chi < T(0) ? T(-1) : T(1);
    const T rounding = velocity_rounding(scene, before) / scene.body.alpha;
    const auto closes = [&](const T& spin, const T& ut) { return T(side * (spin - ut)); };
    const T still = closes(taken.spin, taken.ut),
            flies = closes(before.spin, contact_kinematics(scene.body, before).ut);
    const T closing = std::max(still, flies) > rounding ? std::max(still, flies) : T(0);
    const T room = std::max(T(0), T(scene.widest_chi - abs(taken.chi)));
    const T late = moment_unsure(room, closing, closes(r.spin_rate, r.ut_rate), lasts, unsure);
    if (!(late > T(0))) return T(0);
    const T rate = abs(r.ut_rate) + scene.body.alpha * abs(r.spin_rate) + scene.body.beta + taken.ut * taken.ut +
                   scene.body.alpha * taken.spin * taken.spin;
    return velocities_removed(scene, before, taken) + rate * (lasts + late);
}

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
    const Vec2<T> w = swirl_force(scene, Vec2<T>{cos(contact.psi), sin(contact.psi)});
    const T wn = w.x, wt = abs(w.y);
    const T drag = scene.floor.drags ? T(scene.floor.drag + scene.floor.spin_drag) : T(0);  // how fast it changes a
    if (scene.is_disk()) {
        const T rate = 1 + abs(normal_rate(scene, support, before));
        const T turning = normal_rate(scene, support, contact);
        const T faster = abs(change.ut_rate - body.alpha * change.spin_rate) * body.inverse_inner;
        const T a = wn + body.inner * turning * turning;
        const T a_rate = wt * abs(turning - 1) + 2 * body.inner * abs(turning) * faster;
        return rate * (rate + a_rate / abs(a) + drag) + faster;
    }
    const T rate = 1 + abs(before.ut) + abs(before.spin);
    const T faster = abs(change.ut_rate) + abs(change.spin_rate);
    const T rn = body.alpha * abs(cos(contact.chi)), rt = body.alpha * abs(sin(contact.chi));
    const T spin2 = contact.spin * contact.spin;
    T a = wn + contact.ut * contact.ut - spin2 * body.alpha * cos(contact.chi);
    if (scene.floor.drags)
        a -= ((scene.floor.drag - scene.floor.spin_drag) * contact.spin + scene.floor.turning) * body.alpha *
             sin(contact.chi);
    const T a_rate = wt * abs(contact.ut - 1) + 2 * abs(contact.ut * change.ut_rate) +
                     2 * abs(contact.spin * change.spin_rate) * rn + spin2 * abs(contact.spin - contact.ut) * rt;
    return (rate * (rate + a_rate / abs(a) + drag * (1 + abs(contact.spin) * rt / abs(a))) + faster) *
           (1 + impulse_change(scene, slip, contact.chi));
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
