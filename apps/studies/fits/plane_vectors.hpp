// Vectors of the plane, and the scale of distances, that fits of a wall's place share.
#pragma once

#include "analysis/fits/robust.hpp"

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace swirl::studies {

inline Eigen::Vector2d direction(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// By a quarter of a turn.
inline Eigen::Vector2d turned(const Eigen::Vector2d& a) {
    return {-a[1], a[0]};
}

/// Robust standard deviation about 0.
inline double scale_of(const std::vector<double>& values) {
    std::vector<double> squares;
    for (const double value : values) squares.push_back(value * value);
    return std::sqrt(analysis::quantile(squares, 0.5) / analysis::median_square_of_one);
}

}  // namespace swirl::studies
