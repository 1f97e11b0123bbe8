// The equations of a steady mode (a fixed point of F with impacts), reduced to what a scene leaves open.
//
// With s = sin χ, c = cos χ and w = ±√(β² − s²) (map/README.md, "Steady modes"), after a flight of time τ
//
//     R = c − α + w                     the centre's distance from the swirl's centre, > 0
//     Q = R(1 − cos τ)/τ                half the impulse, which points at the swirl's centre: p = 2Qc, q = −2Qs
//     u_n before = u_n after + p,   u_t before = u_t after + 2Qs;   u_t⁺ = 0: u_n after = (s − Q)/c
//     S = 1 − 2πj/(Nτ)                  j vertices on
//
// and the law of impact says, in terms of ε = −u_n⁺/p, which is e/(1 + e) unless slip stops on the way,
//
//     sticking  u_t⁺ = 0, |tan χ| ≤ μ:  Q (s² + δ c²) = s,  δ = 1 − 2ε;   αS = w − R sin τ/τ − (s/c)(s − Q)
//     sliding   |tan χ| = μ:            αS s = v_n − β sin ψ + 2Qc e/(1 + e)
//
// Reversed slip has |q| < μp and needs |tan χ| > μ(1 + κ/c²): no steady mode has it. So a mode is a point of a plane
// curve at which Nτ(1 − S)/2π is whole. Derived in map/steady/README.md.
#pragma once

#include "map/model/section.hpp"

#include <cmath>

namespace swirl {

/// The sign of w: the body on the outer side of the container's wall (ψ near 0) or on the inner one (ψ near π).
enum class SteadyBranch { plus = 1, minus = -1 };

namespace steady {

/// What depends on χ alone. T is double or a Jet; the scene stays plain.
template <class T>
struct SteadyGeometry {
    T sine, cosine;
    T width;   ///< w
    T radius;  ///< R
};

template <class T>
SteadyGeometry<T> geometry_at(const Scene<double>& scene, SteadyBranch branch, const T& chi) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const T s = sin(chi), c = cos(chi);
    const T square = (scene.beta - s) * (scene.beta + s);
    const T root = plain(square) > 0 ? T(sqrt(square)) : T(0.0);
    const T width = branch == SteadyBranch::plus ? root : T(-root);
    return {s, c, width, c - scene.alpha + width};
}

/// (1 − cos τ)/τ.
template <class T>
T versine_rate(const T& tau) {
    using std::sin;
    const T half = sin(0.5 * tau);
    return 2.0 * half * half / tau;
}

/// p_k/p of a sticking contact, the share of the impulse at which slip stops; ≤ 1 for |tan χ| ≤ μ.
template <class T>
T slip_share(const Scene<double>& scene, const T& size, const T& cosine) {
    const T slope = size / cosine, square = cosine * cosine;
    return scene.inertia_factor * slope / ((scene.inertia_factor + square) * scene.mu - slope * square);
}

/// δ under Stronge's law. With A − 1 = d(1 − k), k = p_k/p, D = 1 + d the slope of C(p) while sticking and f that while
/// slipping, the work ½(2ε − A)p² of the whole impact is −(1 − e²) times that of compression: ½((1 − ε)²/f)p² if slip
/// stops in restitution, the whole less ½(ε²/D)p² if it stops in compression.
template <class T>
T stronge_deficit(double restitution, const T& stop, const T& d, const T& slipping) {
    using std::sqrt;
    const double e2 = restitution * restitution;
    const T more = d * (1.0 - stop), g = (1 - e2) / (4.0 * (1.0 + d)), b = 2.0 * g + e2;
    const T early = 2.0 * (g - e2 * more) / (b + sqrt(b * b - 4.0 * g * (g - e2 * more)));
    if (plain(T(0.5 * (1.0 - early))) <= plain(T((1.0 + d) * (1.0 - stop)))) return early;
    const T h = (1 - e2) / (4.0 * slipping), m = 1.0 - 2.0 * h;
    return 2.0 * (h - more) / (m + sqrt(m * m - 4.0 * h * (h - more)));
}

/// δ = 1 − 2ε of a contact that ends without slip. Formed so that it keeps its digits where it is small (e → 1).
template <class T>
T restitution_deficit(const Scene<double>& scene, const T& sine, const T& cosine) {
    const double e = scene.restitution, kappa = scene.inertia_factor;
    const T size = plain(sine) < 0 ? T(-sine) : sine;
    const T d = size * size / (kappa + cosine * cosine);                 // D − 1
    const T slipping = 1.0 + size * (size - scene.mu * cosine) / kappa;  // f = B₂ − μ|B₃|
    switch (scene.law) {
        case Law::newton:
            return T((1 - e) / (1 + e));
        case Law::stronge:
            return stronge_deficit(e, slip_share(scene, size, cosine), d, slipping);
        case Law::poisson:
            break;
    }
    // slip stops in compression, p_c = p/(1 + e), or later
    const bool early = plain(slip_share(scene, size, cosine)) * (1 + e) <= 1;
    return early ? T((1 - e - 2 * e * d) / (1 + e)) : T((1 - e + 2.0 * (slipping - 1.0)) / (1 + e));
}

/// S for which a contact ends without slip.
template <class T>
T sticking_spin(const Scene<double>& scene, const SteadyGeometry<T>& at, const T& tau) {
    using std::sin;
    const T half_impulse = at.radius * versine_rate(tau);
    return (at.width - at.radius * sin(tau) / tau - at.sine / at.cosine * (at.sine - half_impulse)) / scene.alpha;
}

/// S for which a contact that slips throughout ends with −u_n = e u_n⁻; χ ≠ 0.
template <class T>
T sliding_spin(const Scene<double>& scene, const SteadyGeometry<T>& at, const T& tau) {
    using std::sin;
    const T impulse = 2.0 * at.radius * versine_rate(tau) * at.cosine;
    // v_n = −(R/τ)(cos χ − cos(χ + τ))
    const T vn = -at.radius * (at.cosine * versine_rate(tau) + at.sine * sin(tau) / tau);
    const T container = -at.sine * (at.cosine + at.width);  // β sin ψ
    return (vn - container + scene.restitution / (1 + scene.restitution) * impulse) / (scene.alpha * at.sine);
}

/// S = 1 − 2πj/(Nτ).
inline double spin_of(const Scene<double>& scene, double tau, long long j) {
    return 1 - 2 * pi<double>() * static_cast<double>(j) / (scene.sides * tau);
}

/// j as a real number: N τ(1 − S)/2π.
template <class T>
T vertices_on(const Scene<double>& scene, const T& tau, const T& spin) {
    return scene.sides / (2 * pi<double>()) * tau * (1.0 - spin);
}

/// The section point of (τ, χ, S).
inline SectionPoint<double> section_point_of(const Scene<double>& scene, SteadyBranch branch, double tau, double chi,
                                             double spin) {
    const SteadyGeometry<double> at = geometry_at(scene, branch, chi);
    const double speed = 2 * at.radius * std::sin(0.5 * tau) / tau, along = chi + 0.5 * tau;
    // β cis(ψ + χ) = w − i sin χ; for β = 0 any ψ will do
    const double turned = scene.beta > 0 ? std::atan2(-at.sine, at.width) : 0;
    return {wrapped_angle(turned - chi), chi, -speed * std::sin(along), speed * std::cos(along), spin};
}

}  // namespace steady

}  // namespace swirl
