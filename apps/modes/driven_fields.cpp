#include "apps/modes/driven_fields.hpp"

#include "apps/modes/mean_in_words.hpp"

#include <fmt/format.h>

namespace swirl::apps {

std::string way_in_words(const analysis::GrowthExponent& growth, double limit_spin) {
    if (!std::isnan(growth.value)) return fmt::format("J ~ n^{:.3g}", growth.value);
    return std::isnan(limit_spin) ? "" : fmt::format("S -> {:.6g}", limit_spin);
}

std::string spin_in_words(double mean, double error, const analysis::GrowthExponent& growth, double limit_spin) {
    const std::string way = std::isnan(mean) ? way_in_words(growth, limit_spin) : "";
    return way.empty() ? with_error(mean, error) : way;
}

}  // namespace swirl::apps
