// Windows for spectra: sums of cosines, their gains, and their transforms at any fraction of a bin.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace swirl::analysis {

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

}  // namespace swirl::analysis
