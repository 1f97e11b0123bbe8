#include "apps/input/series_of_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl::apps {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double near_median = 0.1;     // of it: an even step, with the jitter of a camera's clock
constexpr double even_share = 0.9;      // of the steps
constexpr double near_multiple = 0.25;  // of a step: times that are not a multiple of it are no lost rows

/// The usual step of even times, 0 if they are not even.
double usual_step(const std::vector<double>& times) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
    if (steps.size() < 2) return 0;
    auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    const double median = *middle;
    const auto even = std::count_if(steps.begin(), steps.end(),
                                    [&](double step) { return std::abs(step - median) <= near_median * median; });
    return static_cast<double>(even) >= even_share * static_cast<double>(steps.size()) ? median : 0;
}

}  // namespace

std::size_t fill_lost_rows(std::vector<double>& times, std::vector<std::vector<double>>& columns) {
    const double usual = usual_step(times);
    if (!(usual > 0)) return 0;
    std::vector<double> filled{times.front()};
    std::vector<std::size_t> source{0};  // rows of the columns; times.size(): none
    const std::size_t none = times.size(), most = 2 * times.size();
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double step = times[i] - times[i - 1], count = std::round(step / usual);
        const bool lost = count >= 2 && std::abs(step / usual - count) <= near_multiple &&
                          static_cast<double>(filled.size()) + count <= static_cast<double>(most);
        for (double k = 1; lost && k < count; ++k) {
            filled.push_back(times[i - 1] + step * k / count);
            source.push_back(none);
        }
        filled.push_back(times[i]);
        source.push_back(i);
    }
    const std::size_t added = filled.size() - times.size();
    if (added == 0) return 0;
    for (auto& column : columns) {
        std::vector<double> longer;
        longer.reserve(source.size());
        for (const std::size_t i : source) longer.push_back(i == none ? missing : column[i]);
        column = std::move(longer);
    }
    times = std::move(filled);
    return added;
}

std::size_t count_gaps(const std::vector<double>& values) {
    std::size_t gaps = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        gaps += std::isnan(values[i]) && (i == 0 || !std::isnan(values[i - 1])) ? 1 : 0;
    return gaps;
}

AngleRates rates_of_angle(const std::vector<double>& times, const std::vector<double>& angles, double period,
                          double swirl_rate) {
    AngleRates rates;
    for (std::size_t i = 1; i < angles.size(); ++i) {
        const double turn = std::remainder(angles[i] - angles[i - 1], period);
        rates.times.push_back(times[i - 1] + (times[i] - times[i - 1]) / 2);
        rates.values.push_back(turn / (swirl_rate * (times[i] - times[i - 1])));
        if (!std::isnan(turn)) rates.largest_turn = std::max(rates.largest_turn, std::abs(turn) / (period / 2));
    }
    return rates;
}

}  // namespace swirl::apps
