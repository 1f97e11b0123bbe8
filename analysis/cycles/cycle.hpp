// A cycle with what is known of it.
#pragma once

#include "analysis/curves/shooting_residual.hpp"
#include "analysis/cycles/stability.hpp"

#include <complex>
#include <vector>

namespace swirl::analysis {

/// A k-cycle of F: F(z_i) = z_{i+1}.
struct Cycle {
    CyclePoints points;
    double residual = 0;     ///< max-norm of G
    std::int64_t found = 0;  ///< how many candidates of a search led to it; 0: known otherwise
    double return_time = 0;
    double mean = 0;  ///< time mean of the map's observable over the cycle
    std::vector<std::int64_t> word;
    std::vector<std::complex<double>> multipliers;  ///< of DFᵏ, by falling modulus
    int index = 0;                                  ///< how many lie outside the unit circle
    Stability stability = Stability::stable;
    Eigen::MatrixXd tangents;  ///< D × m: directions at z_1 in which the cycle continues as a family

    std::size_t period() const { return points.size(); }
    bool is_family() const { return tangents.cols() > 0; }
};

/// Works out everything but the points and the residual. False if the map ends on the cycle.
/// Multipliers are worked out in 100 digits: some 30 ms for D = 5.
bool complete_cycle(const ShootingMap& map, double p, Cycle& cycle);

/// Directions at z_1, as columns, along which G stays zero: the null space of ∂G/∂Z, its rows and columns scaled, as
/// far as each null vector has a multiplier 1 (to `neutral_margin`) of its own.
Eigen::MatrixXd family_directions(const ShootingResidual& shooting, int dimension);

/// The smallest cyclic part that closes to `closure`.
CyclePoints minimal_cycle(const ShootingMap& map, const CyclePoints& points, double closure);

/// Cycles nearer to each other than this are one; the residual of those found ends near 10⁻¹⁵.
inline constexpr double same_cycle = 1e-6;

/// The largest distance between points of two cycles of one period, for the best cyclic shift; +∞ for other periods.
double distance_between(const ShootingMap& map, const CyclePoints& a, const CyclePoints& b);

}  // namespace swirl::analysis
