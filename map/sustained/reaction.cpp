#include "map/sustained/reaction.hpp"

#include <algorithm>
#include <cmath>

namespace swirl {

namespace {

double sign_of(ContactMotion motion) {
    return motion == ContactMotion::sliding_backward ? -1 : 1;
}

Reaction on_rim(const ContactScene& scene, ContactMotion motion, const ContactState& z) {
    const Body<double>& body = scene.body;
    const double wn = body.beta * std::cos(z.psi), wt = -body.beta * std::sin(z.psi);
    const double rho = body.inner, kappa = scene.inertia_factor();
    const double turning = (z.ut - body.alpha * z.spin) / rho;
    Reaction r;
    r.normal = wn + rho * turning * turning;
    if (motion == ContactMotion::sticking) {
        r.friction = -kappa * wt / (1 + kappa);
        r.reserve = scene.mu * r.normal - std::abs(r.friction);
    } else {
        r.friction = -scene.mu * sign_of(motion) * r.normal;
        r.ut_rate = wt + r.friction * (1 + 1 / kappa);
    }
    r.spin_rate = r.friction / (kappa * body.alpha);
    return r;
}

Reaction on_vertex(const ContactScene& scene, ContactMotion motion, const ContactState& z) {
    const Body<double>& body = scene.body;
    const double wn = body.beta * std::cos(z.psi), wt = -body.beta * std::sin(z.psi);
    const double rn = body.alpha * std::cos(z.chi), rt = body.alpha * std::sin(z.chi);
    const double spin2 = z.spin * z.spin;
    Reaction r;
    if (motion == ContactMotion::sticking) {
        r.spin_rate = (rt * wn - rn * wt) / (body.inertia + body.alpha * body.alpha);
        r.normal = wn - r.spin_rate * rt - spin2 * rn;
        r.friction = -wt - r.spin_rate * rn + spin2 * rt;
        r.reserve = scene.mu * r.normal - std::abs(r.friction);
        return r;
    }
    const double smu = scene.mu * sign_of(motion);
    r.stiffness = 1 + rt * (rt - smu * rn) / body.inertia;
    r.normal = (wn + z.ut * z.ut - spin2 * rn) / r.stiffness;
    r.friction = -smu * r.normal;
    r.spin_rate = (rn * r.friction + rt * r.normal) / body.inertia;
    r.ut_rate = wt + r.friction + r.spin_rate * rn - spin2 * rt;
    return r;
}

/// Two vertices at rest: the reactions are not unique, (λ₁ + λ₂) = Λ is free along the wedge between the contacts.
/// Rest lasts while any Λ keeps both forces within their friction cones: the width of that interval of Λ.
double edge_reserve(const ContactScene& scene, double sum_friction, double difference, double wn) {
    const double c = std::cos(scene.half_chord), s = std::sin(scene.half_chord);
    // f₁ − f₂ = (Λ c − w)/s; the four sides of |f₁| ≤ μλ₁, |f₂| ≤ μλ₂ as a + bΛ ≥ 0.
    double least = 0, most = std::numeric_limits<double>::infinity();
    for (const double first : {1.0, -1.0})       // which contact: λ = (Λ ± D)/2
        for (const double sign : {1.0, -1.0}) {  // which side of the cone
            const double a = scene.mu * first * difference - sign * (sum_friction - first * wn / s);
            const double b = scene.mu - sign * first * c / s;
            if (b > 0)
                least = std::max(least, -a / b);
            else if (b < 0)
                most = std::min(most, -a / b);
            else if (a < 0)
                return a;
        }
    return std::min(most, 1e300) - least;
}

Reaction on_edge(const ContactScene& scene, ContactMotion motion, const ContactState& z) {
    const Body<double>& body = scene.body;
    const double centre = z.psi + scene.half_chord;  // arg X − t
    const double wn = body.beta * std::cos(centre), wt = -body.beta * std::sin(centre);
    const double c = std::cos(scene.half_chord), s = std::sin(scene.half_chord), d = body.outer;
    const double inertia = body.inertia + d * d;
    Reaction r;
    if (motion == ContactMotion::sticking) {
        r.friction = -d * wt;
        const double difference = (-wt - r.friction * c) / s;
        r.reserve = edge_reserve(scene, r.friction, difference, wn);
        // One of the possible pairs, the one without tension along the edge: f₁ = f₂.
        r.normal = 0.5 * (wn / c + difference);
        r.second = 0.5 * (wn / c - difference);
        return r;
    }
    const double smu = scene.mu * sign_of(motion);
    const double lean = -wt * body.inertia / inertia;
    r.stiffness = c + smu * smu * (c - d / inertia);
    const double sum = (wn + d * z.spin * z.spin - smu * lean) / r.stiffness;
    const double difference = (smu * sum * (c - d / inertia) + lean) / s;
    r.normal = 0.5 * (sum + difference);
    r.second = 0.5 * (sum - difference);
    r.friction = -smu * sum;
    r.spin_rate = (r.friction + d * wt) / inertia;
    r.ut_rate = r.spin_rate;
    return r;
}

}  // namespace

Reaction reaction_of(const ContactScene& scene, Support support, ContactMotion motion, const ContactState& state) {
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

double stick_margin(const ContactScene& scene, const ContactState& state) {
    return 1e-12 * (scene.body.beta + scene.body.alpha * state.spin * state.spin);
}

double normal_rate(const ContactScene& scene, Support support, const ContactState& state) {
    if (support == Support::rim) return (state.ut - scene.body.alpha * state.spin) / scene.body.inner;
    return support == Support::vertex ? state.ut : state.spin;
}

}  // namespace swirl
