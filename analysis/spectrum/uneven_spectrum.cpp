#include "analysis/spectrum/uneven_spectrum.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/special_values.hpp"
#include "analysis/spectrum/lomb_scargle.hpp"
#include "analysis/spectrum/resample.hpp"

#include <gsl/gsl_cdf.h>
#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace swirl::analysis {

namespace {

using Matrix3 = Eigen::Matrix3d;
using Vector3 = Eigen::Vector3d;

/// Least squares of c + a cos ωt + b sin ωt over samples begin … end − 1: a and b.
FittedLine amplitudes(std::span<const double> times, std::span<const double> values, double omega) {
    Matrix3 normal = Matrix3::Zero();
    Vector3 right = Vector3::Zero();
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Vector3 row(std::cos(omega * times[i]), std::sin(omega * times[i]), 1);
        normal += row * row.transpose();
        right += row * values[i];
    }
    // At half the sampling frequency of even times one of the two waves is 0: a trace of its square keeps it at 0.
    normal.diagonal().array() += 1e-12 * static_cast<double>(times.size());
    const Vector3 found = normal.ldlt().solve(right);
    return {omega, found[0], found[1]};
}

/// One step of Gauss and Newton for a, b and ω.
FittedLine improved(std::span<const double> times, std::span<const double> values, const FittedLine& line) {
    Matrix3 normal = Matrix3::Zero();
    Vector3 right = Vector3::Zero();
    const double scale = times.back();  // so that all columns are of one size
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double c = std::cos(line.omega * times[i]), s = std::sin(line.omega * times[i]);
        const Vector3 row(c, s, times[i] / scale * (line.b * c - line.a * s));
        normal += row * row.transpose();
        right += row * (values[i] - line.a * c - line.b * s);
    }
    normal.diagonal() *= 1 + 1e-12;
    const Vector3 step = normal.ldlt().solve(right);
    return {line.omega + step[2] / scale, line.a + step[0], line.b + step[1]};
}

}  // namespace

LineFit::LineFit(std::span<const double> times, std::span<const double> values)
    : times_(times.begin(), times.end()), residual_(values.begin(), values.end()) {
    const double middle = times.front() + (times.back() - times.front()) / 2;
    for (double& t : times_) t -= middle;
    refine(0, 1);
}

void LineFit::put(const FittedLine& line, double factor) {
    for (std::size_t i = 0; i < times_.size(); ++i)
        residual_[i] +=
            factor * (line.a * std::cos(line.omega * times_[i]) + line.b * std::sin(line.omega * times_[i]));
}

FittedLine LineFit::fitted(FittedLine line, double reach, int steps) const {
    const double omega = line.omega;
    line = amplitudes(times_, residual_, omega);
    for (int k = 0; k < steps; ++k) {
        const FittedLine next = improved(times_, residual_, line);
        if (!(std::abs(next.omega - omega) < reach)) break;
        line = next;
    }
    return amplitudes(times_, residual_, line.omega);
}

void LineFit::add(double omega, double reach) {
    constexpr int steps = 4;
    lines_.push_back(fitted({omega, 0, 0}, reach, steps));
    put(lines_.back(), -1);
}

void LineFit::take_back() {
    put(lines_.back(), 1);
    lines_.pop_back();
}

void LineFit::refine(double reach, int sweeps) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        double mean = 0;
        for (const double x : residual_) mean += x / static_cast<double>(residual_.size());
        for (double& x : residual_) x -= mean;
        for (FittedLine& line : lines_) {
            put(line, 1);
            line = fitted(line, reach, 2);
            put(line, -1);
        }
    }
}

double LineFit::spread(const FittedLine& line, std::size_t parts) const {
    const double length = (times_.back() - times_.front()) / static_cast<double>(parts);
    if (line.omega * length < 3 * 2 * std::numbers::pi) return nan;
    std::vector<double> powers, part;
    for (std::size_t p = 0; p < parts; ++p) {
        const double from = times_.front() + static_cast<double>(p) * length;
        const auto begin = std::lower_bound(times_.begin(), times_.end(), from);
        const auto end = p + 1 == parts ? times_.end() : std::lower_bound(begin, times_.end(), from + length);
        if (end - begin < 8) return nan;
        const std::span<const double> times(&*begin, static_cast<std::size_t>(end - begin));
        const double* const rest = residual_.data() + (begin - times_.begin());
        part.clear();
        for (std::size_t i = 0; i < times.size(); ++i)
            part.push_back(rest[i] + line.a * std::cos(line.omega * times[i]) +
                           line.b * std::sin(line.omega * times[i]));
        powers.push_back(amplitudes(times, part, line.omega).power());
    }
    double mean = 0, squares = 0;
    for (const double power : powers) mean += power / static_cast<double>(parts);
    for (const double power : powers) squares += (power - mean) * (power - mean);
    return mean > 0 ? std::sqrt(squares / static_cast<double>(parts - 1)) / mean : 0;
}

