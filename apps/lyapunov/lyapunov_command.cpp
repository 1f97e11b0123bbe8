#include "apps/lyapunov/lyapunov_command.hpp"

#include "apps/command_line/documents.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/output/write_table.hpp"

#include <fmt/format.h>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::apps::lyapunov {

const char* const lyapunov_details =
    R"(Each exponent is the mean of ln growth per collision along one direction, from QR of the exact derivative; they are listed
by falling size. Where both halves of the orbit agree to 1e-8 (regular orbits) the means are weighted, elsewhere plain;
standard errors are from blocks. An exponent is -inf (null in JSON) where a direction is annihilated: sticking takes one
rank of DF, the end of a chatter several. The table then names the impacts that did so, and lists the exponents without
them. An exponent is neutral, zero, where the summed growth stays bounded. Without friction and with e = 1, J is conserved
and exponents pair to zero. An orbit that ends early (in-contact, no-contact ...) gives the exponents of the impacts that it
had, and exit code 3.

Example:
  swirl lyapunov --sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1 --collisions 20000)";

void LyapunovCommandOptions::add_to(Flags& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    add_whole_number(command, "--transient", transient, "K", 0, 1'000'000'000,
                     "impacts before those that count (default 10000)");
    add_whole_number(command, "--collisions", collisions, "K", 1, 1'000'000'000, "impacts that count (default 100000)");
}

namespace {

Settings result_of(const OrbitSpectrum& s) {
    return {{"outcome", std::string(name_of(s.outcome))},
            {"impacts", std::int64_t{s.impacts}},
            {"steps", s.spectrum.steps},
            {"time", s.spectrum.time},
            {"sum", s.sum},
            {"block_length", s.spectrum.block_length},
            {"jacobi_residual", s.jacobi_residual}};
}

/// The exponents, by falling size.
Table<std::size_t> exponent_table(const OrbitSpectrum& s) {
    using F = Field<std::size_t>;
    const auto from = [](const std::vector<double>& values) { return [&values](std::size_t i) { return values[i]; }; };
    const auto& means = s.spectrum;
    const ColumnFormat sign{"", column_format_of("  {}").text};
    F without{"without_losses", from(means.without_losses), "1", "per collision, over the impacts that did not"};
    if (!means.annihilations.empty()) without.shown("without them", " {:>16.9g}");
    return {{"exponent"},
            {F{"exponents", from(s.exponents), "1", "per collision"}.shown("per collision", "  {:>16.9g}"),
             F{"exponents_per_time", from(s.per_time), "omega_s", "per unit of time"}
                 .shown("per time", " {:>16.9g}")
                 .in_si("1/s"),
             F{"standard_errors", from(means.standard_errors), "1", "per collision"}.shown("std. error", " {:>12.2g}"),
             F{"standard_errors_per_time", from(means.per_time_standard_errors), no_column},
             F{"plain_means", from(means.exponents), no_column}.shown("plain mean", " {:>16.9g}"),
             F{"weighted_means", from(means.weighted_exponents), no_column},
             F{"lost_ranks", [&means](std::size_t i) { return means.lost_ranks[i]; }, "1",
               "impacts that annihilated this direction"},
             without, F{"signs", [&s](std::size_t i) { return s.signs[i].sign; }, no_column}.shown("", sign)},
            {},
            {"exponents", "standard_errors"}};
}

/// Which impacts annihilated how many directions at once.
Table<analysis::Annihilation> annihilation_table(const OrbitSpectrum& s) {
    using Row = analysis::Annihilation;
    const auto impact = [&s](std::int64_t Row::*step) {
        return [&s, step](const Row& row) { return static_cast<std::int64_t>(s.before) + row.*step; };
    };
    return {{"annihilation"},
            {{"directions", &Row::directions, "1", "directions that were annihilated at once"},
             {"impacts", &Row::steps, "1", "impacts that did so"},
             {"first", impact(&Row::first), "1", "number of the first of them, from the orbit's first impact on"},
             {"last", impact(&Row::last), "1", "of the last"}}};
}

/// How the running means converged.
Table<analysis::Checkpoint> convergence_table(std::size_t exponents) {
    using Row = analysis::Checkpoint;
    using F = Field<Row>;
    return {{"checkpoint"},
            {F{"collisions", &Row::step, "1", "collisions counted so far"}.coordinate(),
             F{"time", &Row::time, no_column}, F{"exponents", &Row::exponents, no_column},
             F{"convergence", &Row::exponents, "1", "running means per collision"}
                 .along({"exponent"}, exponents)
                 .record_only()}};
}

/// Why an exponent may be zero, as far as the scene tells.
std::string_view reason_of(const Scene<double>& scene) {
    if (scene.acts_in_flight()) return "the summed growth stays bounded";
    if (scene.mu == 0 && scene.restitution == 1) return "J is conserved (mu = 0, e = 1)";
    if (keeps_energy_without_sliding(scene)) return "without sliding J + I S/alpha is conserved (e = e_t = 1)";
    if (scene.is_disk() && scene.restitution == 1) return "the disk's steady modes are a family (e = 1)";
    if (scene.is_disk() && scene.mu == 0) return "S is conserved (disk without friction)";
    return "the summed growth stays bounded";
}

/// Those of the exponents that are zero.
Table<std::size_t> neutral_table(const Scene<double>& scene, const OrbitSpectrum& s) {
    return {{"neutral"},
            {{"index", [](std::size_t i) { return i; }, no_column},
             {"growth_order", [&s](std::size_t i) { return s.signs[i].growth_order; }, no_column},
             {"reason", [&scene](std::size_t) { return reason_of(scene); }, no_column}}};
}

std::vector<std::size_t> places_of(const OrbitSpectrum& s, bool only_neutral) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < s.signs.size(); ++i)
        if (!only_neutral || s.signs[i].sign == analysis::ExponentSign::neutral) places.push_back(i);
    return places;
}

