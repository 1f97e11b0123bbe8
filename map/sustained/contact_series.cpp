#include "map/sustained/contact_series.hpp"

#include "map/map_list.hpp"
#include "map/sustained/contact_jets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl {

namespace {

using std::abs, std::cos, std::pow, std::sin;

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

/// Σ a[i] b[k − i] for i from 0 to k: in four sums, as each addition waits for the one before it, and the newest
/// coefficients, a[k] and b[k], last.
template <class T>
T product(const Series<T>& a, const Series<T>& b, int k) {
    if (k == 0) return a[0] * b[0];
    T s0(0), s1(0), s2(0), s3(0);
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

/// The k-th coefficient of a square.
template <class T>
T square(const Series<T>& a, int k) {
    T s0(0), s1(0);
    int i = 0;
    for (; 2 * i + 2 < k; i += 2) {
        s0 += a[i] * a[k - i];
        s1 += a[i + 1] * a[k - i - 1];
    }
    if (2 * i < k) s0 += a[i] * a[k - i];
    const T twice = T(2) * (s0 + s1);
    return k % 2 == 0 ? T(twice + a[k / 2] * a[k / 2]) : twice;
}

/// Sine and cosine of a series: s′ = cθ′, c′ = −sθ′.
template <class T>
struct Turn {
    Series<T> sine{}, cosine{};
    Series<T> rate{};  ///< (k + 1) θₖ₊₁

    /// `rest` is the rounding error of the angle: after many turns it exceeds the rounding of its sine.
    void begin(const T& angle, const T& rest = T(0)) {
        const T s = sin(angle), c = cos(angle);
        sine[0] = s + rest * c;
        cosine[0] = c - rest * s;
    }
    void extend(const Series<T>& angle, int k) {
        if (k == 0) return;
        rate[k - 1] = Plain<T>(k) * angle[k];
        sine[k] = product<T>(rate, cosine, k - 1) * per<T>[k];
        cosine[k] = -product<T>(rate, sine, k - 1) * per<T>[k];
    }
};

template <class T>
struct Builder {
    const ContactScene<T>& scene;
    ContactMotion motion;
    ContactSeries<T>& z;
    Turn<T> psi{}, chi{};
    Series<T> spin2{}, rate{}, other{}, spin_rate{};

    const Body<T>& body = scene.body;
    const bool sticks = motion == ContactMotion::sticking;
    const T smu = sticks ? T(0) : T(scene.mu * Plain<T>(sign_of(motion)));
    const T kappa = scene.inertia_factor();
    const T rolling = -kappa / (T(1) + kappa), grip = T(1) + T(1) / kappa;  // of a disk: f/w_t, and u_t′ by f
    const T beta = body.beta, alpha = body.alpha;
    // Of an edge: the directions of its contacts from its middle, and about the container's centre its inertia, the
    // centre's share of what leans on it, Λ's factor and how friction divides between the two λ.
    const T c = cos(scene.half_chord), per_s = T(1) / sin(scene.half_chord), d = body.outer;
    const T per_inertia = T(1) / (body.inertia + d * d), lean_share = body.inertia * per_inertia;
    const T uneven = c - d * per_inertia, per_stiffness = T(1) / (c + smu * smu * uneven);

    /// Orders k of the rates are known: the next of what they are the rates of.
    void integrate(int k, const T& psi_rate, const T& chi_rate, const T& ut_rate) {
        const Plain<T> next = per<T>[k + 1];
        z.psi[k + 1] = next * (psi_rate - T(k == 0 ? 1 : 0));
        z.chi[k + 1] = next * chi_rate;
        z.ut[k + 1] = next * ut_rate;
        z.spin[k + 1] = next * spin_rate[k];
        z.turned[k + 1] = next * z.spin[k];
        if (scene.mu == T(0)) return;
        // A slip of zero is zero in every order.
        const T slip_power = sticks ? T(0) : product<T>(z.friction, z.ut, k);
        z.work[k + 1] = next * (slip_power - z.friction[k]);
    }

    void rim(int k) {
        psi.extend(z.psi, k);
        const T wn = beta * psi.cosine[k], wt = -beta * psi.sine[k];
        rate[k] = (z.ut[k] - alpha * z.spin[k]) * body.per_inner;
        z.normal[k] = wn + body.inner * square<T>(rate, k);
        z.friction[k] = sticks ? T(rolling * wt) : T(-smu * z.normal[k]);
        spin_rate[k] = alpha * body.per_inertia * z.friction[k];
        integrate(k, rate[k], T(0), sticks ? T(0) : T(wt + z.friction[k] * grip));
    }

    void vertex(int k) {
        psi.extend(z.psi, k);
        chi.extend(z.chi, k);
        const T wn = beta * psi.cosine[k], wt = -beta * psi.sine[k];
        spin2[k] = square<T>(z.spin, k);
        const T inward = alpha * product<T>(spin2, chi.cosine, k), along = alpha * product<T>(spin2, chi.sine, k);
        if (sticks) {
            // Its own turn alone: r_t w_n − r_n w_t, both of them products of series.
            const T torque = alpha * beta * (product<T>(chi.sine, psi.cosine, k) + product<T>(chi.cosine, psi.sine, k));
            spin_rate[k] = torque / (body.inertia + alpha * alpha);
            z.normal[k] = wn - alpha * product<T>(spin_rate, chi.sine, k) - inward;
            z.friction[k] = -wt - alpha * product<T>(spin_rate, chi.cosine, k) + along;
            return integrate(k, T(0), z.spin[k], T(0));
        }
        // S′ = αλ (sin χ − sμ cos χ)/I and B₂ − sμB₃ = 1 + (α²/I) sin χ (sin χ − sμ cos χ).
        other[k] = chi.sine[k] - smu * chi.cosine[k];
        z.stiffness[k] = T(k == 0 ? 1 : 0) + alpha * alpha * body.per_inertia * product<T>(chi.sine, other, k);
        T balance = wn + square<T>(z.ut, k) - inward;
        z.normal[k] = T(0);
        balance -= product<T>(z.stiffness, z.normal, k);
        z.normal[k] = balance / z.stiffness[0];
        z.friction[k] = -smu * z.normal[k];
        spin_rate[k] = alpha * body.per_inertia * product<T>(z.normal, other, k);
        integrate(k, z.ut[k], z.spin[k] - z.ut[k],
                  wt + z.friction[k] + alpha * product<T>(spin_rate, chi.cosine, k) - along);
    }

    /// `psi` is ψ_c here: ψ and half the angle between the contacts. At rest nothing but ψ moves.
    void edge(int k) {
        psi.extend(z.psi, k);
        const T wn = beta * psi.cosine[k], wt = -beta * psi.sine[k];
        if (sticks) {
            z.friction[k] = -d * wt;
            return integrate(k, z.spin[k], T(0), T(0));
        }
        const T lean = -wt * lean_share;
        spin2[k] = square<T>(z.spin, k);
        const T sum = (wn + d * spin2[k] - smu * lean) * per_stiffness;
        const T difference = (smu * sum * uneven + lean) * per_s;
        z.normal[k] = T(0.5) * (sum + difference);
        z.second[k] = T(0.5) * (sum - difference);
        z.friction[k] = -smu * sum;
        spin_rate[k] = (z.friction[k] + d * wt) * per_inertia;
        integrate(k, z.spin[k], T(0), spin_rate[k]);
    }
};

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
    builder.psi.begin(support == Support::edge ? T(start.psi + scene.half_chord) : start.psi, psi_rest);
    builder.chi.begin(start.chi);
    for (int k = 0; k < series_order<T>; ++k) {
        if (support == Support::rim)
            builder.rim(k);
        else if (support == Support::vertex)
            builder.vertex(k);
        else
            builder.edge(k);
    }
    return series;
}

template <class T>
T change_at(const Series<T>& series, const T& t) {
    T sum(0);
    for (int k = series_order<T>; k >= 1; --k) sum = t * (series[k] + sum);
    return sum;
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
T bend_of(const Series<T>& series, const T& t) {
    T sum(0);
    for (int k = series_order<T>; k >= 2; --k) sum = Plain<T>(k * (k - 1)) * abs(series[k]) + t * sum;
    return sum;
}

template <class T>
T reach_of(const Series<T>& series, const T& t) {
    T sum(0);
    for (int k = series_order<T>; k >= 1; --k) sum = t * (abs(series[k]) + sum);
    return sum;
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
    template T bend_of<T>(const Series<T>&, const T&);                                                               \
    template T reach_of<T>(const Series<T>&, const T&);                                                              \
    template Plain<T> step_of(const ContactSeries<T>&, const Plain<T>&);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_CONTACT_SERIES)
SWIRL_EVERY_CONTACT_JET(SWIRL_COMPILE_CONTACT_SERIES)

}  // namespace swirl
