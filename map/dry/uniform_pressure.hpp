// Where a body that slides on its floor with uniform pressure is dragged to: means over its area. map/dry/README.md,
// "Friction".
#pragma once

#include "map/model/body.hpp"
#include "map/numbers/jets.hpp"

#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_d.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace swirl {

/// Means over the area of a body whose points ρ, from its centre, move at u = U + iSρ against the floor.
template <class T>
struct MeanSlip {
    Vec2<T> direction;  ///< ⟨u/|u|⟩: the floor's force is −a_f times it
    T moment{};         ///< ⟨ρ × u/|u|⟩: and so its torque, in R_c
};

/// What the means need of a regular polygon, the rod or the disk, whatever its size. Where |U| ≥ 5α|S| they are a
/// series in q = iSa/U of the area's moments, else in closed form: integrals along the sides (rod: along it), elliptic
/// ones of the disk.
class UniformPressure {
public:
    /// More sides are refused by the map: the closed form is a sum over them.
    static constexpr int most_sides = most_sides_over_dry_floor;

    ///   sides  2 … most_sides, or disk_sides
    explicit UniformPressure(int sides);

    /// Not for U = 0 and S = 0. Error: some 30 ε. Cost: of a hexagon some 10 sincos; it grows with N.
    ///   velocity  U, of the centre against the floor, in R_c ω_s
    ///   arm       from the centre to a vertex; any of a disk
    template <class T>
    MeanSlip<T> mean_slip(const Body<T>& body, const Vec2<T>& velocity, const T& spin, const Vec2<T>& arm) const;

    /// A step of an integration that does not reach across the body's border with the point that does not slide, iU/S
    /// from the centre: on the border the means have no third derivative (rod: on it no second), and an error estimate
    /// is blind to a step across it. Shorter than what leaves ε on a border that is crossed it never is.
    ///   deceleration  a_f
    ///   change        bounds |U|′ + α|S|′
    ///   along_rate    of U along the arm, in axes that turn with it: a rod's border is its line, on which that is 0
    double step_to_border(const Body<double>& body, const Vec2<double>& velocity, double spin, const Vec2<double>& arm,
                          double deceleration, double change, double along_rate) const;

    double distance() const { return distance_; }  ///< ⟨|ρ|⟩, in R_p
    double square() const { return square_; }      ///< ⟨|ρ|²⟩, in R_p²

private:
    /// qⁿ Σ_k c_k |q|^{2k}, q̄^{−n} for n < 0
    struct Harmonic {
        int number;
        std::vector<double> coefficients;
    };
    static constexpr int order = 23;  // of |q| ≤ 1/5: the first term left out is below 5^{−24} = 0.3 ε of the first

    /// Σ binom(½, a) binom(−½, b) M_{a, b + shift} q^a q̄^b by harmonics a − b.
    std::vector<Harmonic> harmonics(int shift) const;
    /// M_ab = ⟨ρ^a ρ̄^b⟩ in R_p, of a body with a vertex at 1.
    double moment(int a, int b) const;

    template <class T>
    static Vec2<T> sum(const std::vector<Harmonic>& harmonics, const Vec2<T>& q);
    template <class T>
    MeanSlip<T> by_series(const Vec2<T>& velocity, const T& spin, const Vec2<T>& arm) const;

    int sides_;
    std::vector<Harmonic> force_, torque_;
    double distance_ = 0, square_ = 0;
};