void write_document(const LyapunovCommandOptions& options, const Scene<double>& scene, const Settings& settings,
                    const OrbitSpectrum& s) {
    print_document([&](JsonWriter& json) {
        write_scene(json, scene, options.scene, &options.start);
        write_lists(json, exponent_table(s), places_of(s, false));
        write_json(json, "annihilations", annihilation_table(s), s.spectrum.annihilations);
        write_json(json, "neutral", neutral_table(scene, s), places_of(s, true));
        write_json(json, "convergence", convergence_table(s.exponents.size()), s.spectrum.record);
        json.member("outcome", name_of(s.outcome));
        write_json(json, "result", result_of(s));
        write_json(json, "settings", settings);
    });
}

void print_spectrum(const Scene<double>& scene, const OrbitSpectrum& s, const std::optional<Units>& units) {
    fmt::print("{}\n{}  outcome {}; {} collisions counted, time {}\n", scene_in_words(scene), units_in_words(units),
               name_of(s.outcome), s.spectrum.steps, with_unit(s.spectrum.time, units, "1/omega_s"));
    if (s.signs.empty()) return;
    print_table(in_units(exponent_table(s), units), places_of(s, false));
    for (const analysis::Annihilation& those : s.spectrum.annihilations)
        fmt::print("  {} direction{} annihilated by {} impact{}, the first of them number {}\n", those.directions,
                   those.directions == 1 ? "" : "s", those.steps, those.steps == 1 ? "" : "s", s.before + those.first);
    fmt::print("  sum {:.9g}\n", s.sum);
    if (std::isfinite(s.jacobi_residual))
        fmt::print("  J is conserved: its gradient is carried along to {:.1e}\n", s.jacobi_residual);
}

void write_spectrum(const RecordGroup& root, const LyapunovCommandOptions& options, const Scene<double>& scene,
                    const Settings& settings, const OrbitSpectrum& s) {
    write_scene(root, scene, &options.start);
    write_attributes(root.group("settings"), settings);
    write_attributes(root.group("result"), result_of(s));
    if (s.exponents.empty()) return;
    const RecordGroup group = root.group("lyapunov");
    write_record(group, exponent_table(s), places_of(s, false));
    if (!s.spectrum.annihilations.empty())
        write_record(root.group("annihilations"), annihilation_table(s), s.spectrum.annihilations);
    write_record(group, convergence_table(s.exponents.size()), s.spectrum.record);
}

}  // namespace

int lyapunov(LyapunovCommandOptions& options) {
    options.scene.read_file(options.output.quiet);
    options.start.take_from(options.scene);
    const Scene<double> scene = options.scene.scene<double>(Extensions::followed);
    const Accuracy accuracy = options.output.accuracy();
    const Start<double> start = options.start.start<double>(scene);
    std::optional<RecordWriter> record = open_record(options.output, "Lyapunov spectrum of a swirled polygon",
                                                     {options.scene.file()}, options.scene.units());
    exit_when_interrupted();
    const OrbitSpectrum s = spectrum_of(scene, start, options.transient, options.collisions, accuracy);
    const Settings settings = {{"transient", options.transient},
                               {"collisions", options.collisions},
                               {"accuracy", options.output.accuracy_name}};
    if (record) {
        write_spectrum(record->root(), options, scene, settings, s);
        record->finish();
    }
    if (options.output.json)
        write_document(options, scene, settings, s);
    else if (!options.output.quiet)
        print_spectrum(scene, s, options.scene.units());
    return s.outcome == Outcome::completed ? exit_done : exit_numerical_ending;
}

}  // namespace swirl::apps::lyapunov
