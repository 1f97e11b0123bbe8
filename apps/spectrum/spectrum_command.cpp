#include "apps/spectrum/spectrum_command.hpp"

#include "analysis/spectrum/lomb_scargle.hpp"
#include "analysis/spectrum/power_spectrum.hpp"
#include "analysis/spectrum/segments.hpp"
#include "analysis/spectrum/spectral_entropy.hpp"
#include "analysis/spectrum/uniform_motion.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/input/each_body.hpp"
#include "apps/spectrum/spectrum_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace swirl::apps::spectrum {

const char* const spectrum_details =
    R"(
A motion that repeats, in one period or several, has its power in lines; chaos spreads it over a continuum of frequencies. The
verdict says which (mixed: both; nonstationary: a transient). A peak's prominence is its power over the noise floor, the
continuum about it; entropy is 0 of one line and 1 of power that is spread evenly.

S(t) of an orbit is constant in flight and smooth in contact; it is averaged exactly over equal time bins. Frequencies are
in units of the swirl's. The bins divide the period of a cycle, and its peaks are named by their harmonic k of the cycle's
frequency; with --bins, harmonics above the highest frequency fold back below it and are marked as folded. Frequencies of a
series are cycles per unit of its times. Uneven times have Lomb and Scargle's periodogram, up to half the mean rate of the
rows, and lines by least squares. Gaps stay open: segments are so long that about as many lie between the gaps as there would be without; gaps of up to three rows in an angle are
bridged, as classify does. The integral of the power is the variance. An orbit that ends early is analysed as
far as it came, with exit code 3.

Examples:
  swirl spectrum --sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95
  swirl spectrum --sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1 --observable x --frame corotating)";

