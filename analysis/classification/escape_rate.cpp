#include "analysis/classification/escape_rate.hpp"

#include "analysis/argument_error.hpp"

#include <gsl/gsl_cdf.h>
#include <boost/math/distributions/binomial.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

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

namespace {

constexpr double one_sided = 0.025;  // of the interval, on either side
constexpr std::int64_t enough = 3;   // that left, for a forecast of the others
constexpr double improbable = 0.05;  // at one rate for all

/// P(as few leave late as did): each of the k that left did so late with the late share of all time in chaos.
double late_share(const std::vector<ChaoticStay>& stays, std::int64_t half) {
    double early = 0, late = 0;
    unsigned left = 0, left_late = 0;
    for (const ChaoticStay& stay : stays) {
        early += static_cast<double>(std::min(stay.steps, half));
        late += static_cast<double>(std::max<std::int64_t>(stay.steps - half, 0));
        left += stay.left ? 1 : 0;
        left_late += stay.left && stay.steps > half ? 1 : 0;
    }
    return left == 0 || late == 0 ? 1 : gsl_cdf_binomial_P(left_late, late / (early + late), left);
}

}  // namespace

EscapeRate escape_rate(std::span<const ChaoticStay> stays, std::int64_t settling) {
    std::vector<ChaoticStay> settled;
    for (const ChaoticStay& stay : stays)
        if (stay.steps > settling) settled.push_back({stay.steps - settling, stay.left});
    EscapeRate rate;
    std::int64_t longest = 0;
    for (const ChaoticStay& stay : settled) {
        (stay.left ? rate.left : rate.remaining) += 1;
        rate.steps += static_cast<double>(stay.steps);
        longest = std::max(longest, stay.steps);
    }
    if (rate.steps == 0) return rate;
    if (rate.left == 0) {
        rate.most_rate = 3 / rate.steps;
        return rate;
    }
    const double freedom = 2 * static_cast<double>(rate.left);
    const double censored = rate.remaining > 0 ? freedom + 2 : freedom;  // time goes on after the last that left
    rate.rate = static_cast<double>(rate.left) / rate.steps;
    rate.least_rate = gsl_cdf_chisq_Pinv(one_sided, freedom) / (2 * rate.steps);
    rate.most_rate = gsl_cdf_chisq_Qinv(one_sided, censored) / (2 * rate.steps);
    rate.half_life = std::log(2) / rate.rate;
    rate.late_share = late_share(settled, longest / 2);
    rate.others_will_leave = rate.left >= enough && rate.late_share >= improbable;
    return rate;
}

double chance_of_leaving(std::int64_t left, double steps, double more) {
    constexpr double beyond = 0.05;
    if (!(steps > 0)) return 1;
    const double rate = gsl_cdf_chisq_Qinv(beyond, 2 * (static_cast<double>(left) + 1)) / (2 * steps);
    return -std::expm1(-rate * more);
}

}  // namespace swirl::analysis
