#include "apps/studies/certify/saddles.hpp"

#include "apps/studies/certify/sampled_covering.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace swirl::studies::certify {

namespace {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

struct FollowedCycle {
    std::vector<ChartStep> steps;
    std::vector<VectorXd> points;
    VectorXd residual;
    bool alive = false;
};

FollowedCycle follow(const ChartMap& map, VectorXd x, int period) {
    FollowedCycle cycle;
    const VectorXd start = x;
    for (int i = 0; i < period; ++i) {
        cycle.points.push_back(x);
        cycle.steps.push_back(map.step(x));
        if (!cycle.steps.back().alive) return cycle;
        x = cycle.steps.back().state;
    }
    cycle.residual = map.difference(x, start);
    cycle.alive = true;
    return cycle;
}

MatrixXd monodromy(const FollowedCycle& cycle, std::size_t first) {
    const auto n = cycle.points.front().size();
    MatrixXd product = MatrixXd::Identity(n, n);
    for (std::size_t i = 0; i < cycle.steps.size(); ++i)
        product = cycle.steps[(first + i) % cycle.steps.size()].by_state * product;
    return product;
}

/// The columns of an orthonormal basis of a covector's kernel.
MatrixXd kernel_of(const RowVectorXd& covector) {
    const MatrixXd q = covector.transpose().householderQr().householderQ();
    return q.rightCols(q.cols() - 1);
}

/// A complex eigenvector times the phase that makes its real and imaginary parts orthogonal: with one scale for both
/// they are turned and shrunk by the pair's modulus, and are the least skew.
Eigen::VectorXcd with_normal_parts(const Eigen::VectorXcd& vector) {
    const std::complex<double> square = (vector.transpose() * vector).value();
    return vector * std::polar(1.0, -0.5 * std::arg(square));
}

/// Eigenvectors; of a pair the real and the imaginary part. The one unstable first.
bool frame_of(const MatrixXd& monodromy, Frame& frame, double& multiplier, std::string& reason) {
    const auto n = monodromy.rows();
    const Eigen::EigenSolver<MatrixXd> solver(monodromy);
    const Eigen::VectorXcd values = solver.eigenvalues();
    Eigen::Index largest = 0;
    values.cwiseAbs().maxCoeff(&largest);
    int outside = 0;
    double second = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        if (std::abs(values[i]) > 1) ++outside;
        if (i != largest) second = std::max(second, std::abs(values[i]));
    }
    if (outside != 1 || values[largest].imag() != 0 || std::abs(values[largest]) < 1.2 || second > 0.97) {
        reason = std::to_string(outside) + " of its multipliers lie outside the unit circle, the largest moduli are " +
                 std::to_string(std::abs(values[largest])) + " and " + std::to_string(second) +
                 ": one above 1.2 and the others below 0.97 are wanted";
        return false;
    }
    multiplier = values[largest].real();
    frame.direction = solver.eigenvectors().col(largest).real().normalized();
    const Eigen::EigenSolver<MatrixXd> left(monodromy.transpose());
    Eigen::Index same = 0;
    (left.eigenvalues().array() - multiplier).abs().minCoeff(&same);
    frame.covector = left.eigenvectors().col(same).real().transpose();
    frame.covector /= frame.covector.dot(frame.direction);
    frame.sides.resize(n, n - 1);
    Eigen::Index k = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        if (i == largest || values[i].imag() < 0) continue;
        const Eigen::VectorXcd vector = with_normal_parts(solver.eigenvectors().col(i));
        const double longest = std::max(vector.real().norm(), vector.imag().norm());
        frame.sides.col(k++) = vector.real() / longest;
        if (values[i].imag() > 0) frame.sides.col(k++) = vector.imag() / longest;
    }
    frame.sides -= frame.direction * (frame.covector * frame.sides);
    if (frame.sides.cols() != 0 && frame.sides.fullPivLu().rank() < n - 1) frame.sides = kernel_of(frame.covector);
    return true;
}

/// Coordinates in a frame with unit widths.
MatrixXd axes_of(const Frame& frame) {
    MatrixXd axes(frame.direction.size(), frame.direction.size());
    axes << frame.direction, frame.sides;
    return axes;
}