namespace {

constexpr std::size_t least_uneven_samples = 8;
constexpr std::size_t parts_of_time = 8;

/// As a spectrum of one segment, so that floors of lines.hpp serve it.
PowerSpectrum with_power(const PowerSpectrum& frame, std::vector<double> power, double step) {
    PowerSpectrum spectrum = frame;
    spectrum.power = std::move(power);
    spectrum.frequency.clear();
    for (std::size_t k = 1; k <= spectrum.power.size(); ++k)
        spectrum.frequency.push_back(static_cast<double>(k) * step);
    spectrum.frequency_step = step;
    return spectrum;
}

double mean_square_of(std::span<const double> values) {
    double sum = 0;
    for (const double x : values) sum += x * x;
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

/// Where lines are sought: frequencies tried, those of lines that were refused, and what a line must exceed.
struct LineSearch {
    const LineOptions& options;
    double step = 0;        ///< of the frequencies of the spectrum, in cycles per unit of time
    std::size_t count = 0;  ///< of them
    double variance = 0;
    std::vector<double> refused = {};
};

struct LineCandidate {
    double frequency = 0, prominence = 0;
};

/// The strongest maximum above the floor that is not beside a frequency of `taken`; frequency 0: none.
LineCandidate strongest(const LineSearch& search, const LineFit& fit, const PowerSpectrum& frame) {
    const std::size_t finer = 2;
    const double step = search.step / static_cast<double>(finer);
    const PowerSpectrum residual =
        with_power(frame, lomb_scargle(fit.times(), fit.residual(), step, finer * search.count), step);
    const std::size_t m = residual.power.size();
    constexpr std::size_t widest = 1024;
    const std::vector<double> floor = noise_floor(residual, std::max<std::size_t>(64, std::min(widest, m / 16)));
    const double factor = gsl_cdf_gamma_Qinv(search.options.false_alarm / static_cast<double>(m), 1, 1);
    const double least = search.options.smallest_power * search.variance * static_cast<double>(fit.times().size()) / 2;
    const auto is_refused = [&](double f) {
        return std::any_of(search.refused.begin(), search.refused.end(),
                           [&](double g) { return std::abs(f - g) < 2 * search.step; });
    };
    LineCandidate best;
    double most = 0;
    for (std::size_t k = 0; k < m; ++k) {
        const double power = residual.power[k], frequency = residual.frequency[k];
        if (power <= most || power <= factor * floor[k] || power < least || frequency < search.step) continue;
        if (is_refused(frequency)) continue;
        most = power;
        best = {frequency, floor[k] > 0 ? power / floor[k] : infinity};
    }
    return best;
}

SpectralPeak peak_of(const FittedLine& line, double prominence, double spread, const PowerSpectrum& spectrum) {
    SpectralPeak peak;
    peak.frequency = line.omega / (2 * std::numbers::pi) * spectrum.settings.cycle_time;
    peak.power = line.power();
    peak.amplitude = std::sqrt(2 * peak.power);
    peak.prominence = prominence;
    peak.spread = spread;
    const double place = std::round(peak.frequency / spectrum.frequency_step) - 1;
    peak.bin = static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(spectrum.power.size() - 1)));
    return peak;
}

void find_lines(UnevenSpectrum& result, LineFit& fit, LineSearch& search) {
    constexpr std::size_t most_refused = 16;
    const double turn = 2 * std::numbers::pi, reach = turn * search.step;
    std::vector<double> prominences;
    while (fit.lines().size() < most_uneven_lines && search.refused.size() < most_refused) {
        const LineCandidate found = strongest(search, fit, result.spectrum);
        if (found.frequency == 0) break;
        fit.add(turn * found.frequency, reach);
        const double spread = fit.spread(fit.lines().back(), parts_of_time);
        const double nearest = turn * search.step / 2;
        const bool is_double = std::any_of(fit.lines().begin(), fit.lines().end() - 1, [&](const FittedLine& line) {
            return std::abs(line.omega - fit.lines().back().omega) < nearest;
        });
        if (spread > search.options.largest_spread || is_double) {
            fit.take_back();
            search.refused.push_back(found.frequency);
            continue;
        }
        prominences.push_back(found.prominence);
        fit.refine(reach, 1);
    }
    fit.refine(reach, 3);
    for (std::size_t k = 0; k < fit.lines().size(); ++k) {
        // What was left of others before they were refined is no line.
        if (fit.lines()[k].power() < search.options.smallest_power * search.variance) continue;
        const double spread = fit.spread(fit.lines()[k], parts_of_time);
        result.peaks.push_back(peak_of(fit.lines()[k], prominences[k], spread, result.spectrum));
        result.share.steadiness_tested = result.share.steadiness_tested || !std::isnan(spread);
    }
    std::stable_sort(result.peaks.begin(), result.peaks.end(),
                     [](const auto& a, const auto& b) { return a.power > b.power; });
}

