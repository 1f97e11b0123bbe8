// Curves in the plane of two parameters on which cycles bifurcate, with what is known of them.
#pragma once

#include "analysis/continuation/normal_form.hpp"
#include "analysis/curves/walk.hpp"

#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::analysis {

enum class BoundaryKind { fold, flip, neimark_sacker };
std::string_view name_of(BoundaryKind kind);

/// Points of codimension 2 on such a curve (Kuznetsov, Elements of Applied Bifurcation Theory, ch. 9).
enum class CodimensionTwo {
    cusp,                   ///< fold: its coefficient is zero
    generalised_flip,       ///< flip: its coefficient is zero
    chenciner,              ///< Neimark–Sacker: the real part of its coefficient is zero
    one_to_one,             ///< a double multiplier 1
    one_to_two,             ///< a double multiplier −1
    one_to_three,           ///< a pair e^{±2πi/3}
    one_to_four,            ///< a pair ±i
    fold_flip,              ///< multipliers 1 and −1
    fold_neimark_sacker,    ///< a multiplier 1 and a pair on the circle
    flip_neimark_sacker,    ///< a multiplier −1 and a pair on the circle
    double_neimark_sacker,  ///< two pairs on the circle
};
std::string_view name_of(CodimensionTwo kind);

/// A cycle on the curve.
struct BoundaryPoint {
    CurvePoint at;                                  ///< y = (Z, p₁, p₂), and cos θ of a Neimark–Sacker point
    std::vector<std::complex<double>> multipliers;  ///< of DFᵏ, by falling modulus
    /// The normal form's b (normal_form.hpp): of a fold ½⟨p, B(q, q)⟩, of a flip and a Neimark–Sacker point the cubic
    /// one. From differences in double along the curve (10⁻⁶ of its terms), from `forms` at special points. NaN where
    /// it does not exist.
    std::complex<double> coefficient;
};

struct BoundarySpecial {
    CodimensionTwo kind = CodimensionTwo::cusp;
    BoundaryPoint cycle;
    std::size_t after = 0;  ///< between points `after` and `after` + 1
};

struct Boundary {
    BoundaryKind kind = BoundaryKind::fold;
    std::size_t period = 1;
    std::vector<BoundaryPoint> points;  ///< in order, from one end to the other
    std::vector<BoundarySpecial> special;
    CurveEnding begin, end;
};

void turn(BoundaryPoint& point);
void turn(BoundarySpecial& special);

/// p₁ and p₂ of y.
Eigen::Vector2d parameters_of(const Boundary& boundary, const Eigen::VectorXd& y);

struct BoundaryOptions {
    Eigen::Vector2d low{0, 0}, high{1, 1};  ///< the plane
    double first_step = 2e-3;  ///< arclength s² = |δZ|²/k + Σ δp_j²/(high_j − low_j)² (+ δ(cos θ)²)
    double longest_step = 0.02;
    double shortest_step = 1e-9;  ///< a step that fails at this length has met a border
    int most_points = 5000;       ///< in each direction
    double steep_below = 0;       ///< see AugmentedSystem
    /// Higher derivatives of Fᵏ at a cycle in more digits; without it, differences in double.
    std::function<HigherForms(const CyclePoints& points, const Eigen::Vector2d& p)> forms;
    /// Names a border from the last cycle before it and the itinerary found behind it (empty: the map ends, or nothing
    /// is known); an empty name if none is seen there.
    std::function<std::string(const CyclePoints& points, const Eigen::Vector2d& p,
                              const std::vector<std::int64_t>& itinerary_behind)>
        name_border;
    std::function<void(const Eigen::Vector2d& p)> progress;
    std::function<bool()> stop;
};

}  // namespace swirl::analysis
