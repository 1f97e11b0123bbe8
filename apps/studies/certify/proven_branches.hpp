// Branches of cycles along a parameter, proven, with what happens on them.
#pragma once

#include "apps/studies/certify/certified_orbit.hpp"
#include "apps/studies/scene_map/parameter_range.hpp"
#include "map/proof/prove_branch.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace swirl::studies::certify {

/// A stretch of a branch on which as many multipliers lie outside the unit circle everywhere, or on which that is not
/// decided, from parameter to parameter in the branch's order.
struct StabilitySpan {
    proof::ProvenStability stability = proof::ProvenStability::undecided;
    int outside = 0;
    double begin = 0, end = 0;  ///< of the parameter
    double length = 0;          ///< as proof::BranchBox::length
};

struct CertifiedBranch {
    std::size_t number = 1;  ///< of the cycle that it was followed from, in its record or of those that were found
    Scene<double> scene;     ///< of that cycle
    std::size_t period = 1;
    proof::BranchProof proof;

    std::vector<StabilitySpan> spans() const;
    double length() const;
    /// The share of its length on which the stability is proven, too.
    double decided_share() const;
};

/// A branch of a record, its cycles in their order, and the part of it that proven branches cover.
struct RecordedBranch {
    std::size_t number = 0;
    std::vector<CyclePlace> places;
    double length = 0, proven_length = 0;  ///< of the chords between neighbouring cycles
};

struct ProvenBranches {
    Scene<double> scene;
    ParameterRange along;
    std::vector<CertifiedBranch> branches;
    std::vector<RecordedBranch> recorded;  ///< of a record's branches
    bool whole = true;                     ///< false: a stop left some out
    bool found = true;                     ///< false: the point led to no cycle

    std::size_t proven() const;
    std::size_t boxes() const;
    double proven_share() const;  ///< of the recorded branches' length
};

/// The branch through a cycle.
CertifiedBranch proven_branch_at(const CyclePlace& place, const ParameterRange& along,
                                 const std::function<bool()>& stop);

/// Each once: a cycle that lies on the branch of another is left out. Cost: some 2 ms times the period a box, 50 to
/// 1,000 boxes a branch.
std::vector<CertifiedBranch> prove_branches(std::vector<CyclePlace> places, const ParameterRange& along,
                                            const RunControl& control = {});

/// Covers the branches of a record by proven ones, from one of their cycles after another that none covers yet. A cycle
/// is covered where it lies in a box of a branch with its word and, where that is decided, its number of multipliers
/// outside the unit circle, as double arithmetic has it.
ProvenBranches cover_branches(const Scene<double>& scene, std::vector<RecordedBranch> recorded,
                              const ParameterRange& along, const RunControl& control = {});

}  // namespace swirl::studies::certify
