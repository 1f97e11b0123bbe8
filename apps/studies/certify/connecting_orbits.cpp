#include "apps/studies/certify/connecting_orbits.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::studies::certify {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Guesses at which Newton's method begins are nearer to a cycle than that, in each coordinate of its frame.
constexpr double near_a_cycle = 0.1;

struct Orbit {
    std::vector<VectorXd> points;
    std::vector<ChartStep> steps;  ///< one less than points

    bool advance(const ChartMap& map) {
        ChartStep step = map.step(points.back());
        if (!step.alive) return false;
        points.push_back(step.state);
        steps.push_back(std::move(step));
        return true;
    }
};

/// The unstable manifold of a saddle, from very near to its set i, outside of it.
class Manifold {
public:
    Manifold(const ChartMap& map, const Saddle& saddle, std::size_t i) : map_(map), saddle_(saddle), i_(i) {
        double scale = 1;
        while (scale * saddle.sets[i].width > 1e-6) {
            scale /= std::abs(saddle.multiplier);
            ++turns_;
        }
    }

    /// Steps from its beginning to where its points are outside of the set.
    std::size_t inside() const { return static_cast<std::size_t>(turns_) * saddle_.sets.size(); }

    /// The orbit that leaves the set at roughly that distance along the direction, with `most` steps from there; less
    /// where it ends.
    Orbit from(double distance, int most) const {
        const FramedSet& set = saddle_.sets[i_];
        Orbit orbit;
        orbit.points.push_back(set.point + set.frame.direction * (distance / std::pow(saddle_.multiplier, turns_)));
        for (std::size_t k = inside() + static_cast<std::size_t>(most); k > 0 && orbit.advance(map_); --k) continue;
        return orbit;
    }

private:
    const ChartMap& map_;
    const Saddle& saddle_;
    std::size_t i_;
    int turns_ = 0;
};

MatrixXd unit_axes(const Frame& frame) {
    MatrixXd axes(frame.direction.size(), frame.direction.size());
    axes << frame.direction, frame.sides;
    return axes;
}

/// A point of a cycle as orbits may come to it.
struct Target {
    std::size_t saddle, set;
    MatrixXd in_frame;  ///< coordinates along the frame's directions
    MatrixXd in_set;    ///< a set's own
    double away;        ///< no point that far is near
    double far;         ///< nor of its surroundings, where a manifold may cross its stable side
};

std::vector<Target> targets_of(const std::vector<Saddle>& saddles) {
    std::vector<Target> targets;
    for (std::size_t b = 0; b < saddles.size(); ++b)
        for (std::size_t j = 0; j < saddles[b].sets.size(); ++j) {
            const FramedSet& set = saddles[b].sets[j];
            const MatrixXd axes = unit_axes(set.frame);
            const MatrixXd matrix = set.matrix();
            const double around = 3 * matrix.rightCols(matrix.cols() - 1).colwise().norm().sum();
            targets.push_back({b, j, axes.inverse(), matrix.inverse(), near_a_cycle * axes.colwise().norm().sum(),
                               around + 30 * matrix.col(0).norm()});
        }
    return targets;
}

double largest_side(const VectorXd& q) {
    return q.tail(q.size() - 1).cwiseAbs().maxCoeff();
}

class Search {
public:
    Search(const ChartMap& map, const std::vector<Saddle>& saddles, const ScanPart& part, std::size_t most)
        : map_(map), saddles_(saddles), part_(part), most_(most), targets_(targets_of(saddles)) {}

    /// The first point from `begin` on that is near a cycle; `target` is set.
    std::optional<std::size_t> near_one(const Orbit& orbit, std::size_t begin, const Target*& target) const {
        for (std::size_t m = begin; m < orbit.points.size(); ++m)
            for (const Target& candidate : targets_) {
                const VectorXd d = map_.difference(orbit.points[m], set_of(candidate).point);
                if (d.norm() > candidate.away) continue;
                if ((candidate.in_frame * d).cwiseAbs().maxCoeff() > near_a_cycle) continue;
                target = &candidate;
                return m;
            }
        return {};
    }

