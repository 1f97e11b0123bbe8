#include "map/intervals/bifurcation_point.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace swirl::intervals {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Row = std::vector<std::pair<std::size_t, Ball>>;

/// q at first, as u + iv, and θ.
struct Direction {
    VectorXd u, v;
    double angle = 0;
};

/// M(1) without its closing entries, and those.
struct Split {
    MatrixXd open, closing;
};
Split split(const SecondOrder& at) {
    const auto n = static_cast<Index>(at.values.size());
    Split parts{MatrixXd::Zero(n, n), MatrixXd::Zero(n, n)};
    for (Index row = 0; row < n; ++row)
        for (const DependentEntry& entry : at.rows[static_cast<std::size_t>(row)]) {
            const auto column = static_cast<Index>(entry.column);
            if (column < n) (entry.closing ? parts.closing : parts.open)(row, column) += middle(entry.value);
        }
    return parts;
}

/// The multiplier with positive imaginary part that lies nearest to the unit circle: of (A + λB) q = 0,
/// (A + B)⁻¹ B q = q/(1 − λ).
std::optional<Direction> complex_direction(const Split& parts) {
    const MatrixXd shifted = (parts.open + parts.closing).partialPivLu().solve(parts.closing);
    if (!shifted.allFinite()) return std::nullopt;
    const Eigen::EigenSolver<MatrixXd> solver(shifted);
    if (solver.info() != Eigen::Success) return std::nullopt;
    std::optional<Direction> best;
    double least = 0.1;
    for (Index i = 0; i < shifted.rows(); ++i) {
        const std::complex<double> value = solver.eigenvalues()[i];
        if (std::abs(value) < 1e-12) continue;
        const std::complex<double> multiplier = 1.0 - 1.0 / value;
        const double off = std::abs(std::abs(multiplier) - 1);
        if (!(multiplier.imag() > 1e-9) || !(off < least)) continue;
        least = off;
        const Eigen::VectorXcd vector = solver.eigenvectors().col(i);
        best = Direction{vector.real() / vector.norm(), vector.imag() / vector.norm(), std::arg(multiplier)};
    }
    return best;
}

std::optional<Direction> first_direction(const SecondOrder& at, BifurcationKind kind) {
    const Split parts = split(at);
    if (!parts.open.allFinite() || !parts.closing.allFinite()) return std::nullopt;
    if (kind == BifurcationKind::neimark_sacker) return complex_direction(parts);
    const double lambda = kind == BifurcationKind::fold ? 1 : -1;
    const Eigen::JacobiSVD<MatrixXd> svd(parts.open + lambda * parts.closing, Eigen::ComputeFullV);
    const VectorXd u = svd.matrixV().col(svd.matrixV().cols() - 1);
    return Direction{u, VectorXd::Zero(u.size()), 0};
}

/// ‖I − C A‖ < 1 for the inverse C of the middle, so that every matrix in A has an inverse.
bool is_regular(const Linearisation& matrix) {
    const MatrixXd inverse = approximate_inverse(matrix);
    if (!inverse.allFinite()) return false;
    const std::size_t n = matrix.rows.size();
    for (std::size_t i = 0; i < n; ++i) {
        BallVector left(n);
        left[i] = Ball(1);
        for (std::size_t j = 0; j < n; ++j) {
            const Ball factor(-inverse(static_cast<Index>(i), static_cast<Index>(j)));
            for (const auto& [column, entry] : matrix.rows[j]) left[column].add_product(factor, entry);
        }
        Ball sum;
        for (const Ball& x : left) sum += abs(x);
        if (!(upper(sum) < 1)) return false;
    }
    return true;
}

/// Unknowns: x, p, q (of a complex pair its real parts, then its imaginary ones, then θ).
class ExtendedSystem {
public:
    ExtendedSystem(const SecondOrderSystem& system, BifurcationKind kind, const Direction& first)
        : system_(system), kind_(kind), first_(first), n_(static_cast<std::size_t>(first.u.size())) {}