namespace detail {

/// B = ∫ cos² φ dφ/Δ and E = ∫ Δ dφ over a quarter turn, Δ² = 1 − m sin² φ; and D = ∫ sin² φ dφ/Δ.
template <class T>
struct EllipticPair {
    T b, e;
};

// No numbers give none: Boost would throw.
inline double elliptic_d(double m) {
    if (std::isnan(m)) return m;
    return boost::math::ellint_d(std::sqrt(std::min(m, 1 - 0x1p-53)));  // at 1 it is infinite, and times 1 − m = 0
}

inline EllipticPair<double> elliptic_pair(double m) {
    if (std::isnan(m)) return {m, m};
    const double e = boost::math::ellint_2(std::sqrt(std::min(m, 1.0)));
    return {e - std::max(1 - m, 0.0) * elliptic_d(m), e};
}

/// dE/dm = −D/2, dB/dm = (D − B)/2m; for small m that difference is lost, and its series is taken.
template <class U, int n>
EllipticPair<ceres::Jet<U, n>> elliptic_pair(const ceres::Jet<U, n>& m) {
    const EllipticPair<U> at = elliptic_pair(m.a);
    const U d = elliptic_d(m.a);
    const U slope = m.a < U(1e-4) ? U(pi<U>() / 32) * (1 + U(0.75) * m.a) : (d - at.b) / (2 * m.a);
    return {ceres::Jet<U, n>(at.b, slope * m.v), ceres::Jet<U, n>(at.e, U(-0.5) * d * m.v)};
}

/// The disk in closed form; with ε = |U|/α|S| and m = ε² or 1/ε²
///     ε ≤ 1: 4/3π (E + B) U/α|S|,  ± 4/9π α (E (3 − 2m) + m B)      ε ≥ 1: 4/3π (E + B) U/|U|,  ± 4/9π α ε (E − 2B +
///     3mB)
/// (Farkas, Bartels, Unger & Wolf, PRL 90, 248302 (2003), eqs 5 and 6, whose E and K are here sums without
/// cancellation).
template <class T>
MeanSlip<T> mean_slip_of_disk(const Body<T>& body, const Vec2<T>& velocity, const T& spin) {
    using std::sqrt;
    const bool is_positive = plain(spin) > 0;
    const T rim = body.alpha * (is_positive ? spin : T(-spin));
    const T speed2 = dot(velocity, velocity), rim2 = rim * rim;
    const T third = T(4 / (3 * pi<Plain<T>>())), ninth = T(4 / (9 * pi<Plain<T>>())) * body.alpha;
    MeanSlip<T> mean;
    if (plain(speed2) <= plain(rim2)) {
        const T m = speed2 / rim2;
        const auto [b, e] = elliptic_pair(m);
        mean.direction = T(third * (e + b) / rim) * velocity;
        mean.moment = ninth * (e * (T(3) - T(2) * m) + m * b);
    } else {
        const T m = rim2 / speed2, speed = sqrt(speed2);
        const auto [b, e] = elliptic_pair(m);
        mean.direction = T(third * (e + b) / speed) * velocity;
        mean.moment = ninth * (speed / rim) * (e - T(2) * b + T(3) * m * b);
    }
    if (!is_positive) mean.moment = -mean.moment;
    return mean;
}

/// Along a segment, ξ = u t + d n from the point about which the body turns: ∫ du |ξ|, and ∫ du/|ξ|.
template <class T>
struct AlongSegment {
    T start_radius, end_radius;  ///< |ξ| at its ends
    T distance;                  ///< d
    T inverse{};                 ///< ∫ du/|ξ|; 0 where d is none but rounding, where it is not used
    T radius{};                  ///< ∫ |ξ| du
};

/// |ξ|; √ has no derivative at 0, where what it is multiplied with is 0, too.
template <class T>
T length_of(const Vec2<T>& v) {
    using std::sqrt;
    const T square = dot(v, v);
    return plain(square) == 0 ? T(0) : T(sqrt(square));
}

template <class T>
AlongSegment<T> along_segment(const Vec2<T>& from, const Vec2<T>& tangent, const T& length) {
    using std::log;
    const Vec2<T> normal{tangent.y, -tangent.x};
    AlongSegment<T> along;
    const T start = dot(from, tangent), end = start + length;
    along.start_radius = length_of(from);
    along.end_radius = length_of(Vec2<T>(from + length * tangent));
    along.distance = dot(from, normal);
    const T square = along.distance * along.distance;
    const auto rounding = epsilon<Plain<T>>() * plain(length);  // within it an end may lie at the point itself
    if (plain(square) > rounding * rounding) {
        // of the three forms of ln((end + R_end)/(start + R_start)) the one without differences
        if (plain(start) >= 0)
            along.inverse = log((end + along.end_radius) / (start + along.start_radius));
        else if (plain(end) <= 0)
            along.inverse = log((along.start_radius - start) / (along.end_radius - end));
        else
            along.inverse = log((end + along.end_radius) * (along.start_radius - start) / square);
    }
    along.radius = T(0.5) * (end * along.end_radius - start * along.start_radius + square * along.inverse);
    return along;
}

/// About r_c = iU/S, where nothing slides: u/|u| = ± i ξ/|ξ|, ξ = ρ − r_c, and by Gauss' theorem
///     ∫ ξ/|ξ| dA = ∮ |ξ| n du      ∫ |ξ| dA = ⅓ ∮ |ξ| ξ·n du.
template <class T>
MeanSlip<T> mean_slip_of_sides(const Body<T>& body, const Vec2<T>& velocity, const T& spin, const Vec2<T>& arm) {
    const Vec2<T> pivot = quarter_turned(Vec2<T>((T(1) / spin) * velocity));
    Vec2<T> toward{T(0), T(0)};
    T radius(0);
    if (body.sides == rod_sides) {
        const Vec2<T> tangent = T(T(-1) / body.alpha) * arm;
        const T length = T(2) * body.alpha;
        const AlongSegment<T> along = along_segment(Vec2<T>(arm - pivot), tangent, length);
        toward = T((along.end_radius - along.start_radius) / length) * tangent +
                 T(along.distance * along.inverse / length) * Vec2<T>{tangent.y, -tangent.x};
        radius = along.radius / length;
    } else {
        for (int k = 0; k < body.sides; ++k) {
            const Vec2<T> from = body.turned_to_vertex(arm, k);
            const Vec2<T> side = times(from, body.next_turn);
            const Vec2<T> tangent = T(T(1) / body.side) * side;
            const AlongSegment<T> along = along_segment(Vec2<T>(from - pivot), tangent, body.side);
            toward = toward + along.radius * Vec2<T>{tangent.y, -tangent.x};
            radius = radius + along.radius * along.distance;
        }
        const T half_side = T(0.5) * body.side;
        const T area = T(body.sides) * half_side * (half_side / body.half_slope);
        toward = T(T(1) / area) * toward;
        radius = radius / (T(3) * area);
    }
    const bool is_positive = plain(spin) > 0;
    MeanSlip<T> mean;
    mean.direction = quarter_turned(is_positive ? toward : T(-1) * toward);
    mean.moment = (is_positive ? radius : T(-radius)) + cross(pivot, mean.direction);
    return mean;
}

}  // namespace detail

