// Saddle cycles with one unstable direction, with sets about their points; and orbits that lead from one to another.
#pragma once

#include "apps/studies/certify/chart_map.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace swirl::studies::certify {

/// Axes at a point of an orbit: `covector` is 1 on `direction` and 0 on `sides`, which span the rest.
struct Frame {
    Eigen::VectorXd direction;
    Eigen::RowVectorXd covector;
    Eigen::MatrixXd sides;  ///< columns
};

/// {point + direction w q_0 + Σ sides_k s_k q_k : |q_i| ≤ 1}.
struct FramedSet {
    Eigen::VectorXd point;
    Frame frame;
    double width = 0;         ///< w
    Eigen::VectorXd heights;  ///< s
    std::int64_t letter = 0;  ///< of F from the point
    double duration = 0;      ///< of its flight

    Eigen::MatrixXd matrix() const;
};

struct Saddle {
    std::size_t number = 0;       ///< of the cycle, from 1
    std::vector<FramedSet> sets;  ///< about its points, each carried over the next
    double multiplier = 0;        ///< of Fᵏ, the one outside the unit circle
    std::string reason;           ///< why there are no sets
};

/// The cycle near a point, by Newton's method on Fᵏ, its frames, and the largest sets that F carries over each other
/// as sampled points show. Cost: some 10,000 steps.
///   widest  of the sets, along the unstable direction
///   aspect  their heights, in units of the width, at least
Saddle saddle_at(const ChartMap& map, const Eigen::VectorXd& point, int period, double widest, double aspect);

/// An orbit from one saddle to another: the sets about its points between the two.
struct Connection {
    std::size_t from = 0, from_set = 0;  ///< saddle, and its set that is carried over the first
    std::size_t to = 0, to_set = 0;
    std::vector<FramedSet> sets;
};

/// A stretch of one side of an unstable manifold: points first … last of `scan` where it leaves a saddle's set.
struct ScanPart {
    std::size_t saddle = 0, set = 0;
    double side = 1;
    int first = 0, last = 0, scan = 0;
};

/// All sides of all manifolds in parts of some thousand points.
std::vector<ScanPart> scan_parts(const std::vector<Saddle>& saddles, int scan);

/// The orbits that begin in a part and come to the stable manifold of a set of one of the saddles after at most `most`
/// steps, each with sets that fit between. Cost: `most` steps a point.
std::vector<Connection> connections_in(const ChartMap& map, const std::vector<Saddle>& saddles, const ScanPart& part,
                                       int most, const std::function<bool()>& stop);

/// No common point, as double arithmetic has it.
bool are_apart(const ChartMap& map, const FramedSet& a, const FramedSet& b);

}  // namespace swirl::studies::certify
