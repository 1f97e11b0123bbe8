// One way along any curve in the plane of two parameters, with zeros of functions on it.
#pragma once

#include "analysis/boundaries/arc.hpp"

#include <string>
#include <vector>

namespace swirl::analysis {

enum class ArcEnd {
    plane,    ///< it left the plane
    closed,   ///< it came back to where it began: the last point is the first
    refused,  ///< `accepts` said no: the last point is the last one that was accepted, to the shortest step
    failed,   ///< the corrector found no point to go on
    most_points,
    stopped,
};

/// A function along the curve whose zeros are of interest.
struct ArcTest {
    std::string kind;
    std::function<double(const ArcPoint&)> value;
};

struct ArcSpecial {
    std::string kind;
    ArcPoint at;
    std::size_t after = 0;  ///< between points `after` and `after` + 1
};

struct Arc {
    std::vector<ArcPoint> points;
    std::vector<ArcSpecial> special;
    ArcEnd begin = ArcEnd::plane, end = ArcEnd::plane;
    std::string begin_why, end_why;  ///< of a refusal: what `accepts` said
};

struct ArcOptions {
    Eigen::Vector2d low{0, 0}, high{1, 1};  ///< the plane
    Eigen::Index parameters = 0;            ///< where p₁, p₂ stand in y
    double first_step = 2e-3, longest_step = 0.02, shortest_step = 1e-7;
    int most_points = 5000;  ///< in each direction
    std::vector<ArcTest> tests;
    /// Why a point is none of the curve sought, though it solves the equations; empty: it is one.
    std::function<std::string(const ArcPoint&)> accepts;
    /// b with whole turns added to its angles, so that it lies nearest to a; empty: y has no angles.
    std::function<Eigen::VectorXd(const Eigen::VectorXd& a, const Eigen::VectorXd& b)> turned_to;
    std::function<bool()> stop;
};

/// Both ways from a point of the curve. Steps adapt to the corrector and the bend (14° a step); words are ignored.
Arc follow_arc(const ArcSystem& system, const ArcPoint& start, const ArcOptions& options);

}  // namespace swirl::analysis
