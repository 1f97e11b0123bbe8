#include "analysis/spectrum/bin_average.hpp"

#include "analysis/argument_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace swirl::analysis {

template <class Value>
BinAverager<Value>::BinAverager(double start, double width, std::size_t max_bins)
    : start_(start), width_(width), max_bins_(max_bins), end_(start) {
    if (!std::isfinite(start)) refuse("bin start", start, "finite");
    if (!(width > 0) || !std::isfinite(width)) refuse("bin width", width, "positive and finite");
    if (max_bins % 2 != 0) refuse("max_bins", static_cast<double>(max_bins), "0 or even");
}

template <class Value>
void BinAverager<Value>::require_piece(double until) const {
    if (!std::isfinite(until) || until < end_) {
        refuse("end of piece", until, "finite and not before the last, " + digits_of(end_));
    }
    const double resolution = std::numeric_limits<double>::epsilon() * std::max(std::abs(start_), std::abs(until));
    if (width_ < 4 * resolution) refuse("bin width", width_, "wider than the rounding of the times");
}

template <class Value>
void BinAverager<Value>::deposit(Value integral, double duration) {
    if (!std::isfinite(squared(integral))) refuse("signal", std::sqrt(squared(integral)), "finite");
    bin_integral_ += integral;
    bin_duration_ += duration;
    integral_ += integral;
}

template <class Value>
void BinAverager<Value>::close_bin() {
    // Divided by what was covered rather than by Δ: the same up to the rounding of the bin's edges, and a constant
    // signal stays constant.
    averages_.push_back(bin_integral_ / bin_duration_);
    bin_integral_ = Value{};
    bin_duration_ = 0;
    if (max_bins_ == 0 || averages_.size() < max_bins_) return;
    for (std::size_t i = 0; i < max_bins_ / 2; ++i) averages_[i] = (averages_[2 * i] + averages_[2 * i + 1]) * 0.5;
    averages_.resize(max_bins_ / 2);
    width_ *= 2;
}

template <class Value>
Value BinAverager<Value>::mean() const {
    return integral_ / (end_ - start_);
}

template <class Value>
double BinAverager<Value>::mean_square() const {
    return square_integral_ / (end_ - start_);
}

template class BinAverager<double>;
template class BinAverager<std::complex<double>>;

EvenSeries bin_averages(std::span<const double> times, std::span<const double> values, std::size_t bins) {
    if (times.size() != values.size() + 1 || values.empty()) {
        refuse("number of breakpoints", static_cast<double>(times.size()),
               "number of values + 1 = " + std::to_string(values.size() + 1) + " ≥ 2");
    }
    if (bins == 0) refuse("bins", 0, "at least 1");
    const double width = (times.back() - times.front()) / static_cast<double>(bins);
    BinAverager<double> averager(times.front(), width);
    for (std::size_t i = 0; i + 1 < values.size(); ++i) averager.add_constant(times[i + 1], values[i]);
    // The last edge can lie an ulp beyond the last breakpoint; the last value then reaches to it.
    const double last_edge = times.front() + static_cast<double>(bins) * width;
    averager.add_constant(std::max(times.back(), last_edge), values.back());
    return {times.front() + width / 2, width, averager.averages()};
}

}  // namespace swirl::analysis
