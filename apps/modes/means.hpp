// The mean over runs, and its error.
#pragma once

#include <span>

namespace swirl::apps {

/// x̄ = Σ x_i / n; NaN of none.
double mean_of(std::span<const double> values);

/// The standard error of x̄, √(Σ (x_i − x̄)² / (n (n − 1))); NaN of fewer than two.
double error_of_mean(std::span<const double> values);

}  // namespace swirl::apps
