#include "apps/input/series_of_motion.hpp"

#include "analysis/within_period.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace swirl::apps {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double near_median = 0.1;         // of it: an even step, with the jitter of a camera's clock
constexpr double even_share = 0.9;          // of the steps
constexpr double near_multiple = 0.25;      // of a step: times that are not a multiple of it are no lost rows
constexpr double largest_digit = 0.4;       // of the median: coarser times do not tell one row from two
constexpr double shortest_break = 1.75;     // steps: beyond it and no multiple, the clock has jumped
constexpr double rounding_of_times = 1e-9;  // steps: closer to even times is even
constexpr double seldom = 0.01;
constexpr std::size_t fewest_periods = 8;  // of an exact cycle, analysis/classification/returns.hpp

/// The usual step of even times, 0 if they are not even.
double usual_step(const std::vector<double>& times, LongSteps meaning) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
    if (steps.size() < 2) return 0;
    auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    const double median = *middle, digit = meaning == LongSteps::lost_rows ? decimal_resolution(times) : 0;
    const double near = std::max(near_median * median, digit <= largest_digit * median ? 1.01 * digit : 0);
    double sum = 0;
    std::size_t even = 0;
    for (const double step : steps)
        if (std::abs(step - median) <= near) sum += step, ++even;
    return static_cast<double>(even) >= even_share * static_cast<double>(steps.size()) ? sum / static_cast<double>(even)
                                                                                       : 0;
}

/// So many rows are lost in a step.
double lost_in(double step, double usual) {
    const double count = std::round(step / usual);
    return count >= 2 && std::abs(step / usual - count) <= near_multiple ? count - 1 : 0;
}

bool are_lost(const std::vector<double>& times, double usual, LongSteps meaning) {
    if (meaning != LongSteps::maybe) return meaning == LongSteps::lost_rows;
    std::size_t steps = 0;
    for (std::size_t i = 1; i < times.size(); ++i) steps += lost_in(times[i] - times[i - 1], usual) > 0 ? 1 : 0;
    return steps < fewest_periods || static_cast<double>(steps) <= seldom * static_cast<double>(times.size());
}

}  // namespace