    /// Between two neighbours on the manifold: a point whose m-th image lies on a target's stable side, by halving,
    /// where their m-th images lie on both sides of it.
    std::optional<Orbit> across(const Manifold& manifold, const Orbit& one, const Orbit& other, double left,
                                double right, std::size_t m, const Target& target) const {
        const auto at = [&](const Orbit& orbit) -> VectorXd {
            return target.in_set * map_.difference(orbit.points[m], set_of(target).point);
        };
        const VectorXd first = at(one), second = at(other);
        if (first[0] * second[0] > 0 || largest_side(first) > 3 || largest_side(second) > 3) return {};
        Orbit middle;
        for (int halving = 0; halving < 40; ++halving) {
            const double cut = 0.5 * (left + right);
            middle = manifold.from(cut, static_cast<int>(m - manifold.inside()));
            if (middle.points.size() <= m) return {};
            const double value = at(middle)[0];
            if (std::abs(value) < 1e-6) break;
            (value * first[0] > 0 ? left : right) = cut;
        }
        const VectorXd end = at(middle);
        if (!(std::abs(end[0]) < 0.05) || largest_side(end) > 0.8) return {};
        return middle;
    }

    /// The first such point of two neighbours, as an orbit.
    std::optional<ConnectingOrbit> across_one(const Manifold& manifold, const Orbit& one, const Orbit& other,
                                              double left, double right) const {
        const std::size_t common = std::min(one.points.size(), other.points.size());
        for (std::size_t m = manifold.inside() + 1; m < common; ++m) {
            if (one.steps[m - 1].letter != other.steps[m - 1].letter) return {};
            for (const Target& target : targets_) {
                if (map_.difference(other.points[m], set_of(target).point).norm() > target.far) continue;
                std::optional<Orbit> orbit = across(manifold, one, other, left, right, m, target);
                if (!orbit) continue;
                if (auto connecting = between(std::move(*orbit), m, target)) return connecting;
            }
        }
        return {};
    }

    /// The orbit with a guess that ends near a target at its m-th point; none where Newton's method leads to none, or
    /// where it does not fit between the sets.
    std::optional<ConnectingOrbit> between(Orbit guess, std::size_t m, const Target& target) const {
        guess.points.resize(m + 1);
        const std::size_t last = continued(guess.points, target);
        if (!solved(guess, saddles_[target.saddle].sets[last])) return {};
        return cut(std::move(guess));
    }

private:
    const FramedSet& set_of(const Target& target) const { return saddles_[target.saddle].sets[target.set]; }

    /// Goes on along the stable directions, as the derivative on the cycle says, until the target's set is reached;
    /// returns in which of the sets the last point is.
    std::size_t continued(std::vector<VectorXd>& points, const Target& target) const {
        const std::vector<FramedSet>& sets = saddles_[target.saddle].sets;
        std::size_t i = target.set;
        VectorXd side = (target.in_frame * map_.difference(points.back(), sets[i].point)).tail(map_.dimension() - 1);
        points.back() = sets[i].point + sets[i].frame.sides * side;
        for (std::size_t k = 0; k < most_ && (side.array() / sets[i].heights.array()).abs().maxCoeff() > 0.4; ++k) {
            const VectorXd d = map_.step(sets[i].point).by_state * (sets[i].frame.sides * side);
            i = (i + 1) % sets.size();
            side = (unit_axes(sets[i].frame).inverse() * d).tail(side.size());
            points.push_back(sets[i].point + sets[i].frame.sides * side);
        }
        return i;
    }

    bool solved(Orbit& orbit, const FramedSet& end) const {
        const Index n = map_.dimension(), count = static_cast<Index>(orbit.points.size()), last = n * (count - 1);
        const FramedSet& begin = saddles_[part_.saddle].sets[part_.set];
        const MatrixXd at_begin = unit_axes(begin.frame).inverse().bottomRows(n - 1);
        for (int round = 0; round < 30; ++round) {
            MatrixXd system = MatrixXd::Zero(n * count, n * count);
            VectorXd open(n * count);
            orbit.steps.clear();
            for (Index i = 0; i + 1 < count; ++i) {
                const auto k = static_cast<std::size_t>(i);
                orbit.steps.push_back(map_.step(orbit.points[k]));
                if (!orbit.steps.back().alive) return false;
                open.segment(n * i, n) = map_.difference(orbit.steps.back().state, orbit.points[k + 1]);
                system.block(n * i, n * i, n, n) = orbit.steps.back().by_state;
                system.block(n * i, n * (i + 1), n, n).diagonal().setConstant(-1);
            }
            open.segment(last, n - 1) = at_begin * map_.difference(orbit.points.front(), begin.point);
            system.block(last, 0, n - 1, n) = at_begin;
            open[last + n - 1] = end.frame.covector.dot(map_.difference(orbit.points.back(), end.point));
            system.block(last + n - 1, last, 1, n) = end.frame.covector;
            if (open.norm() < 1e-12) return true;
            VectorXd change = system.partialPivLu().solve(open);
            if (!change.allFinite()) return false;
            change *= std::min(1.0, near_a_cycle / change.lpNorm<Eigen::Infinity>());
            for (Index i = 0; i < count; ++i) orbit.points[static_cast<std::size_t>(i)] -= change.segment(n * i, n);
            if (round > 15 && open.norm() > 1e-3) return false;
        }
        return false;
    }

