#include "map/contact/reaction.hpp"

#include "map/contact/contact_jets.hpp"
#include "map/map_list.hpp"
#include "map/numbers/quad.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl {

namespace {

using std::abs, std::cos, std::sin;

template <class T>
T sign_of(ContactMotion motion) {
    return motion == ContactMotion::sliding_backward ? T(-1) : T(1);
}

template <class T>
Vec2<T> swirl_at(const ContactScene<T>& scene, const T& psi) {
    return swirl_force(scene, Vec2<T>{cos(psi), sin(psi)});
}

/// The drag's torque on a body that turns about a point so far from its centre: γd² + γ_r I, by S.
template <class T>
T drag_about(const ContactScene<T>& scene, const T& distance) {
    return scene.floor.drag * distance * distance + scene.floor.spin_drag * scene.body.inertia;
}

template <class T>
Reaction<T> on_rim(const ContactScene<T>& scene, ContactMotion motion, const ContactState<T>& z) {
    const Body<T>& body = scene.body;
    const ContactFloor<T>& floor = scene.floor;
    const Vec2<T> w = swirl_at(scene, z.psi);
    const T &wn = w.x, &wt = w.y;
    const T rho = body.inner, kappa = scene.inertia_factor();
    const T turning = (z.ut - body.alpha * z.spin) / rho;
    Reaction<T> r;
    r.normal = wn + rho * turning * turning;
    if (motion == ContactMotion::sticking) {
        r.friction = -kappa * wt / (T(1) + kappa);
        if (floor.drags)
            r.friction +=
                (kappa * (floor.drag - floor.spin_drag) * rho * turning - kappa * body.alpha * floor.turning) /
                (T(1) + kappa);
        r.reserve = scene.mu * r.normal - abs(r.friction);
    } else {
        r.friction = -scene.mu * sign_of<T>(motion) * r.normal;
        r.ut_rate = wt + r.friction * (T(1) + T(1) / kappa);
        if (floor.drags)
            r.ut_rate -=
                floor.drag * rho * turning + floor.spin_drag * body.alpha * z.spin - body.alpha * floor.turning;
    }
    r.spin_rate = r.friction / (kappa * body.alpha);
    if (floor.drags) r.spin_rate -= floor.spin_drag * z.spin - floor.turning;
    return r;
}

template <class T>
Reaction<T> on_vertex(const ContactScene<T>& scene, ContactMotion motion, const ContactState<T>& z) {
    const Body<T>& body = scene.body;
    const ContactFloor<T>& floor = scene.floor;
    const Vec2<T> w = swirl_at(scene, z.psi);
    const T &wn = w.x, &wt = w.y;
    const T rn = body.alpha * cos(z.chi), rt = body.alpha * sin(z.chi);
    const T spin2 = z.spin * z.spin;
    Reaction<T> r;
    if (motion == ContactMotion::sticking) {
        const T about_vertex = body.inertia + body.alpha * body.alpha;
        r.spin_rate = (rt * wn - rn * wt) / about_vertex;
        if (floor.drags)
            r.spin_rate -= (drag_about(scene, body.alpha) * z.spin - body.inertia * floor.turning) / about_vertex;
        r.normal = wn - r.spin_rate * rt - spin2 * rn;
        r.friction = -wt - r.spin_rate * rn + spin2 * rt;
        if (floor.drags) {
            r.normal -= floor.drag * z.spin * rt;
            r.friction -= floor.drag * z.spin * rn;
        }
        r.reserve = scene.mu * r.normal - abs(r.friction);
        return r;
    }
    const T smu = scene.mu * sign_of<T>(motion);
    r.stiffness = T(1) + rt * (rt - smu * rn) / body.inertia;
    T pull = wn + z.ut * z.ut - spin2 * rn;
    if (floor.drags) pull -= ((floor.drag - floor.spin_drag) * z.spin + floor.turning) * rt;
    r.normal = pull / r.stiffness;
    r.friction = -smu * r.normal;
    r.spin_rate = (rn * r.friction + rt * r.normal) / body.inertia;
    if (floor.drags) r.spin_rate -= floor.spin_drag * z.spin - floor.turning;
    r.ut_rate = wt + r.friction + r.spin_rate * rn - spin2 * rt;
    if (floor.drags) r.ut_rate -= floor.drag * (z.ut - z.spin * rn);
    return r;
}

/// Two vertices at rest: the reactions are not unique, (λ₁ + λ₂) = Λ is free along the wedge between the contacts.
/// Rest lasts while any Λ keeps both forces within their friction cones.
template <class T>
EdgeNormals<T> normals_within_cones(const ContactScene<T>& scene, const T& sum_friction, const T& difference,
                                    const T& wn) {
    const T c = cos(scene.half_chord), s = sin(scene.half_chord);
    // f₁ − f₂ = (Λ c − w)/s; the four sides of |f₁| ≤ μλ₁, |f₂| ≤ μλ₂ as a + bΛ ≥ 0.
    T least(0), most = std::numeric_limits<T>::infinity();
    for (const int first : {1, -1})       // which contact: λ = (Λ ± D)/2
        for (const int sign : {1, -1}) {  // which side of the cone
            const T a = scene.mu * T(first) * difference - T(sign) * (sum_friction - T(first) * wn / s);
            const T b = scene.mu - T(sign * first) * c / s;
            if (b > 0)
                least = std::max(least, T(-a / b));
            else if (b < 0)
                most = std::min(most, T(-a / b));
            else if (a < 0)
                return {least, T(least + a)};
        }
    return {least, most};
}

template <class T>
Reaction<T> on_edge(const ContactScene<T>& scene, ContactMotion motion, const ContactState<T>& z) {
    const Body<T>& body = scene.body;
    const ContactFloor<T>& floor = scene.floor;
    const T centre = z.psi + scene.half_chord;  // arg X − t
    const Vec2<T> w = swirl_at(scene, centre);
    const T &wn = w.x, &wt = w.y;
    const T c = cos(scene.half_chord), s = sin(scene.half_chord), d = body.outer;
    const T inertia = body.inertia + d * d;
    Reaction<T> r;
    if (motion == ContactMotion::sticking) {
        r.friction = -d * wt;
        if (floor.drags) r.friction -= body.inertia * floor.turning;
        const T difference = (-wt - r.friction * c) / s;
        const EdgeNormals<T> normals = normals_within_cones(scene, r.friction, difference, wn);
        r.reserve = std::min(normals.most, T(1e300)) - normals.least;
        const T sum = normals.nearest_to(wn / c);
        r.normal = T(0.5) * (sum + difference);
        r.second = T(0.5) * (sum - difference);
        return r;
    }
    const T smu = scene.mu * sign_of<T>(motion);
    T lean = -wt * body.inertia / inertia;
    if (floor.drags)
        lean +=
            ((floor.drag - floor.spin_drag) * d * z.spin * body.inertia + floor.turning * d * body.inertia) / inertia;
    r.stiffness = c + smu * smu * (c - d / inertia);
    const T sum = (wn + d * z.spin * z.spin - smu * lean) / r.stiffness;
    const T difference = (smu * sum * (c - d / inertia) + lean) / s;
    r.normal = T(0.5) * (sum + difference);
    r.second = T(0.5) * (sum - difference);
    r.friction = -smu * sum;
    r.spin_rate = (r.friction + d * wt) / inertia;
    if (floor.drags) r.spin_rate -= (drag_about(scene, d) * z.spin - body.inertia * floor.turning) / inertia;
    r.ut_rate = r.spin_rate;
    return r;
}

}  // namespace

