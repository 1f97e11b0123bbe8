// Cycles: the minimal period of k points that F maps to each other, stability, and what is known of a cycle.
#pragma once

#include "analysis/curves/shooting_residual.hpp"

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace swirl::analysis {

/// The smallest divisor d of k after which every one of the points comes again, to `closure`. One point is not enough:
/// near a flip a cycle of twice the period may nearly come again at some of its points.
///   distance  (i, j) ↦ the distance of points i and j
template <class Distance>
std::size_t minimal_period(std::size_t k, double closure, const Distance& distance) {
    for (std::size_t d = 1; d < k; ++d) {
        if (k % d != 0) continue;
        bool closes = true;
        for (std::size_t i = 0; closes && i < k; ++i) closes = distance(i, (i + d) % k) <= closure;
        if (closes) return d;
    }
    return k;
}

// What the multipliers of a cycle say: which are neutral, which attract, which repel.

/// A modulus, or a multiplier, this near to 1 can't be told from it: a double multiplier 1 (e = 1 without friction)
/// splits by the root of the residual's rounding. And what attracts by less takes a million impacts to come e times
/// nearer: no orbit that is followed shows it.
inline constexpr double neutral_margin = 1e-6;

enum class Stability {
    stable,    ///< all multipliers inside the unit circle
    unstable,  ///< one outside
    neutral,   ///< none outside, some on it (to `neutral_margin`)
};
std::string_view name_of(Stability stability);

using Multipliers = std::span<const std::complex<double>>;

/// True if the multiplier is 1: that of a direction in which the cycle continues as a family.
bool is_one(std::complex<double> multiplier);

/// How many lie outside the unit circle.
int index_of(Multipliers multipliers);
Stability stability_of(Multipliers multipliers);

/// The largest modulus of those that are not 1, 0 if there is none: the rate at which a family, or a cycle, attracts.
double slowest_of(Multipliers multipliers);

/// True if all but those that are 1 lie inside the unit circle.
bool attracts(Multipliers multipliers);

/// The eigenvalues of DFᵏ in the order of `sort_multipliers`; none of a matrix that is not finite. Cost: some 10 D³.
std::vector<std::complex<double>> sorted_multipliers(const Eigen::MatrixXd& derivative);

/// By falling modulus; of a conjugate pair that with Im > 0 first.
void sort_multipliers(std::vector<std::complex<double>>& multipliers);

// A cycle with what is known of it.

/// A k-cycle of F: F(z_i) = z_{i+1}.
struct Cycle {
    CyclePoints points;
    double residual = 0;     ///< max-norm of G
    std::int64_t found = 0;  ///< how many candidates of a search led to it; 0: known otherwise
    double return_time = 0;
    double mean = 0;  ///< time mean of the map's observable over the cycle
    std::vector<std::int64_t> itinerary;
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
