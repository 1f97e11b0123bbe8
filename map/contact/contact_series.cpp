#include "map/contact/contact_series.hpp"

#include "map/contact/contact_jets.hpp"
#include "map/map_list.hpp"
#include "map/numbers/exact_sum.hpp"
#include "map/numbers/quad.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace swirl {

namespace {

using std::abs, std::cos, std::pow, std::sin;

/// Two numbers side by side: what multiplies both is read once.
template <class T>
struct Two {
    T first{}, second{};

    Two() = default;
    Two(const T& a, const T& b) : first(a), second(b) {}

    T operator[](int i) const { return i == 0 ? first : second; }
    Two& operator+=(const Two& o) {
        first += o.first;
        second += o.second;
        return *this;
    }
    friend Two operator+(const Two& a, const Two& b) { return {a.first + b.first, a.second + b.second}; }
    friend Two operator*(const Two& a, const Two& b) { return {a.first * b.first, a.second * b.second}; }
    friend Two operator*(const T& a, const Two& b) { return {a * b.first, a * b.second}; }
};

/// In double they share a register: stored one by one and loaded together, they would have to wait for the store.
template <>
struct Two<double> {
    using Register [[gnu::vector_size(16)]] = double;
    Register both{};

    Two() = default;
    Two(Register r) : both(r) {}
    Two(double a, double b) : both{a, b} {}

    double operator[](int i) const { return both[i]; }
    Two& operator+=(const Two& o) {
        both += o.both;
        return *this;
    }
    friend Two operator+(const Two& a, const Two& b) { return a.both + b.both; }
    friend Two operator*(const Two& a, const Two& b) { return a.both * b.both; }
    friend Two operator*(double a, const Two& b) { return a * b.both; }
};

template <class T>
using TwoSeries = std::array<Two<T>, series_order<T> + 1>;

/// Σ a[i] b[k − i] for i from 0 to k, of a series and one or two: in four sums, as each addition waits for the one
/// before it, and the newest coefficients, a[k] and b[k], last.
template <class A, class B, class E = typename B::value_type>
E product(const A& a, const B& b, int k) {
    if (k == 0) return a[0] * b[0];
    E s0 = E{}, s1 = s0, s2 = s0, s3 = s0;
    int i = 1;
    for (; i + 3 < k; i += 4) {
        s0 += a[i] * b[k - i];
        s1 += a[i + 1] * b[k - i - 1];
        s2 += a[i + 2] * b[k - i - 2];
        s3 += a[i + 3] * b[k - i - 3];
    }
    if (i < k) s0 += a[i] * b[k - i];
    if (i + 1 < k) s1 += a[i + 1] * b[k - i - 1];
    if (i + 2 < k) s2 += a[i + 2] * b[k - i - 2];
    return ((s0 + s1) + (s2 + s3)) + (a[0] * b[k] + a[k] * b[0]);
}

/// The k-th coefficient of the square of one or two series.
template <class A, class E = typename A::value_type>
E square(const A& a, int k) {
    E s0 = E{}, s1 = s0;
    int i = 0;
    for (; 2 * i + 2 < k; i += 2) {
        s0 += a[i] * a[k - i];
        s1 += a[i + 1] * a[k - i - 1];
    }
    if (2 * i < k) s0 += a[i] * a[k - i];
    s0 += s1;
    s0 += s0;
    if (k % 2 == 0) s0 += a[k / 2] * a[k / 2];
    return s0;
}

double sign_of(ContactMotion motion) {
    return motion == ContactMotion::sliding_backward ? -1 : 1;
}

template <class T>
using Inverses = std::array<Plain<T>, series_order<T> + 1>;

template <class T>
constexpr Inverses<T> inverses() {
    Inverses<T> table{};
    for (int k = 1; k <= series_order<T>; ++k) table[k] = fraction<T>(1, k);
    return table;
}
/// 1/k, tabled: the recurrences would wait for each division.
template <class T>
const Inverses<T> per = inverses<T>();

/// Sine and cosine of a series, times a size: s′ = cθ′, c′ = −sθ′.
template <class T>
struct Turn {
    TwoSeries<T> both{};  ///< (s, c)
    Series<T> rate{};     ///< (k + 1) θₖ₊₁

    T sine(int k) const { return both[k][0]; }
    T cosine(int k) const { return both[k][1]; }

