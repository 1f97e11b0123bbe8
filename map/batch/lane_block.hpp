// What the lanes of a batch hold, number by number in arrays, so that a kernel for any width of vectors reads them.
#pragma once

#include "map/model/body.hpp"
#include "map/model/impact.hpp"
#include "map/model/section.hpp"

#include <cfloat>
#include <cstdint>

namespace swirl::detail {

static_assert(FLT_EVAL_METHOD == 0, "lanes have the bits of the scalar map where that rounds every result to double");

/// Lanes of one block: a whole number of vectors of every instruction set (AVX-512: 8 doubles).
inline constexpr int block_lanes = 8;

/// One number of each lane.
struct alignas(64) LaneNumbers {
    double of[block_lanes] = {};
};

/// A UnbiasedFactor of each lane.
struct LaneFactors {
    LaneNumbers first, second;
};

/// Numbers of a lane's scene: those of `Body`, and of the impact.
struct LaneScenes {
    LaneNumbers alpha, beta, inverse_inertia, inverse_inner, disk_grip, inner, outer;
    LaneFactors unbiased_alpha, unbiased_inverse_alpha, unbiased_inner, unbiased_inverse_inner;
    LaneNumbers mu, restitution;
    LaneNumbers chatter;      ///< chatter_tolerance (1 − e); not read at e = 1 where nothing chatters
    LaneNumbers widest_sine;  ///< ContactScene's
    // Polygons only.
    LaneNumbers sides, spacing, per_spacing, half_slope, side, next_turn_x, next_turn_y;
    alignas(64) std::int64_t first_vertex[block_lanes] = {};  ///< where its vertices begin in `vertices`
};

/// The lanes of a block: scenes, states, and what the last impact of each was.
struct LaneBlock {
    LaneScenes scenes;
    LaneNumbers psi_x, psi_y, chi_x, chi_y, vn, vt, spin;  ///< PostImpactState
    LaneNumbers guess;                                     ///< > 0: where the search goes on (disk)
    LaneNumbers looks;                                     ///< moments at which this flight was evaluated
    LaneNumbers flight_time, normal, tangential;           ///< of the last impact
    LaneNumbers mode, vertex_step, steps;                  ///< of it, too, and whole numbers
    const double* vertices = nullptr;  ///< four numbers for each: what a polygon's `Body` has tabled, with the rests
};

/// What a round did, a bit for each lane. A lane in neither is looked at again in the next round.
struct RoundResult {
    std::uint32_t struck = 0;  ///< went on to its next impact
    std::uint32_t left = 0;    ///< is unchanged: the scalar code decides its step …
    std::uint32_t search_failed =
        0;  ///< … and its searches from the circle's return would find nothing, as the lane's did
};

/// Another search, another impact: which kernel is run, and its argument.
struct KernelKind {
    Shape shape = Shape::disk;
    ImpactRule rule = ImpactRule::frictionless;
    bool sums_chatter = false;  ///< e < 1: a state that may chatter leaves
};

/// One look at every lane's flight. Compiled for each instruction set; the processor's best is chosen at run time.
RoundResult advance_lanes(const KernelKind& kind, LaneBlock& block);

/// The second search, from samples, for disks whose first has failed (`RoundResult::search_failed`): each lane is
/// struck or left.
RoundResult advance_sampled_disks(ImpactRule rule, LaneBlock& block);

// Parts of `advance_lanes` (disks_kernels.cpp, polygons_kernels.cpp). A disk's laws with friction coincide.
RoundResult advance_disks(ImpactRule rule, bool sums_chatter, LaneBlock& block);
RoundResult advance_polygons(ImpactRule rule, bool sums_chatter, LaneBlock& block);

/// The lanes of one vector of the instruction set that is used.
int lanes_of_vector();
/// Its name.
const char* name_of_instruction_set();

}  // namespace swirl::detail