    Linearisation at(const BallVector& y) const {
        const SecondOrder inner = system_(BallVector(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(n_ + 1)));
        Linearisation result;
        result.values = inner.values;
        for (const auto& entries : inner.rows) {
            Row row;
            for (const DependentEntry& entry : entries) row.emplace_back(entry.column, entry.value);
            result.rows.push_back(std::move(row));
        }
        for (const bool imaginary : {false, true}) {
            if (imaginary && !is_complex()) break;
            for (const auto& entries : inner.rows) add_direction_row(entries, y, imaginary, result);
        }
        add_norm(y, result);
        return result;
    }

    /// By q and λ: at a multiplier that is simple it has an inverse.
    Linearisation bordered(const BallVector& y) const {
        const SecondOrder inner = system_(BallVector(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(n_ + 1)));
        const Linearisation all = at(y);
        Linearisation result;
        const std::size_t parts = is_complex() ? 2 : 1;
        for (std::size_t i = n_; i < all.rows.size(); ++i) {
            Row row;
            for (const auto& [column, entry] : all.rows[i])
                if (column > n_) row.emplace_back(column - (n_ + 1), entry);
            if (i - n_ < parts * n_) {  // by |λ|, of a real one by λ, but for its sign
                const auto& entries = inner.rows[(i - n_) % n_];
                for (const DependentEntry& entry : entries)
                    if (entry.closing)
                        row.emplace_back(all.rows.size() - n_ - 1, entry.value * turned(entry, y, i >= 2 * n_));
            }
            result.rows.push_back(std::move(row));
        }
        return result;
    }

    /// ∂_x G.
    Linearisation by_state(const BallVector& y) const {
        const Linearisation all = at(y);
        Linearisation result;
        for (std::size_t i = 0; i < n_; ++i) {
            Row row;
            for (const auto& [column, entry] : all.rows[i])
                if (column < n_) row.emplace_back(column, entry);
            result.rows.push_back(std::move(row));
        }
        return result;
    }

    bool is_complex() const { return kind_ == BifurcationKind::neimark_sacker; }
    std::size_t angle_place() const { return 3 * n_ + 1; }

private:
    struct Factor {
        Ball cosine, sine;
    };
    Factor multiplier(const BallVector& y) const {
        if (!is_complex()) return {Ball(kind_ == BifurcationKind::fold ? 1 : -1), Ball(0)};
        auto at = sine_cosine(y[angle_place()]);
        return {std::move(at.cosine), std::move(at.sine)};
    }
    const Ball& real(const BallVector& y, std::size_t column) const { return y[n_ + 1 + column]; }
    Ball imaginary(const BallVector& y, std::size_t column) const {
        return is_complex() ? y[2 * n_ + 1 + column] : Ball(0);
    }
    /// What an entry multiplies in M(λ) q: its part of q, of a closing one of λq.
    Ball turned(const DependentEntry& entry, const BallVector& y, bool imaginary_part) const {
        const Ball& u = real(y, entry.column);
        const Ball v = imaginary(y, entry.column);
        if (!entry.closing) return imaginary_part ? v : u;
        const Factor factor = multiplier(y);
        return imaginary_part ? factor.sine * u + factor.cosine * v : factor.cosine * u - factor.sine * v;
    }

    /// A row of M(λ) q, its real or its imaginary part.
    void add_direction_row(const std::vector<DependentEntry>& entries, const BallVector& y, bool imaginary_part,
                           Linearisation& result) const {
        const Factor factor = multiplier(y);
        Ball value;
        Row row;
        for (const DependentEntry& entry : entries) {
            if (entry.column == n_) continue;
            const Ball part = turned(entry, y, imaginary_part);
            value.add_product(entry.value, part);
            for (const auto& [column, slope] : entry.by) row.emplace_back(column, slope * part);
            const std::size_t own = (imaginary_part ? 2 * n_ : n_) + 1 + entry.column;
            const std::size_t other = (imaginary_part ? n_ : 2 * n_) + 1 + entry.column;
            row.emplace_back(own, entry.closing ? entry.value * factor.cosine : entry.value);
            if (!entry.closing || !is_complex()) continue;
            const Ball across = entry.value * factor.sine;
            row.emplace_back(other, imaginary_part ? across : -across);
            const Ball turn = turned(entry, y, !imaginary_part);  // ∂_θ λq = iλq
            row.emplace_back(angle_place(), entry.value * (imaginary_part ? turn : -turn));
        }
        result.values.push_back(std::move(value));
        result.rows.push_back(std::move(row));
    }

