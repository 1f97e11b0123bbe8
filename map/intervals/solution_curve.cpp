#include "map/intervals/solution_curve.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace swirl::intervals {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<Running> as_running(const std::vector<double>& x) {
    return {x.begin(), x.end()};
}

/// The place of a column in a matrix without that of the running unknown.
Index without(std::size_t running, std::size_t column) {
    return static_cast<Index>(column < running ? column : column - 1);
}

/// ∂_x G to second order in e, and ∂G by the running unknown in the middle.
struct Derivative {
    std::array<MatrixXd, 3> by_order;
    VectorXd by_running;
};
Derivative derivative_of(const CurveLinearisation& at, std::size_t running) {
    const auto n = static_cast<Index>(at.values.size());
    Derivative result{{MatrixXd::Zero(n, n), MatrixXd::Zero(n, n), MatrixXd::Zero(n, n)}, VectorXd::Zero(n)};
    for (Index row = 0; row < n; ++row)
        for (const auto& [column, entry] : at.rows[static_cast<std::size_t>(row)]) {
            if (column == running) {
                result.by_running[row] += entry.mid;
                continue;
            }
            const Index place = without(running, column);
            result.by_order[0](row, place) += entry.mid;
            result.by_order[1](row, place) += entry.by[0];
            result.by_order[2](row, place) += entry.two[0];
        }
    return result;
}

/// Newton's method with the running unknown fixed. @return whether it converges
bool settle(const CurveSystem& system, std::size_t running, std::vector<double>& x) {
    constexpr int most = 10;
    double moved = 1;
    for (int k = 0; k < most && moved > 1e-14; ++k) {
        const CurveLinearisation at = system(as_running(x));
        const Derivative derivative = derivative_of(at, running);
        VectorXd values(static_cast<Index>(at.values.size()));
        for (std::size_t i = 0; i < at.values.size(); ++i) values[static_cast<Index>(i)] = at.values[i].mid;
        const VectorXd change = derivative.by_order[0].partialPivLu().solve(values);
        if (!change.allFinite() || change.lpNorm<Eigen::Infinity>() > 0.5) return false;
        moved = change.lpNorm<Eigen::Infinity>();
        for (std::size_t i = 0; i < x.size(); ++i)
            if (i != running) x[i] -= change[without(running, i)];
    }
    return moved < 1e-9;
}

/// C(e) ≈ (∂_x G)⁻¹, a polynomial in e.
struct Inverse {
    std::array<MatrixXd, 3> by_order;
    Running entry(Index i, Index j) const {
        Running x(by_order[0](i, j));
        x.by[0] = by_order[1](i, j);
        x.two[0] = by_order[2](i, j);
        return x;
    }
    bool is_finite() const {
        return std::all_of(by_order.begin(), by_order.end(), [](const MatrixXd& m) { return m.allFinite(); });
    }
};
Inverse inverse_of(const Derivative& derivative) {
    const auto& [d0, d1, d2] = derivative.by_order;
    const MatrixXd c0 = d0.partialPivLu().inverse(), c1 = -c0 * d1 * c0;
    return {{c0, c1, -c0 * d2 * c0 - c1 * d1 * c0}};
}

/// |C G| + |I − C ∂_x G| width, unknown by unknown.
std::vector<double> image_of(const std::vector<Running>& at_centre, const CurveLinearisation& over, std::size_t running,
                             const std::vector<double>& width) {
    const Inverse inverse = inverse_of(derivative_of(over, running));
    const auto n = static_cast<Index>(at_centre.size());
    std::vector<double> image(width.size(), 0.0);
    if (!inverse.is_finite()) return {};
    for (std::size_t i = 0; i < width.size(); ++i) {
        if (i == running) continue;
        Running moved;
        std::vector<Running> left(width.size());
        left[i] = Running(1);
        for (Index row = 0; row < n; ++row) {
            const Running factor = inverse.entry(without(running, i), row);
            const auto at = static_cast<std::size_t>(row);
            moved += factor * at_centre[at];
            for (const auto& [column, entry] : over.rows[at])
                if (column != running) left[column] -= factor * entry;
        }
        double sum = largest(moved);
        for (std::size_t k = 0; k < width.size(); ++k)
            if (k != running) sum = detail::at_least(sum + largest(left[k]) * width[k]);
        if (!std::isfinite(sum)) return {};
        image[i] = sum;
    }
    return image;
}

bool is_inside(const std::vector<double>& image, const std::vector<double>& width, std::size_t running) {
    for (std::size_t i = 0; i < image.size(); ++i)
        if (i != running && !(image[i] < width[i])) return false;
    return !image.empty();
}

double size_of(double x) {
    return std::max(1.0, std::abs(x));
}

