#include "apps/studies/certify/sampled_covering.hpp"

#include <Eigen/LU>

#include <cmath>
#include <vector>

namespace swirl::studies::certify {

using Eigen::VectorXd;

std::vector<VectorXd> sampled_points(Eigen::Index dimension, double low, double high, int count) {
    std::vector<VectorXd> points;
    for (int i = 0; i < count; ++i) {
        const double along = count == 1 ? 0.5 * (low + high) : low + (high - low) * i / (count - 1);
        for (int corner = -1; corner < 1 << (dimension - 1); ++corner) {
            VectorXd q = VectorXd::Zero(dimension);
            q[0] = along;
            for (Eigen::Index k = 1; k < dimension && corner >= 0; ++k) q[k] = (corner >> (k - 1) & 1) != 0 ? 1 : -1;
            points.push_back(q);
        }
    }
    return points;
}

bool covers_in_samples(const ChartMap& map, const FramedSet& from, const FramedSet& to) {
    const Eigen::MatrixXd own = from.matrix(), inverse = to.matrix().inverse();
    if (!inverse.allFinite()) return false;
    double ends[2] = {0, 0};
    for (const VectorXd& q : sampled_points(from.point.size(), -1, 1, 17)) {
        const ChartStep step = map.step(from.point + own * q);
        if (!step.alive || step.letter != from.letter) return false;
        const VectorXd at = inverse * map.difference(step.state, to.point);
        if (std::abs(at[0]) < 1.1 && at.tail(at.size() - 1).cwiseAbs().maxCoeff() > 0.95) return false;
        if (std::abs(q[0]) < 1) continue;
        if (std::abs(at[0]) < 1.05) return false;
        double& end = ends[q[0] > 0 ? 1 : 0];
        if (end * at[0] < 0) return false;
        end = at[0];
    }
    return ends[0] * ends[1] < 0;
}

}  // namespace swirl::studies::certify
