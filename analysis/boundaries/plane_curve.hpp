// Any curve in the plane of two parameters, whatever its equations are, with zeros of functions on it.
#pragma once

#include "analysis/curves/walk.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace swirl::analysis {

/// What counts as on the plane's edge, in its widths: the end of a curve that was followed to it lies there up to what
/// roundings leave.
inline constexpr double on_edge = 1e-12;

/// How far p is outside the plane low … high, in its widths; negative inside, infinite where p is no number.
double outside_plane(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Eigen::Vector2d& p);

/// A function along the curve whose zeros are of interest.
struct TestFunction {
    std::string kind;
    std::function<double(const CurvePoint&)> value;
};

struct PlaneSpecial {
    std::string kind;
    CurvePoint at;
    std::size_t after = 0;  ///< between points `after` and `after` + 1
};
void turn(PlaneSpecial& special);

/// It ends at the plane's edge, closed (the last point is the first), at a border (`accepts` said no, and what it said:
/// the last point is the last one that was accepted, to the shortest step), not converged, at most points or stopped.
struct PlaneCurve {
    std::vector<CurvePoint> points;
    std::vector<PlaneSpecial> special;
    CurveEnding begin, end;
};

struct PlaneCurveOptions {
    Eigen::Vector2d low{0, 0}, high{1, 1};  ///< the plane
    Eigen::Index parameters = 0;            ///< where p₁, p₂ stand in y
    StepRule steps{2e-3, 0.02, 1e-7};
    std::vector<TestFunction> tests;
    /// Why a point is none of the curve sought, though it solves the equations; empty: it is one.
    std::function<std::string(const CurvePoint&)> accepts;
    /// b with whole turns added to its angles, so that it lies nearest to a; empty: y has no angles.
    std::function<Eigen::VectorXd(const Eigen::VectorXd& a, const Eigen::VectorXd& b)> turned_to;
    std::function<bool()> stop;
};

/// Both ways from a point of the curve.
PlaneCurve follow_plane_curve(const CurveProblem& problem, const CurvePoint& start, const PlaneCurveOptions& options);

}  // namespace swirl::analysis