/// `before`: mean square before lines were subtracted, about the mean.
void judge_lines(UnevenSpectrum& result, const LineFit& fit, double before, const LineOptions& options) {
    LineShare& share = result.share;
    share.lines = result.peaks.size();
    share.nonstationarity = result.spectrum.nonstationarity;
    share.line_fraction = std::max(0.0, before - mean_square_of(fit.residual())) / result.spectrum.variance;
    share.verdict = share.nonstationarity > options.nonstationary  ? SpectrumVerdict::nonstationary
                    : share.line_fraction >= options.all_lines     ? SpectrumVerdict::lines
                    : share.line_fraction <= options.all_continuum ? SpectrumVerdict::continuum
                                                                   : SpectrumVerdict::mixed;
}

/// Subtracts the mean or the least-squares line in time.
void subtract_line(std::span<const double> times, std::vector<double>& values, Detrend detrend) {
    if (detrend == Detrend::none) return;
    const double n = static_cast<double>(times.size());
    double mean_time = 0;
    for (const double t : times) mean_time += (t - times.front()) / n;
    const auto from_middle = [&](std::size_t i) { return times[i] - times.front() - mean_time; };
    for (int pass = 0; pass < 2; ++pass) {  // the second takes what the first left by rounding
        double mean = 0, products = 0, squares = 0;
        for (std::size_t i = 0; i < times.size(); ++i) mean += values[i] / n;
        for (std::size_t i = 0; i < times.size(); ++i) {
            products += from_middle(i) * (values[i] - mean);
            squares += from_middle(i) * from_middle(i);
        }
        const double slope = detrend == Detrend::linear ? products / squares : 0;
        for (std::size_t i = 0; i < times.size(); ++i) values[i] -= mean + slope * from_middle(i);
    }
}

/// The mean of the distances that are no gaps.
double usual_distance(std::span<const double> times) {
    const double longest = ResampleOptions{}.gap_factor * median_distance(times);
    double sum = 0, count = 0;
    for (std::size_t i = 1; i < times.size(); ++i)
        if (times[i] - times[i - 1] <= longest) sum += times[i] - times[i - 1], ++count;
    return sum / count;
}

/// Variances of the whole and of the halves of the samples; false: constant to rounding.
bool measure_variances(PowerSpectrum& spectrum, std::span<const double> values, double scale) {
    spectrum.variance = mean_square_of(values);
    if (std::sqrt(spectrum.variance) <= 64 * std::numeric_limits<double>::epsilon() * scale) {
        spectrum.variance = 0;
        return false;
    }
    const double first = mean_square_of(values.first(values.size() / 2));
    const double second = mean_square_of(values.last(values.size() / 2));
    spectrum.nonstationarity = std::abs(first - second) / (first + second);
    return true;
}

}  // namespace

UnevenSpectrum uneven_spectrum(std::span<const double> all_times, std::span<const double> all_values,
                               const SpectrumOptions& options, const LineOptions& line_options) {
    UnevenSpectrum result;
    const TimedSamples samples = samples_there(all_times, all_values);
    PowerSpectrum& spectrum = result.spectrum;
    spectrum.settings = options;
    spectrum.samples = samples.times.size();
    if (spectrum.samples < least_uneven_samples) return result;
    const double n = static_cast<double>(spectrum.samples);
    spectrum.spacing = usual_distance(samples.times);
    const double length = samples.times.back() - samples.times.front() + spectrum.spacing;
    const auto count = static_cast<std::size_t>(length / (2 * spectrum.spacing) * (1 + 1e-12));
    LineSearch search{line_options, 1 / length, count};
    double scale = 0;
    for (const double x : samples.values) scale = std::max(scale, std::abs(x));
    std::vector<double> values = samples.values;
    subtract_line(samples.times, values, options.detrend);
    const bool varies = measure_variances(spectrum, values, scale);
    spectrum.outcome = varies ? SpectrumOutcome::completed : SpectrumOutcome::constant;
    spectrum.segments = 1;
    spectrum.segment_length = spectrum.settings.segment_length = spectrum.samples;
    spectrum.effective_segments = 1;
    spectrum =
        with_power(spectrum, lomb_scargle(samples.times, values, search.step, count), search.step * options.cycle_time);
    double sum = 0;
    for (const double p : spectrum.power) sum += p;
    if (varies) spectrum.variance_scale = spectrum.variance / (2 * sum / n);
    for (double& p : spectrum.power) p *= varies ? spectrum.variance_scale * 2 / (n * spectrum.frequency_step) : 0;
    if (!varies) result.share.verdict = SpectrumVerdict::constant;
    if (!varies) return result;
    search.variance = spectrum.variance;
    LineFit fit(samples.times, values);
    const double before = mean_square_of(fit.residual());
    find_lines(result, fit, search);
    judge_lines(result, fit, before, line_options);
    return result;
}

}  // namespace swirl::analysis