template <class T>
Vec2<T> UniformPressure::sum(const std::vector<Harmonic>& harmonics, const Vec2<T>& q) {
    const T square = dot(q, q);
    Vec2<T> total{T(0), T(0)};
    for (const Harmonic& harmonic : harmonics) {
        T amplitude(0);
        for (auto c = harmonic.coefficients.rbegin(); c != harmonic.coefficients.rend(); ++c)
            amplitude = T(*c) + square * amplitude;
        const Vec2<T> factor = harmonic.number < 0 ? Vec2<T>{q.x, -q.y} : q;
        Vec2<T> power{amplitude, T(0)};
        for (int n = harmonic.number < 0 ? -harmonic.number : harmonic.number; n > 0; --n) power = times(power, factor);
        total = total + power;
    }
    return total;
}

/// u/|u| = U/|U| (1 + z)^½ (1 + z̄)^{−½}, z = iSρ/U; q is z at a vertex.
template <class T>
MeanSlip<T> UniformPressure::by_series(const Vec2<T>& velocity, const T& spin, const Vec2<T>& arm) const {
    using std::sqrt;
    const T square = dot(velocity, velocity);
    const Vec2<T> q = T(spin / square) * quarter_turned(seen_from(velocity, arm));
    const Vec2<T> along = T(T(1) / sqrt(square)) * velocity;
    MeanSlip<T> mean;
    mean.direction = times(along, sum(force_, q));
    const Vec2<T> turned = times(along, sum(torque_, q));
    mean.moment = cross(arm, turned);  // Im(ā …)
    return mean;
}

template <class T>
MeanSlip<T> UniformPressure::mean_slip(const Body<T>& body, const Vec2<T>& velocity, const T& spin,
                                       const Vec2<T>& arm) const {
    const auto rim = plain(body.alpha) * plain(spin);
    const bool is_disk = body.sides == disk_sides;
    if (plain(dot(velocity, velocity)) >= 25 * rim * rim)
        return by_series(velocity, spin, is_disk ? Vec2<T>{body.alpha, T(0)} : arm);
    return is_disk ? detail::mean_slip_of_disk(body, velocity, spin)
                   : detail::mean_slip_of_sides(body, velocity, spin, arm);
}

}  // namespace swirl
