// `swirl certify --chaos`: sets that F carries over each other, and the entropy that follows.
#include "apps/certify/certificate_file.hpp"
#include "apps/certify/certify_command.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/run_control.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/certify/proven_chaos.hpp"
#include "map/orbit/orbit.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps::certify {

namespace {

constexpr std::array coordinate_names{"psi", "chi", "vn", "vt", "S"};

void write_cycles(JsonWriter& json, const ProvenChaos& found) {
    json.key("cycles");
    json.begin_array(JsonLayout::rows);
    for (const ChaosCycle& cycle : found.cycles) {
        json.begin_object();
        json.member("orbit", static_cast<std::int64_t>(cycle.number));
        json.member("period", static_cast<std::int64_t>(cycle.period));
        json.member("multiplier", cycle.multiplier);
        write_reason(json, cycle.reason);
        json.end_object();
    }
    json.end_array();
    json.key("connections");
    json.begin_array(JsonLayout::rows);
    for (const ChaosLink& orbit : found.orbits) {
        json.begin_object();
        json.member("from", static_cast<std::int64_t>(orbit.from));
        json.member("to", static_cast<std::int64_t>(orbit.to));
        json.member("sets", static_cast<std::int64_t>(orbit.sets));
        json.member("proven", orbit.proven);
        write_reason(json, orbit.reason);
        json.end_object();
    }
    json.end_array();
}

void write_sets(JsonWriter& json, const ProvenChaos& found) {
    json.key("sets");
    json.begin_array(JsonLayout::rows);
    for (std::size_t i = 0; i < found.claim.sets.size(); ++i) {
        const proof::SectionSet& set = found.claim.sets[i];
        const std::size_t n = set.centre.size();
        json.begin_object();
        json.list("centre", set.centre);
        json.key("matrix");
        json.begin_array();
        for (std::size_t row = 0; row < n; ++row)
            json.array(std::vector<double>(set.matrix.begin() + static_cast<std::ptrdiff_t>(row * n),
                                           set.matrix.begin() + static_cast<std::ptrdiff_t>((row + 1) * n)));
        json.end_array();
        json.member("weight", i < found.bound.weights.size() ? found.bound.weights[i] : 0.0);
        json.end_object();
    }
    json.end_array();
    json.key("coverings");
    json.begin_array(JsonLayout::rows);
    for (std::size_t i = 0; i < found.claim.links.size(); ++i) {
        const proof::CoveringClaim& link = found.claim.links[i];
        const SectionPoint<double>& z = link.image;
        json.begin_object();
        json.member("from", static_cast<std::int64_t>(link.from + 1));
        json.member("to", static_cast<std::int64_t>(link.to + 1));
        json.member("vertex_step", link.branch.vertex_step);
        json.member("contact_mode", name_of(link.branch.mode));
        json.member("flight_time", link.time);
        json.list("image", std::vector<double>{z.psi, z.chi, z.vn, z.vt, z.spin});
        json.member("pieces", found.pieces[i]);
        json.end_object();
    }
    json.end_array();
}

Settings result_of(const ProvenChaos& found) {
    return {{"proven", found.proven()},
            {"entropy", found.bound.entropy},
            {"growth", found.bound.growth},
            {"exponent", found.exponent},
            {"J", found.claim.jacobi.value_or(std::nan(""))},
            {"reason", found.reason}};
}

std::vector<std::string> chart_names(const ProvenChaos& found) {
    std::vector<std::string> names;
    for (const std::size_t index : proof::section_chart(found.scene)) names.emplace_back(coordinate_names[index]);
    return names;
}

struct ChaosSet {
    const proof::SectionSet* set;
    double weight;
};

Table<ChaosSet> set_table(const std::vector<std::string>& coordinates) {
    using F = Field<ChaosSet>;
    Table<ChaosSet> table{{"set"}, {}, {}, {}};
    const std::size_t n = coordinates.size();
    for (std::size_t i = 0; i < n; ++i)
        table.fields.push_back(
            F{"centre_" + coordinates[i], [i](const ChaosSet& s) { return s.set->centre[i]; }, "1", "of the set"});
    for (std::size_t edge = 0; edge < n; ++edge)
        for (std::size_t i = 0; i < n; ++i)
            table.fields.push_back(F{fmt::format("edge{}_{}", edge + 1, coordinates[i]),
                                     [=](const ChaosSet& s) { return s.set->matrix[n * i + edge]; }, "1",
                                     edge == 0 ? "half the edge that F stretches" : "half an edge"});
    table.fields.push_back(F{"weight", &ChaosSet::weight, "1", "v of A v >= growth v, A the matrix of the coverings"});
    return table;
}

struct ChaosCovering {
    const proof::CoveringClaim* link;
    int pieces;
};

Table<ChaosCovering> covering_table() {
    using F = Field<ChaosCovering>;
    const auto number = [](std::size_t proof::CoveringClaim::*end) {
        return [end](const ChaosCovering& c) { return static_cast<std::int64_t>(c.link->*end) + 1; };
    };
    return {{"covering"},
            {F{"from", number(&proof::CoveringClaim::from), "1", "the set, from 1"},
             F{"to", number(&proof::CoveringClaim::to), "1", "the set that it is carried over"},
             F{"contact_mode", [](const ChaosCovering& c) { return std::string(name_of(c.link->branch.mode)); }, "",
               "of the impacts"},
             F{"flight_time", [](const ChaosCovering& c) { return c.link->time; }, "1/omega_s",
               "from the first set's centre"},
             F{"pieces", [](const ChaosCovering& c) { return std::int64_t{c.pieces}; }, "1", "in which it is proven"}},
            {},
            {}};
}

Table<CarriedPoint> carried_table() {
    using F = Field<CarriedPoint>;
    return {
        {"carried_point"},
        {F{"covering", [](const CarriedPoint& p) { return static_cast<std::int64_t>(p.covering) + 1; }, "1", "from 1"},
         F{"q", &CarriedPoint::q, "1", "of the set that is carried, along the edge that F stretches"},
         F{"side", &CarriedPoint::side, "1", "along its second edge"},
         F{"carried_q", &CarriedPoint::carried_q, "1", "where F carries it, in the edges of the other set"},
         F{"carried_side", &CarriedPoint::carried_side, "1", "along the second of these"}},
        {},
        {}};
}

void write_chaos_record(RecordWriter& record, const ProvenChaos& found, const Settings& settings) {
    constexpr int points = 41;
    std::vector<ChaosSet> sets;
    for (std::size_t i = 0; i < found.claim.sets.size(); ++i)
        sets.push_back({&found.claim.sets[i], i < found.bound.weights.size() ? found.bound.weights[i] : 0});
    std::vector<ChaosCovering> coverings;
    for (std::size_t i = 0; i < found.claim.links.size(); ++i)
        coverings.push_back({&found.claim.links[i], found.pieces[i]});
    const RecordGroup root = record.root();
    write_attributes(root.group("scene"), scene_settings(found.scene));
    write_attributes(root.group("settings"), settings);
    write_attributes(root.group("result"), {{"outcome", found.whole ? "completed" : "interrupted"}});
    write_attributes(root.group("chaos"), result_of(found));
    write_record(root.group("sets"), set_table(chart_names(found)), sets);
    write_record(root.group("coverings"), covering_table(), coverings);
    write_record(root.group("carried"), carried_table(), carried_points(found, points));
}

Settings settings_of(const ChaosOptions& how) {
    return {{"link_length", static_cast<std::int64_t>(how.longest_link)},
            {"exponent_impacts", static_cast<std::int64_t>(how.exponent_impacts)}};
}

std::string document_of(const CertifyOptions& options, const ProvenChaos& found, const ChaosOptions& how) {
    std::string text;
    JsonWriter json(text);
    const bool uniform = found.scene.inertia_factor == uniform_inertia_factor<double>(found.scene.sides);
    json.begin_object(JsonLayout::rows);
    json.member("certificate", "swirl");
    write_scene(json, found.scene, options.scene);
    json.member("inertia", uniform ? "uniform lamina" : "as given");
    json.key("chaos");
    json.begin_object();
    json.member("proven", found.proven());
    json.member("entropy", found.bound.entropy);
    json.member("growth", found.bound.growth);
    json.member("exponent", found.exponent);
    write_reason(json, found.reason);
    json.end_object();
    json.key("coordinates");
    json.begin_array();
    for (const std::string& name : chart_names(found)) json.value(name);
    json.end_array();
    json.key("J");
    found.claim.jacobi ? json.value(*found.claim.jacobi) : json.null();
    write_cycles(json, found);
    write_sets(json, found);
    json.member("outcome", found.whole ? "completed" : "interrupted");
    write_json(json, "settings", settings_of(how));
    json.member("swirl_version", version());
    json.end_object();
    json.finish();
    return with_checksum(text.substr(0, text.rfind("\n}")));
}

void print_chaos(const CertifyOptions& options, const ProvenChaos& found) {
    fmt::print("{}\n{}", scene_in_words(found.scene), units_in_words(options.scene.units()));
    for (const ChaosCycle& cycle : found.cycles)
        fmt::print("{}\n", wrapped(fmt::format("  orbit {}, period {}: {}", cycle.number, cycle.period,
                                               cycle.reason.empty()
                                                   ? fmt::format("{0} set{1}, multiplier {2:.6g}", cycle.period,
                                                                 cycle.period == 1 ? "" : "s", cycle.multiplier)
                                                   : "left out: " + cycle.reason),
                                   4));
    std::map<std::array<std::size_t, 3>, std::size_t> proven;  // from, to, sets: how many
    std::size_t failed = 0;
    const std::string* why = nullptr;
    for (const ChaosLink& orbit : found.orbits) {
        if (orbit.proven) ++proven[{orbit.from, orbit.to, orbit.sets}];
        if (orbit.proven) continue;
        if (failed++ == 0) why = &orbit.reason;
    }
    for (const auto& [key, count] : proven)
        fmt::print("  from {} to {} by {} sets: {} orbit{} proven\n", key[0], key[1], key[2], count,
                   count == 1 ? "" : "s");
    if (failed > 0)
        fmt::print("{}\n",
                   wrapped(fmt::format("  {} orbit{} not proven: {}", failed, failed == 1 ? "" : "s", *why), 4));
    fmt::print("  {} sets, {} times one is carried over another, in {} pieces\n", found.claim.sets.size(),
               found.claim.links.size(), std::accumulate(found.pieces.begin(), found.pieces.end(), 0));
    if (found.proven())
        fmt::print("  proven: topological entropy of F >= {:.6f} per impact\n", found.bound.entropy);
    else
        fmt::print("{}\n", wrapped(fmt::format("  no chaos proven: {}", found.reason), 4));
    if (!std::isnan(found.exponent))
        fmt::print("  largest Lyapunov exponent of an orbit from there: {:.4f} per impact, not proven\n",
                   found.exponent);
    if (!found.whole) fmt::print("  interrupted: some were not tried\n");
}

/// Cycles along a branch have scenes of their own.
bool are_alike(const Scene<double>& a, const Scene<double>& b) {
    return a.alpha == b.alpha && a.beta == b.beta && a.mu == b.mu && a.restitution == b.restitution &&
           a.inertia_factor == b.inertia_factor;
}

/// A frictionless disk's cycles come in families: the point says on which level of J, and Newton's method on that level
/// finds the cycle near it.
AskedCycles asked_on_level(const CertifyOptions& options, const Scene<double>& scene) {
    if (options.near.empty())
        throw BadInput(
            "chaos of a disk without friction: --near psi,vn,vt,S is wanted, whose J is the level looked at");
    const auto z = section_point_from<double>("--near", point_without_units(options.near, options.scene.units()), true);
    require_leaving(make_body(scene), z);
    const auto period = static_cast<std::size_t>(options.period());
    return {scene, {{scene, std::vector<SectionPoint<double>>(period, z), 1}}, true, true};
}

}  // namespace

