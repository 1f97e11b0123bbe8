// Sets on the section, and what is claimed and proven of how F carries them over each other: plain numbers.
#pragma once

#include "map/proof/claim.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::proof {

/// The coordinates in which F is looked at: of ψ, χ, v_n, v_t, S by number. A polygon has all, a disk leaves χ out. Of
/// the frictionless disk at e = 1, whose S never changes and whose J is conserved, ψ and v_t are left, on one level of
/// J: v_n = β sin ψ − √(2J + |P|² − (v_t − P_x)²), P the centre from the swirl's.
std::vector<std::size_t> section_chart(const Scene<double>& scene);

/// A parallelepiped {centre + A q : |q_i| ≤ 1} of the chart's coordinates. The first column of A is the direction in
/// which it is stretched, the one of its exit; the others are contracted.
struct SectionSet {
    std::vector<double> centre;
    std::vector<double> matrix;  ///< A, row by row
};

/// F carries set `from` over set `to`: the flight from its centre takes `time`, ends so and leads to `image`, both
/// roughly. `slip` is found.
struct CoveringClaim {
    std::size_t from = 0, to = 0;
    Branch branch;
    double time = 0;
    SectionPoint<double> image = {};  ///< not used by the proof: where a check begins
};

struct ChaosClaim {
    std::optional<double> jacobi;  ///< the level of J without S, ½|V − ẑ×P|² − ½|P|², where the chart needs it
    std::vector<SectionSet> sets;
    std::vector<CoveringClaim> links;
};

struct CoveringProof {
    bool proven = false;
    std::string reason;  ///< what failed and by how much; empty if proven
    int pieces = 0;      ///< of the set that were looked at
};

/// A lower bound of the spectral radius of a transition matrix, and the vector that shows it.
struct GrowthBound {
    double growth = 0;            ///< λ ≤ the spectral radius
    double entropy = 0;           ///< h ≤ log λ, for an application of F; 0 if λ ≤ 1
    std::vector<double> weights;  ///< v ≥ 0 of the sets with A v ≥ λ v
};

/// Is the scene one whose chart is known? @throws std::invalid_argument naming what is not: a floor that drags, a rod,
/// a polygon without friction at e = 1, whose J is conserved, or no friction at e < 1, where every motion dies out
void require_chart(const Scene<double>& scene);

/// N ⟹ M under F (map/proof/README.md, "Chaos"): on every piece of set `from` F is one smooth branch or continuous
/// (slip that stops at once), without an earlier contact; the image lies between the contracted sides of `to` wherever
/// it is not beyond its exit; the two exit faces lie beyond different ends; no angle of the image is half a turn or
/// more from the centre of `to`, so that no image goes round the other way. Cost: some 1 to 5 ms a piece.
///   most_pieces  after which nothing is said
CoveringProof prove_covering(const Scene<double>& scene, const ChaosClaim& claim, const CoveringClaim& link,
                             int most_pieces);

/// Empty if the two sets have no point in common, angles modulo 2π; else why that is not shown.
std::string common_point(const Scene<double>& scene, const ChaosClaim& claim, std::size_t i, std::size_t j);

/// Collatz–Wielandt: A v ≥ λ v for one v ≥ 0, v ≠ 0, has λ ≤ spectral radius. v by iteration in double, λ over balls.
///   links  pairs (from, to); none twice
GrowthBound growth_bound(std::size_t sets, const std::vector<std::pair<std::size_t, std::size_t>>& links);

}  // namespace swirl::proof
