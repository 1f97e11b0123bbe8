// Exact averages of a signal over equal time bins, piece by piece, without keeping the signal.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace swirl::analysis {

/// Accumulates x̄_k = (1/Δ) ∫_{kΔ}^{(k+1)Δ} x(start + t) dt for a signal that arrives in consecutive pieces.
///   Value   double, or std::complex<double> for a point x + iy of the plane
/// Averaging before sampling reduces the aliasing of jumps of S(t): it is a low-pass, sinc²(fΔ) in power. A constant
/// piece is exact to rounding; any other piece is as exact as the integral given for it. With `max_bins` > 0 the number
/// of bins is bounded: when they are full, neighbours are merged and Δ doubles (still exact, for the halves have equal
/// length), so an orbit of unknown length needs O(max_bins) memory. Cost O(pieces + bins). The last, incomplete bin is
/// not part of averages().
template <class Value>
class BinAverager {
public:
    /// width > 0 in the signal's time unit; max_bins 0 (no bound) or an even number ≥ 2; start finite.
    /// Throws std::invalid_argument otherwise.
    BinAverager(double start, double width, std::size_t max_bins = 0);

    /// The signal is `value` from end() to `until`. Throws if `until` < end() or something is not finite.
    void add_constant(double until, Value value) {
        const double duration = until - end_;
        add(until, [value](double a, double b) { return value * (b - a); });
        square_integral_ += squared(value) * duration;
    }

    /// The signal from end() to `until` has the integral ∫_a^b x dt = integral(a, b), both times absolute.
    /// mean_square() then leaves this piece out: it is defined for piecewise-constant signals only.
    template <class Integral>
    void add(double until, const Integral& integral) {
        require_piece(until);
        while (end_ < until) {
            const double edge = bin_end();
            const double to = std::min(until, edge);
            deposit(integral(end_, to), to - end_);
            if (to == edge) close_bin();
            end_ = to;
        }
    }

    std::vector<Value> averages() const { return averages_; }
    double start() const { return start_; }
    double width() const { return width_; }  ///< the present Δ
    double end() const { return end_; }      ///< how far the signal is known
    Value mean() const;                      ///< time mean over all pieces, the incomplete bin included
    double mean_square() const;              ///< time mean of |x|² over all pieces (constant pieces)

private:
    void require_piece(double until) const;
    double bin_end() const { return start_ + static_cast<double>(averages_.size() + 1) * width_; }
    void deposit(Value integral, double duration);
    void close_bin();
    static double squared(double x) { return x * x; }
    static double squared(const std::complex<double>& x) { return std::norm(x); }

    double start_;
    double width_;
    std::size_t max_bins_;
    double end_;
    Value bin_integral_{};
    double bin_duration_ = 0;
    Value integral_{};
    double square_integral_ = 0;
    std::vector<Value> averages_;
};

extern template class BinAverager<double>;
extern template class BinAverager<std::complex<double>>;

/// Equally spaced samples; NaN marks a sample that is missing.
struct EvenSeries {
    double start = 0;    ///< time of the first sample (of a bin: its centre)
    double spacing = 1;  ///< > 0
    std::vector<double> values;
};

/// Exact averages over `bins` equal bins of [times.front(), times.back()] of the signal that is values[i] on
/// [times[i], times[i+1]).
///   times   n + 1 breakpoints, not falling;   values   n
/// Throws std::invalid_argument for wrong sizes, falling or not finite times, no duration, or bins = 0. O(n + bins).
EvenSeries bin_averages(std::span<const double> times, std::span<const double> values, std::size_t bins);

}  // namespace swirl::analysis
