#include "map/intervals/eigenvalue_discs.hpp"

#include "map/intervals/arb.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace swirl::intervals {

namespace {

/// A matrix of complex balls that clears itself.
struct ComplexMatrix {
    acb_mat_t m;
    explicit ComplexMatrix(std::size_t n) { acb_mat_init(m, static_cast<slong>(n), static_cast<slong>(n)); }
    ComplexMatrix(const ComplexMatrix&) = delete;
    ComplexMatrix& operator=(const ComplexMatrix&) = delete;
    ~ComplexMatrix() { acb_mat_clear(m); }
};

struct ComplexVector {
    acb_ptr v;
    slong size;
    explicit ComplexVector(std::size_t n) : v(_acb_vec_init(static_cast<slong>(n))), size(static_cast<slong>(n)) {}
    ComplexVector(const ComplexVector&) = delete;
    ComplexVector& operator=(const ComplexVector&) = delete;
    ~ComplexVector() { _acb_vec_clear(v, size); }
};

void fill(ComplexMatrix& to, const std::vector<BallVector>& from) {
    for (std::size_t i = 0; i < from.size(); ++i)
        for (std::size_t j = 0; j < from.size(); ++j) {
            acb_ptr entry = acb_mat_entry(to.m, static_cast<slong>(i), static_cast<slong>(j));
            arb_set(acb_realref(entry), from[i][j].raw());
        }
}

double up(double x) {
    return std::nextafter(x, std::numeric_limits<double>::infinity());
}

/// A disc about a complex ball, its centre rounded to doubles.
Disc disc_about(acb_srcptr ball, double more) {
    Ball re, im;
    arb_set(re.raw(), acb_realref(ball));
    arb_set(im.raw(), acb_imagref(ball));
    Disc disc{middle(re), middle(im), 0};
    const double across = upper(abs(re - Ball(disc.re))), along = upper(abs(im - Ball(disc.im)));
    disc.radius = up(up(std::hypot(across, along) * (1 + 1e-15)) + more);
    if (!std::isfinite(disc.radius)) disc = {0, 0, std::numeric_limits<double>::infinity()};
    return disc;
}

bool meet(const Disc& a, const Disc& b) {
    return std::hypot(a.re - b.re, a.im - b.im) * (1 - 1e-15) <= up(a.radius + b.radius);
}

/// One disc about two.
Disc around_both(const Disc& a, const Disc& b) {
    Disc both{0.5 * (a.re + b.re), 0.5 * (a.im + b.im), 0};
    for (const Disc& disc : {a, b})
        both.radius = std::max(both.radius, up(std::hypot(both.re - disc.re, both.im - disc.im) * (1 + 1e-15)) +
                                                disc.radius * (1 + 1e-15));
    return both;
}

/// Discs that meet become one, until none meet: as often as it counts.
std::vector<Disc> with_common_discs(std::vector<Disc> discs) {
    std::vector<std::pair<Disc, std::size_t>> groups;
    for (const Disc& disc : discs) groups.emplace_back(disc, 1);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < groups.size() && !changed; ++i)
            for (std::size_t j = i + 1; j < groups.size() && !changed; ++j) {
                if (!meet(groups[i].first, groups[j].first)) continue;
                groups[i] = {around_both(groups[i].first, groups[j].first), groups[i].second + groups[j].second};
                groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(j));
                changed = true;
            }
    }
    discs.clear();
    for (const auto& [disc, count] : groups) discs.insert(discs.end(), count, disc);
    return discs;
}

/// The matrix is real: a disc that its mirror image alone meets holds a real eigenvalue.
void put_on_axis(std::vector<Disc>& discs) {
    for (std::size_t i = 0; i < discs.size(); ++i) {
        if (discs[i].im == 0 || std::abs(discs[i].im) > discs[i].radius) continue;
        const Disc wide{discs[i].re, 0, up(discs[i].radius + std::abs(discs[i].im))};
        bool alone = true;
        for (std::size_t j = 0; j < discs.size(); ++j) alone = alone && (j == i || !meet(wide, discs[j]));
        if (alone) discs[i] = wide;
    }
}

