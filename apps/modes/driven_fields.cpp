#include "apps/modes/driven_fields.hpp"

#include <fmt/format.h>

namespace swirl::apps {

std::string way_in_words(const analysis::GrowthExponent& growth, double limit_spin) {
    if (!std::isnan(growth.value)) return fmt::format("J ~ n^{:.3g}", growth.value);
    return std::isnan(limit_spin) ? "" : fmt::format("S -> {:.6g}", limit_spin);
}

}  // namespace swirl::apps
