#include "analysis/lyapunov/lost_ranks.hpp"

#include "analysis/linear_algebra/turned_frame.hpp"
#include "analysis/lyapunov/generic_frame.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace swirl::analysis {

Eigen::Index lost_ranks(std::span<const Eigen::MatrixXd> derivatives, double rank_tolerance) {
    const Eigen::Index dimension = derivatives[0].rows();
    Eigen::MatrixXd frame = generic_frame(static_cast<int>(dimension));
    std::vector<bool> lost(dimension, false);
    for (Eigen::Index round = 0; round < dimension; ++round) {
        for (const Eigen::MatrixXd& derivative : derivatives) {
            frame = derivative * frame;
            const Eigen::VectorXd diagonal = turn_frame(frame);
            for (Eigen::Index i = 0; i < dimension; ++i) {
                if (std::abs(diagonal[i]) <= rank_tolerance * derivative.norm()) lost[i] = true;
            }
        }
    }
    return std::count(lost.begin(), lost.end(), true);
}

}  // namespace swirl::analysis
