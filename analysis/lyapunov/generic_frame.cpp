#include "analysis/lyapunov/generic_frame.hpp"

#include "analysis/linear_algebra/turned_frame.hpp"

#include <cmath>

namespace swirl::analysis {

Eigen::MatrixXd generic_frame(int dimension) {
    // Incommensurate phases for the lack of symmetry, the identity for good conditioning.
    Eigen::MatrixXd seed = Eigen::MatrixXd::Identity(dimension, dimension);
    for (int i = 0; i < dimension; ++i) {
        for (int j = 0; j < dimension; ++j) seed(i, j) += std::sin(1.0 + 2.3 * i + 3.7 * j + 1.9 * i * j);
    }
    turn_frame(seed);
    return seed;
}

}  // namespace swirl::analysis
