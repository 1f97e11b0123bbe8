// Segments of a series and their windows.
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace swirl::analysis {

// Windows for spectra: sums of cosines, their gains, and their transforms at any fraction of a bin.

/// w_j = Σ_m (−1)^m a_m cos(2πmj/n), j = 0 … n − 1: the periodic ("DFT-even") form.
enum class Window {
    rectangular,      ///< a = 1
    hann,             ///< ½, ½
    hamming,          ///< 0.54, 0.46
    blackman_harris,  ///< 4 terms, −92 dB side lobes (Harris 1978)
    flat_top,         ///< 5 terms (D'Antona & Ferrero 2006): amplitude right to 0.01 dB without interpolation
};
std::string_view name_of(Window window);
/// The inverse of name_of(), e.g. "blackman-harris". Throws std::invalid_argument for any other word, listing these.
Window window_from_name(std::string_view word);

std::vector<double> window_values(Window window, std::size_t n);

/// Bins from the centre of a line to the first zero of its image: 1, 2, 2, 4, 5.
int main_lobe_half_width(Window window);

/// |Σ_j w_j e^{−2πi x j/n}|: the image of a line of unit amplitude, x bins from its centre. O(terms).
double window_transform(Window window, std::size_t n, double x);

// Where the segments of Welch's method lie: within the stretches of a series that have no gap.

inline bool is_missing(double x) {
    return std::isnan(x);
}
inline bool is_missing(const std::complex<double>& x) {
    return std::isnan(x.real()) || std::isnan(x.imag());
}

/// Samples begin … end − 1, none of which is missing.
struct Stretch {
    std::size_t begin = 0, end = 0;
};

/// The longest runs of samples that are there, in order; none: all is NaN. O(n).
std::vector<Stretch> stretches_of(std::span<const double> series);
std::vector<Stretch> stretches_of(std::span<const std::complex<double>> series);

/// How many segments of `length` ≥ 1 samples, each `overlap` of it (0 ≤ overlap < 1) into the next, lie within the
/// stretches: the first of each begins where its stretch does. It never grows with the length. O(stretches).
std::size_t segments_within(std::span<const Stretch> stretches, std::size_t length, double overlap);

/// The largest length up to `longest` of which `segments` ≥ 1 or more lie within the stretches; 0: not even of 1.
/// O(stretches log longest).
std::size_t fitted_segment_length(std::span<const Stretch> stretches, std::size_t segments, double overlap,
                                  std::size_t longest);

/// Where they begin; of more than `most` (0: all) so many, spread evenly over them. O(segments).
std::vector<std::size_t> segment_starts(std::span<const Stretch> stretches, std::size_t length, double overlap,
                                        std::size_t most = 0);

/// The largest even number ≤ 2n/17 without a prime factor above 7: about 16 half-overlapping segments (n below 136: n).
std::size_t automatic_segment_length(std::size_t n);

/// automatic_segment_length of the samples from the first stretch to the last where there are no gaps. With gaps the
/// largest length up to it of which as many segments lie within the stretches as there would be without gaps; where so
/// many do not even of 16 samples, those of 16, or else the longest stretch. So more samples never give fewer or
/// shorter segments but where the length without gaps changes its rule (n = 136). 0: no stretch.
std::size_t automatic_segment_length(std::span<const Stretch> stretches, double overlap);

}  // namespace swirl::analysis