    /// l·q = 1, l the conjugate of the q at first.
    void add_norm(const BallVector& y, Linearisation& result) const {
        Ball along(-1), across;
        Row along_row, across_row;
        for (std::size_t i = 0; i < n_; ++i) {
            const Ball u0(first_.u[static_cast<Index>(i)]), v0(first_.v[static_cast<Index>(i)]);
            const Ball &u = real(y, i), v = imaginary(y, i);
            along += u0 * u + v0 * v;
            along_row.emplace_back(n_ + 1 + i, u0);
            if (!is_complex()) continue;
            across += u0 * v - v0 * u;
            along_row.emplace_back(2 * n_ + 1 + i, v0);
            across_row.emplace_back(2 * n_ + 1 + i, u0);
            across_row.emplace_back(n_ + 1 + i, -v0);
        }
        result.values.push_back(std::move(along));
        result.rows.push_back(std::move(along_row));
        if (!is_complex()) return;
        result.values.push_back(std::move(across));
        result.rows.push_back(std::move(across_row));
    }

    const SecondOrderSystem& system_;
    BifurcationKind kind_;
    const Direction& first_;
    std::size_t n_;
};

/// Newton's method. @return whether it converges
bool settle(const ExtendedSystem& system, std::vector<double>& y) {
    constexpr int most = 12;
    double moved = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most && moved > 1e-13; ++k) {
        const Linearisation at = system.at(BallVector(y.begin(), y.end()));
        const MatrixXd inverse = approximate_inverse(at);
        VectorXd values(static_cast<Index>(y.size()));
        for (std::size_t i = 0; i < y.size(); ++i) values[static_cast<Index>(i)] = middle(at.values[i]);
        const VectorXd change = inverse * values;
        if (!change.allFinite() || change.lpNorm<Eigen::Infinity>() > 1) return false;
        moved = change.lpNorm<Eigen::Infinity>();
        for (std::size_t i = 0; i < y.size(); ++i) y[i] -= change[static_cast<Index>(i)];
    }
    return moved < 1e-8;
}

/// A box about y with exactly one zero; nothing where none is mapped into itself.
std::optional<BallVector> box_of_zero(const BallSystem& system, const std::vector<double>& y) {
    const BallVector centre(y.begin(), y.end());
    const MatrixXd inverse = approximate_inverse(system(centre));
    if (!inverse.allFinite()) return std::nullopt;
    for (const double radius : {1e-9, 1e-10, 1e-11, 1e-12, 1e-13}) {
        std::vector<double> radii;
        for (const double x : y) radii.push_back(radius * std::max(1.0, std::abs(x)));
        BallVector box = boxes(centre, radii);
        if (lies_inside(krawczyk_image(system, centre, box, inverse), box)) return box;
    }
    return std::nullopt;
}

}  // namespace

std::optional<BifurcationPoint> bifurcation_point(const SecondOrderSystem& system, BifurcationKind kind,
                                                  const std::vector<double>& near) {
    const auto first = first_direction(system(BallVector(near.begin(), near.end())), kind);
    if (!first) return std::nullopt;
    const ExtendedSystem extended(system, kind, *first);
    std::vector<double> y = near;
    y.insert(y.end(), first->u.begin(), first->u.end());
    if (extended.is_complex()) {
        y.insert(y.end(), first->v.begin(), first->v.end());
        y.push_back(first->angle);
    }
    if (!settle(extended, y)) return std::nullopt;
    const BallSystem equations = [&extended](const BallVector& box) { return extended.at(box); };
    const auto box = box_of_zero(equations, y);
    if (!box || !is_regular(extended.bordered(*box))) return std::nullopt;
    if (kind != BifurcationKind::fold && !is_regular(extended.by_state(*box))) return std::nullopt;
    const BallVector zero = narrowed(equations, *box);
    BifurcationPoint point;
    point.unknowns.assign(zero.begin(), zero.begin() + static_cast<std::ptrdiff_t>(near.size()));
    if (!extended.is_complex()) return point;
    point.angle = zero[extended.angle_place()];
    if (!is_positive(point.angle) || !is_positive(pi_ball() - point.angle)) return std::nullopt;
    return point;
}

}  // namespace swirl::intervals
