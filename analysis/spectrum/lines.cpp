#include "analysis/spectrum/lines.hpp"

#include "analysis/enum_name.hpp"
#include "analysis/special_values.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_movstat.h>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>

namespace swirl::analysis {

namespace {

/// Power as the window saw it: without the compensation of bin averages.
double seen_power(const PowerSpectrum& spectrum, std::size_t k) {
    if (!spectrum.settings.compensate_bin_average) return spectrum.power[k];
    const double per_bin = spectrum.frequency[k] * spectrum.spacing / spectrum.settings.cycle_time;
    return spectrum.power[k] * bin_average_gain(per_bin);
}

/// |X_k| of one segment in units in which a line of amplitude A (two-sided) or A/2 (one-sided) gives A |W(x)|.
double modulus(const PowerSpectrum& spectrum, std::size_t k, double window_power) {
    const std::size_t n = spectrum.segment_length;
    const bool edge = spectrum.frequency[k] == 0 || 2 * k == n;
    const double sides = spectrum.two_sided || edge ? 1 : 2;
    const double density = seen_power(spectrum, k) / spectrum.variance_scale / sides;
    return std::sqrt(density * spectrum.frequency_step * static_cast<double>(n) * window_power);
}

/// The place x of a line, in bins from the largest of three neighbouring bins.
double place_between(Window window, std::size_t n, double left, double centre, double right) {
    const bool two_points = window == Window::rectangular;
    const double side = right >= left ? 1 : -1;
    const auto mismatch = [&](double x) {
        if (!two_points) return left * window_transform(window, n, 1 - x) - right * window_transform(window, n, 1 + x);
        return std::max(left, right) * window_transform(window, n, x) - centre * window_transform(window, n, side - x);
    };
    // A line's own maximum lies within half a bin; a little more is left for what leaks in.
    double from = two_points ? std::min(0.0, side) : -0.75;
    double to = two_points ? std::max(0.0, side) : 0.75;
    const double at_from = mismatch(from);
    const double at_to = mismatch(to);
    if (at_from * at_to > 0 || at_from == at_to) return 0;
    std::uintmax_t iterations = 100;
    const auto bracket = boost::math::tools::toms748_solve(mismatch, from, to, at_from, at_to,
                                                           boost::math::tools::eps_tolerance<double>(50), iterations);
    return (bracket.first + bracket.second) / 2;
}

/// Wide enough that the lines of a rich spectrum stay a minority, narrow enough to follow a continuum.
std::size_t default_half_width(const PowerSpectrum& spectrum) {
    constexpr std::size_t widest = 512;
    const std::size_t lobes = 16 * static_cast<std::size_t>(main_lobe_half_width(spectrum.settings.window));
    return std::max(lobes, std::min(widest, spectrum.power.size() / 16));
}

std::size_t half_width(const PowerSpectrum& spectrum, const LineOptions& options) {
    return options.floor_half_width > 0 ? options.floor_half_width : default_half_width(spectrum);
}

/// Power over the expected power that K averaged periodograms exceed in one bin of m with `false_alarm`/m.
double threshold(const PowerSpectrum& spectrum, double false_alarm) {
    const double k = spectrum.effective_segments;
    return gsl_cdf_gamma_Qinv(false_alarm / static_cast<double>(spectrum.power.size()), k, 1 / k);
}

/// The last bin of a real series' spectrum, at half the sampling frequency.
bool is_nyquist(const PowerSpectrum& spectrum, std::size_t k) {
    return !spectrum.two_sided && 2 * k == spectrum.segment_length;
}

/// Compared two-sided: the Nyquist bin of a one-sided spectrum isn't doubled as its neighbour is.
bool is_local_maximum(const PowerSpectrum& spectrum, std::size_t k) {
    const auto level = [&](std::size_t j) { return (is_nyquist(spectrum, j) ? 2 : 1) * spectrum.power[j]; };
    if (k == 0 || !(level(k) > level(k - 1))) return false;
    return k + 1 < spectrum.power.size() ? level(k) >= level(k + 1) : is_nyquist(spectrum, k);
}

SpectralPeak refine(const PowerSpectrum& spectrum, std::size_t k, double window_power) {
    const Window window = spectrum.settings.window;
    const std::size_t n = spectrum.segment_length;
    const double centre = modulus(spectrum, k, window_power);
    const bool nyquist = is_nyquist(spectrum, k);
    const double x = nyquist ? 0
                             : place_between(window, n, modulus(spectrum, k - 1, window_power), centre,
                                             modulus(spectrum, k + 1, window_power));
    SpectralPeak peak;
    peak.bin = k;
    peak.frequency = spectrum.frequency[k] + x * spectrum.frequency_step;
    peak.amplitude = (spectrum.two_sided || nyquist ? 1 : 2) * centre / window_transform(window, n, x);
    if (spectrum.settings.compensate_bin_average) {
        peak.amplitude /= std::sqrt(bin_average_gain(peak.frequency * spectrum.spacing / spectrum.settings.cycle_time));
    }
    peak.power = peak.amplitude * peak.amplitude / (spectrum.two_sided || nyquist ? 1 : 2);
    peak.spread = spectrum.spread.empty() ? nan : spectrum.spread[k];
    return peak;
}

std::vector<SpectralPeak> peaks_above(const PowerSpectrum& spectrum, const std::vector<double>& floor,
                                      const LineOptions& options) {
    double window_power = 0;
    for (const double w : window_values(spectrum.settings.window, spectrum.segment_length)) window_power += w * w;
    const double strongest = *std::max_element(spectrum.power.begin(), spectrum.power.end());
    const double factor = threshold(spectrum, options.false_alarm);
    std::vector<SpectralPeak> peaks;
    for (std::size_t k = 0; k < spectrum.power.size(); ++k) {
        const double power = spectrum.power[k];
        if (spectrum.frequency[k] == 0 || !is_local_maximum(spectrum, k)) continue;
        if (power <= factor * floor[k] || power < options.smallest_power * strongest) continue;
        if (!spectrum.spread.empty() && spectrum.spread[k] > options.largest_spread) continue;
        peaks.push_back(refine(spectrum, k, window_power));
        peaks.back().prominence = floor[k] > 0 ? power / floor[k] : infinity;
    }
    std::stable_sort(peaks.begin(), peaks.end(), [](const auto& a, const auto& b) { return a.power > b.power; });
    return peaks;
}

LineShare share_of(const PowerSpectrum& spectrum, const std::vector<double>& floor,
                   const std::vector<SpectralPeak>& peaks, const LineOptions& options) {
    LineShare result;
    const auto lobe = static_cast<std::size_t>(main_lobe_half_width(spectrum.settings.window));
    std::vector<char> in_line(spectrum.power.size(), 0);
    for (const SpectralPeak& peak : peaks) {
        const std::size_t from = peak.bin > lobe ? peak.bin - lobe : 0;
        const std::size_t to = std::min(peak.bin + lobe, in_line.size() - 1);
        std::fill(in_line.begin() + from, in_line.begin() + to + 1, char{1});
    }
    double total = 0;
    double above = 0;
    for (std::size_t k = 0; k < in_line.size(); ++k) {
        total += spectrum.power[k];
        if (in_line[k] != 0) above += std::max(0.0, spectrum.power[k] - floor[k]);
    }
    result.lines = peaks.size();
    result.line_fraction = above / total;
    result.nonstationarity = spectrum.nonstationarity;
    result.steadiness_tested = !spectrum.spread.empty();
    if (result.nonstationarity > options.nonstationary)
        result.verdict = SpectrumVerdict::nonstationary;
    else if (result.line_fraction >= options.all_lines)
        result.verdict = SpectrumVerdict::lines;
    else if (result.line_fraction <= options.all_continuum)
        result.verdict = SpectrumVerdict::continuum;
    else
        result.verdict = SpectrumVerdict::mixed;
    return result;
}

}  // namespace

std::vector<double> noise_floor(const PowerSpectrum& spectrum, std::size_t half_width) {
    std::vector<double> power = spectrum.power;
    if (power.empty()) return power;
    const std::size_t m = power.size();
    const std::size_t reach = std::min(half_width, (m - 1) / 2);
    gsl_vector_const_view in = gsl_vector_const_view_array(spectrum.power.data(), m);
    gsl_vector_view out = gsl_vector_view_array(power.data(), m);
    const std::unique_ptr<gsl_movstat_workspace, decltype(&gsl_movstat_free)> workspace(
        gsl_movstat_alloc(2 * reach + 1), &gsl_movstat_free);
    if (!workspace) throw std::bad_alloc();
    gsl_movstat_median(GSL_MOVSTAT_END_TRUNCATE, &in.vector, &out.vector, workspace.get());
    const double k = std::max(spectrum.effective_segments, 1.0);
    const double median_over_mean = gsl_cdf_gamma_Pinv(0.5, k, 1 / k);
    for (double& level : power) level /= median_over_mean;
    return power;
}

std::vector<SpectralPeak> find_peaks(const PowerSpectrum& spectrum, const LineOptions& options) {
    return find_lines(spectrum, options).peaks;
}

std::string_view name_of(SpectrumVerdict verdict) {
    using enum SpectrumVerdict;
    return name_in<SpectrumVerdict>({{constant, "constant"},
                                     {lines, "lines"},
                                     {continuum, "continuum"},
                                     {mixed, "mixed"},
                                     {nonstationary, "nonstationary"},
                                     {undecided, "undecided"}},
                                    verdict);
}

Lines find_lines(const PowerSpectrum& spectrum, const LineOptions& options) {
    Lines lines;
    if (spectrum.outcome == SpectrumOutcome::constant) lines.share.verdict = SpectrumVerdict::constant;
    if (spectrum.outcome != SpectrumOutcome::completed) return lines;
    const std::vector<double> floor = noise_floor(spectrum, half_width(spectrum, options));
    lines.peaks = peaks_above(spectrum, floor, options);
    lines.share = share_of(spectrum, floor, lines.peaks, options);
    return lines;
}

LineShare line_share(const PowerSpectrum& spectrum, const LineOptions& options) {
    return find_lines(spectrum, options).share;
}

}  // namespace swirl::analysis
