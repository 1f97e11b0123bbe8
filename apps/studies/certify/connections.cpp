#include "apps/studies/certify/connecting_orbits.hpp"
#include "apps/studies/certify/saddles.hpp"
#include "apps/studies/certify/sampled_covering.hpp"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::studies::certify {

namespace {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

/// |d(image's first coordinate)/dq_0| and q_0 where the image crosses the frame's kernel.
struct Crossing {
    double at = 0, slope = 0;
};

std::optional<Crossing> crossing_of(const ChartMap& map, const FramedSet& from, const FramedSet& to, double guess) {
    Crossing crossing{guess, 0};
    for (int i = 0; i < 20; ++i) {
        const ChartStep step = map.step(from.point + from.frame.direction * (from.width * crossing.at));
        if (!step.alive) return {};
        const double value = to.frame.covector.dot(map.difference(step.state, to.point));
        crossing.slope = to.frame.covector.dot(step.by_state * from.frame.direction) * from.width;
        const double change = value / crossing.slope;
        if (!std::isfinite(change)) return {};
        crossing.at -= std::clamp(change, -0.5, 0.5);
        if (std::abs(change) < 1e-12) break;
    }
    return crossing;
}

/// Heights of `to` that hold the image of `from` where it crosses it, and are no less than a share of the largest of
/// them (what is too flat needs many pieces); false: F is another branch there, or it ends.
bool fit_heights(const ChartMap& map, const FramedSet& from, FramedSet& to, double guess, double share) {
    const std::optional<Crossing> crossing = crossing_of(map, from, to, guess);
    if (!crossing || std::abs(crossing->at) > 1) return false;
    const double reach = 1.4 * to.width / std::abs(crossing->slope);
    const double low = std::max(-1.0, crossing->at - reach), high = std::min(1.0, crossing->at + reach);
    const auto n = from.point.size();
    MatrixXd axes(n, n);
    axes << to.frame.direction, to.frame.sides;
    const MatrixXd inverse = axes.inverse(), own = from.matrix();
    if (!inverse.allFinite()) return false;
    to.heights = VectorXd::Constant(n - 1, 1e-3 * to.width);
    for (const VectorXd& q : sampled_points(n, low, high, 9)) {
        const ChartStep step = map.step(from.point + own * q);
        if (!step.alive || step.letter != from.letter) return false;
        const VectorXd at = inverse * map.difference(step.state, to.point);
        to.heights = to.heights.cwiseMax(1.25 * at.tail(n - 1).cwiseAbs());
    }
    to.heights = to.heights.cwiseMax(share * to.heights.maxCoeff());
    return true;
}

/// An orthonormal basis of the covector's kernel, the longest images of the sides before first.
MatrixXd carried_sides(const RowVectorXd& covector, const MatrixXd& images) {
    const MatrixXd q = covector.transpose().householderQr().householderQ();
    const MatrixXd kernel = q.rightCols(q.cols() - 1);
    MatrixXd inside = kernel.transpose() * images;
    std::vector<Eigen::Index> order(static_cast<std::size_t>(inside.cols()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
        return inside.col(a).squaredNorm() > inside.col(b).squaredNorm();
    });
    MatrixXd sorted = inside;
    for (Eigen::Index k = 0; k < inside.cols(); ++k) sorted.col(k) = inside.col(order[static_cast<std::size_t>(k)]);
    const MatrixXd basis = sorted.householderQr().householderQ();
    return kernel * basis;
}

/// The orbit's own crossing of `to`, from the middle of `from`, looked at more closely than `covers_in_samples` does.
bool lands_within(const ChartMap& map, const FramedSet& from, const FramedSet& to) {
    const ChartStep middle = map.step(from.point);
    if (!middle.alive) return false;
    const double growth = std::abs(to.frame.covector.dot(middle.by_state * from.frame.direction));
    const double reach = std::min(1.0, 1.4 * to.width / (growth * from.width));
    const MatrixXd own = from.matrix(), inverse = to.matrix().inverse();
    const double offset = std::abs((inverse * map.difference(middle.state, to.point))[0]);
    if (!(offset < 0.1)) return false;
    for (const VectorXd& q : sampled_points(from.point.size(), -reach, reach, 9)) {
        const ChartStep step = map.step(from.point + own * q);
        if (!step.alive || step.letter != from.letter) return false;
        if ((inverse * map.difference(step.state, to.point)).tail(own.cols() - 1).cwiseAbs().maxCoeff() > 0.9)
            return false;
    }
    return true;
}

/// Without the last sets, where one before them is carried over a set of the cycle itself.
void end_early(const ChartMap& map, const std::vector<FramedSet>& cycle, Connection& connection) {
    const std::size_t count = connection.sets.size(), p = cycle.size();
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const std::size_t to = (connection.to_set + p * count - (count - 1 - i)) % p;
        const FramedSet& last = connection.sets[i];
        if (!lands_within(map, last, cycle[to]) || !covers_in_samples(map, last, cycle[to])) continue;
        connection.to_set = to;
        connection.sets.resize(i + 1);
        return;
    }
}