    /// In which set a point lies; with room within its sides for what is squeezed about the point.
    const Target* holder_of(const VectorXd& x, double sides) const {
        for (const Target& target : targets_) {
            const VectorXd q = target.in_set * map_.difference(x, set_of(target).point);
            if (std::abs(q[0]) < 1 && largest_side(q) < sides) return &target;
        }
        return nullptr;
    }

    /// What lies between the sets. Its points are the orbit's own, one after another, so that what Newton's method
    /// leaves open does not grow.
    std::optional<ConnectingOrbit> cut(Orbit&& orbit) const {
        std::size_t begin = 0;
        const Target* from = nullptr;
        for (; begin < orbit.points.size(); ++begin) {
            const Target* now = holder_of(orbit.points[begin], 1);
            if (now == nullptr || now->saddle != part_.saddle) break;
            from = now;
        }
        const Target* to = nullptr;
        std::size_t end = begin;
        while (end < orbit.points.size() && (to = holder_of(orbit.points[end], 0.5)) == nullptr) ++end;
        if (from == nullptr || to == nullptr || end == begin || end - begin > most_) return {};
        const VectorXd q = to->in_set * map_.difference(orbit.points[end], set_of(*to).point);
        if (std::abs(q[0]) > 0.05) return {};
        ConnectingOrbit found;
        found.from = from->saddle;
        found.from_set = from->set;
        found.to = to->saddle;
        found.to_set = to->set;
        found.leaves_at = (from->in_set * map_.difference(orbit.points[begin - 1], set_of(*from).point))[0];
        found.first_by_state = orbit.steps[begin - 1].by_state;
        const auto place = [](auto& list, std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
        found.points.assign(place(orbit.points, begin), place(orbit.points, end));
        found.steps.assign(place(orbit.steps, begin), place(orbit.steps, end));
        return found;
    }

    const ChartMap& map_;
    const std::vector<Saddle>& saddles_;
    const ScanPart& part_;
    std::size_t most_;
    std::vector<Target> targets_;
};

bool is_known(const ChartMap& map, const std::vector<ConnectingOrbit>& known, const ConnectingOrbit& orbit) {
    return std::any_of(known.begin(), known.end(), [&](const ConnectingOrbit& other) {
        return other.points.size() == orbit.points.size() && other.to == orbit.to && other.to_set == orbit.to_set &&
               map.difference(other.points.front(), orbit.points.front()).norm() < 1e-7;
    });
}

}  // namespace

std::vector<ConnectingOrbit> connecting_orbits(const ChartMap& map, const std::vector<Saddle>& saddles,
                                               const ScanPart& part, int most, const std::function<bool()>& stop) {
    std::vector<ConnectingOrbit> found;
    const Saddle& a = saddles[part.saddle];
    const FramedSet& source = a.sets[(part.set + a.sets.size() - 1) % a.sets.size()];
    const FramedSet& left = a.sets[part.set];
    const double slope =
        left.frame.covector.dot(map.step(source.point).by_state * source.frame.direction) * source.width / left.width;
    const double low = 1.02, high = 0.97 * std::abs(slope);
    if (!(high > low)) return found;
    const Manifold manifold(map, a, part.set);
    const Search search(map, saddles, part, static_cast<std::size_t>(most));
    Orbit last;
    double last_distance = 0;
    for (int k = part.first; k <= part.last; ++k) {
        if (stop && stop()) return found;
        const double distance = part.side * left.width * low * std::pow(high / low, k / (1.0 * part.scan));
        Orbit orbit = manifold.from(distance, most);
        std::optional<ConnectingOrbit> connecting = search.across_one(manifold, last, orbit, last_distance, distance);
        const Target* target = nullptr;
        if (!connecting)
            if (const std::optional<std::size_t> m = search.near_one(orbit, manifold.inside() + 1, target))
                connecting = search.between(orbit, *m, *target);
        if (connecting && !is_known(map, found, *connecting)) found.push_back(std::move(*connecting));
        last = std::move(orbit);
        last_distance = distance;
    }
    return found;
}

}  // namespace swirl::studies::certify