template <class T>
EdgeNormals<T> edge_normals(const ContactScene<T>& scene, const Vec2<T>& force, const T& sum_friction) {
    const T c = cos(scene.half_chord), s = sin(scene.half_chord);
    return normals_within_cones(scene, sum_friction, T((force.y - sum_friction * c) / s), T(-force.x));
}

template <class T>
Reaction<T> reaction_of(const ContactScene<T>& scene, Support support, ContactMotion motion,
                        const ContactState<T>& state) {
    switch (support) {
        case Support::rim:
            return on_rim(scene, motion, state);
        case Support::vertex:
            return on_vertex(scene, motion, state);
        case Support::edge:
            return on_edge(scene, motion, state);
    }
    return {};
}

template <class T>
T stick_margin(const ContactScene<T>& scene, const ContactState<T>& state) {
    const T push = scene.floor.drags ? T(abs(scene.floor.push.x) + abs(scene.floor.push.y)) : T(0);
    return tolerance<T>(1e-12) * (scene.body.beta + push + scene.body.alpha * state.spin * state.spin);
}

template <class T>
T normal_rate(const ContactScene<T>& scene, Support support, const ContactState<T>& state) {
    if (support == Support::rim) return (state.ut - scene.body.alpha * state.spin) / scene.body.inner;
    return support == Support::vertex ? state.ut : state.spin;
}

#define SWIRL_COMPILE_REACTION(T) \
    template Reaction<T> reaction_of(const ContactScene<T>&, Support, ContactMotion, const ContactState<T>&);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_REACTION)
SWIRL_EVERY_CONTACT_JET(SWIRL_COMPILE_REACTION)
#define SWIRL_COMPILE_RATES(T)                                               \
    template T stick_margin(const ContactScene<T>&, const ContactState<T>&); \
    template T normal_rate(const ContactScene<T>&, Support, const ContactState<T>&);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_RATES)
template EdgeNormals<double> edge_normals(const ContactScene<double>&, const Vec2<double>&, const double&);

}  // namespace swirl