struct Fit {
    double room;   ///< by how much more than asked for each set is carried beyond the next one's exits
    double least;  ///< width, in units of the target's: with wide sets of low sides their curvature matters less
    double share;  ///< of the largest side that each other has at least
};

constexpr Fit fits[] = {{1.1, 0, 1e-3},  {1.25, 0, 1e-3},    {1.5, 0, 1e-3},    {1.25, 0.01, 5e-3}, {1.25, 0.1, 5e-3},
                        {1.25, 1, 5e-3}, {1.25, 0.01, 1e-3}, {1.25, 0.1, 1e-3}, {1.25, 1, 1e-3}};

/// Sets about the orbit's points; none where they do not fit.
std::optional<Connection> fitted(const ChartMap& map, const std::vector<Saddle>& saddles, const ConnectingOrbit& orbit,
                                 const Fit& fit) {
    const FramedSet &source = saddles[orbit.from].sets[orbit.from_set], &target = saddles[orbit.to].sets[orbit.to_set];
    const std::size_t count = orbit.points.size();
    Connection connection{saddles[orbit.from].number, orbit.from_set, saddles[orbit.to].number, orbit.to_set, {}};
    std::vector<FramedSet>& sets = connection.sets;
    sets.resize(count);
    // Stable directions from the end, unstable ones from the beginning.
    RowVectorXd covector = target.frame.covector;
    for (std::size_t i = count; i-- > 0;) {
        covector = covector * orbit.steps[i].by_state;
        covector /= covector.norm();
        sets[i].point = orbit.points[i];
        sets[i].letter = orbit.steps[i].letter;
        sets[i].duration = orbit.steps[i].duration;
        sets[i].frame.covector = covector;
    }
    const auto before = [&](std::size_t i) { return i == 0 ? &source : &sets[i - 1]; };
    const auto carried_by = [&](std::size_t i) { return i == 0 ? orbit.first_by_state : orbit.steps[i - 1].by_state; };
    for (std::size_t i = 0; i < count; ++i) {
        Frame& frame = sets[i].frame;
        frame.direction = (carried_by(i) * before(i)->frame.direction).normalized();
        const double along = frame.covector.dot(frame.direction);
        if (!(std::abs(along) > 1e-3)) return {};  // close to a tangency
        frame.covector /= along;
    }
    // Widths from the end, so that the last one is carried across the target.
    double width = 1.12 * target.width;
    RowVectorXd next = target.frame.covector;
    for (std::size_t i = count; i-- > 0;) {
        const double growth = std::abs(next.dot(orbit.steps[i].by_state * sets[i].frame.direction));
        sets[i].width = std::max(width * fit.room / growth, fit.least * target.width);
        if (!(sets[i].width < 0.05)) return {};
        width = sets[i].width;
        next = sets[i].frame.covector;
    }
    // Heights from the beginning, so that each holds what is carried into it.
    for (std::size_t i = 0; i < count; ++i) {
        const FramedSet& last = *before(i);
        const MatrixXd images = carried_by(i) * last.frame.sides * last.heights.asDiagonal();
        sets[i].frame.sides = carried_sides(sets[i].frame.covector, images);
        if (!fit_heights(map, last, sets[i], i == 0 ? orbit.leaves_at : 0, fit.share)) return {};
        if (!(sets[i].heights.maxCoeff() < 0.2)) return {};
        if (!covers_in_samples(map, last, sets[i])) return {};
    }
    if (!covers_in_samples(map, sets.back(), target)) return {};
    end_early(map, saddles[orbit.to].sets, connection);
    return connection;
}

}  // namespace

std::vector<ScanPart> scan_parts(const std::vector<Saddle>& saddles, int scan) {
    constexpr int piece = 5000;
    std::vector<ScanPart> parts;
    for (std::size_t a = 0; a < saddles.size(); ++a)
        for (std::size_t i = 0; i < saddles[a].sets.size(); ++i)
            for (const double side : {-1.0, 1.0})
                for (int first = 0; first < scan; first += piece)
                    parts.push_back({a, i, side, first, std::min(scan, first + piece), scan});
    return parts;
}

std::vector<Connection> connections_in(const ChartMap& map, const std::vector<Saddle>& saddles, const ScanPart& part,
                                       int most, const std::function<bool()>& stop) {
    std::vector<Connection> found;
    for (const ConnectingOrbit& orbit : connecting_orbits(map, saddles, part, most, stop))
        for (const Fit& fit : fits) {
            std::optional<Connection> connection = fitted(map, saddles, orbit, fit);
            if (!connection) continue;
            found.push_back(std::move(*connection));
            break;
        }
    return found;
}

}  // namespace swirl::studies::certify
