#include "analysis/spectrum/window.hpp"

#include "analysis/enum_name.hpp"

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

}  // namespace swirl::analysis