/// The parabola's coefficients: the curve's tangent and what the line leaves of second order.
void bend(const CurveSystem& system, CurvePiece& piece) {
    const double half = tube(piece, piece.near)[piece.running].by[0];
    const std::vector<double> tangent = direction_at(system, piece.middle, piece.running);
    if (tangent.empty()) return;
    for (std::size_t i = 0; i < tangent.size(); ++i) piece.slope[i] = i == piece.running ? 0 : tangent[i] * half;
    const CurveLinearisation line = system(centre_of(piece));
    VectorXd second(static_cast<Index>(line.values.size()));
    for (std::size_t i = 0; i < line.values.size(); ++i) second[static_cast<Index>(i)] = line.values[i].two[0];
    const VectorXd bent = derivative_of(line, piece.running).by_order[0].partialPivLu().solve(second);
    if (!bent.allFinite()) return;
    for (std::size_t i = 0; i < piece.curvature.size(); ++i)
        if (i != piece.running) piece.curvature[i] = -bent[without(piece.running, i)];
}

/// A domain that Krawczyk's operator maps into itself. @return whether there is one
bool enclose(const CurveSystem& system, CurvePiece& piece) {
    const std::vector<Running> at_centre = system(centre_of(piece)).values;
    const std::vector<double> none(piece.middle.size(), 0.0);
    std::vector<double> width = image_of(at_centre, system(centre_of(piece)), piece.running, none);
    if (width.empty()) return false;
    for (std::size_t i = 0; i < width.size(); ++i) width[i] = 4 * width[i] + 1e-11 * size_of(piece.middle[i]);
    constexpr int most = 4;
    for (int k = 0; k < most; ++k) {
        const std::vector<double> image = image_of(at_centre, system(tube(piece, width)), piece.running, width);
        if (image.empty()) return false;
        if (is_inside(image, width, piece.running)) {
            piece.domain = width;
            piece.near = image;
            return true;
        }
        for (std::size_t i = 0; i < width.size(); ++i) width[i] = 2 * image[i] + 1e-14 * size_of(piece.middle[i]);
    }
    return false;
}

}  // namespace

double largest(const Running& x) {
    return std::max(std::abs(lower(x)), std::abs(upper(x)));
}

std::vector<Running> tube(const CurvePiece& piece, const std::vector<double>& width) {
    std::vector<Running> unknowns;
    for (std::size_t i = 0; i < piece.middle.size(); ++i) {
        if (i == piece.running) {
            unknowns.push_back(Running::variable(piece.low, piece.high, 0));
            continue;
        }
        Running x(piece.middle[i]);
        x.by[0] = piece.slope[i];
        x.two[0] = piece.curvature[i];
        x.rest = width[i];
        unknowns.push_back(x);
    }
    return unknowns;
}

std::vector<Running> centre_of(const CurvePiece& piece) {
    return tube(piece, std::vector<double>(piece.middle.size(), 0.0));
}

std::vector<double> direction_at(const CurveSystem& system, const std::vector<double>& point, std::size_t running) {
    const Derivative derivative = derivative_of(system(as_running(point)), running);
    const VectorXd solved = derivative.by_order[0].partialPivLu().solve(derivative.by_running);
    if (!solved.allFinite()) return {};
    std::vector<double> direction(point.size(), 1.0);
    for (std::size_t i = 0; i < point.size(); ++i)
        if (i != running) direction[i] = -solved[without(running, i)];
    return direction;
}

std::optional<CurvePiece> curve_piece(const CurveSystem& system, const std::vector<double>& start, std::size_t running,
                                      double low, double high) {
    CurvePiece piece;
    piece.running = running;
    piece.low = low;
    piece.high = high;
    piece.middle = start;
    piece.middle[running] = Running::variable(low, high, 0).mid;
    if (!settle(system, running, piece.middle)) return std::nullopt;
    const std::vector<double> none(start.size(), 0.0);
    piece.slope = piece.curvature = piece.domain = piece.near = none;
    if (low < high) bend(system, piece);
    if (!enclose(system, piece)) return std::nullopt;
    return piece;
}

CurvePiece as_point(const std::vector<Ball>& unknowns, std::size_t running) {
    CurvePiece point;
    point.running = running;
    point.low = lower(unknowns[running]);
    point.high = upper(unknowns[running]);
    point.slope.assign(unknowns.size(), 0.0);
    point.curvature = point.slope;
    for (const Ball& x : unknowns) {
        point.middle.push_back(middle(x));
        point.near.push_back(upper(abs(x - Ball(point.middle.back()))));
    }
    point.domain = point.near;
    return point;
}

bool lies_on(const CurvePiece& piece, const CurvePiece& point) {
    const std::vector<Running> at = tube(point, point.near);
    const Running s = at[piece.running], over = Running::variable(piece.low, piece.high, 0);
    if (!(lower(s) > piece.low && upper(s) < piece.high)) return false;
    const Running e = (s - Running(over.mid)) / Running(over.by[0]), e2 = square(e);
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (i == piece.running) continue;
        const Running away =
            at[i] - (Running(piece.middle[i]) + Running(piece.slope[i]) * e) - Running(piece.curvature[i]) * e2;
        if (!(largest(away) < piece.domain[i])) return false;
    }
    return true;
}

}  // namespace swirl::intervals
