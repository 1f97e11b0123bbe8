// Sets of the section that F carries over each other as a certificate states them, and their check by other equations.
#pragma once

#include "map/proof_check/stated_cycle.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace swirl::proof_check {

/// {centre + A q : |q_i| ≤ 1} of ψ, χ, v_n, v_t, S; of a disk ψ, v_n, v_t, S; of one without friction ψ, v_t on a level
/// of J. `weight` is its entry of v.
struct StatedSet {
    std::vector<double> centre, matrix;
    double weight = 0;
};

/// F carries set `from` over set `to`. The flight from the centre takes `time` and leads to `image` (ψ, χ, v_n, v_t,
/// S), both roughly: where the check begins.
struct StatedCovering {
    std::size_t from = 0, to = 0;
    int vertex_step = 0;
    std::string contact_mode;
    double time = 0;
    std::array<double, 5> image{};
};

/// No two sets over which one set is carried have a common point; A v ≥ growth · v for the matrix A of the coverings;
/// entropy ≤ log growth.
struct StatedChaos {
    StatedCycle scene;  ///< the scene alone is read
    std::optional<double> jacobi;
    std::vector<StatedSet> sets;
    std::vector<StatedCovering> coverings;
    double growth = 0, entropy = 0;
};

/// Proves all of it again; empty if it holds, else what does not (README.md of map/proof, "Chaos" and "Checking").
/// Images are enclosed by Krawczyk's operator on the equations between neighbouring points (impact_equations.hpp), with
/// a set's points as its parameters; their derivative is that of the linearised equations.
///   stop  true: end, with words that say so
std::string what_fails(const StatedChaos& chaos, const std::function<bool()>& stop);

}  // namespace swirl::proof_check
