// The impact of a rigid body with the wall under Coulomb friction, in closed form.
//
// Routh's plane impact (map/README.md, "Impact"; Wang & Mason, J. Appl. Mech. 59 (1992) 635; Stronge, Proc. R. Soc. A
// 431 (1990) 169). The impulse on the body is −p n + q t, p ≥ 0 grows from 0, and with C = −u_n
//     C = C₀ + B₂ p + B₃ q,   u_t = u_t₀ + B₃ p + B₁ q,   dq = −μ sign(u_t) dp while slipping.
// C(p) is therefore piecewise linear with at most one kink, where slip stops; the five contact modes are where it
// falls.
#pragma once

#include "map/model/scene.hpp"
#include "map/numbers/real.hpp"

#include <cmath>
#include <cstddef>
#include <string_view>

namespace swirl {

/// The law of the contact, chosen once per scene. Without friction no friction code runs.
enum class ImpactRule { frictionless, poisson, newton, stronge };

/// The five contact modes of Wang & Mason, and the sixth without friction. C-: slip stopped during compression;
/// R-: during restitution; reversed: it then slipped back.
enum class ContactMode { frictionless, sliding, c_sticking, r_sticking, c_reversed, r_reversed };

inline std::string_view name_of(ContactMode mode) {
    static constexpr std::string_view names[] = {"frictionless", "sliding",    "c-sticking",
                                                 "r-sticking",   "c-reversed", "r-reversed"};
    return names[static_cast<std::size_t>(mode)];
}

/// Has the slip stopped for good by the impact's end, in compression or in restitution?
inline bool ends_in_stick(ContactMode mode) {
    return mode == ContactMode::c_sticking || mode == ContactMode::r_sticking;
}

#include "map/model/impact_formulas.hpp"

/// The impulse −p n + q t on the body.
template <class T>
struct Impulse {
    T normal{};      ///< p ≥ 0
    T tangential{};  ///< q
    ContactMode mode = ContactMode::frictionless;
};

namespace detail {

/// C(p) as two straight pieces: slope `first` up to `kink`, slope `second` beyond.
template <class T>
struct NormalVelocityPath {
    T start;   ///< C₀ < 0
    T first;   ///< dC/dp while slipping as at first, B₂ − sμB₃ (may be ≤ 0 if the kink comes before C = 0)
    T second;  ///< dC/dp after the kink, > 0
    T kink;    ///< p at which slip stops
    bool has_kink;

