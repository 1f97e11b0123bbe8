#include "apps/modes/means.hpp"

#include "analysis/special_values.hpp"

#include <gsl/gsl_statistics_double.h>

#include <cmath>

namespace swirl::apps {

double mean_of(std::span<const double> values) {
    return values.empty() ? analysis::nan : gsl_stats_mean(values.data(), 1, values.size());
}

double error_of_mean(std::span<const double> values) {
    if (values.size() < 2) return analysis::nan;
    return gsl_stats_sd(values.data(), 1, values.size()) / std::sqrt(static_cast<double>(values.size()));
}

}  // namespace swirl::apps