namespace {

constexpr std::size_t fewest_samples = 8;                  // as analysis::power_spectrum
constexpr std::int64_t most_bins = std::int64_t{1} << 24;  // some seconds and 1 GB, also of few impacts

/// The most samples of which `segments` overlapping segments lie between the gaps.
std::size_t segment_length(std::span<const analysis::Stretch> stretches, std::size_t n, std::int64_t segments,
                           double overlap) {
    if (segments == 0) return 0;
    const std::size_t length =
        analysis::fitted_segment_length(stretches, static_cast<std::size_t>(segments), overlap, n);
    if (length < fewest_samples)
        throw BadInput(fmt::format("segments = {} leaves {} of {} samples for each{}; {} or more are needed", segments,
                                   length, n, stretches.size() > 1 ? " between the gaps" : "", fewest_samples));
    return length;
}

/// A segment of whole periods, as many as fit into the length that it would have: then lines lie on frequencies of the
/// transform, and between them is what rounding leaves.
std::size_t whole_periods(const SpectrumSignal& signal, const analysis::SpectrumOptions& settings, std::size_t n) {
    const std::size_t length =
        settings.segment_length > 0 ? settings.segment_length : analysis::automatic_segment_length(n);
    const std::size_t period = signal.samples_of_period;
    return std::max(length / period, std::size_t{1}) * period;
}

analysis::SpectrumOptions settings_for(const SpectrumOptions& options, const SpectrumSignal& signal, std::size_t n) {
    analysis::SpectrumOptions settings;
    settings.window = analysis::window_from_name(options.window);
    settings.detrend = analysis::detrend_from_name(options.detrend);
    settings.overlap = options.overlap;
    settings.compensate_bin_average = options.compensate;
    settings.cycle_time = signal.cycle_time;
    settings.segments = static_cast<std::size_t>(options.segments);
    const auto stretches =
        signal.positions.empty() ? analysis::stretches_of(signal.values) : analysis::stretches_of(signal.positions);
    settings.segment_length = segment_length(stretches, n, options.segments, options.overlap);
    if (signal.samples_of_period > 0 && options.segments != 1)
        settings.segment_length = whole_periods(signal, settings, n);
    return settings;
}

void check_flags(const SpectrumOptions& options) {
    analysis::window_from_name(options.window);
    analysis::detrend_from_name(options.detrend);
    if (!(options.overlap >= 0 && options.overlap < 1))
        throw BadInput(fmt::format("overlap = {:g} is outside its range: 0 <= overlap < 1", options.overlap));
    if (options.output.accuracy() != Accuracy::double_precision && options.input.kind() != InputKind::scene)
        throw BadInput(fmt::format("accuracy = {} is an orbit's that is followed", options.output.accuracy_name));
    if (options.input.kind() == InputKind::series && options.frame != SpectrumOptions{}.frame)
        throw BadInput(fmt::format("frame = '{}' is of an orbit's positions; a series has none", options.frame));
    analysis::frame_from_name(options.frame);
    if (is_spin(options) && options.frame != SpectrumOptions{}.frame)
        throw BadInput(
            fmt::format("frame = '{}' is of positions (--observable x, y or position); S has none", options.frame));
}

/// So many rows are missing that segments between the gaps tell little of what all rows know together.
bool is_riddled(const SpectrumOptions& options, const SpectrumSignal& signal) {
    constexpr std::size_t short_segment = 64, fewer = 4;
    const auto stretches = analysis::stretches_of(signal.values);
    if (!signal.series || !signal.resampled.empty() || stretches.size() < 2 || options.segments > 0) return false;
    const std::size_t length = analysis::automatic_segment_length(stretches, options.overlap);
    const std::size_t without = analysis::automatic_segment_length(stretches.back().end - stretches.front().begin);
    return length < fewest_samples || (length < short_segment && fewer * length < without);
}

/// Where gaps make segments shorter than they would be.
void note_short_segments(const SpectrumOptions& options, const analysis::PowerSpectrum& spectrum,
                         SpectrumSignal& signal) {
    const auto stretches = analysis::stretches_of(signal.values);
    if (stretches.size() < 2 || options.segments > 0 || spectrum.segments == 0) return;
    const std::size_t without = analysis::automatic_segment_length(stretches.back().end - stretches.front().begin);
    if (spectrum.segment_length < without)
        signal.notes.push_back(fmt::format("segments lie between the gaps: {} samples long, {} without gaps",
                                           spectrum.segment_length, without));
}

/// Where most of the power lies within a few steps of the spectrum's frequencies from 0, of which a window makes one
/// lump.
void note_unresolved(const SpectrumOptions& options, const analysis::PowerSpectrum& spectrum, SpectrumSignal& signal) {
    constexpr std::size_t fewest_steps = 4;  // a Hann window's line is four steps wide
    if (!signal.series || options.segments > 0 || spectrum.segments < 2) return;
    const std::vector<double>& power = spectrum.power;
    double whole = 0, near = 0;
    for (std::size_t k = 0; k < power.size(); ++k) {
        whole += power[k];
        if (k < fewest_steps) near += power[k];
    }
    if (power.size() <= fewest_steps || !(near > 0.5 * whole)) return;
    signal.notes.push_back(
        fmt::format("most of the power lies below a frequency of {:.3g}, which {} segments do not resolve: --segments "
                    "1 makes one of "
                    "all rows",
                    spectrum.frequency[fewest_steps], spectrum.segments));
}

/// Of rows that lie on no even times, or so many of which are missing that no segment lies between the gaps.
void take_uneven(const SpectrumOptions& options, const SpectrumSignal& signal, SpectrumReport& report) {
    analysis::SpectrumOptions settings;
    settings.detrend = analysis::detrend_from_name(options.detrend);
    settings.cycle_time = signal.cycle_time;
    analysis::UnevenSpectrum found = analysis::uneven_spectrum(signal.series->times, signal.values, settings);
    report.uneven = true;
    report.spectrum = std::move(found.spectrum);
    report.peaks = std::move(found.peaks);
    report.share = found.share;
}

void refuse_segments_of_uneven(const SpectrumOptions& options) {
    const SpectrumOptions as_usual;
    const char* const flag = options.segments > 1                  ? "segments"
                             : options.overlap != as_usual.overlap ? "overlap"
                             : options.window != as_usual.window   ? "window"
                                                                   : nullptr;
    if (flag != nullptr)
        throw BadInput(
            fmt::format("--{} is of even times; those of this series are uneven, and all of its rows make one "
                        "periodogram (--resample DT makes them even)",
                        flag));
}

void take_even(const SpectrumOptions& options, SpectrumSignal& signal, std::size_t n, SpectrumReport& report) {
    const auto settings = settings_for(options, signal, n);
    report.spectrum = signal.positions.empty() ? analysis::power_spectrum(signal.values, signal.spacing, settings)
                                               : analysis::power_spectrum(signal.positions, signal.spacing, settings);
    note_short_segments(options, report.spectrum, signal);
    note_unresolved(options, report.spectrum, signal);
    analysis::Lines lines = analysis::find_lines(report.spectrum);
    report.peaks = std::move(lines.peaks);
    report.share = lines.share;
    if (signal.highest > 0)
        std::erase_if(report.peaks, [&](const auto& peak) { return peak.frequency > signal.highest; });
}

SpectrumReport report_of(const SpectrumOptions& options, SpectrumSignal& signal) {
    SpectrumReport report{options, signal, {}, {}, {}, std::nan("")};
    if (!signal.enough) return report;
    const std::size_t n = std::max(signal.positions.size(), signal.values.size());
    if (n < fewest_samples)
        throw BadInput(fmt::format("series of {} samples: a spectrum needs {} or more", n, fewest_samples));
    if (signal.uneven) {
        refuse_segments_of_uneven(options);
        take_uneven(options, signal, report);
        signal.notes.emplace_back("the times are uneven: Lomb and Scargle's periodogram, lines by least squares");
    } else if (is_riddled(options, signal)) {
        take_uneven(options, signal, report);
        signal.notes.emplace_back(
            "stretches between the gaps are short: Lomb and Scargle's periodogram of all rows, lines "
            "by least squares");
    } else {
        take_even(options, signal, n, report);
    }
    report.entropy = analysis::spectral_entropy(report.spectrum);
    return report;
}

}  // namespace

