#include "analysis/classification/rate_interval.hpp"

#include "analysis/argument_error.hpp"

#include <boost/math/distributions/binomial.hpp>

#include <cmath>

namespace swirl::analysis {

namespace {

using Binomial = boost::math::binomial_distribution<double>;

constexpr double two_sided = 0.05;  // of the interval, on both sides together

void require_counts(std::int64_t k, std::int64_t n) {
    if (n < 0) refuse("trials", static_cast<double>(n), "0 or more");
    if (k < 0 || k > n)
        refuse("occurrences", static_cast<double>(k), "0 to " + digits_of(static_cast<double>(n)) + " in so many");
}

}  // namespace

RateInterval rate_interval(std::int64_t k, std::int64_t n) {
    require_counts(k, n);
    if (n == 0) return {std::nan(""), 0, 1};
    const double trials = static_cast<double>(n), times = static_cast<double>(k);
    const double beside = k == 0 || k == n ? two_sided : two_sided / 2;
    RateInterval interval;
    interval.rate = times / trials;
    if (k > 0) interval.least = Binomial::find_lower_bound_on_p(trials, times, beside);
    if (k < n) interval.most = Binomial::find_upper_bound_on_p(trials, times, beside);
    return interval;
}

double most_rate(std::int64_t k, std::int64_t n, double confidence) {
    require_counts(k, n);
    if (!(confidence > 0 && confidence < 1)) refuse("confidence", confidence, "above 0, below 1");
    if (k == n) return 1;
    return Binomial::find_upper_bound_on_p(static_cast<double>(n), static_cast<double>(k), 1 - confidence);
}

}  // namespace swirl::analysis
