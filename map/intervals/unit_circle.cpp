#include "map/intervals/unit_circle.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>

namespace swirl::intervals {

RunningMatrix product(const RunningMatrix& a, const RunningMatrix& b) {
    RunningMatrix result(a.size(), std::vector<Curved<1>>(a.size()));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < a.size(); ++j)
            for (std::size_t l = 0; l < a.size(); ++l) result[i][j] += a[i][l] * b[l][j];
    return result;
}

CurvedMatrix with_second_variable(const RunningMatrix& matrix) {
    CurvedMatrix result;
    for (const auto& row : matrix) {
        auto& widened = result.emplace_back();
        for (const Curved<1>& x : row) {
            Curved<2>& y = widened.emplace_back(x.mid);
            y.by[0] = x.by[0];
            y.two[Curved<2>::place(0, 0)] = x.two[0];
            y.rest = x.rest;
        }
    }
    return result;
}

namespace {

using Turning = Curved<3>;  ///< by both numbers and θ
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

struct Complex {
    Turning re, im;
};
Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
Complex operator-(const Complex& a, const Complex& b) {
    return {a.re - b.re, a.im - b.im};
}
Complex operator+(const Complex& a, const Complex& b) {
    return {a.re + b.re, a.im + b.im};
}
Complex operator/(const Complex& a, const Complex& b) {
    const Turning one_over = Turning(1) / (square(b.re) + square(b.im));
    return {(a.re * b.re + a.im * b.im) * one_over, (a.im * b.re - a.re * b.im) * one_over};
}
using Matrix = std::vector<std::vector<Complex>>;

/// A and B, over the ranges or in their middle.
struct Pencil {
    std::vector<std::vector<Turning>> a, b;
    std::size_t size() const { return a.size(); }
};

Turning turning(const Curved<2>& x, bool at_middle) {
    Turning result(x.mid);
    if (at_middle) return result;
    result.by = {x.by[0], x.by[1], 0};
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = i; j < 2; ++j) result.two[Turning::place(i, j)] = x.two[Curved<2>::place(i, j)];
    result.rest = x.rest;
    return result;
}

Pencil pencil_of(const CurvedMatrix& a, const CurvedMatrix& b, bool at_middle) {
    const std::size_t n = a.size();
    Pencil pencil{std::vector(n, std::vector<Turning>(n)), std::vector(n, std::vector<Turning>(n))};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            pencil.a[i][j] = turning(a[i][j], at_middle);
            pencil.b[i][j] = turning(b[i][j], at_middle);
        }
    return pencil;
}

/// C and R with C(A + zB)R diagonal for all z, in the middle and roughly: with K = (A + σB)⁻¹B = RΛR⁻¹ and
/// C = R⁻¹(A + σB)⁻¹ it is 1 + (z − σ)Λ. Not finite where that fails.
struct Basis {
    Eigen::MatrixXcd left, right;
};
Basis basis_of(const Pencil& middle) {
    const auto n = static_cast<Eigen::Index>(middle.size());
    constexpr double shift = 0.3;  // no multiplier is exactly that
    Eigen::MatrixXd shifted(n, n), second(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) {
            const auto k = static_cast<std::size_t>(i), l = static_cast<std::size_t>(j);
            second(i, j) = middle.b[k][l].mid;
            shifted(i, j) = middle.a[k][l].mid + shift * second(i, j);
        }
    const Eigen::MatrixXd inverse = shifted.partialPivLu().inverse();
    Basis basis{Eigen::MatrixXcd::Constant(n, n, nan_value), Eigen::MatrixXcd::Constant(n, n, nan_value)};
    if (!inverse.allFinite()) return basis;
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(inverse * second);
    if (solver.info() != Eigen::Success) return basis;
    basis.right = solver.eigenvectors();
    basis.left = basis.right.inverse() * inverse.cast<std::complex<double>>();
    return basis;
}

/// C M R.
Matrix transformed(const std::vector<std::vector<Turning>>& m, const Basis& basis) {
    const std::size_t n = m.size();
    const auto number = [](const Eigen::MatrixXcd& from, std::size_t i, std::size_t j) {
        const std::complex<double> z = from(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        return Complex{Turning(z.real()), Turning(z.imag())};
    };
    Matrix half(n, std::vector<Complex>(n)), whole = half;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t k = 0; k < n; ++k) {
                const Complex c = number(basis.left, i, k);
                half[i][j] = half[i][j] + Complex{c.re * m[k][j], c.im * m[k][j]};
            }
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t k = 0; k < n; ++k) whole[i][j] = whole[i][j] + half[i][k] * number(basis.right, k, j);
    return whole;
}

