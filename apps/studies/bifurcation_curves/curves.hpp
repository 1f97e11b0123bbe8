// The curves of a plane as they are written, whatever equations they solve.
#pragma once

#include "apps/studies/bifurcation_curves/starting_points.hpp"

#include <complex>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace swirl::studies::bifurcation_curves {

struct CurveCycle {
    Eigen::Vector2d parameters{0, 0};
    analysis::CyclePoints points;
    std::vector<std::complex<double>> multipliers;  ///< by falling modulus
    double angle = 0;                               ///< θ of the critical multiplier e^{iθ}
    /// b of the normal form (analysis/continuation/normal_form.hpp); NaN where there is none.
    std::complex<double> coefficient{std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::quiet_NaN()};
    std::optional<BorderCycle> border{};  ///< of a curve on a border: its flights, and what touches
};

struct CurveSpecial {
    std::string kind;
    CurveCycle cycle;
    std::size_t after = 0;  ///< between the curve's points `after` and `after` + 1
};

struct Curve {
    std::string kind;
    std::size_t period = 1;
    std::vector<CurveCycle> points;
    std::vector<CurveSpecial> special;
    std::string begins, ends;  ///< why it ends there
};

struct FollowOptions {
    double longest_step = 0.02;
    std::size_t longest_period = 1;  ///< of cycles that are followed where curves meet
    RunControl control = {};
    /// Towards where the only impact of a fixed point vanishes, too (analysis::BoundaryOptions::steep_below).
    bool to_vanishing_impacts = false;
};

struct PlaneCurves {
    std::vector<Curve> curves;
    std::size_t starting_points = 0;    ///< special points that curves were sought from
    std::size_t without = 0;            ///< of those: at which none was found
    std::vector<std::string> left_out;  ///< kinds of borders that are not followed, each once
    bool whole = true;                  ///< false: stopped before all were followed
};

/// Follows curves, each once.
class CurveSearch {
public:
    CurveSearch(const Scene<double>& scene, const Plane& plane, const FollowOptions& options);
    ~CurveSearch();

    /// The curve through every starting point, and the curves that these lead to: borders that smooth curves end on,
    /// fold and flip curves that end on borders, curves that cross others or end on them at their points of
    /// codimension 2. What a stop leaves is what was finished.
    /// @return the curve through each starting point, by a number that is its own; none where none was found
    std::vector<std::optional<std::size_t>> follow(const std::vector<StartingPoint>& starting_points);
    /// The number of the curve of which that curve was found to be a part since; else its own.
    std::size_t whole_of(std::size_t curve) const;
    PlaneCurves found() const;

private:
    class Walk;
    std::unique_ptr<Walk> walk_;
};

}  // namespace swirl::studies::bifurcation_curves
