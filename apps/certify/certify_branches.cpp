// `swirl certify --along` and `--branches`: branches of cycles along a parameter, proven.
#include "apps/certify/certificate_file.hpp"
#include "apps/certify/certify_command.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/parameter_range.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/run_control.hpp"
#include "apps/orbits/recorded_cycles.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/studies/certify/proven_branches.hpp"
#include "map/model/parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps::certify {

namespace {

using proof::BranchBox;
using proof::BranchEnd;
using proof::BranchEndKind;
using proof::SpecialPoint;

/// What the scene of all branches is: its parameter does not matter, but is a number of it.
Scene<double> scene_along(Scene<double> scene, const ParameterRange& along) {
    number_of(scene, *along.parameter) = along.low;
    return scene;
}

void write_box(JsonWriter& json, const BranchBox& box) {
    json.begin_object();
    json.member("running", static_cast<std::int64_t>(box.running));
    json.list("range", std::vector<double>{box.low, box.high});
    json.list("middle", box.middle);
    json.member("within", box.within);
    json.key("outside");
    box.decided ? json.value(box.outside) : json.null();
    json.key("inside");
    box.decided ? json.value(box.inside) : json.null();
    json.end_object();
}

void write_end(JsonWriter& json, const BranchEnd& end, const ParameterRange& along) {
    json.begin_object();
    json.member("kind", proof::name_of(end.kind));
    json.member("proven", end.proven);
    json.key("box");
    json.begin_object();
    json.list(along.name, std::vector<double>{end.parameter_low, end.parameter_high});
    json.end_object();
    write_reason(json, end.reason);
    json.end_object();
}

void write_word(JsonWriter& json, const std::vector<proof::Branch>& word) {
    json.key("word");
    json.begin_array();
    for (const proof::Branch& letter : word) {
        json.begin_object();
        json.member("vertex_step", letter.vertex_step);
        json.member("contact_mode", name_of(letter.mode));
        json.member("slip", letter.slip);
        json.end_object();
    }
    json.end_array();
}

void write_special(JsonWriter& json, const SpecialPoint& special, const ParameterRange& along) {
    json.begin_object();
    json.member("kind", proof::name_of(special.kind));
    json.member("proven", special.proven);
    json.key("box");
    json.begin_object();
    json.list(along.name, std::vector<double>{special.parameter_low, special.parameter_high});
    json.end_object();
    json.member("outside_before", special.outside_before);
    json.member("outside_after", special.outside_after);
    if (special.proven) {
        json.list("middle", special.middle);
        json.member("within", special.within);
        if (special.kind == proof::SpecialKind::neimark_sacker)
            json.list("angle", std::vector<double>{special.angle_low, special.angle_high});
    }
    json.end_object();
}

void write_branch(JsonWriter& json, const CertifiedBranch& branch, const ParameterRange& along) {
    Scene<double> scene = branch.scene;
    json.begin_object(JsonLayout::rows);
    json.member("orbit", static_cast<std::int64_t>(branch.number));
    json.member("period", static_cast<std::int64_t>(branch.period));
    json.member("proven", branch.proof.proven());
    json.member("followed_from", number_of(scene, *along.parameter));
    write_reason(json, branch.proof.proven() ? std::string() : branch.proof.reason);
    write_word(json, branch.proof.itinerary);
    if (branch.proof.proven()) {
        json.list("range", std::vector<double>{branch.proof.from, branch.proof.to});
        json.member("length", branch.length());
        json.member("decided_share", branch.decided_share());
        json.key("stability");
        json.begin_array();
        for (const StabilitySpan& span : branch.spans()) {
            json.begin_object();
            json.list(along.name, std::vector<double>{span.begin, span.end});
            json.member("stability", proof::name_of(span.stability));
            json.end_object();
        }
        json.end_array();
        json.key("special");
        json.begin_array();
        for (const SpecialPoint& special : branch.proof.special) write_special(json, special, along);
        json.end_array();
        json.key("ends");
        json.begin_array();
        for (const BranchEnd& end : branch.proof.ends) write_end(json, end, along);
        json.end_array();
    }
    json.key("boxes");
    json.begin_array(JsonLayout::rows);
    for (const BranchBox& box : branch.proof.boxes) write_box(json, box);
    json.end_array();
    json.end_object();
}

void write_recorded(JsonWriter& json, const ProvenBranches& found) {
    json.key("recorded");
    json.begin_array(JsonLayout::rows);
    for (const RecordedBranch& branch : found.recorded) {
        json.begin_object();
        json.member("branch", static_cast<std::int64_t>(branch.number));
        json.member("cycles", static_cast<std::int64_t>(branch.places.size()));
        json.member("length", branch.length);
        json.member("proven_share", branch.length > 0 ? branch.proven_length / branch.length : 0);
        json.end_object();
    }
    json.end_array();
    json.member("proven_share", found.proven_share());
}

std::string document_of(const CertifyOptions& options, const ProvenBranches& found) {
    std::string text;
    JsonWriter json(text);
    const Scene<double> scene = scene_along(found.scene, found.along);
    const bool uniform = scene.inertia_factor == uniform_inertia_factor<double>(scene.sides) &&
                         found.along.parameter != Parameter::inertia_factor;
    json.begin_object(JsonLayout::rows);
    json.member("certificate", "swirl");
    write_scene(json, scene, options.scene);
    json.member("inertia", uniform ? "uniform lamina" : "as given");
    json.key("along");
    json.begin_object();
    json.list(found.along.name, std::vector<double>{found.along.low, found.along.high});
    json.end_object();
    json.key("branches");
    json.begin_array(JsonLayout::rows);
    for (const CertifiedBranch& branch : found.branches) write_branch(json, branch, found.along);
    json.end_array();
    json.member("proven", static_cast<std::int64_t>(found.proven()));
    json.member("boxes", static_cast<std::int64_t>(found.boxes()));
    if (!found.recorded.empty()) write_recorded(json, found);
    json.member("outcome", found.whole ? "completed" : "interrupted");
    json.member("swirl_version", version());
    json.end_object();
    json.finish();
    return with_checksum(text.substr(0, text.rfind("\n}")));
}

std::string word_of(const std::vector<proof::Branch>& word) {
    std::string text;
    for (const proof::Branch& letter : word)
        text += fmt::format("{}{:+d} {}", text.empty() ? "" : ", ", letter.vertex_step, name_of(letter.mode));
    return text;
}

std::string end_in_words(const BranchEnd& end, const ParameterRange& along) {
    if (end.kind == BranchEndKind::range) return fmt::format("at the end of the range, {:.9g}", end.parameter_low);
    if (end.kind == BranchEndKind::closed) return "where it began";
    const std::string place =
        fmt::format("between {} = {:.12g} and {:.12g}", along.name, end.parameter_low, end.parameter_high);
    if (end.reason.empty()) return fmt::format("{}: {}", place, proof::name_of(end.kind));
    const bool is_doubt = !end.proven && end.kind != BranchEndKind::equations;
    return fmt::format("{}: {}{}{}", place, is_doubt ? "not certain: " : "", end.reason, end.proven ? " (proven)" : "");
}

std::string special_in_words(const SpecialPoint& special) {
    const std::string counts =
        fmt::format("{} multipliers outside, then {}", special.outside_before, special.outside_after);
    if (!special.proven)
        return fmt::format("{}, not proven, between {:.12g} and {:.12g}: {}", proof::name_of(special.kind),
                           special.parameter_low, special.parameter_high, counts);
    const double middle = special.middle.back();
    std::string text = fmt::format("{} at {:.12g} (proven within {:.1g}): {}", proof::name_of(special.kind), middle,
                                   special.parameter_high - middle, counts);
    if (special.kind == proof::SpecialKind::neimark_sacker)
        text += fmt::format(", of angle {:.9g}", 0.5 * (special.angle_low + special.angle_high));
    return text;
}

void print_branch(const CertifiedBranch& branch, const ParameterRange& along) {
    const std::string head =
        fmt::format("  orbit {}, period {}, {}", branch.number, branch.period, word_of(branch.proof.itinerary));
    if (!branch.proof.proven()) {
        fmt::print("{}\n", wrapped(fmt::format("{}: not proven: {}", head, branch.proof.reason), 4));
        return;
    }
    fmt::print("{}\n", wrapped(fmt::format("{}: proven from {} = {:.10g} to {:.10g}, {} boxes", head, along.name,
                                           branch.proof.from, branch.proof.to, branch.proof.boxes.size()),
                               4));
    for (const StabilitySpan& span : branch.spans())
        if (span.stability != proof::ProvenStability::undecided)
            fmt::print("    {:<11} from {:.10g} to {:.10g}\n", proof::name_of(span.stability), span.begin, span.end);
    for (const SpecialPoint& special : branch.proof.special)
        fmt::print("    {}\n", wrapped(special_in_words(special), 6));
    for (const BranchEnd& end : branch.proof.ends)
        fmt::print("    {}\n", wrapped("ends " + end_in_words(end, along), 6));
}

void print_branches(const ProvenBranches& found, double seconds) {
    fmt::print("{} = {:g} to {:g}: {} of {} branches proven, in {} boxes\n", found.along.name, found.along.low,
               found.along.high, found.proven(), found.branches.size(), found.boxes());
    for (const CertifiedBranch& branch : found.branches) print_branch(branch, found.along);
    for (const RecordedBranch& branch : found.recorded)
        fmt::print("  branch {} of the record, {} cycles: {:.3f} % of its length is proven\n", branch.number,
                   branch.places.size(), branch.length > 0 ? 100 * branch.proven_length / branch.length : 0);
    if (!found.recorded.empty())
        fmt::print("  {:.3f} % of all branches' length is proven\n", 100 * found.proven_share());
    if (found.proven() > 0)
        fmt::print("  {:.1f} s: {:.0f} branches a minute\n", seconds,
                   60 * static_cast<double>(found.proven()) / std::max(seconds, 1e-3));
    if (!found.found) fmt::print("  no cycle found\n");
    if (!found.whole) fmt::print("  interrupted: some branches were not followed to their ends\n");
}

/// Narrower ones are below what a box's ends are known to.
void require_wide_range(const ParameterRange& along) {
    constexpr double least = 1e-4;
    if (!(along.high - along.low >= (1 - 1e-9) * least))  // 0.40005 - 0.39995 is one
        throw BadInput(fmt::format("along {}={:.12g}:{:.12g}: a range of {:g} or more is wanted", along.name, along.low,
                                   along.high, least));
}

/// The record's branches, each with its cycles in order.
std::vector<RecordedBranch> recorded_branches(const orbits::RecordCycles& cycles, const std::string& file) {
    if (cycles.along.empty() || cycles.branches.empty())
        throw BadInput(fmt::format(
            "record '{}' holds no branches along a parameter; one of continue or bifurcate --branches is needed",
            file));
    std::vector<RecordedBranch> recorded;
    for (std::size_t i = 0; i < cycles.places.size(); ++i) {
        const auto number = static_cast<std::size_t>(cycles.branches[i]);
        if (recorded.empty() || recorded.back().number != number) recorded.push_back({number, {}, 0, 0});
        recorded.back().places.push_back(cycles.places[i]);
    }
    return recorded;
}

/// From the least to the largest parameter that the record's cycles have.
ParameterRange range_of_cycles(const orbits::RecordCycles& cycles) {
    ParameterRange along;
    along.name = cycles.along;
    along.parameter = parameter_named(cycles.along);
    bool first = true;
    for (const CyclePlace& place : cycles.places) {
        Scene<double> scene = place.scene;
        const double value = number_of(scene, *along.parameter);
        along.low = first ? value : std::min(along.low, value);
        along.high = first ? value : std::max(along.high, value);
        first = false;
    }
    return along;
}

bool is_isolated(const Scene<double>& scene, const ParameterRange& along) {
    try {
        proof::require_isolated_branch(scene, *along.parameter, along.low, along.high);
    } catch (const std::invalid_argument&) {
        return false;
    }
    return true;
}

/// The range that the record was asked for, in which branches may go on beyond their last cycles; that of the cycles
/// alone where it is not told or reaches to where cycles come in families.
ParameterRange range_of(const orbits::RecordCycles& cycles) {
    ParameterRange own = range_of_cycles(cycles);
    if (cycles.range.empty()) return own;
    const bool counted = std::count(cycles.range.begin(), cycles.range.end(), ':') != 1;
    const ParameterRange asked = parameter_range_from(cycles.range, counted, true);
    ParameterRange along = own;
    along.low = std::min({own.low, asked.low, asked.high});
    along.high = std::max({own.high, asked.low, asked.high});
    return asked.parameter == own.parameter && is_isolated(cycles.scene, along) ? along : own;
}

ProvenBranches covered(const CertifyOptions& options) {
    const orbits::RecordCycles cycles = orbits::cycles_of_record(options.record);
    warn_without_checksum(options.record, options.output.quiet);
    std::vector<RecordedBranch> recorded = recorded_branches(cycles, options.record);
    const ParameterRange along = range_of(cycles);
    if (!(along.low < along.high))
        throw BadInput(fmt::format("record '{}': all its cycles have the same {}", options.record, along.name));
    require_wide_range(along);
    proof::require_isolated_branch(cycles.scene, *along.parameter, along.low, along.high);
    return cover_branches(cycles.scene, std::move(recorded), along, run_control(options.output));
}

ProvenBranches followed(const CertifyOptions& options, const ParameterRange& along) {
    AskedCycles asked = asked_cycles(options);
    for (const double end : {along.low, along.high}) {  // throws where the scene has no such number
        Scene<double> scene = asked.scene;
        number_of(scene, *along.parameter) = end;
        validated(scene);
    }
    proof::require_isolated_branch(asked.scene, *along.parameter, along.low, along.high);
    for (CyclePlace& place : asked.places) {
        const double value = number_of(place.scene, *along.parameter);
        if (value < along.low || value > along.high)
            throw BadInput(fmt::format("along {}={:g}:{:g} does not hold the cycle's own {} = {:g}", along.name,
                                       along.low, along.high, along.name, value));
    }
    const RunControl control = run_control(options.output);
    ProvenBranches found{asked.scene, along, prove_branches(asked.places, along, control), {}, true, asked.found};
    found.whole = !is_interrupted();
    return found;
}

}  // namespace

int certify_branches(CertifyOptions& options) {
    options.scene.read_file(options.output.quiet);
    options.start.take_from(options.scene);
    const ParameterRange along =
        options.branches ? ParameterRange{} : parameter_range_from(options.along, false, false);
    if (!options.branches) require_wide_range(along);
    if (options.all) options.max_time();  // refused before the file is opened
    const std::unique_ptr<OutputFile> file =
        open_certificate(options.certificate, options.output.force, {options.record, options.scene.file()});
    note_interruptions();
    const auto begin = std::chrono::steady_clock::now();
    const ProvenBranches found = options.branches ? covered(options) : followed(options, along);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    finish_up();
    give(
        options, file.get(), [&] { return document_of(options, found); }, [&] { print_branches(found, seconds); });
    if (!found.whole) return exit_interrupted;
    return found.found && found.proven() == found.branches.size() && found.proven() > 0 ? exit_done
                                                                                        : exit_numerical_ending;
}

}  // namespace swirl::apps::certify
