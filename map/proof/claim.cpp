#include "map/proof/claim.hpp"

#include "map/proof/branch_claim.hpp"

#include <algorithm>
#include <cstddef>

namespace swirl::proof {

std::string_view name_of(ProvenStability stability) {
    static constexpr std::string_view names[] = {"attracting", "saddle", "repelling", "neutral", "undecided"};
    return names[static_cast<std::size_t>(stability)];
}

std::string_view name_of(SpecialKind kind) {
    switch (kind) {
        case SpecialKind::fold:
            return "fold";
        case SpecialKind::flip:
            return "flip";
        case SpecialKind::neimark_sacker:
            return "neimark-sacker";
        case SpecialKind::change:
            break;
    }
    return "change";
}

std::string_view name_of(BranchEndKind kind) {
    static constexpr std::string_view names[] = {"range",  "closed",    "contact-mode", "clearance",
                                                 "period", "equations", "stopped"};
    return names[static_cast<std::size_t>(kind)];
}

double CycleProof::radius() const {
    double largest = 0;
    for (const PointRadii& box : radii) largest = std::max(largest, *std::max_element(box.begin(), box.end()));
    return time_radii.empty() ? largest : std::max(largest, *std::max_element(time_radii.begin(), time_radii.end()));
}

}  // namespace swirl::proof
