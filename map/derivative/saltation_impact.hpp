// The differential of the impact, by hand: how the impulse (p, q) of every law and contact mode changes with the state
// before. Derivation: map/README.md, "Derivative".
#pragma once

#include "map/model/impact.hpp"

#include <Eigen/Core>

#include <cmath>

namespace swirl::detail {

/// A differential: its coefficients on (dψ, dχ, dv_n, dv_t, dS) just before the impact.
template <class T>
using Differential = Eigen::Matrix<T, 1, 5>;

/// A number with its differential.
template <class T>
struct Varied {
    T value{};
    Differential<T> change = Differential<T>::Zero();
};

/// What the impulse depends on, with differentials (all functions of the state before the impact).
template <class T>
struct VariedKinematics {
    Varied<T> un, ut, b1, b2, b3;
};

/// dp and dq.
template <class T>
struct ImpulseChange {
    Differential<T> normal = Differential<T>::Zero();
    Differential<T> tangential = Differential<T>::Zero();
};

/// c = B₂ + r B₃, the slope dC/dp where dq/dp = r.
template <class T>
Varied<T> slope(const VariedKinematics<T>& a, const Varied<T>& rate) {
    return {a.b2.value + rate.value * a.b3.value, a.b2.change + rate.value * a.b3.change + a.b3.value * rate.change};
}

/// Without friction and in sliding all laws end at p = (1 + e) u_n/c: dp = ((1 + e) du_n − p dc)/c, dq = r dp.
template <class T>
ImpulseChange<T> change_in_sliding(const VariedKinematics<T>& a, const T& rate, const T& restitution) {
    const Varied<T> c = slope(a, Varied<T>{rate});
    const T p = (T(1) + restitution) * a.un.value / c.value;
    ImpulseChange<T> change;
    change.normal = ((T(1) + restitution) * a.un.change - p * c.change) / c.value;
    change.tangential = rate * change.normal;
    return change;
}

/// C(p) around the kink where slip stops.
template <class T>
struct VariedKink {
    Varied<T> first;    ///< c, dC/dp before
    Varied<T> second;   ///< f, dC/dp after
    Varied<T> impulse;  ///< p_k
    Varied<T> level;    ///< C_k = C(p_k)
};

/// p_k = s u_t/d with d = μB₁ − sB₃ (u_t falls to zero at the rate sd), C_k = −u_n + c p_k.
template <class T>
VariedKink<T> kink_of(const VariedKinematics<T>& a, const T& mu, const T& sign, const Varied<T>& slope_after) {
    VariedKink<T> kink;
    kink.first = slope(a, Varied<T>{-sign * mu});
    kink.second = slope_after;
    const T slowing = mu * a.b1.value - sign * a.b3.value;
    if (slowing > T(0)) {  // else p_k = 0: at rest, and friction just holds B₃'s pull
        kink.impulse.value = sign * a.ut.value / slowing;
        kink.impulse.change =
            (sign * a.ut.change - kink.impulse.value * (mu * a.b1.change - sign * a.b3.change)) / slowing;
    }
    kink.level.value = -a.un.value + kink.first.value * kink.impulse.value;
    kink.level.change = -a.un.change + kink.impulse.value * kink.first.change + kink.first.value * kink.impulse.change;
    return kink;
}

/// The p at which C reaches a level beyond the kink: p = p_k + (C_f − C_k)/f.
template <class T>
Varied<T> impulse_at_level(const VariedKink<T>& kink, const Varied<T>& level) {
    const T beyond = (level.value - kink.level.value) / kink.second.value;
    Varied<T> p;
    p.value = kink.impulse.value + beyond;
    p.change =
        kink.impulse.change + (level.change - kink.level.change - beyond * kink.second.change) / kink.second.value;
    return p;
}

/// Poisson's end, (1 + e) p_c: C(p_c) = 0 lies beyond the kink if C_k < 0, before it otherwise.
template <class T>
Varied<T> end_of_poisson(const VariedKinematics<T>& a, const VariedKink<T>& kink, const T& restitution) {
    Varied<T> compression;
    if (kink.level.value < T(0)) {
        compression = impulse_at_level(kink, Varied<T>{});
    } else {
        compression.value = a.un.value / kink.first.value;
        compression.change = (a.un.change - compression.value * kink.first.change) / kink.first.value;
    }
    return {(T(1) + restitution) * compression.value, (T(1) + restitution) * compression.change};
}

/// The C at which Stronge's restitution ends. With the work of either phase in triangles and trapezia,
///   C_k < 0:  C_f² = e² [f (u_n − C_k) p_k + C_k²]          (kink in compression)
///   else:     C_f² = C_k² + (f/c)(e² u_n² − C_k²)           (kink in restitution)
template <class T>
Varied<T> level_of_stronge(const VariedKinematics<T>& a, const VariedKink<T>& kink, const T& restitution) {
    using std::sqrt;
    const T& un = a.un.value;
    const T& ck = kink.level.value;
    const T& f = kink.second.value;
    const T& pk = kink.impulse.value;
    Varied<T> level;
    if (ck < T(0)) {
        const T root = sqrt(f * (un - ck) * pk + ck * ck);
        const Differential<T> square = (un - ck) * pk * kink.second.change +
                                       f * pk * (a.un.change - kink.level.change) +
                                       f * (un - ck) * kink.impulse.change + T(2) * ck * kink.level.change;
        level.value = restitution * root;
        level.change = (restitution / (T(2) * root)) * square;
    } else {
        const T& c = kink.first.value;
        const T e2 = restitution * restitution;
        const T left = e2 * un * un - ck * ck;
        const Differential<T> left_change = T(2) * (e2 * un * a.un.change - ck * kink.level.change);
        const Differential<T> square = T(2) * ck * kink.level.change + (f / c) * left_change +
                                       (left / c) * (kink.second.change - (f / c) * kink.first.change);
        level.value = sqrt(ck * ck + (f / c) * left);
        level.change = square / (T(2) * level.value);
    }
    return level;
}

template <ImpactRule rule, class T>
Varied<T> end_beyond_kink(const VariedKinematics<T>& a, const VariedKink<T>& kink, const T& restitution) {
    if constexpr (rule == ImpactRule::poisson)
        return end_of_poisson(a, kink, restitution);
    else if constexpr (rule == ImpactRule::newton)
        return impulse_at_level(kink, Varied<T>{restitution * a.un.value, restitution * a.un.change});
    else
        return impulse_at_level(kink, level_of_stronge(a, kink, restitution));
}

constexpr bool is_reversed(ContactMode mode) {
    return mode == ContactMode::c_reversed || mode == ContactMode::r_reversed;
}

/// dq/dp once slip has stopped: sticking holds u_t = 0, r = −B₃/B₁; reversed slip has r = sμ.
template <class T>
Varied<T> rate_beyond_kink(const VariedKinematics<T>& a, const T& mu, const T& sign, ContactMode mode) {
    if (is_reversed(mode)) return {sign * mu};
    const T rate = -a.b3.value / a.b1.value;
    return {rate, -(a.b3.change + rate * a.b1.change) / a.b1.value};
}

/// dC/dp once slip has stopped: while sticking (B₁ + B₂ − 1)/B₁, as `ContactKinematics::sticking`.
template <class T>
Varied<T> slope_beyond_kink(const VariedKinematics<T>& a, const Varied<T>& rate, ContactMode mode) {
    if (is_reversed(mode)) return slope(a, rate);
    const T f = (a.b2.value + (a.b1.value - T(1))) / a.b1.value;
    return {f, (a.b2.change + (T(1) - f) * a.b1.change) / a.b1.value};
}

/// dp and dq in the given contact mode; on a border between modes, that mode's one-sided differential.
template <ImpactRule rule, class T>
ImpulseChange<T> impulse_change(const VariedKinematics<T>& a, const T& mu, const T& restitution, ContactMode mode) {
    if constexpr (rule == ImpactRule::frictionless) {
        return change_in_sliding(a, T(0), restitution);
    } else {
        // From rest the body slips the way B₃ pulls it, as in impulse().
        const T sign = (a.ut.value == T(0) ? a.b3.value : a.ut.value) > T(0) ? T(1) : T(-1);
        if (!(a.un.value > T(0)) && a.ut.value == T(0)) return {};  // no impulse, nor for its neighbours of one side
        if (mode == ContactMode::sliding) return change_in_sliding(a, T(-sign * mu), restitution);
        const Varied<T> rate = rate_beyond_kink(a, mu, sign, mode);
        const VariedKink<T> kink = kink_of(a, mu, sign, slope_beyond_kink(a, rate, mode));
        const Varied<T> end = end_beyond_kink<rule>(a, kink, restitution);
        // q = −sμ p_k + r (p − p_k)
        ImpulseChange<T> change;
        change.normal = end.change;
        change.tangential = (-sign * mu) * kink.impulse.change + rate.value * (end.change - kink.impulse.change) +
                            (end.value - kink.impulse.value) * rate.change;
        return change;
    }
}

}  // namespace swirl::detail
