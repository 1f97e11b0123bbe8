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

/// An orbit from a point of an unstable manifold.
struct Excursion {
    std::vector<VectorXd> points;  ///< the first is on the manifold
    std::vector<ChartStep> steps;
    std::vector<std::int64_t> letters;
};

/// The unstable manifold of the set that is carried over set `i` of a saddle, outside of set i.
class Manifold {
public:
    Manifold(const ChartMap& map, const Saddle& saddle, std::size_t i) : map_(map), saddle_(saddle), i_(i) {
        double scale = 1;
        while (scale * saddle.sets[i].width > 1e-6) {
            scale /= std::abs(saddle.multiplier);
            ++turns_;
        }
    }

    /// The point whose distance along the direction is roughly so much; none where an orbit ends.
    std::optional<VectorXd> at(double distance) const {
        const FramedSet& set = saddle_.sets[i_];
        VectorXd x = set.point + set.frame.direction * (distance / std::pow(saddle_.multiplier, turns_));
        for (std::size_t k = 0; k < static_cast<std::size_t>(turns_) * saddle_.sets.size(); ++k) {
            const ChartStep step = map_.step(x);
            if (!step.alive) return {};
            x = step.state;
        }
        return x;
    }

    /// Of `most` steps, less where it ends.
    Excursion from(double distance, int most) const {
        Excursion orbit;
        std::optional<VectorXd> x = at(distance);
        if (!x) return orbit;
        orbit.points.push_back(*x);
        for (int i = 0; i < most; ++i) {
            orbit.steps.push_back(map_.step(orbit.points.back()));
            if (!orbit.steps.back().alive) {
                orbit.steps.pop_back();
                break;
            }
            orbit.letters.push_back(orbit.steps.back().letter);
            orbit.points.push_back(orbit.steps.back().state);
        }
        return orbit;
    }

private:
    const ChartMap& map_;
    const Saddle& saddle_;
    std::size_t i_;
    int turns_ = 0;
};

/// A set's own coordinates.
struct Coordinates {
    const FramedSet* set = nullptr;
    MatrixXd inverse;

    explicit Coordinates(const FramedSet& of) : set(&of), inverse(of.matrix().inverse()) {}
    VectorXd of(const ChartMap& map, const VectorXd& x) const { return inverse * map.difference(x, set->point); }
};

double largest_side(const VectorXd& q) {
    return q.tail(q.size() - 1).cwiseAbs().maxCoeff();
}

/// The first point of an orbit that lies in one of the sets; none: npos.
std::size_t first_arrival(const ChartMap& map, const std::vector<Coordinates>& sets, const Excursion& orbit,
                          std::size_t before) {
    for (std::size_t m = 0; m < before; ++m)
        for (const Coordinates& set : sets)
            if (set.of(map, orbit.points[m]).cwiseAbs().maxCoeff() < 1) return m;
    return before;
}

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

