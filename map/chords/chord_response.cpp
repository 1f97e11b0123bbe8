#include "map/chords/chord_response.hpp"

#include "map/numbers/real.hpp"

#include <Eigen/LU>

#include <cmath>

namespace swirl {

namespace {

using Complex = std::complex<double>;
constexpr Complex i{0, 1};

/// cis x − 1 − ix and cis x − 1, without cancellation.
Complex cis_beyond_linear(double x) {
    constexpr double small = 0.1;
    if (std::abs(x) > small) return Complex(-2 * std::pow(std::sin(0.5 * x), 2), std::sin(x) - x);
    Complex sum = 0, term = -0.5 * x * x;
    for (int k = 3; std::abs(term) > 1e-18 * std::abs(sum); ++k) {
        sum += term;
        term *= i * x / static_cast<double>(k);
    }
    return sum;
}
Complex cis_minus_one(double x) {
    const double half = std::sin(0.5 * x);
    return {-2 * half * half, std::sin(x)};
}

/// The amplitudes of both components of a plane vector.
struct Components {
    Complex n, t;
};
Components operator+(const Components& a, const Components& b) {
    return {a.n + b.n, a.t + b.t};
}
/// A plane vector with a real, oscillating length: Re(length cis θ)·direction.
Components along(const Complex& length, const Complex& direction) {
    return {length * direction.real(), length * direction.imag()};
}
/// A vector that turns with the force: direction · cis θ.
Components turning(const Complex& direction) {
    return {direction, -i * direction};
}

/// A chord at a speed, and its linear step.
struct ChordStep {
    double alpha, kappa, v, a, tau, spin;
    Complex back;  ///< cis(−(π − 2a)): into the axes of the next impact

    ChordStep(const Scene<double>& scene, const Chord& chord, double speed)
        : alpha(scene.alpha),
          kappa(scene.inertia_factor),
          v(speed),
          a(chord.angle),
          tau(chord.length / speed),
          spin(-speed * std::sin(chord.angle) / scene.alpha),
          back(-std::cos(2 * chord.angle), -std::sin(2 * chord.angle)) {}

    /// The amplitudes after the next impact.
    struct Next {
        ChordDeviation after;
        Complex time, slip, chi;  ///< δτ, u_t before the impact, χ
    };

    ///   moved, sped  what the force adds to the position and to the velocity during the flight, in units of β cis θ
    Next operator()(const ChordDeviation& s, const Complex& moved, const Complex& sped) const {
        const Complex &psi = s[0], &chi = s[1], &wn = s[2], &wt = s[3], &turn = s[4];
        const Complex arm = i * alpha;
        const Components point = along(chi, arm - arm * back) + along(tau * wn, back) + along(tau * wt, i * back) +
                                 along(tau * turn, arm) + turning(back * moved);
        Next next;
        next.time = -point.n / (v * std::cos(a));
        const Complex& wall = point.t;
        next.chi = chi + tau * turn + spin * next.time - wall;
        const Components w =
            along(wn, back) + along(wt, i * back) + turning(back * sped) + along(wall, -i * std::polar(v, a));
        next.slip = w.t + alpha * turn;
        const double p0 = 2 * v * std::cos(a);
        const Complex p = 2.0 * (w.n - spin * alpha * next.chi);
        const Complex q = -(kappa * next.slip + p0 * next.chi) / (1 + kappa);
        next.after << psi + wall - next.time, next.chi, w.n - p, w.t + q, turn + (q + p0 * next.chi) / (kappa * alpha);
        return next;
    }
};

/// The mean over θ of Re(x cis θ) Re(y cis θ).
double mean_of_product(const Complex& x, const Complex& y) {
    return 0.5 * std::real(x * std::conj(y));
}

}  // namespace

Eigen::Matrix<double, 5, 5> chord_derivative(const Scene<double>& scene, const Chord& chord, double v) {
    const ChordStep step(scene, chord, v);
    Eigen::Matrix<double, 5, 5> m;
    for (int k = 0; k < 5; ++k) m.col(k) = step(ChordDeviation::Unit(k), 0, 0).after.real();
    return m;
}

ChordResponse chord_response(const Scene<double>& scene, const Chord& chord, double v) {
    using Matrix5 = Eigen::Matrix<Complex, 5, 5>;
    const ChordStep step(scene, chord, v);
    const Complex moved = -cis_beyond_linear(step.tau), sped = -i * cis_minus_one(step.tau);
    const Complex lambda = std::polar(1.0, step.tau) * step.back;
    const Matrix5 m = chord_derivative(scene, chord, v).cast<Complex>();
    ChordResponse response;
    const ChordDeviation drive = step(ChordDeviation::Zero(), moved, sped).after;
    const ChordDeviation& s = response.amplitude =
        Matrix5(lambda * Matrix5::Identity() - m).partialPivLu().solve(drive);
    const auto next = step(s, moved, sped);
    const Complex along_chord = std::polar(v, -(pi<double>() - step.a));  // the conjugate of w
    response.work = mean_of_product(s[2], sped) + mean_of_product(s[3], -i * sped) +
                    mean_of_product(next.time, along_chord * std::polar(1.0, step.tau)) +
                    mean_of_product(-s[0], i * along_chord * sped) + 0.5 * std::norm(sped);
    const double per_b1 = step.kappa / (1 + step.kappa);
    response.loss = 0.5 * per_b1 * mean_of_product(next.slip, next.slip);
    if (scene.law == Law::newton)
        response.loss += per_b1 * v * std::cos(step.a) / step.kappa * mean_of_product(next.slip, next.chi);
    return response;
}

double chord_resonance(const Chord& chord) {
    return chord.length / (pi<double>() - 2 * chord.angle);
}

}  // namespace swirl
