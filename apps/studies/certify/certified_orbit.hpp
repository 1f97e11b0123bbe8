// Cycles as candidates of a proof, and what was proven of them.
#pragma once

#include "apps/studies/cycles/near_orbit.hpp"
#include "apps/studies/parallel/run_control.hpp"
#include "map/proof/all_fixed_points.hpp"
#include "map/proof/prove_cycle.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::studies::certify {

using cycles::CyclePlace;

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
    std::optional<proof::AllFixedPoints> all;  ///< how the plane was covered, if all were to be found
    bool found = true;                         ///< false: the point led to no cycle
    bool whole = true;                         ///< false: a stop left cycles out, or parts of the plane

    std::size_t proven() const {
        std::size_t count = 0;
        for (const CertifiedOrbit& orbit : orbits) count += orbit.proof.proven() ? 1 : 0;
        return count;
    }
};

/// What the map itself says of a cycle through these points: its flights' times and its itinerary.
Candidate candidate_at(const CyclePlace& place);

/// What is proven of one, as number 1.
CertifiedOrbit proven_at(const CyclePlace& place);

/// Each in its place, numbered from 1; those that a stop left are dropped. Cost: some 10 ms a cycle of few impacts.
std::vector<CertifiedOrbit> prove_cycles(std::vector<CyclePlace> places, const RunControl& control = {});

}  // namespace swirl::studies::certify
