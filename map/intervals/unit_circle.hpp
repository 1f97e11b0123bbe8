// How many zeros λ of det(A + λ B) lie inside the unit circle, for matrices that depend on two numbers.
#pragma once

#include "map/intervals/curved.hpp"

#include <optional>
#include <vector>

namespace swirl::intervals {

/// To second order in both.
using CurvedMatrix = std::vector<std::vector<Curved<2>>>;
/// By one number alone.
using RunningMatrix = std::vector<std::vector<Curved<1>>>;

/// Of square matrices.
RunningMatrix product(const RunningMatrix& a, const RunningMatrix& b);

/// A matrix with a second variable, on which it does not depend.
CurvedMatrix with_second_variable(const RunningMatrix& matrix);

/// The number for all values of the two, if none lies on the circle for any; nothing where that is not shown.
///
/// Where det(A + e^{iθ}B) ≠ 0 for all θ and all values, as many zeros lie inside as the determinant turns about 0 while
/// θ goes round (the argument principle). [0, π] is halved until on each part Gauss' elimination of C(A + e^{iθ}B)R, C
/// and R such that it is diagonal in the middle, has pivots that keep to one side of 0. Matrices without large entries
/// should be given: a derivative with a large multiplier is better left as the equations that it follows from.
std::optional<int> zeros_inside(const CurvedMatrix& a, const CurvedMatrix& b);

}  // namespace swirl::intervals