int certify_chaos(CertifyOptions& options) {
    options.scene.read_file(options.output.quiet);
    options.start.take_from(options.scene);
    if (options.record.empty()) proof::require_chart(options.scene.scene<double>());
    if (options.all) options.max_time();  // refused before the file is opened
    CertifyFiles files = open_files(options, "Sets that the map carries over each other: chaos, proven");
    note_interruptions();
    ChaosOptions how;
    how.longest_link = static_cast<int>(options.link_length.value_or(how.longest_link));
    how.control = run_control(options.output);
    const bool on_level =
        options.record.empty() && options.scene.scene<double>().is_disk() && options.scene.scene<double>().mu == 0;
    const AskedCycles asked = on_level ? asked_on_level(options, options.scene.scene<double>()) : asked_cycles(options);
    for (const CyclePlace& place : asked.places)
        if (!are_alike(place.scene, asked.scene))
            throw BadInput(
                fmt::format("record '{}': its cycles are of different scenes; --orbit I chooses one", options.record));
    const ProvenChaos found = proven_chaos(asked.scene, asked.places, how);
    finish_up();
    if (files.record) {
        write_chaos_record(*files.record, found, settings_of(how));
        files.record->finish();
    }
    give(
        options, files.certificate.get(), [&] { return document_of(options, found, how); },
        [&] { print_chaos(options, found); });
    if (!found.whole) return exit_interrupted;
    return found.proven() ? exit_done : exit_numerical_ending;
}

}  // namespace swirl::apps::certify
