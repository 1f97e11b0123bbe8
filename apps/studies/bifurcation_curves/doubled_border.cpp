#include "apps/studies/bifurcation_curves/doubled_border.hpp"

#include "analysis/linear_algebra/dense.hpp"
#include "apps/studies/bifurcation_curves/border_system.hpp"
#include "apps/studies/bifurcation_curves/critical_word.hpp"

namespace swirl::studies::bifurcation_curves {

namespace {

/// Both turns the same.
BorderCycle twice(const BorderCycle& cycle) {
    BorderCycle both = cycle;
    both.points.insert(both.points.end(), cycle.points.begin(), cycle.points.end());
    both.times.insert(both.times.end(), cycle.times.begin(), cycle.times.end());
    both.vertices.insert(both.vertices.end(), cycle.vertices.begin(), cycle.vertices.end());
    return both;
}

/// The unknowns of both turns moved by the eigenvector at −1 of one of them, one forwards and one back.
Eigen::VectorXd apart_by(const WordMap& map, const BorderCycle& flip, const BorderCycle& both) {
    const BorderLayout one = layout_of(map, flip), two = layout_of(map, both);
    const Eigen::MatrixXd vectors = analysis::right_singular_vectors(word_matrix(map, flip, -1)).right;
    const Eigen::VectorXd null = vectors.col(vectors.cols() - 1);
    Eigen::VectorXd apart = Eigen::VectorXd::Zero(unknowns_of(map, both).size());
    const Eigen::Index n = one.parameters();
    apart.head(n) = null.head(n);
    apart.segment(n, n) = -null.head(n);
    apart.segment(two.time(0), one.period) = null.tail(one.period);
    apart.segment(two.time(one.period), one.period) = -null.tail(one.period);
    return apart.normalized();
}

}  // namespace

std::optional<BorderCycle> doubled_on_border(const WordMap& map, const Plane& plane, const BorderCycle& flip) {
    const BorderCycle both = twice(flip);
    const analysis::CurveProblem problem = border_problem(map, plane, both);
    const Eigen::VectorXd middle = unknowns_of(map, both);
    const Eigen::VectorXd apart = apart_by(map, flip, both);
    for (const double amplitude : {1e-2, -1e-2, 1e-3, -1e-3, 1e-4, -1e-4}) {
        const auto equations = [&](const Eigen::VectorXd& y) {
            analysis::ShootingResidual at = problem.equations(y);
            if (!at.alive) return at;
            at.gap.conservativeResize(y.size());
            at.jacobian.conservativeResize(y.size(), y.size());
            at.gap[y.size() - 1] = apart.dot(y - middle) - amplitude;
            at.jacobian.row(y.size() - 1) = apart.transpose();
            return at;
        };
        const auto y = analysis::solve_square_system(equations, middle + amplitude * apart);
        if (y && refusal_of(map, both, *y).empty()) return border_cycle_at(map, both, *y);
    }
    return std::nullopt;
}

}  // namespace swirl::studies::bifurcation_curves