/// Heights of `to` that hold the image of `from` where it crosses it; false: F is another branch there, or it ends.
bool fit_heights(const ChartMap& map, const FramedSet& from, FramedSet& to, double guess) {
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

/// Sets about the orbit's points before `arrival`, in set `to_set` of b; none where they do not fit.
std::optional<Connection> fitted(const ChartMap& map, const Saddle& a, std::size_t before, const Saddle& b,
                                 std::size_t to_set, const Excursion& orbit, std::size_t arrival, double guess,
                                 double room) {
    Connection connection;
    connection.from = a.number;
    connection.from_set = before;
    connection.to = b.number;
    connection.to_set = to_set;
    std::vector<FramedSet>& sets = connection.sets;
    sets.resize(arrival);
    const FramedSet &source = a.sets[before], &target = b.sets[to_set];
    // Stable directions from the end, unstable ones from the beginning.
    RowVectorXd covector = target.frame.covector;
    for (std::size_t i = arrival; i-- > 0;) {
        covector = covector * orbit.steps[i].by_state;
        covector /= covector.norm();
        sets[i].point = orbit.points[i];
        sets[i].letter = orbit.letters[i];
        sets[i].duration = orbit.steps[i].duration;
        sets[i].frame.covector = covector;
    }
    const FramedSet* last = &source;
    MatrixXd by_state = map.step(source.point + source.frame.direction * (source.width * guess)).by_state;
    if (by_state.size() == 0) return {};
    for (std::size_t i = 0; i < arrival; ++i) {
        Frame& frame = sets[i].frame;
        frame.direction = (by_state * last->frame.direction).normalized();
        const double along = frame.covector.dot(frame.direction);
        if (!(std::abs(along) > 1e-3)) return {};  // close to a tangency
        frame.covector /= along;
        by_state = orbit.steps[i].by_state;
        last = &sets[i];
    }
    // Widths from the end, so that the last one is carried across the target.
    double width = 1.12 * target.width;
    RowVectorXd next = target.frame.covector;
    for (std::size_t i = arrival; i-- > 0;) {
        const double growth = std::abs(next.dot(orbit.steps[i].by_state * sets[i].frame.direction));
        sets[i].width = width * room / growth;
        if (!(sets[i].width < 0.05)) return {};
        width = sets[i].width;
        next = sets[i].frame.covector;
    }
    // Heights from the beginning, so that each holds what is carried into it.
    last = &source;
    by_state = map.step(source.point + source.frame.direction * (source.width * guess)).by_state;
    for (std::size_t i = 0; i < arrival; ++i) {
        MatrixXd images = by_state * last->frame.sides * last->heights.asDiagonal();
        sets[i].frame.sides = carried_sides(sets[i].frame.covector, images);
        if (!fit_heights(map, *last, sets[i], i == 0 ? guess : 0)) return {};
        if (!(sets[i].heights.maxCoeff() < 0.2)) return {};
        if (!covers_in_samples(map, *last, sets[i])) return {};
        by_state = orbit.steps[i].by_state;
        last = &sets[i];
    }
    if (!covers_in_samples(map, *last, target)) return {};
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

namespace {

/// A set that orbits may come to.
struct Target {
    std::size_t saddle, set;
    Coordinates own;
    double near;  ///< what lies farther is outside of its surroundings
};

std::vector<Target> targets_of(const std::vector<Saddle>& saddles) {
    std::vector<Target> targets;
    for (std::size_t b = 0; b < saddles.size(); ++b)
        for (std::size_t j = 0; j < saddles[b].sets.size(); ++j) {
            Coordinates own(saddles[b].sets[j]);
            const Eigen::MatrixXd matrix = saddles[b].sets[j].matrix();
            const double near =
                3 * matrix.rightCols(matrix.cols() - 1).colwise().norm().sum() + 30 * matrix.col(0).norm();
            targets.push_back({b, j, std::move(own), near});
        }
    return targets;
}

/// Between two neighbouring points of a manifold: the one whose m-th image lies on a target's stable manifold.
std::optional<Excursion> arriving(const ChartMap& map, const Manifold& manifold, const Target& target, double left,
                                  double right, double at_left, std::size_t m) {
    Excursion middle;
    for (int halving = 0; halving < 60; ++halving) {
        const double cut = 0.5 * (left + right);
        middle = manifold.from(cut, static_cast<int>(m));
        if (middle.points.size() <= m) return {};
        const double value = target.own.of(map, middle.points[m])[0];
        if (std::abs(value) < 1e-7) break;
        (value * at_left > 0 ? left : right) = cut;
    }
    const VectorXd end = target.own.of(map, middle.points[m]);
    if (!(std::abs(end[0]) < 0.05) || largest_side(end) > 0.8) return {};
    return middle;
}

}  // namespace

std::vector<Connection> connections_in(const ChartMap& map, const std::vector<Saddle>& saddles, const ScanPart& part,
                                       int most, const std::function<bool()>& stop) {
    std::vector<Connection> found;
    const std::vector<Target> targets = targets_of(saddles);
    std::vector<Coordinates> all;
    for (const Target& target : targets) all.push_back(target.own);
    const Saddle& a = saddles[part.saddle];
    const std::size_t before = (part.set + a.sets.size() - 1) % a.sets.size();
    const FramedSet &source = a.sets[before], &left = a.sets[part.set];
    const double slope =
        left.frame.covector.dot(map.step(source.point).by_state * source.frame.direction) * source.width / left.width;
    const double low = 1.02, high = 0.97 * std::abs(slope);
    if (!(high > low)) return found;
    const Manifold manifold(map, a, part.set);
    const Coordinates at_left(left);
    Excursion last;
    double last_distance = 0;
    for (int k = part.first; k <= part.last; ++k) {
        if (stop && stop()) return found;
        const double distance = part.side * left.width * low * std::pow(high / low, k / (1.0 * part.scan));
        Excursion now = manifold.from(distance, most);
        const std::size_t common = std::min(now.points.size(), last.points.size());
        bool taken = false;
        for (std::size_t m = 1; m < common && !taken; ++m) {
            if (now.letters[m - 1] != last.letters[m - 1]) break;
            for (const Target& target : targets) {
                if (map.difference(now.points[m], target.own.set->point).norm() > target.near) continue;
                const VectorXd one = target.own.of(map, last.points[m]), other = target.own.of(map, now.points[m]);
                if (one[0] * other[0] > 0 || largest_side(one) > 3 || largest_side(other) > 3) continue;
                const std::optional<Excursion> orbit =
                    arriving(map, manifold, target, last_distance, distance, one[0], m);
                if (!orbit) continue;
                taken = true;
                if (first_arrival(map, all, *orbit, m) != m) break;
                const double guess = at_left.of(map, orbit->points[0])[0] / slope;
                for (const double room : {1.1, 1.25, 1.5}) {
                    auto fit = fitted(map, a, before, saddles[target.saddle], target.set, *orbit, m, guess, room);
                    if (!fit) continue;
                    found.push_back(std::move(*fit));
                    break;
                }
                break;
            }
        }
        last = std::move(now);
        last_distance = distance;
    }
    return found;
}

}  // namespace swirl::studies::certify