/// Heights such that each box of sides is carried into the next with room to spare; false: there are none.
bool balance_heights(std::vector<FramedSet>& sets, const FollowedCycle& cycle, double least) {
    const std::size_t p = sets.size();
    const auto n = sets.front().point.size();
    std::vector<MatrixXd> carried;
    for (std::size_t i = 0; i < p; ++i) {
        const MatrixXd all = axes_of(sets[(i + 1) % p].frame).inverse() * cycle.steps[i].by_state * sets[i].frame.sides;
        carried.push_back(all.bottomRows(n - 1).cwiseAbs());
        sets[i].heights = VectorXd::Constant(n - 1, least * sets[i].width);
    }
    const double limit = 100 * sets.front().heights.maxCoeff();
    for (int round = 0; round < 200; ++round) {
        bool changed = false;
        for (std::size_t i = 0; i < p; ++i) {
            VectorXd& next = sets[(i + 1) % p].heights;
            const VectorXd wanted = 1.1 * (carried[i] * sets[i].heights);
            for (Eigen::Index k = 0; k < next.size(); ++k)
                if (wanted[k] > next[k] * (1 + 1e-9)) {
                    next[k] = wanted[k];
                    changed = true;
                }
            if (next.maxCoeff() > limit) return false;
        }
        if (!changed) return true;
    }
    return false;
}

/// All sets of a cycle are carried over the next, by sampled points.
bool cycle_holds(const ChartMap& map, const std::vector<FramedSet>& sets) {
    for (std::size_t i = 0; i < sets.size(); ++i)
        if (!covers_in_samples(map, sets[i], sets[(i + 1) % sets.size()])) return false;
    return true;
}

}  // namespace

MatrixXd FramedSet::matrix() const {
    MatrixXd matrix = axes_of(frame);
    matrix.col(0) *= width;
    for (Eigen::Index k = 0; k < heights.size(); ++k) matrix.col(k + 1) *= heights[k];
    return matrix;
}

Saddle saddle_at(const ChartMap& map, const VectorXd& point, int period, double widest, double aspect) {
    Saddle saddle;
    VectorXd x = point;
    FollowedCycle cycle = follow(map, x, period);
    for (int i = 0; i < 20 && cycle.alive && cycle.residual.norm() > 1e-14; ++i) {
        const MatrixXd system = monodromy(cycle, 0) - MatrixXd::Identity(x.size(), x.size());
        x -= system.fullPivLu().solve(cycle.residual);
        FollowedCycle next = follow(map, x, period);
        const bool better = next.alive && next.residual.norm() < cycle.residual.norm();
        if (!better && cycle.residual.norm() < 1e-10) break;
        cycle = std::move(next);
    }
    if (!cycle.alive || cycle.residual.norm() > 1e-9) {
        saddle.reason = "Newton's method leads to no cycle there";
        return saddle;
    }
    const std::size_t p = cycle.steps.size();
    std::vector<FramedSet> sets(p);
    for (std::size_t i = 0; i < p; ++i) {
        sets[i].point = cycle.points[i];
        sets[i].letter = cycle.steps[i].letter;
        sets[i].duration = cycle.steps[i].duration;
        if (!frame_of(monodromy(cycle, i), sets[i].frame, saddle.multiplier, saddle.reason)) return saddle;
    }
    const double growth = std::pow(std::abs(saddle.multiplier), 1.0 / period);
    for (double width = widest; width > 1e-7; width *= 0.7) {
        sets[0].width = width;
        for (std::size_t i = 0; i + 1 < p; ++i)
            sets[i + 1].width = sets[i].width / growth * (cycle.steps[i].by_state * sets[i].frame.direction).norm();
        if (!balance_heights(sets, cycle, aspect) || !cycle_holds(map, sets)) continue;
        saddle.sets = sets;
        return saddle;
    }
    saddle.reason = "no size of sets about its points was found that F carries over each other";
    return saddle;
}

bool are_apart(const ChartMap& map, const FramedSet& a, const FramedSet& b) {
    const VectorXd d = map.difference(b.point, a.point);
    const MatrixXd ma = a.matrix(), mb = b.matrix();
    if (d.norm() > ma.colwise().norm().sum() + mb.colwise().norm().sum()) return true;
    static constexpr double room = 1.001;
    const auto separated = [](const MatrixXd& own, const MatrixXd& other, const VectorXd& offset) {
        const MatrixXd inverse = own.inverse();
        const VectorXd at = (inverse * offset).cwiseAbs();
        const VectorXd reach = (inverse * other).cwiseAbs().rowwise().sum();
        return ((at - reach).array() > room).any();
    };
    return separated(ma, mb, d) || separated(mb, ma, -d);
}

}  // namespace swirl::studies::certify
