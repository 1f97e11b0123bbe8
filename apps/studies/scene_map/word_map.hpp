// Flights and impacts by a word that is given, over two parameters, for cycles on the borders of the map.
#pragma once

#include "map/derivative/parameter.hpp"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace swirl::studies {

/// g and g′ of a vertex at a time after z; derivatives by (z, t, p₁, p₂), D + 3 long.
struct WordTouchRows {
    double gap = 0, rate = 0;
    Eigen::RowVectorXd gap_by, rate_by;
};

/// One of swirl::ModeMargins with its derivatives.
struct ModeMargin {
    double value = 0;
    Eigen::RowVectorXd by;
};

/// The state after its impact then, with derivatives by the same, D × (D + 3).
struct WordStep {
    WordTouchRows touch;
    Eigen::VectorXd after;
    Eigen::MatrixXd after_by;
    ContactMode mode = ContactMode::frictionless;
    bool stops = false;           ///< slip could stop: the next two have a meaning
    ModeMargin slip, late, held;  ///< p_k − p_end; C(p_k); |B₃| − μB₁
};

struct WordMap {
    int dimension = 0;
    int sides = 0;                      ///< 0: a disk, whose rim is its one vertex
    std::vector<double> angle_periods;  ///< per coordinate; 0: a plain number
    using Point = Eigen::VectorXd;
    using Plane = Eigen::Vector2d;
    std::function<WordStep(const Point& z, double time, const Plane& p, int vertex)> step;
    std::function<WordTouchRows(const Point& z, double time, const Plane& p, int vertex)> touch;
    /// The vertices nearest to the wall at a time, with their gaps: the nearest first.
    std::function<std::vector<std::pair<int, double>>(const Point& z, double time, const Plane& p)> nearest;
};

/// The scene's; vertices are counted from the one that has just struck. Friction is what `scene` has, or where μ is a
/// parameter.
WordMap word_map_of(const Scene<double>& scene, Parameter first, Parameter second);

}  // namespace swirl::studies
