#include "map/proof/claim.hpp"

#include "map/proof/branch_claim.hpp"

#include <algorithm>

namespace swirl::proof {

std::string_view name_of(ProvenStability stability) {
    switch (stability) {
        case ProvenStability::attracting:
            return "attracting";
        case ProvenStability::saddle:
            return "saddle";
        case ProvenStability::repelling:
            return "repelling";
        case ProvenStability::neutral:
            return "neutral";
        case ProvenStability::undecided:
            break;
    }
    return "undecided";
}

std::string_view name_of(BranchEndKind kind) {
    switch (kind) {
        case BranchEndKind::range:
            return "range";
        case BranchEndKind::closed:
            return "closed";
        case BranchEndKind::contact_mode:
            return "contact-mode";
        case BranchEndKind::clearance:
            return "clearance";
        case BranchEndKind::period:
            return "period";
        case BranchEndKind::equations:
            return "equations";
        case BranchEndKind::stopped:
            break;
    }
    return "stopped";
}

double CycleProof::radius() const {
    double largest = 0;
    for (const PointRadii& box : radii) largest = std::max(largest, *std::max_element(box.begin(), box.end()));
    return time_radii.empty() ? largest : std::max(largest, *std::max_element(time_radii.begin(), time_radii.end()));
}

}  // namespace swirl::proof