/// A + zB in that basis.
struct Diagonalised {
    Matrix a, b;
    Matrix at(const Complex& z) const {
        Matrix m = a;
        for (std::size_t i = 0; i < m.size(); ++i)
            for (std::size_t j = 0; j < m.size(); ++j) m[i][j] = m[i][j] + z * b[i][j];
        return m;
    }
};

/// It lies on one side of a line through 0, so that its angle changes by less than π.
bool keeps_to_one_side(const Complex& pivot) {
    const auto clear = [](const Turning& x) { return is_positive(x) || is_negative(x); };
    return clear(pivot.re) || clear(pivot.im) || clear(pivot.re + pivot.im) || clear(pivot.re - pivot.im);
}

/// The pivots of Gauss' elimination; nothing where one may be 0.
std::optional<std::vector<Complex>> pivots_of(Matrix m) {
    const std::size_t n = m.size();
    std::vector<Complex> pivots;
    for (std::size_t k = 0; k < n; ++k) {
        if (!keeps_to_one_side(m[k][k])) return std::nullopt;
        pivots.push_back(m[k][k]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const Complex factor = m[i][k] / m[k][k];
            for (std::size_t j = k + 1; j < n; ++j) m[i][j] = m[i][j] - factor * m[k][j];
        }
    }
    return pivots;
}

Complex on_circle(const Turning& angle) {
    const auto at = sine_cosine(angle);
    return {at.cosine, at.sine};
}

/// By how much the determinant turns as θ goes from one to the other; nothing where it may be 0.
std::optional<double> turned(const Diagonalised& all, const Diagonalised& middle, double from, double to) {
    if (!pivots_of(all.at(on_circle(Turning::variable(from, to, 2))))) return std::nullopt;
    // The matrices in the middle are among all, and what does not vanish has the same number of turns for all.
    const auto start = pivots_of(middle.at(on_circle(Turning(from))));
    const auto end = pivots_of(middle.at(on_circle(Turning(to))));
    if (!start || !end) return std::nullopt;
    double angle = 0;
    for (std::size_t i = 0; i < start->size(); ++i) {
        const std::complex<double> first((*start)[i].re.mid, (*start)[i].im.mid);
        const std::complex<double> last((*end)[i].re.mid, (*end)[i].im.mid);
        angle += std::arg(last / first);
    }
    return angle;
}

}  // namespace

std::optional<int> zeros_inside(const CurvedMatrix& a, const CurvedMatrix& b) {
    constexpr int begin = 6, most = 150;
    const Pencil over = pencil_of(a, b, false), at_middle = pencil_of(a, b, true);
    const Basis basis = basis_of(at_middle);
    if (!basis.left.allFinite() || !basis.right.allFinite()) return std::nullopt;
    const Diagonalised all{transformed(over.a, basis), transformed(over.b, basis)};
    const Diagonalised middle{transformed(at_middle.a, basis), transformed(at_middle.b, basis)};
    const double pi_up = upper(pi_ball());
    std::vector<std::pair<double, double>> waiting;
    for (int k = begin; k-- > 0;) waiting.emplace_back(pi_up * k / begin, pi_up * (k + 1) / begin);
    double sum = 0;
    for (int looked = 0; !waiting.empty(); ++looked) {
        if (looked > most) return std::nullopt;
        const auto [from, to] = waiting.back();
        waiting.pop_back();
        if (const auto angle = turned(all, middle, from, to)) {
            sum += *angle;
            continue;
        }
        if (to - from < 1e-4) return std::nullopt;
        const double half = 0.5 * (from + to);
        waiting.emplace_back(half, to);
        waiting.emplace_back(from, half);
    }
    // Of real matrices the lower half circle turns it as far as the upper.
    const double count = sum / pi_up, whole = std::round(count);
    if (!(std::abs(count - whole) < 0.01) || whole < 0) return std::nullopt;
    return static_cast<int>(whole);
}

}  // namespace swirl::intervals