    T at_kink() const { return start + first * kink; }
    bool kink_in_compression() const { return has_kink && plain(at_kink()) < 0; }
    /// p_c, where C = 0.
    T compression_end() const { return kink_in_compression() ? T(kink - at_kink() / second) : T(-start / first); }
};

/// The p at which C reaches `level` ≥ 0 beyond the end of compression p_c (Newton's end).
template <class T>
T end_at_velocity(const NormalVelocityPath<T>& path, const T& compression_end, const T& level) {
    if (path.kink_in_compression()) return compression_end + level / path.second;
    if (!path.has_kink || plain(level) <= plain(path.at_kink())) return compression_end + level / path.first;
    return path.kink + (level - path.at_kink()) / path.second;
}

/// The p at which the work ∫C dp of restitution is e² times that of compression (Stronge's end).
template <class T>
T end_at_work(const NormalVelocityPath<T>& path, const T& compression_end, const T& restitution) {
    using std::sqrt;
    const T at_kink = path.has_kink ? path.at_kink() : T(0);
    if (path.kink_in_compression()) {
        const T compression = T(-0.5) * ((path.start + at_kink) * path.kink + at_kink * (compression_end - path.kink));
        return compression_end + restitution * sqrt(T(2) * compression / path.second);
    }
    const T straight = compression_end + restitution * compression_end;
    if (!path.has_kink || plain(straight) <= plain(path.kink)) return straight;
    // Work of restitution ½C₀²e²/first: ½C_k²/first on the first piece, ½(C_f² − C_k²)/second on the second.
    const T level = restitution * path.start;
    const T left = (level * level - at_kink * at_kink) * (path.second / path.first);
    return path.kink + left / (path.second * (at_kink + sqrt(at_kink * at_kink + left)));
}

template <ImpactRule rule, class T>
T impulse_end(const NormalVelocityPath<T>& path, const T& restitution) {
    const T compression_end = path.compression_end();
    if constexpr (rule == ImpactRule::newton)
        return end_at_velocity(path, compression_end, T(-restitution * path.start));
    else if constexpr (rule == ImpactRule::stronge)
        return end_at_work(path, compression_end, restitution);
    else
        return compression_end + restitution * compression_end;
}

}  // namespace detail

/// u_n of an impact. A vertex that grazes, or that the wall outruns while it is within rounding of it, is found at the
/// wall with a u_n that is negative by rounding: it touches without an impulse (p → 0 as u_n → 0).
template <class T>
[[gnu::always_inline]] inline T approaching(const T& un) {
    return plain(un) < 0 ? T(0) : un;
}

/// The disk's impulse: B₃ = 0 and B₂ = 1 decouple the directions, slip stops at p = |u_t|/(μB₁), and all laws agree.
/// An impact that sticks returns u_t⁺ = −e_t u_t⁻ by q = −(1 + e_t)u_t/B₁; it slides where that exceeds μp (Walton).
/// Energy is never gained: q opposes the mean of u_t before and after. c-sticking: |q| < μu_n, what friction can give
/// in compression. `grip` = (1 + e_t)/B₁: no division. Source: Walton & Braun, J. Rheol. 30 (1986) 949.
template <class T>
[[gnu::always_inline]] inline Impulse<T> disk_impulse(const T& normal, const T& ut, const T& grip, const T& mu,
                                                      const T& restitution) {
    using std::fabs;
    const T un = approaching(normal);
    const T end = (T(1) + restitution) * un;
    const T stick = -grip * ut;  // the impulse that stops the slip, or returns it
    if (fabs(plain(stick)) > plain(mu) * plain(end))
        return {end, plain(ut) > 0 ? T(-mu * end) : T(mu * end), ContactMode::sliding};
    const bool early = fabs(plain(stick)) < plain(mu) * plain(un);
    return {end, stick, early ? ContactMode::c_sticking : ContactMode::r_sticking};
}

/// The impulse of one impact.
///   rule         how restitution ends (or no friction at all)
///   approach     velocities and lever arms at the contact; u_n < 0 counts as 0 (`approaching`)
///   mu           μ ≥ 0 (not read without friction)
///   restitution  e ∈ [0, 1]
/// Poisson p = (1 + e) p_c; Newton C = −e C₀ (may create energy); Stronge W_r = e² W_c. Cost: a few divisions, one
/// square root for Stronge with a kink.
template <ImpactRule rule, class T>
Impulse<T> impulse(const ContactKinematics<T>& approach, const T& mu, const T& restitution) {
    const T b2 = approach.b2();
    const T un = approaching(approach.un);
    if constexpr (rule == ImpactRule::frictionless) {
        return {(T(1) + restitution) * un / b2, T(0), ContactMode::frictionless};
    } else {
        using std::fabs;
        const T b1 = approach.b1();
        const T b3 = approach.b3();
        const T stick = mu * b1;
        const bool sticks = fabs(plain(b3)) <= plain(stick);
        const bool at_rest = plain(approach.ut) == 0;
        // The direction of slip; from rest, that in which B₃ pulls if friction can't hold it.
        const bool positive = at_rest ? plain(b3) > 0 : plain(approach.ut) > 0;
        const T signed_b3 = positive ? b3 : T(-b3);
        const T slowing = stick - signed_b3;  // −d|u_t|/dp
        const bool has_kink = at_rest ? sticks : plain(slowing) > 0;

        detail::NormalVelocityPath<T> path{T(-un), b2 - mu * signed_b3, T(0), T(0), has_kink};
        if (has_kink) {
            path.kink = plain(slowing) > 0 ? T((positive ? approach.ut : T(-approach.ut)) / slowing) : T(0);
            path.second = sticks ? approach.sticking() : T(b2 + mu * signed_b3);
        }
        const T end = detail::impulse_end<rule>(path, restitution);
        const T friction = positive ? T(-mu) : mu;  // dq/dp at first
        if (!has_kink || plain(end) < plain(path.kink)) return {end, friction * end, ContactMode::sliding};

        const T after = sticks ? T(-b3 / b1) : T(-friction);
        const bool early = path.kink_in_compression();
        const ContactMode mode = sticks ? (early ? ContactMode::c_sticking : ContactMode::r_sticking)
                                        : (early ? ContactMode::c_reversed : ContactMode::r_reversed);
        return {end, friction * path.kink + after * (end - path.kink), mode};
    }
}

}  // namespace swirl