    /// Turned back by a tilt: (1 − i·tilt) times what it is of.
    void tilt(const T& by) {
        const T s = sine(0), c = cosine(0);
        both[0] = Two<T>(s + by * c, c - by * s);
    }
    /// `rest` is the rounding error of the angle: after many turns it exceeds the rounding of its sine.
    void begin(const T& size, const T& angle, const T& rest = T(0)) {
        const T s = sin(angle), c = cos(angle);
        both[0] = size * Two<T>(s + rest * c, c - rest * s);
    }
    /// θₖ is known.
    void extend(const T& angle, int k) {
        if (k == 0) return;
        rate[k - 1] = Plain<T>(k) * angle;
        const Two<T> by_rate = product(rate, both, k - 1);
        both[k] = Two<T>(by_rate[1] * per<T>[k], -by_rate[0] * per<T>[k]);
    }
    /// θ′ = −1.
    void extend_steadily(int k) {
        if (k > 0) both[k] = Two<T>(-cosine(k - 1) * per<T>[k], sine(k - 1) * per<T>[k]);
    }
};

template <class T>
struct Builder {
    const ContactScene<T>& scene;
    ContactMotion motion;
    ContactSeries<T>& z;
    Turn<T> swirl{};   ///< β(sin ψ, cos ψ) = (−w_t, w_n)
    Turn<T> r{};       ///< α(sin χ, cos χ) = (r_t, r_n)
    Turn<T> torque{};  ///< of a vertex that sticks: its sine is S′
    Series<T> spin2{}, rate{}, tangential{}, lever{}, spin_rate{};
    TwoSeries<T> rates{}, pushed{};
    T per_stiffness_now{};

    const Body<T>& body = scene.body;
    const bool sticks = motion == ContactMotion::sticking;
    const bool dissipates = !sticks && scene.mu != T(0);
    const T smu = sticks ? T(0) : T(scene.mu * Plain<T>(sign_of(motion)));
    const T kappa = scene.inertia_factor();
    const T rolling = -kappa / (T(1) + kappa), grip = T(1) + T(1) / kappa;  // of a disk: f/w_t, and u_t′ by f
    const T alpha = body.alpha, by_force = alpha * body.inverse_inertia;
    // Of an edge: the directions of its contacts from its middle, and about the container's centre its inertia, the
    // centre's share of what leans on it, Λ's factor and how friction divides between the two λ.
    const T c = cos(scene.half_chord), per_s = T(1) / sin(scene.half_chord), d = body.outer;
    const T inverse_inertia = T(1) / (body.inertia + d * d), lean_share = body.inertia * inverse_inertia;
    const T uneven = c - d * inverse_inertia, per_stiffness = T(1) / (c + smu * smu * uneven);
    // Of a floor that drags; none of it is read elsewhere.
    const ContactFloor<T>& floor = scene.floor;
    const bool drags = floor.drags;
    const T apart = drags ? T(floor.drag - floor.spin_drag) : T(0);
    const T about_vertex = drags ? slowing_about(alpha) : T(0), about_middle = drags ? slowing_about(d) : T(0);

    /// (γl² + γ_r I)/(I + l²), by which S falls about a point l from the centre.
    T slowing_about(const T& l) const {
        return (floor.drag * l * l + floor.spin_drag * body.inertia) / (body.inertia + l * l);
    }

    void begin(Support support, const ContactState<T>& start, const T& psi_rest) {
        const T& beta = body.beta;
        swirl.begin(beta, support == Support::edge ? T(start.psi + scene.half_chord) : start.psi, psi_rest);
        if (drags) swirl.tilt(floor.tilt);
        if (support != Support::vertex) return;
        r.begin(alpha, start.chi);
        if (!sticks) return;
        const ExactSum<T> sum = exact_sum(start.psi, start.chi);
        torque.begin(alpha * beta / (body.inertia + alpha * alpha), sum.sum, T(sum.rest + psi_rest));
        if (drags) torque.tilt(floor.tilt);
    }

    /// Orders k of the rates are known: the next of what they are the rates of.
    ///   slip_power  of f u_t
    void integrate(int k, const T& psi_rate, const T& chi_rate, const T& ut_rate, const T& slip_power) {
        const Plain<T>& next = per<T>[k + 1];
        z.psi[k + 1] = next * (psi_rate - T(k == 0 ? 1 : 0));
        z.chi[k + 1] = next * chi_rate;
        z.ut[k + 1] = next * ut_rate;
        z.spin[k + 1] = next * spin_rate[k];
        z.turned[k + 1] = next * z.spin[k];
        z.work[k + 1] = next * (slip_power - z.friction[k]);
    }

    T slip_power(int k) const { return dissipates ? product(z.friction, z.ut, k) : T(0); }

