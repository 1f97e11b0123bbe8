// A map as solvers see it: sizes known at run time, none, one or two parameters, compiled once for every system.
#pragma once

#include "analysis/section_map.hpp"
#include "analysis/special_values.hpp"
#include "analysis/within_period.hpp"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace swirl::analysis {

/// F(z; p) with its derivatives.
struct ShootingStep {
    bool alive = false;            ///< false: the map ends here; nothing else is meaningful then
    Eigen::VectorXd state;         ///< F(z; p)
    Eigen::MatrixXd by_state;      ///< ∂F/∂z, D × D
    Eigen::MatrixXd by_parameter;  ///< ∂F/∂p, a column for each parameter; empty for a map without one
    double duration = 1;           ///< time that the step took
    std::int64_t letter = 0;       ///< which smooth branch of the map was taken
    double integral = 0;           ///< of an observable over the step's duration, for maps that have one
    /// A smooth quantity that falls to zero where the step ceases to exist (an impact's normal velocity). The map may
    /// end a little before, at its `least_margin`.
    double margin = infinity;
};

/// The coordinates of a map's states.
struct MapCoordinates {
    int dimension = 0;
    /// The last so many of F's components are not the next point's but must be zero; the same number of the last
    /// coordinates are unknowns of each point alone (the time of its impact, say). `by_state` is square all the same.
    int constraints = 0;
    double least_margin = 0;            ///< of its steps: see ShootingStep::margin
    std::vector<double> angle_periods;  ///< per coordinate; 0: a plain number

    /// a − b, angles as angles, in [−P/2, P/2].
    Eigen::VectorXd difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
        return difference(a, b, dimension);
    }

    /// a − b, angles as angles, of whatever begins with so many coordinates of points, one point after another.
    Eigen::VectorXd difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b, Eigen::Index coordinates) const {
        Eigen::VectorXd d = a - b;
        for (Eigen::Index i = 0; i < coordinates; ++i)
            d[i] = within_period(d[i], angle_periods[static_cast<std::size_t>(i % dimension)]);
        return d;
    }

    /// What a step leaves open: F(z) less the next point, and the constraints.
    Eigen::VectorXd gap(const Eigen::VectorXd& image, const Eigen::VectorXd& next) const {
        Eigen::VectorXd open = difference(image, next);
        open.tail(constraints) = image.tail(constraints);
        return open;
    }

    /// The largest coordinate of the difference.
    double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
        return difference(a, b).lpNorm<Eigen::Infinity>();
    }

    /// z with its angles in (−P/2, P/2].
    Eigen::VectorXd normalised(const Eigen::VectorXd& z) const { return normalised(z, dimension); }
    Eigen::VectorXd normalised(const Eigen::VectorXd& y, Eigen::Index coordinates) const {
        return difference(y, Eigen::VectorXd::Zero(y.size()), coordinates);
    }
};

/// z ↦ F(z; p). A map without a parameter ignores p.
struct ShootingMap : MapCoordinates {
    bool has_parameter = false;
    std::function<ShootingStep(const Eigen::VectorXd& z, double p)> step = {};
    /// The step from the nearest state of surfaces on which cycles may lie and beside which F is another map, for
    /// guesses that are beside them. What it converges to has still to close by `step`. Empty: there are no such
    /// surfaces.
    std::function<ShootingStep(const Eigen::VectorXd& z, double p)> step_from_surface = {};
};

/// z ↦ F(z; p), p = (p₁, p₂).
struct PlaneMap : MapCoordinates {
    std::function<ShootingStep(const Eigen::VectorXd& z, const Eigen::Vector2d& p)> step = {};
};

/// The map on the line through p along parameter `axis` (0 or 1), for solvers of one parameter.
ShootingMap on_line(const PlaneMap& map, int axis, const Eigen::Vector2d& p);

/// Any SectionMap as a ShootingMap without a parameter. The map must outlive it.
template <SectionMap M>
ShootingMap shooting_map(const M& map) {
    ShootingMap result;
    result.dimension = M::dimension;
    for (int i = 0; i < M::dimension; ++i) result.angle_periods.push_back(map.angle_period(i));
    result.step = [&map](const Eigen::VectorXd& z, double) {
        const auto linearised = map.linearise(state_at(map, Vector<M::dimension>(z)));
        ShootingStep step;
        step.alive = goes_on(map, linearised) && linearised.derivative.allFinite();
        if (!step.alive) return step;
        step.state = coordinates(map, linearised.state);
        step.by_state = linearised.derivative;
        step.duration = linearised.duration;
        step.letter = linearised.letter;
        step.integral = linearised.integral;
        return step;
    };
    return result;
}

}  // namespace swirl::analysis
