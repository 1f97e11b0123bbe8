#include "analysis/spectrum/segments.hpp"

#include "analysis/enum_name.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>

namespace swirl::analysis {

namespace {

constexpr std::array<Window, 5> all_windows = {Window::rectangular, Window::hann, Window::hamming,
                                               Window::blackman_harris, Window::flat_top};

constexpr std::array<double, 1> rectangular_terms = {1};
constexpr std::array<double, 2> hann_terms = {0.5, 0.5};
constexpr std::array<double, 2> hamming_terms = {0.54, 0.46};
constexpr std::array<double, 4> blackman_harris_terms = {0.35875, 0.48829, 0.14128, 0.01168};
constexpr std::array<double, 5> flat_top_terms = {0.21557895, 0.41663158, 0.277263158, 0.083578947, 0.006947368};

std::span<const double> terms(Window window) {
    switch (window) {
        case Window::rectangular:
            return rectangular_terms;
        case Window::hann:
            return hann_terms;
        case Window::hamming:
            return hamming_terms;
        case Window::blackman_harris:
            return blackman_harris_terms;
        case Window::flat_top:
            return flat_top_terms;
    }
    return rectangular_terms;
}

/// Σ_j e^{−2πi x j/n} in closed form.
std::complex<double> dirichlet(std::size_t n, double x) {
    const double samples = static_cast<double>(n);
    const double denominator = std::sin(std::numbers::pi * x / samples);
    const double modulus = denominator == 0 ? samples : std::sin(std::numbers::pi * x) / denominator;
    return std::polar(1.0, -std::numbers::pi * x * (samples - 1) / samples) * modulus;
}

}  // namespace

std::string_view name_of(Window window) {
    using enum Window;
    return name_in<Window>({{rectangular, "rectangular"},
                            {hann, "hann"},
                            {hamming, "hamming"},
                            {blackman_harris, "blackman-harris"},
                            {flat_top, "flat-top"}},
                           window);
}

Window window_from_name(std::string_view word) {
    std::string allowed;
    for (const Window window : all_windows) {
        if (name_of(window) == word) return window;
        allowed += (allowed.empty() ? "" : ", ") + std::string(name_of(window));
    }
    throw std::invalid_argument("window = " + std::string(word) + ": must be one of " + allowed);
}

std::vector<double> window_values(Window window, std::size_t n) {
    std::vector<double> values(n, 0.0);
    const std::span<const double> a = terms(window);
    for (std::size_t j = 0; j < n; ++j) {
        const double phase = 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
        for (std::size_t m = 0; m < a.size(); ++m) {
            values[j] += (m % 2 == 0 ? a[m] : -a[m]) * std::cos(static_cast<double>(m) * phase);
        }
    }
    return values;
}

int main_lobe_half_width(Window window) {
    return static_cast<int>(terms(window).size());
}

double window_transform(Window window, std::size_t n, double x) {
    // A cosine term is two lines of half its size, m bins to either side.
    const std::span<const double> a = terms(window);
    std::complex<double> sum = a[0] * dirichlet(n, x);
    for (std::size_t m = 1; m < a.size(); ++m) {
        const double shift = static_cast<double>(m);
        const double term = (m % 2 == 0 ? 0.5 : -0.5) * a[m];
        sum += term * (dirichlet(n, x - shift) + dirichlet(n, x + shift));
    }
    return std::abs(sum);
}

namespace {

constexpr std::size_t shortest_automatic = 16;  // below, a line's main lobe is a quarter of the spectrum

template <class Sample>
std::vector<Stretch> runs_of(std::span<const Sample> series) {
    std::vector<Stretch> stretches;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= series.size(); ++i) {
        if (i < series.size() && !is_missing(series[i])) continue;
        if (i > begin) stretches.push_back({begin, i});
        begin = i + 1;
    }
    return stretches;
}

std::size_t hop_of(std::size_t length, double overlap) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(static_cast<double>(length) * (1 - overlap))));
}

std::size_t count_in(const Stretch& stretch, std::size_t length, std::size_t hop) {
    const std::size_t samples = stretch.end - stretch.begin;
    return samples < length ? 0 : (samples - length) / hop + 1;
}

bool only_small_factors(std::size_t n) {
    for (const std::size_t prime : {2, 3, 5, 7}) {
        while (n % prime == 0) n /= prime;
    }
    return n == 1;
}

std::size_t quick_length(std::size_t length) {
    length -= length % 2;
    while (!only_small_factors(length)) length -= 2;
    return length;
}

}  // namespace

std::vector<Stretch> stretches_of(std::span<const double> series) {
    return runs_of(series);
}

std::vector<Stretch> stretches_of(std::span<const std::complex<double>> series) {
    return runs_of(series);
}

std::size_t segments_within(std::span<const Stretch> stretches, std::size_t length, double overlap) {
    const std::size_t hop = hop_of(length, overlap);
    std::size_t count = 0;
    for (const Stretch& stretch : stretches) count += count_in(stretch, length, hop);
    return count;
}

std::size_t fitted_segment_length(std::span<const Stretch> stretches, std::size_t segments, double overlap,
                                  std::size_t longest) {
    std::size_t fits = 0, too_long = longest + 1;
    while (fits + 1 < too_long) {
        const std::size_t middle = fits + (too_long - fits) / 2;
        (segments_within(stretches, middle, overlap) >= segments ? fits : too_long) = middle;
    }
    return fits;
}

std::vector<std::size_t> segment_starts(std::span<const Stretch> stretches, std::size_t length, double overlap,
                                        std::size_t most) {
    const std::size_t hop = hop_of(length, overlap);
    std::vector<std::size_t> starts;
    for (const Stretch& stretch : stretches)
        for (std::size_t k = 0; k < count_in(stretch, length, hop); ++k) starts.push_back(stretch.begin + k * hop);
    if (most == 0 || starts.size() <= most) return starts;
    for (std::size_t k = 0; k < most; ++k) starts[k] = starts[k * starts.size() / most];
    starts.resize(most);
    return starts;
}

std::size_t automatic_segment_length(std::size_t n) {
    const std::size_t length = 2 * n / 17;
    return length < shortest_automatic ? n : quick_length(length);
}

std::size_t automatic_segment_length(std::span<const Stretch> stretches, double overlap) {
    if (stretches.empty()) return 0;
    const Stretch whole{stretches.front().begin, stretches.back().end};
    const std::size_t without_gaps = automatic_segment_length(whole.end - whole.begin);
    if (stretches.size() == 1) return without_gaps;
    const std::size_t wanted = segments_within({&whole, 1}, without_gaps, overlap);
    const std::size_t length = fitted_segment_length(stretches, wanted, overlap, without_gaps);
    if (wanted == 1) return length;
    if (length >= shortest_automatic) return quick_length(length);
    if (segments_within(stretches, shortest_automatic, overlap) > 0) return shortest_automatic;
    return fitted_segment_length(stretches, 1, overlap, without_gaps);
}

}  // namespace swirl::analysis
