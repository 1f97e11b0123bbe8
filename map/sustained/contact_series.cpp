#include "map/sustained/contact_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl {

namespace {

constexpr int order = series_order;

double sign_of(ContactMotion motion) {
    return motion == ContactMotion::sliding_backward ? -1 : 1;
}

constexpr Series inverses() {
    Series table{};
    for (int k = 1; k <= order; ++k) table[k] = 1.0 / k;
    return table;
}
/// 1/k, tabled: the recurrences would wait for each division.
constexpr Series per = inverses();

/// Σ a[i] b[k − i] for i from 0 to k: in four sums, as each addition waits for the one before it, and the newest
/// coefficients, a[k] and b[k], last.
double product(const Series& a, const Series& b, int k) {
    if (k == 0) return a[0] * b[0];
    double s0 = 0, s1 = 0, s2 = 0, s3 = 0;
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
double square(const Series& a, int k) {
    double s0 = 0, s1 = 0;
    int i = 0;
    for (; 2 * i + 2 < k; i += 2) {
        s0 += a[i] * a[k - i];
        s1 += a[i + 1] * a[k - i - 1];
    }
    if (2 * i < k) s0 += a[i] * a[k - i];
    return k % 2 == 0 ? 2 * (s0 + s1) + a[k / 2] * a[k / 2] : 2 * (s0 + s1);
}

/// Sine and cosine of a series: s′ = cθ′, c′ = −sθ′.
struct Turn {
    Series sine{}, cosine{};
    Series rate{};  ///< (k + 1) θₖ₊₁

    /// `rest` is the rounding error of the angle: after many turns it exceeds the rounding of its sine.
    void begin(double angle, double rest = 0) {
        const double s = std::sin(angle), c = std::cos(angle);
        sine[0] = s + rest * c;
        cosine[0] = c - rest * s;
    }
    void extend(const Series& angle, int k) {
        if (k == 0) return;
        rate[k - 1] = k * angle[k];
        sine[k] = product(rate, cosine, k - 1) * per[k];
        cosine[k] = -product(rate, sine, k - 1) * per[k];
    }
};

struct Builder {
    const ContactScene& scene;
    ContactMotion motion;
    ContactSeries& z;
    Turn psi{}, chi{};
    Series spin2{}, rate{}, other{}, spin_rate{};

    const Body<double>& body = scene.body;
    const bool sticks = motion == ContactMotion::sticking;
    const double smu = sticks ? 0 : scene.mu * sign_of(motion);
    const double kappa = scene.inertia_factor();
    const double rolling = -kappa / (1 + kappa), grip = 1 + 1 / kappa;  // of a disk: f/w_t, and u_t′ by f
    const double beta = body.beta, alpha = body.alpha;
    // Of an edge: the directions of its contacts from its middle, and about the container's centre its inertia, the
    // centre's share of what leans on it, Λ's factor and how friction divides between the two λ.
    const double c = std::cos(scene.half_chord), per_s = 1 / std::sin(scene.half_chord), d = body.outer;
    const double per_inertia = 1 / (body.inertia + d * d), lean_share = body.inertia * per_inertia;
    const double uneven = c - d * per_inertia, per_stiffness = 1 / (c + smu * smu * uneven);

    /// Orders k of the rates are known: the next of what they are the rates of.
    void integrate(int k, double psi_rate, double chi_rate, double ut_rate) {
        const double next = per[k + 1];
        z.psi[k + 1] = next * (psi_rate - (k == 0 ? 1 : 0));
        z.chi[k + 1] = next * chi_rate;
        z.ut[k + 1] = next * ut_rate;
        z.spin[k + 1] = next * spin_rate[k];
        z.turned[k + 1] = next * z.spin[k];
        if (scene.mu == 0) return;
        // A slip of zero is zero in every order.
        const double slip_power = sticks ? 0 : product(z.friction, z.ut, k);
        z.work[k + 1] = next * (slip_power - z.friction[k]);
    }

    void rim(int k) {
        psi.extend(z.psi, k);
        const double wn = beta * psi.cosine[k], wt = -beta * psi.sine[k];
        rate[k] = (z.ut[k] - alpha * z.spin[k]) * body.per_inner;
        z.normal[k] = wn + body.inner * square(rate, k);
        z.friction[k] = sticks ? rolling * wt : -smu * z.normal[k];
        spin_rate[k] = alpha * body.per_inertia * z.friction[k];
        integrate(k, rate[k], 0, sticks ? 0 : wt + z.friction[k] * grip);
    }

    void vertex(int k) {
        psi.extend(z.psi, k);
        chi.extend(z.chi, k);
        const double wn = beta * psi.cosine[k], wt = -beta * psi.sine[k];
        spin2[k] = square(z.spin, k);
        const double inward = alpha * product(spin2, chi.cosine, k), along = alpha * product(spin2, chi.sine, k);
        if (sticks) {
            // Its own turn alone: r_t w_n − r_n w_t, both of them products of series.
            const double torque = alpha * beta * (product(chi.sine, psi.cosine, k) + product(chi.cosine, psi.sine, k));
            spin_rate[k] = torque / (body.inertia + alpha * alpha);
            z.normal[k] = wn - alpha * product(spin_rate, chi.sine, k) - inward;
            z.friction[k] = -wt - alpha * product(spin_rate, chi.cosine, k) + along;
            return integrate(k, 0, z.spin[k], 0);
        }
        // S′ = αλ (sin χ − sμ cos χ)/I and B₂ − sμB₃ = 1 + (α²/I) sin χ (sin χ − sμ cos χ).
        other[k] = chi.sine[k] - smu * chi.cosine[k];
        z.stiffness[k] = (k == 0 ? 1 : 0) + alpha * alpha * body.per_inertia * product(chi.sine, other, k);
        double balance = wn + square(z.ut, k) - inward;
        z.normal[k] = 0;
        balance -= product(z.stiffness, z.normal, k);
        z.normal[k] = balance / z.stiffness[0];
        z.friction[k] = -smu * z.normal[k];
        spin_rate[k] = alpha * body.per_inertia * product(z.normal, other, k);
        integrate(k, z.ut[k], z.spin[k] - z.ut[k],
                  wt + z.friction[k] + alpha * product(spin_rate, chi.cosine, k) - along);
    }

    /// `psi` is ψ_c here: ψ and half the angle between the contacts. At rest nothing but ψ moves.
    void edge(int k) {
        psi.extend(z.psi, k);
        const double wn = beta * psi.cosine[k], wt = -beta * psi.sine[k];
        if (sticks) {
            z.friction[k] = -d * wt;
            return integrate(k, z.spin[k], 0, 0);
        }
        const double lean = -wt * lean_share;
        spin2[k] = square(z.spin, k);
        const double sum = (wn + d * spin2[k] - smu * lean) * per_stiffness;
        const double difference = (smu * sum * uneven + lean) * per_s;
        z.normal[k] = 0.5 * (sum + difference);
        z.second[k] = 0.5 * (sum - difference);
        z.friction[k] = -smu * sum;
        spin_rate[k] = (z.friction[k] + d * wt) * per_inertia;
        integrate(k, z.spin[k], 0, spin_rate[k]);
    }
};

}  // namespace

ContactSeries contact_series(const ContactScene& scene, Support support, ContactMotion motion,
                             const ContactState& start, double psi_rest) {
    ContactSeries series;
    series.psi[0] = start.psi;
    series.chi[0] = start.chi;
    series.ut[0] = start.ut;
    series.spin[0] = start.spin;
    Builder builder{scene, motion, series};
    builder.psi.begin(support == Support::edge ? start.psi + scene.half_chord : start.psi, psi_rest);
    builder.chi.begin(start.chi);
    for (int k = 0; k < order; ++k) {
        if (support == Support::rim)
            builder.rim(k);
        else if (support == Support::vertex)
            builder.vertex(k);
        else
            builder.edge(k);
    }
    return series;
}

double change_at(const Series& series, double t) {
    double sum = 0;
    for (int k = order; k >= 1; --k) sum = t * (series[k] + sum);
    return sum;
}

double value_at(const Series& series, double t) {
    return series[0] + change_at(series, t);
}

double derivative_at(const Series& series, double t) {
    double sum = 0;
    for (int k = order; k >= 1; --k) sum = k * series[k] + t * sum;
    return sum;
}

double bend_of(const Series& series, double t) {
    double sum = 0;
    for (int k = order; k >= 2; --k) sum = k * (k - 1) * std::abs(series[k]) + t * sum;
    return sum;
}

double reach_of(const Series& series, double t) {
    double sum = 0;
    for (int k = order; k >= 1; --k) sum = t * (std::abs(series[k]) + sum);
    return sum;
}

double step_of(const ContactSeries& z, double tolerance) {
    double last = 0, before = 0;
    for (const Series* series : {&z.psi, &z.chi, &z.ut, &z.spin, &z.turned, &z.work}) {
        const double scale = std::max(1.0, std::abs((*series)[0]));
        last = std::max(last, std::abs((*series)[order]) / scale);
        before = std::max(before, std::abs((*series)[order - 1]) / scale);
    }
    const auto limit = [&](double term, int k) {
        return term > 0 ? std::pow(tolerance / term, 1.0 / k) : std::numeric_limits<double>::infinity();
    };
    return std::min(limit(last, order), limit(before, order - 1));
}

}  // namespace swirl