    void rim(int k) {
        swirl.extend(z.psi[k], k);
        const T wn = swirl.cosine(k), wt = -swirl.sine(k);
        rate[k] = (z.ut[k] - alpha * z.spin[k]) * body.inverse_inner;
        z.normal[k] = wn + body.inner * square(rate, k);
        z.friction[k] = sticks ? T(rolling * wt) : T(-smu * z.normal[k]);
        if (drags && sticks) z.friction[k] -= rolling * apart * body.inner * rate[k];
        spin_rate[k] = by_force * z.friction[k];
        T ut_rate = sticks ? T(0) : T(wt + z.friction[k] * grip);
        if (drags) {
            spin_rate[k] -= floor.spin_drag * z.spin[k];
            if (!sticks) ut_rate -= floor.drag * body.inner * rate[k] + floor.spin_drag * alpha * z.spin[k];
        }
        integrate(k, rate[k], T(0), ut_rate, slip_power(k));
    }

    /// Its own turn alone: S′ = αβ sin(ψ + χ)/(I + α²).
    void vertex_that_sticks(int k) {
        swirl.extend_steadily(k);
        r.extend(z.chi[k], k);
        torque.extend(T(z.psi[k] + z.chi[k]), k);
        spin2[k] = square(z.spin, k);
        spin_rate[k] = torque.sine(k);
        if (drags) spin_rate[k] -= about_vertex * z.spin[k];
        const Two<T> inwards = product(spin2, r.both, k), along = product(spin_rate, r.both, k);
        z.normal[k] = swirl.cosine(k) - (along[0] + inwards[1]);
        z.friction[k] = swirl.sine(k) - (along[1] - inwards[0]);
        if (drags) {
            const Two<T> turning = product(z.spin, r.both, k);
            z.normal[k] -= floor.drag * turning[0];
            z.friction[k] -= floor.drag * turning[1];
        }
        integrate(k, T(0), z.spin[k], T(0), T(0));
    }

    /// With the lever r_t − sμr_n: S′ = λ lever/I, λ + S′r_t = w_n + u_t² − S²r_n and B₂ − sμB₃ = 1 + r_t lever/I. The
    /// products with λ and S′ want their own k-th coefficients last.
    void vertex_that_slides(int k) {
        swirl.extend(z.psi[k], k);
        r.extend(z.chi[k], k);
        tangential[k] = r.sine(k);
        lever[k] = r.sine(k) - smu * r.cosine(k);
        rates[k] = Two<T>(z.spin[k], z.ut[k]);
        pushed[k] = Two<T>(lever[k], z.ut[k]);
        const Two<T> squares = square(rates, k);
        spin2[k] = squares[0];
        z.stiffness[k] = T(k == 0 ? 1 : 0) + body.inverse_inertia * product(tangential, lever, k);
        if (k == 0) per_stiffness_now = T(1) / z.stiffness[0];
        const Two<T> inwards = product(spin2, r.both, k), along = product(spin_rate, r.both, k);
        const Two<T> by_normal = product(z.normal, pushed, k);
        T pull = swirl.cosine(k) + squares[1] - inwards[1] - along[0];
        const Two<T> turning = drags ? product(z.spin, r.both, k) : Two<T>();
        if (drags) pull += floor.spin_drag * z.spin[k] * tangential[0] - floor.drag * turning[0];
        z.normal[k] = (pull - (body.inverse_inertia * tangential[0]) * by_normal[0]) * per_stiffness_now;
        z.friction[k] = -smu * z.normal[k];
        spin_rate[k] = body.inverse_inertia * (by_normal[0] + z.normal[k] * lever[0]);
        if (drags) spin_rate[k] -= floor.spin_drag * z.spin[k];
        T ut_rate = (along[1] - swirl.sine(k) - inwards[0]) + (z.friction[k] + spin_rate[k] * r.cosine(0));
        if (drags) ut_rate -= floor.drag * (z.ut[k] - turning[1]);
        const T power = dissipates ? T(-smu * (by_normal[1] + z.normal[k] * z.ut[0])) : T(0);
        integrate(k, z.ut[k], z.spin[k] - z.ut[k], ut_rate, power);
    }