std::size_t fill_lost_rows(std::vector<double>& times, std::vector<std::vector<double>>& columns, LongSteps meaning) {
    const double usual = usual_step(times, meaning);
    if (!(usual > 0) || !are_lost(times, usual, meaning)) return 0;
    std::vector<double> filled{times.front()};
    std::vector<std::size_t> source{0};  // rows of the columns; times.size(): none
    const std::size_t none = times.size(), most = 2 * times.size();
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double step = times[i] - times[i - 1];
        double lost = lost_in(step, usual);
        const bool is_break = step > usual * static_cast<double>(most - std::min(most, filled.size())) ||
                              (meaning == LongSteps::lost_rows && lost == 0 && step >= shortest_break * usual);
        if (is_break) lost = 1;
        for (double k = 1; k <= lost; ++k) {
            filled.push_back(times[i - 1] + (is_break ? usual : step * k / (lost + 1)));
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

double decimal_resolution(const std::vector<double>& values) {
    const auto multiples = [&](double scale) {
        return std::all_of(values.begin(), values.end(), [&](double value) {
            if (std::isnan(value)) return true;
            const double scaled = std::abs(value) * scale;
            return scaled < 1e13 && std::abs(scaled - std::round(scaled)) <= 6e-16 * scaled;
        });
    };
    double scale = 1;
    for (int digits = 0; digits <= 12; ++digits, scale *= 10)
        if (multiples(scale)) return 1 / scale;
    return 0;
}

double rounding_step(const std::vector<double>& values) {
    constexpr double off = 1e-6;  // of a step: what differences of numbers in double leave, and no chance does
    std::vector<double> from_first;
    double first = std::nan(""), largest = 0;
    for (const double value : values) {
        if (std::isnan(value)) continue;
        if (std::isnan(first)) first = value;
        from_first.push_back(std::abs(value - first));
        largest = std::max(largest, from_first.back());
    }
    if (!(largest > 0) || !std::isfinite(largest)) return 0;
    constexpr double finest = 1e-9;
    for (double step = std::pow(10.0, std::floor(std::log10(largest))); step >= finest * largest; step /= 10) {
        const bool fits = std::all_of(from_first.begin(), from_first.end(), [&](double value) {
            return std::abs(value / step - std::round(value / step)) <= off;
        });
        if (!fits) continue;
        long long common = 0;
        for (const double value : from_first) common = std::gcd(common, std::llround(value / step));
        return static_cast<double>(common) * step;
    }
    return 0;
}

std::size_t count_gaps(const std::vector<double>& values) {
    std::size_t gaps = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        gaps += std::isnan(values[i]) && (i == 0 || !std::isnan(values[i - 1])) ? 1 : 0;
    return gaps;
}

double even_out_times(std::vector<double>& times, const std::vector<double>& angles, double period) {
    const double n = static_cast<double>(times.size()), middle = (n - 1) / 2;
    if (times.size() < 3) return 0;
    double mean = 0, products = 0, squares = 0;
    for (const double t : times) mean += (t - times.front()) / n;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double k = static_cast<double>(i) - middle;
        products += k * (times[i] - times.front() - mean);
        squares += k * k;
    }
    const double step = products / squares, start = times.front() + mean - middle * step;
    const auto deviation = [&](std::size_t i) { return times[i] - (start + static_cast<double>(i) * step); };
    double largest = 0, turns = 0, count = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        largest = std::max(largest, std::abs(deviation(i)) / step);
        if (i == 0) continue;
        const double turn = analysis::within_period(angles[i] - angles[i - 1], period);
        if (!std::isnan(turn)) turns += turn, ++count;
    }
    if (!(largest > rounding_of_times && largest < 0.5) || count == 0) return 0;
    const double rate = turns / count / step;
    double as_even = 0, as_given = 0, before = missing, moved_before = missing;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double turn = analysis::within_period(angles[i] - angles[i - 1], period);
        const double moved = turn - rate * (deviation(i) - deviation(i - 1));
        if (!std::isnan(turn - before)) {
            as_even += (turn - before) * (turn - before);
            as_given += (moved - moved_before) * (moved - moved_before);
        }
        before = turn;
        moved_before = moved;
    }
    if (2 * as_given < as_even) return 0;
    for (std::size_t i = 0; i < times.size(); ++i) times[i] = start + static_cast<double>(i) * step;
    return largest;
}

void level_rounding(AngleRates& rates, const std::vector<double>& angles, double swirl_rate) {
    if (rates.times.size() < 2) return;
    double largest = 0, mean = 0, count = 0, shortest = std::numeric_limits<double>::infinity();
    for (const double angle : angles) largest = std::max(largest, std::isnan(angle) ? 0 : std::abs(angle));
    for (std::size_t i = 1; i < rates.times.size(); ++i)
        shortest = std::min(shortest, rates.times[i] - rates.times[i - 1]);
    for (const double rate : rates.values)
        if (!std::isnan(rate)) mean += rate, ++count;
    mean /= count;
    // Units in the last place of an angle (in degrees, once more in radians, of the turn) and of a time, at either end.
    const double last_time = std::max(std::abs(rates.times.front()), std::abs(rates.times.back()));
    const double rounding = 4 * std::numeric_limits<double>::epsilon() *
                            (largest / std::abs(swirl_rate) + last_time * std::abs(mean)) / shortest;
    for (const double rate : rates.values)
        if (std::abs(rate - mean) > rounding) return;
    for (double& rate : rates.values)
        if (!std::isnan(rate)) rate = mean;
}

AngleRates rates_of_angle(const std::vector<double>& times, const std::vector<double>& angles, double period,
                          double swirl_rate) {
    AngleRates rates;
    for (std::size_t i = 1; i < angles.size(); ++i) {
        const double turn = analysis::within_period(angles[i] - angles[i - 1], period);
        rates.times.push_back(times[i - 1] + (times[i] - times[i - 1]) / 2);
        rates.values.push_back(turn / (swirl_rate * (times[i] - times[i - 1])));
        if (!std::isnan(turn)) rates.largest_turn = std::max(rates.largest_turn, std::abs(turn) / (period / 2));
    }
    return rates;
}

}  // namespace swirl::apps