void sort_by_modulus(std::vector<Disc>& discs) {
    std::sort(discs.begin(), discs.end(), [](const Disc& a, const Disc& b) {
        const double left = std::hypot(a.re, a.im), right = std::hypot(b.re, b.im);
        if (std::abs(left - right) > 1e-13 * (left + right)) return left > right;
        return a.im > b.im;
    });
}

/// Gershgorin's discs of R⁻¹ A R; empty if R has no inverse.
std::vector<Disc> gershgorin(const ComplexMatrix& a, const ComplexMatrix& vectors, std::size_t n) {
    ComplexMatrix inverse(n), product(n);
    if (acb_mat_inv(inverse.m, vectors.m, ball_precision) == 0) return {};
    acb_mat_mul(product.m, a.m, vectors.m, ball_precision);
    acb_mat_mul(product.m, inverse.m, product.m, ball_precision);
    std::vector<Disc> discs;
    for (std::size_t i = 0; i < n; ++i) {
        Ball reach, size;
        for (std::size_t j = 0; j < n; ++j) {
            if (j == i) continue;
            acb_abs(size.raw(), acb_mat_entry(product.m, static_cast<slong>(i), static_cast<slong>(j)), ball_precision);
            reach += size;
        }
        if (!is_finite(reach)) return {};
        discs.push_back(
            disc_about(acb_mat_entry(product.m, static_cast<slong>(i), static_cast<slong>(i)), upper(reach)));
    }
    return discs;
}

/// All eigenvalues lie within a norm of 0.
std::vector<Disc> within_norm(const std::vector<BallVector>& matrix) {
    Ball largest;
    for (const BallVector& row : matrix)
        for (const Ball& entry : row) largest += abs(entry);
    return std::vector<Disc>(matrix.size(), Disc{0, 0, upper(largest)});
}

}  // namespace

double Disc::least_modulus() const {
    return std::max(0.0, std::hypot(re, im) * (1 - 1e-15) - radius * (1 + 1e-15));
}
double Disc::largest_modulus() const {
    return std::hypot(re, im) * (1 + 1e-15) + radius * (1 + 1e-15);
}

std::vector<Disc> eigenvalue_discs(const std::vector<BallVector>& matrix) {
    const std::size_t n = matrix.size();
    ComplexMatrix a(n), rough(n), vectors(n);
    fill(a, matrix);
    acb_mat_get_mid(rough.m, a.m);
    ComplexVector values(n);
    std::vector<Disc> discs;
    if (acb_mat_approx_eig_qr(values.v, nullptr, vectors.m, rough.m, nullptr, 0, ball_precision) != 0) {
        acb_mat_get_mid(vectors.m, vectors.m);
        discs = gershgorin(a, vectors, n);
    }
    if (discs.empty()) return within_norm(matrix);
    discs = with_common_discs(discs);
    put_on_axis(discs);
    sort_by_modulus(discs);
    return discs;
}

std::vector<Disc> eigenvalue_discs_by_arb(const std::vector<BallVector>& matrix) {
    const std::size_t n = matrix.size();
    ComplexMatrix a(n), rough(n), vectors(n);
    fill(a, matrix);
    acb_mat_get_mid(rough.m, a.m);
    ComplexVector approximate(n), enclosed(n);
    acb_mat_approx_eig_qr(approximate.v, nullptr, vectors.m, rough.m, nullptr, 0, ball_precision);
    if (acb_mat_eig_multiple(enclosed.v, a.m, approximate.v, vectors.m, ball_precision) == 0) return {};
    std::vector<Disc> discs;
    for (std::size_t i = 0; i < n; ++i) discs.push_back(disc_about(enclosed.v + i, 0));
    sort_by_modulus(discs);
    return discs;
}

}  // namespace swirl::intervals
