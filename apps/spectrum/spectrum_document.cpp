#include "apps/spectrum/spectrum_document.hpp"

#include "apps/output/write_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace swirl::apps::spectrum {

namespace {

using analysis::SpectralPeak;

/// The units of frequency, of the signal, of its variance and of its power; a series' own are not known.
struct SpectrumUnits {
    const char *frequency = "1", *signal = "1", *variance = "1", *power = "1";
};

SpectrumUnits units_of(const SpectrumReport& report) {
    if (!report.signal.orbit) return {};
    if (report.options.observable == "S") return {"omega_s", "1", "1", "1/omega_s"};
    return {"omega_s", "R_c", "R_c^2", "R_c^2 1/omega_s"};
}

/// 1/T of the cycle that S(t) is; NaN: none is known.
double fundamental_of(const SpectrumReport& report) {
    return report.signal.period > 0 ? report.signal.cycle_time / report.signal.period : std::nan("");
}

/// The k with a peak at k times the cycle's frequency; NaN: at none.
double harmonic_of(const SpectrumReport& report, const SpectralPeak& peak) {
    constexpr double in_bins = 0.05;  // peaks are right to 1e-4 bins, but for those of a rectangular window
    const double fundamental = fundamental_of(report), k = std::round(peak.frequency / fundamental);
    const bool near = std::abs(peak.frequency - k * fundamental) <= in_bins * report.spectrum.frequency_step;
    return near && k > 0 ? k : std::nan("");
}

/// Of a cycle nothing else has power: a harmonic above the highest frequency, which the bins folded back below it.
bool is_folded(const SpectrumReport& report, const SpectralPeak& peak) {
    return report.signal.period > 0 && std::isnan(harmonic_of(report, peak));
}

Table<SpectralPeak> peak_table(const SpectrumReport& report) {
    using F = Field<SpectralPeak>;
    const SpectrumUnits units = units_of(report);
    const auto harmonic = [&report](const SpectralPeak& peak) { return harmonic_of(report, peak); };
    F number{"harmonic", harmonic, "1", "k of a cycle's line at k times its frequency; NaN: none"};
    if (report.signal.period > 0) number.shown("harmonic", " {:>8.6g}");
    return {{"peak"},
            {F{"frequency", &SpectralPeak::frequency, units.frequency, "between bins"}.shown("peak: frequency",
                                                                                             "{:>16.9g}"),
             F{"power", &SpectralPeak::power, units.variance, "variance of the line"}.shown("power", " {:>14.6g}"),
             F{"amplitude", &SpectralPeak::amplitude, units.signal, "A of A cos(2 pi f t + phase)"}.shown("amplitude",
                                                                                                          " {:>14.6g}"),
             F{"prominence", &SpectralPeak::prominence, "1", "power over the noise floor"}.shown("prominence",
                                                                                                 " {:>12.4g}"),
             {"spread", &SpectralPeak::spread, "1", "scatter between segments: 0 a line, 1 a continuum"},
             number,
             {"folded", [&report](const SpectralPeak& peak) { return is_folded(report, peak); }, "1",
              "of a cycle: a harmonic above the highest frequency, folded back below it"}}};
}

Settings settings_of(const SpectrumReport& report) {
    const auto& options = report.options;
    const auto& s = report.spectrum;
    const ImpactRange range = options.input.range();
    Settings settings = {{"transient", range.transient}};
    if (range.collisions >= 0) settings.emplace_back("collisions", range.collisions);
    if (report.signal.orbit) {
        settings.emplace_back("observable", options.observable);
        if (options.observable != "S") settings.emplace_back("frame", options.frame);
        settings.emplace_back("bins", static_cast<std::int64_t>(s.samples));
        settings.emplace_back("compensate", options.compensate);
        settings.emplace_back("accuracy", options.output.accuracy_name);
    }
    if (report.signal.series)
        settings.emplace_back("samples_bridged", static_cast<std::int64_t>(report.signal.bridged));
    const Settings rest = {
        {"window", options.window},         {"detrend", options.detrend},
        {"overlap", options.overlap},       {"segment_length", static_cast<std::int64_t>(s.segment_length)},
        {"spacing", report.signal.spacing}, {"cycle_time", report.signal.cycle_time}};
    settings.insert(settings.end(), rest.begin(), rest.end());
    return settings;
}

Settings result_of(const SpectrumReport& report) {
    const auto& s = report.spectrum;
    const std::string state = report.signal.enough ? std::string(name_of(s.outcome)) : "too-short";
    return {{"spectrum_outcome", state},
            {"method", std::string(report.uneven ? "lomb-scargle" : "welch")},
            {"two_sided", s.two_sided},
            {"frequency_step", s.frequency_step},
            {"fundamental", fundamental_of(report)},
            {"variance", s.variance},
            {"entropy", report.entropy},
            {"verdict", std::string(name_of(report.share.verdict))},
            {"line_fraction", report.share.line_fraction},
            {"nonstationarity", s.nonstationarity},
            {"segments", static_cast<std::int64_t>(s.segments)},
            {"segments_skipped", static_cast<std::int64_t>(s.segments_skipped)},
            {"variance_scale", s.variance_scale}};
}

}  // namespace