void SpectrumOptions::add_to(Flags& command) {
    input.add_to(command);
    output.add_to(command);
    Flags spectrum = command.under("Spectrum");
    spectrum
        .add_option("--observable", observable, "NAME",
                    "of an orbit: S (default), x, y, or position (x + iy, two-sided)")
        ->offer({"S", "x", "y", "position"});
    spectrum.add_option("--frame", frame, "NAME", "of positions: laboratory (default), container or corotating")
        ->offer({"laboratory", "container", "corotating"});
    add_whole_number(spectrum, "--bins", bins, "B", fewest_samples, most_bins,
                     "equal time bins of an orbit (default 4 or more an impact, a power of 2)");
    spectrum
        .add_option("--window", window, "NAME", "rectangular, hann (default), hamming, blackman-harris or flat-top")
        ->offer({"rectangular", "hann", "hamming", "blackman-harris", "flat-top"});
    spectrum.add_option("--detrend", detrend, "NAME", "what is subtracted: none, mean (default) or linear")
        ->offer({"none", "mean", "linear"});
    add_whole_number(spectrum, "--segments", segments, "K", 1, 1'000'000,
                     "of Welch's method (default about 16; 1: the finest resolution)");
    spectrum.add_option("--overlap", overlap, "F", "of neighbouring segments, 0 <= overlap < 1 (default 0.5)");
    spectrum.add_flag("--compensate", compensate, "undo what averaging over bins takes from the power");
    spectrum.add_option("--resample", resample, "DT",
                        "put a measured series on even times, this far apart: straight lines, then a low-pass");
}

int find_spectrum(SpectrumOptions& options) {
    check_flags(options);
    options.input.kind();
    if (!options.input.series.each.empty())
        return for_each_body(options.input.series, options.input.scene, options.input.start, options.output,
                             [&] { return find_spectrum(options); });
    std::optional<RecordWriter> record = open_record(options.output, "Power spectrum", options.input.files());
    SpectrumSignal signal = signal_of(options);
    if (is_interrupted()) return exit_interrupted;
    warn_without_checksum(options.input.record, options.output.quiet);
    exit_when_interrupted();
    const SpectrumReport report = report_of(options, signal);
    if (record) {
        if (signal.orbit) scale_columns(*record, *signal.orbit);
        write_record(record->root(), report);
        record->finish();
    }
    if (options.output.json)
        write_json(report);
    else if (!options.output.quiet)
        print_table(report);
    const bool cut = options.input.kind() == InputKind::scene && signal.orbit->outcome != "completed";
    using analysis::SpectrumOutcome;
    const bool none = report.spectrum.outcome == SpectrumOutcome::no_complete_segment ||
                      (report.uneven && report.spectrum.outcome == SpectrumOutcome::too_short);
    return cut || none ? exit_numerical_ending : exit_done;
}

}  // namespace swirl::apps::spectrum
