#include "apps/lyapunov/lyapunov_command.hpp"

#include "apps/command_line/documents.hpp"
#include "apps/command_line/interruption.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace swirl::apps::lyapunov {

const char* const lyapunov_details =
    R"(Exponents are means of ln growth per collision, by falling size, from QR of the exact derivative: weighted means
where both halves of the orbit agree on them to 1e-8 (regular orbits), plain means elsewhere; standard errors are from
blocks. One that is -inf (null in JSON) lost a rank: sticking annihilates a direction. neutral: zero, because the summed
growth stays bounded. Without friction and with e = 1 J is conserved, and exponents pair to zero.
An orbit that ends before its collisions are whole (in-contact, no-contact ...) is told with exit 3 and what there was.

Example:
  swirl lyapunov --sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1 --collisions 20000)";

void LyapunovCommandOptions::add_to(CLI::App& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    command.add_option("--transient", transient, "impacts before those that count (default 10000)")
        ->type_name("K")
        ->check(CLI::Range(std::int64_t{0}, std::int64_t{1'000'000'000}));
    command.add_option("--collisions", collisions, "impacts that count (default 100000)")
        ->type_name("K")
        ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000}));
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

void write_list(JsonWriter& json, std::string_view key, const std::vector<double>& values) {
    json.key(key);
    json.begin_array();
    for (const double value : values) json.value(value);
    json.end_array();
}

void write_exponents(JsonWriter& json, const OrbitSpectrum& s) {
    write_list(json, "exponents", s.exponents);
    write_list(json, "exponents_per_time", s.per_time);
    const analysis::LyapunovSpectrum nothing;
    const auto& spectrum = s.exponents.empty() ? nothing : s.spectrum;  // that of no step is a NaN for each direction
    write_list(json, "standard_errors", spectrum.standard_errors);
    write_list(json, "standard_errors_per_time", spectrum.per_time_standard_errors);
    write_list(json, "plain_means", spectrum.exponents);
    write_list(json, "weighted_means", spectrum.weighted_exponents);
    json.key("signs");
    json.begin_array();
    for (const auto& sign : s.signs) json.value(analysis::name_of(sign.sign));
    json.end_array();
}

/// Why an exponent may be zero, as far as the scene tells.
std::string_view reason_of(const Scene<double>& scene) {
    if (scene.mu == 0 && scene.restitution == 1) return "J is conserved (mu = 0, e = 1)";
    if (scene.is_disk() && scene.restitution == 1) return "the disk's steady modes are a family (e = 1)";
    if (scene.is_disk() && scene.mu == 0) return "S is conserved (disk without friction)";
    return "the summed growth stays bounded";
}

void write_document(const LyapunovCommandOptions& options, const Scene<double>& scene, const Settings& settings,
                    const OrbitSpectrum& s) {
    JsonWriter json(stdout);
    json.begin_object(JsonLayout::rows);
    write_json(json, "scene", scene_settings(scene));
    write_json(json, "start", start_settings(options.start, scene));
    if (const auto units = options.scene.units()) write_json(json, "units", unit_settings(*units));
    write_exponents(json, s);
    json.key("neutral");
    json.begin_array(JsonLayout::rows);
    for (std::size_t i = 0; i < s.signs.size(); ++i) {
        if (s.signs[i].sign != analysis::ExponentSign::neutral) continue;
        json.begin_object();
        json.member("index", static_cast<std::int64_t>(i));
        json.member("growth_order", s.signs[i].growth_order);
        json.member("reason", reason_of(scene));
        json.end_object();
    }
    json.end_array();
    json.key("convergence");
    json.begin_array(JsonLayout::rows);
    for (const auto& point : s.spectrum.record) {
        json.begin_object();
        json.member("collisions", point.step);
        json.member("time", point.time);
        write_list(json, "exponents", point.exponents);
        json.end_object();
    }
    json.end_array();
    json.member("outcome", name_of(s.outcome));
    write_json(json, "result", result_of(s));
    write_json(json, "settings", settings);
    json.member("swirl_version", std::string_view(version()));
    json.end_object();
    json.finish();
}

void print_table(const Scene<double>& scene, const OrbitSpectrum& s) {
    fmt::print("{}\n  outcome {}; {} collisions counted, time {:.6g}\n", describe(scene), name_of(s.outcome),
               s.spectrum.steps, s.spectrum.time);
    if (s.signs.empty()) return;
    fmt::print("  {:>16} {:>12} {:>16} {:>16}\n", "per collision", "std. error", "per time", "plain mean");
    for (std::size_t i = 0; i < s.signs.size(); ++i)
        fmt::print("  {:>16.9g} {:>12.2g} {:>16.9g} {:>16.9g}  {}\n", s.exponents[i], s.spectrum.standard_errors[i],
                   s.per_time[i], s.spectrum.exponents[i], analysis::name_of(s.signs[i].sign));
    fmt::print("  sum {:.9g}\n", s.sum);
    if (std::isfinite(s.jacobi_residual))
        fmt::print("  J is conserved: its gradient is carried along to {:.1e}\n", s.jacobi_residual);
}

void write_record(RecordWriter& record, const LyapunovCommandOptions& options, const Scene<double>& scene,
                  const Settings& settings, const OrbitSpectrum& s) {
    const RecordGroup root = record.root();
    write_attributes(root.group("scene"), scene_settings(scene));
    write_attributes(root.group("start"), start_settings(options.start, scene));
    write_attributes(root.group("settings"), settings);
    write_attributes(root.group("result"), result_of(s));
    if (!s.exponents.empty()) {
        const RecordGroup group = root.group("lyapunov");
        const std::vector<std::string> along{"exponent"}, both{"checkpoint", "exponent"};
        group.dimension("exponent", s.exponents.size());
        group.dimension("checkpoint", s.spectrum.record.size());
        group.write<double>("exponents", along, s.exponents, {"1", "per collision", {}});
        group.write<double>("exponents_per_time", along, s.per_time, {"omega_s", "per unit of time", {}});
        group.write<double>("standard_errors", along, s.spectrum.standard_errors, {"1", "per collision", {}});
        std::vector<std::int64_t> steps;
        std::vector<double> values;
        for (const auto& point : s.spectrum.record) {
            steps.push_back(point.step);
            values.insert(values.end(), point.exponents.begin(), point.exponents.end());
        }
        group.write<std::int64_t>("checkpoint", {"checkpoint"}, steps, {"1", "collisions counted so far", {}});
        group.write<double>("convergence", both, values, {"1", "running means per collision", {}});
    }
    record.finish();
}

}  // namespace

int lyapunov(LyapunovCommandOptions& options) {
    options.scene.read_file();
    const Scene<double> scene = options.scene.scene<double>();
    if (options.output.accuracy() != Accuracy::double_precision)
        throw BadInput(fmt::format("accuracy = {}: lyapunov works in double", options.output.accuracy_name));
    const Start<double> start = options.start.start<double>(scene);
    std::optional<RecordWriter> record;
    if (!options.output.record.empty())
        record.emplace(open_record(options.output.record, "Lyapunov spectrum of a swirled polygon"));
    exit_when_interrupted();
    const OrbitSpectrum s = spectrum_of(scene, start, options.transient, options.collisions);
    const Settings settings = {{"transient", options.transient},
                               {"collisions", options.collisions},
                               {"accuracy", options.output.accuracy_name}};
    if (record) write_record(*record, options, scene, settings, s);
    if (options.output.json)
        write_document(options, scene, settings, s);
    else if (!options.output.quiet)
        print_table(scene, s);
    return s.outcome == Outcome::completed ? exit_done : exit_numerical_ending;
}

}  // namespace swirl::apps::lyapunov
