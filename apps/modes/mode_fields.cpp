#include "apps/modes/mode_fields.hpp"

#include "apps/modes/verdict_in_words.hpp"

#include <fmt/format.h>

namespace swirl::apps {

std::string way_in_words(const analysis::GrowthExponent& growth, double limit_spin) {
    if (!std::isnan(growth.value)) return fmt::format("J ~ n^{:.3g}", growth.value);
    return std::isnan(limit_spin) ? "" : fmt::format("S -> {:.6g}", limit_spin);
}

std::string spin_in_words(double mean, double error, bool chaotic, const std::string& way) {
    if (std::isnan(mean) && !way.empty()) return way;
    return chaotic && std::isnan(error) && !std::isnan(mean) ? about(mean) : with_error(mean, error);
}

}  // namespace swirl::apps