void write_json(const SpectrumReport& report) {
    print_document([&](JsonWriter& json) {
        if (report.signal.orbit) write_orbit(json, *report.signal.orbit);
        if (report.signal.series) write_json(json, "series", series_settings(*report.signal.series));
        if (!report.signal.resampled.empty()) write_json(json, "resampled", report.signal.resampled);
        json.list("frequency", report.spectrum.frequency);
        json.list("power", report.spectrum.power);
        write_json(json, "peaks", peak_table(report), report.peaks);
        write_members(json, result_of(report));
        json.list("notes", report.signal.notes, JsonLayout::rows);
        write_json(json, "settings", settings_of(report));
    });
}

void write_record(const RecordGroup& root, const SpectrumReport& report) {
    if (report.signal.orbit) write_orbit(root, *report.signal.orbit);
    if (report.signal.series) write_series(root, *report.signal.series);
    if (!report.signal.resampled.empty()) write_attributes(root.group("resampled"), report.signal.resampled);
    write_attributes(root.group("settings"), settings_of(report));
    const RecordGroup group = root.group("spectrum");
    write_attributes(group, result_of(report));
    group.attribute("notes", fmt::format("{}", fmt::join(report.signal.notes, "; ")));
    const auto& s = report.spectrum;
    const SpectrumUnits units = units_of(report);
    if (!s.frequency.empty()) {
        group.dimension("frequency", s.frequency.size());
        group.write<double>(
            "frequency", {"frequency"}, s.frequency,
            {units.frequency, "frequency: 1 is the swirl's, or of a series a cycle per unit of its times", {}});
        group.write<double>("power", {"frequency"}, s.power,
                            {units.power, "power per unit of frequency; its integral is the variance", {}});
    }
    if (!report.peaks.empty()) apps::write_record(root.group("peaks"), peak_table(report), report.peaks);
}

void print_table(const SpectrumReport& report) {
    if (report.signal.orbit)
        fmt::print("{} after {} impacts\n", report.signal.orbit->outcome, report.signal.orbit->impacts);
    if (report.signal.series)
        fmt::print("series: {}\n{}", series_in_words(*report.signal.series), notes_in_lines(*report.signal.series));
    const auto& s = report.spectrum;
    const auto units = report.signal.orbit ? units_of(*report.signal.orbit) : std::nullopt;
    fmt::print("{}", units_in_words(units));
    if (report.uneven)
        fmt::print("{} samples at uneven times, {:.6g} apart; ", s.samples, s.spacing);
    else
        fmt::print("{} samples every {}, {} segments of {}; ", s.samples,
                   with_unit(report.signal.spacing, units, "1/omega_s"), s.segments, s.segment_length);
    fmt::print("variance {}, entropy {}\n{} ({:.1f} % in lines)\n",
               with_unit(s.variance, units, units_of(report).variance),
               std::isnan(report.entropy) ? "-" : fmt::format("{:.4f}", report.entropy), name_of(report.share.verdict),
               100 * report.share.line_fraction);
    constexpr std::size_t most = 20;
    std::vector<SpectralPeak> peaks = report.peaks;
    const std::size_t folded = std::erase_if(peaks, [&](const SpectralPeak& peak) { return is_folded(report, peak); });
    if (!peaks.empty())
        apps::print_table(in_units(peak_table(report), units), std::span(peaks).first(std::min(most, peaks.size())));
    if (peaks.size() > most) fmt::print("and {} more (--json, -o)\n", peaks.size() - most);
    if (folded > 0)
        fmt::print("and {} folded: harmonics of the cycle above {}, which these bins show below it\n", folded,
                   with_unit(s.frequency.back(), units, "omega_s"));
    for (const auto& note : report.signal.notes) fmt::print("note: {}\n", note);
}

}  // namespace swirl::apps::spectrum
