#include "apps/studies/bifurcation_curves/critical_word.hpp"

#include "analysis/linear_algebra/dense.hpp"

namespace swirl::studies::bifurcation_curves {

Eigen::MatrixXd word_matrix(const WordMap& map, const BorderCycle& cycle, double multiplier) {
    const Eigen::Index d = map.dimension, k = static_cast<Eigen::Index>(cycle.points.size());
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(k * (d + 1), k * (d + 1));
    for (Eigen::Index i = 0; i < k; ++i) {
        const auto flight = static_cast<std::size_t>(i);
        const WordStep step = map.step(cycle.points[flight], cycle.times[flight], cycle.p, cycle.vertices[flight]);
        const Eigen::Index next = (i + 1) % k;
        m.block(i * d, i * d, d, d) += step.after_by.leftCols(d);
        m.block(i * d, k * d + i, d, 1) = step.after_by.col(d);
        m.block(i * d, next * d, d, d) -= (i + 1 == k ? multiplier : 1.0) * Eigen::MatrixXd::Identity(d, d);
        m.block(k * d + i, i * d, 1, d) = step.touch.gap_by.head(d);
        m(k * d + i, k * d + i) = step.touch.gap_by[d];
    }
    return m;
}

double word_determinant(const WordMap& map, const BorderCycle& cycle, double multiplier) {
    return analysis::determinant_of(word_matrix(map, cycle, multiplier));
}

BorderCycle with_impact(const WordMap& map, const BorderCycle& grazing, double earlier) {
    BorderCycle cycle = grazing;
    const double time = grazing.touch_time - earlier;
    const WordStep step = map.step(grazing.points.front(), time, grazing.p, grazing.vertex);
    cycle.points = {grazing.points.front(), step.after};
    cycle.points.insert(cycle.points.end(), grazing.points.begin() + 1, grazing.points.end());
    cycle.times.insert(cycle.times.begin(), time);
    cycle.times[1] = grazing.times.front() - time;
    cycle.vertices.insert(cycle.vertices.begin(), grazing.vertex);
    if (map.sides > 0) cycle.vertices[1] = (grazing.vertices.front() + map.sides - grazing.vertex) % map.sides;
    return cycle;
}

double grazing_determinant(const WordMap& map, const BorderCycle& grazing, double multiplier) {
    constexpr double earlier = 1e-6;  // the impact's derivative is that of u_n > 0; extrapolated, to 10⁻¹²
    const double near = word_determinant(map, with_impact(map, grazing, earlier), multiplier);
    const double far = word_determinant(map, with_impact(map, grazing, 2 * earlier), multiplier);
    return 2 * near - far;
}

}  // namespace swirl::studies::bifurcation_curves
