// k-cycles by multi-shooting, and the null space of an equation's Jacobian, whatever the units of its rows and columns.
#pragma once

#include "analysis/curves/shooting_residual.hpp"

#include <Eigen/Core>

#include <functional>

namespace swirl::analysis {

/// Scales rows and columns until the largest of each is 1 but for a few per cent (D. Ruiz, RAL-TR-2001-034): the
/// singular values of a scene with S of 10³ then say what its equations say, not what its coordinates are. Returns the
/// columns' factors c, so that c∘v is a null vector of the given matrix if v is one of the scaled.
Eigen::VectorXd equilibrate(Eigen::MatrixXd& matrix);

/// What counts as zero of a scaled matrix's singular values, in units of the largest: well above a derivative's
/// rounding, well below |multiplier − 1| of an isolated cycle.
inline constexpr double null_margin = 1e-8;

/// Null vectors of a matrix as columns, the surest last: those of singular values below `null_margin` after
/// `equilibrate`. Cost: one SVD.
Eigen::MatrixXd null_vectors(const Eigen::MatrixXd& matrix);

// k-cycles by multi-shooting: the k points are unknowns of a least-squares problem that Ceres solves.

struct ShootingOptions {
    int most_iterations = 40;
    double residual = 1e-8;  ///< |G| below which the polishing takes over
    double radius = 1;       ///< of the first trust region, in units of the coordinates
    /// For one guess of many. Gives up where the least cost has not fallen by a fifth in eight iterations: of 27,698
    /// searches for a hexagon's cycles of periods 1 to 8 (α = 0.635, β = 0.5, μ = 0.5, e = 0.95) 4,923 came near a
    /// cycle within 40 iterations; this ends 6 of them before, and all take 0.4 of the iterations. (Beside a fold the
    /// cost falls slowly.) And more than 10 unknowns are solved for by the normal equations, whose condition is
    /// squared, in place of QR: half the time, and the same 4,515 cycles.
    bool one_of_many = false;
};

struct ShootingResult {
    bool converged = false;
    int iterations = 0;   ///< Ceres' and the polishing's
    double residual = 0;  ///< max-norm of G reached; +∞ if the map ends at the start
    CyclePoints points;
};

/// Solves G(Z; p) = 0 from a guess by Levenberg–Marquardt with the exact Jacobian, then Newton to rounding. Where the
/// map ends or jumps the step is refused and the trust region shrinks, so that a cycle is found only where all its
/// steps are those of the map itself.
///   accept  residual that counts as converged, after polishing
/// Cost: some 10 to 40 iterations of k steps and one QR of (k D) unknowns.
ShootingResult solve_shooting(const ShootingMap& map, const CyclePoints& guess, double p, double accept,
                              const ShootingOptions& options = {});

/// A map whose points carry one more unknown, the time of their step, with one constraint
/// (map/derivative/timed_collision.hpp).
struct TimedMap {
    ShootingMap map;
    /// The time after z at which an impact would lead nearest to `next`, whether or not the wall is there then.
    std::function<double(const Eigen::VectorXd& z, const Eigen::VectorXd& next)> time_between;
};

/// A cycle near grazing, where DF grows without bound and a guess may miss the wall: solved by `timed`,
/// then closed by the map itself. Converged only if its steps are those of the map, to `accept` or to the rounding of z
/// that DF leaves in G.
ShootingResult solve_near_grazing(const ShootingMap& map, const TimedMap& timed, const CyclePoints& guess, double p,
                                  double accept, const ShootingOptions& options = {});

}  // namespace swirl::analysis
