// What `swirl certify` proved, and what not.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/orbits/recorded_cycles.hpp"
#include "map/proof/all_fixed_points.hpp"
#include "map/proof/prove_cycle.hpp"

#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::certify {

using orbits::CyclePlace;

/// What is to be proven of it; `reason` says why there is nothing to prove.
struct Candidate {
    proof::CycleClaim claim;
    std::string reason;
};

struct CertifiedOrbit {
    std::size_t number = 1;  ///< in its record, or of those that were found
    Scene<double> scene;
    std::size_t period = 1;
    SectionPoint<double> point;
    swirl::proof::CycleProof proof;
};

struct Certified {
    Scene<double> scene;
    std::string along;  ///< the parameter in which the cycles' scenes differ; empty: they do not
    std::vector<CertifiedOrbit> orbits;
    std::optional<proof::AllFixedPoints> all;  ///< with --all: how the plane was covered
    bool found = true;                         ///< false: --near led to no cycle
    bool whole = true;                         ///< false: an interruption left cycles out, or parts of the plane

    std::size_t proven() const {
        std::size_t count = 0;
        for (const CertifiedOrbit& orbit : orbits) count += orbit.proof.proven() ? 1 : 0;
        return count;
    }
};

/// What the map itself says of a cycle through these points: its flights' times and its word.
Candidate candidate_at(const CyclePlace& place);

}  // namespace swirl::apps::certify