    /// ψ is ψ_c here: ψ and half the angle between the contacts. At rest nothing but ψ moves.
    void edge(int k) {
        swirl.extend(z.psi[k], k);
        const T wn = swirl.cosine(k), wt = -swirl.sine(k);
        if (sticks) {
            z.friction[k] = -d * wt;
            return integrate(k, z.spin[k], T(0), T(0), T(0));
        }
        T lean = -wt * lean_share;
        if (drags) lean += apart * d * z.spin[k] * lean_share;
        spin2[k] = square(z.spin, k);
        const T sum_of_two = (wn + d * spin2[k] - smu * lean) * per_stiffness;
        const T difference = (smu * sum_of_two * uneven + lean) * per_s;
        z.normal[k] = T(0.5) * (sum_of_two + difference);
        z.second[k] = T(0.5) * (sum_of_two - difference);
        z.friction[k] = -smu * sum_of_two;
        spin_rate[k] = (z.friction[k] + d * wt) * inverse_inertia;
        if (drags) spin_rate[k] -= about_middle * z.spin[k];
        integrate(k, z.spin[k], T(0), spin_rate[k], slip_power(k));
    }
};

/// Σ cₖ tᵏ over k ≥ 1: odd and even powers beside each other, as each step of Horner's rule waits for the one before.
///   of  what is taken of a coefficient: T → T
template <class T, class Of>
T sum_of_powers(const Series<T>& series, const T& t, const Of& of) {
    constexpr int order = series_order<T>;
    static_assert(order % 2 == 0);
    const T square_of_t = t * t;
    Two<T> sum(of(series[order - 1]), of(series[order]));
    for (int k = order - 3; k >= 1; k -= 2) sum = Two<T>(of(series[k]), of(series[k + 1])) + square_of_t * sum;
    return t * (sum[0] + t * sum[1]);
}

}  // namespace

template <class T>
ContactSeries<T> contact_series(const ContactScene<T>& scene, Support support, ContactMotion motion,
                                const ContactState<T>& start, const T& psi_rest) {
    ContactSeries<T> series;
    series.psi[0] = start.psi;
    series.chi[0] = start.chi;
    series.ut[0] = start.ut;
    series.spin[0] = start.spin;
    Builder<T> builder{scene, motion, series};
    builder.begin(support, start, psi_rest);
    for (int k = 0; k < series_order<T>; ++k) {
        if (support == Support::rim)
            builder.rim(k);
        else if (support == Support::edge)
            builder.edge(k);
        else if (builder.sticks)
            builder.vertex_that_sticks(k);
        else
            builder.vertex_that_slides(k);
    }
    return series;
}

template <class T>
T change_at(const Series<T>& series, const T& t) {
    return sum_of_powers(series, t, [](const T& c) { return c; });
}

template <class T>
T value_at(const Series<T>& series, const T& t) {
    return series[0] + change_at<T>(series, t);
}

template <class T>
T derivative_at(const Series<T>& series, const T& t) {
    T sum(0);
    for (int k = series_order<T>; k >= 1; --k) sum = Plain<T>(k) * series[k] + t * sum;
    return sum;
}

template <class T>
T second_derivative_bound(const Series<T>& series, const T& t) {
    T sum(0);
    for (int k = series_order<T>; k >= 2; --k) sum = Plain<T>(k * (k - 1)) * abs(series[k]) + t * sum;
    return sum;
}

template <class T>
T reach_of(const Series<T>& series, const T& t) {
    return sum_of_powers(series, t, [](const T& c) { return T(abs(c)); });
}

template <class T>
Plain<T> step_of(const ContactSeries<T>& z, const Plain<T>& tolerance) {
    using P = Plain<T>;
    constexpr int order = series_order<T>;
    P last(0), before(0);
    for (const Series<T>* series : {&z.psi, &z.chi, &z.ut, &z.spin, &z.turned, &z.work}) {
        const P scale = std::max(P(1), P(abs(plain((*series)[0]))));
        last = std::max(last, P(abs(plain((*series)[order])) / scale));
        before = std::max(before, P(abs(plain((*series)[order - 1])) / scale));
    }
    const auto limit = [&](const P& term, int k) {
        return term > 0 ? P(pow(P(tolerance / term), fraction<T>(1, k))) : std::numeric_limits<P>::infinity();
    };
    return std::min(limit(last, order), limit(before, order - 1));
}

#define SWIRL_COMPILE_CONTACT_SERIES(T)                                                                              \
    template ContactSeries<T> contact_series(const ContactScene<T>&, Support, ContactMotion, const ContactState<T>&, \
                                             const T&);                                                              \
    template T change_at<T>(const Series<T>&, const T&);                                                             \
    template T value_at<T>(const Series<T>&, const T&);                                                              \
    template T derivative_at<T>(const Series<T>&, const T&);                                                         \
    template T second_derivative_bound<T>(const Series<T>&, const T&);                                               \
    template T reach_of<T>(const Series<T>&, const T&);                                                              \
    template Plain<T> step_of(const ContactSeries<T>&, const Plain<T>&);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_CONTACT_SERIES)
SWIRL_EVERY_CONTACT_JET(SWIRL_COMPILE_CONTACT_SERIES)

}  // namespace swirl
