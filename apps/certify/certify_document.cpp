#include "apps/branches/section_point.hpp"
#include "apps/certify/certify_command.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "map/model/parameter.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::certify {

namespace {

using Orbit = CertifiedOrbit;
using proof::MultiplierDisc;

void write_point_of(JsonWriter& json, const Scene<double>& scene, const SectionPoint<double>& z) {
    write_point(json, coordinates_of(z, scene.is_disk()));
}

void write_discs(JsonWriter& json, const Orbit& orbit) {
    json.begin_array();
    for (const MultiplierDisc& disc : orbit.proof.multipliers)
        json.array(std::vector<double>{disc.re, disc.im, disc.radius});
    json.end_array();
}

void write_phase(JsonWriter& json, const Orbit& orbit) {
    if (!orbit.proof.phase) return json.null();
    json.begin_object();
    json.member(orbit.proof.phase->by_time ? "tau" : "S", orbit.proof.phase->value);
    json.end_object();
}

/// The box: each point with its half-widths, the flight that begins there, and the impact that ends it.
void write_steps(JsonWriter& json, const Orbit& orbit) {
    const proof::CycleProof& p = orbit.proof;
    json.begin_array();
    for (std::size_t i = 0; i < p.radii.size(); ++i) {
        const auto& r = p.radii[i];
        json.begin_object();
        json.key("point");
        write_point_of(json, orbit.scene, p.points[i]);
        json.key("half_widths");
        write_point_of(json, orbit.scene, {r[0], r[1], r[2], r[3], r[4]});
        json.member("flight_time", p.times[i]);
        json.member("flight_time_half_width", p.time_radii[i]);
        json.member("vertex_step", p.itinerary[i].vertex_step);
        json.member("contact_mode", name_of(p.itinerary[i].mode));
        json.member("slip", p.itinerary[i].slip);
        json.end_object();
    }
    json.end_array();
}

std::string reason_or_none(const Orbit& orbit) {
    return orbit.proof.proven() ? "" : orbit.proof.reason;
}

std::string inertia_of(const Orbit& orbit) {
    const bool uniform = orbit.scene.inertia_factor == uniform_inertia_factor<double>(orbit.scene.sides);
    return uniform ? "uniform lamina" : "as given";
}

Table<Orbit> orbit_table(const std::string& along) {
    using F = Field<Orbit>;
    const auto parameter = parameter_named(along);
    const auto value = [parameter](const Orbit& o) {
        Scene<double> scene = o.scene;
        return parameter ? number_of(scene, *parameter) : std::nan("");
    };
    const auto parameters = [parameter, along, value](JsonWriter& json, const Orbit& o) {
        json.begin_object();
        if (parameter) json.member(along, value(o));
        json.end_object();
    };
    const auto radius = [](const Orbit& o) { return o.proof.radii.empty() ? std::nan("") : o.proof.radius(); };
    const auto proven = [](const Orbit& o) { return o.proof.proven(); };
    return {{"orbit"},
            {F{"number", &Orbit::number, no_column}.table_only().shown("orbit", "  {:>5}"),
             F{"period", &Orbit::period, "1", "k"}.shown("period", " {:>6}"),
             F{"proven", proven, no_column},
             F{"parameters", parameters},
             F{"inertia", inertia_of, no_column},
             F{"value", value, no_column}.table_only().shown(along, " {:>16.12g}").when(parameter.has_value()),
             {"point", [](JsonWriter& json, const Orbit& o) { write_point_of(json, o.scene, o.point); }},
             F{"S", [](const Orbit& o) { return o.point.spin; }, "1", "S of its first point"}.table_only().shown(
                 "S", " {:>16.12f}"),
             F{"radius", radius, no_column}.shown("radius", " {:>8.1e}"),
             {"multipliers", write_discs},
             F{"stability", [](const Orbit& o) { return std::string(name_of(o.proof.stability)); }, no_column}.json_as(
                 [](const Orbit& o) {
                     return o.proof.proven() ? std::optional(std::string(name_of(o.proof.stability))) : std::nullopt;
                 }),
             F{"reason", reason_or_none, no_column}.json_as(
                 [](const Orbit& o) { return o.proof.proven() ? std::nullopt : std::optional(o.proof.reason); }),
             {"phase", write_phase},
             {"steps", write_steps},
             F{"words",
               [](const Orbit& o) {
                   return o.proof.proven() ? fmt::format("proven, {}", name_of(o.proof.stability))
                                           : fmt::format("not proven: {}", o.proof.reason);
               },
               no_column}
                 .table_only()
                 .shown("", "  {}")},
            {},
            {}};
}

void write_all(JsonWriter& json, const proof::AllFixedPoints& all) {
    json.begin_object(JsonLayout::rows);
    json.member("max_time", all.max_time);
    json.member("complete", all.complete());
    json.member("found", static_cast<std::int64_t>(all.proven.size()));
    json.member("refuted", static_cast<std::int64_t>(all.refuted.size()));
    json.member("cells", static_cast<std::int64_t>(all.cells));
    if (!all.none.empty()) json.member("none_exist", all.none);
    json.key("open");
    json.begin_array(JsonLayout::rows);
    for (const proof::OpenCell& cell : all.open) {
        json.begin_object();
        json.list("tau", std::vector<double>{cell.tau_low, cell.tau_high});
        json.list("phi", std::vector<double>{cell.phi_low, cell.phi_high});
        json.member("reason", cell.reason);
        json.end_object();
    }
    json.end_array();
    json.end_object();
}

}  // namespace

std::string certificate_text(const CertifyOptions& options, const Certified& certified) {
    std::string text;
    JsonWriter json(text);
    json.begin_object(JsonLayout::rows);
    json.member("certificate", "swirl");
    write_scene(json, certified.scene, options.scene);
    write_json(json, "orbits", orbit_table(certified.along), certified.orbits);
    json.member("proven", static_cast<std::int64_t>(certified.proven()));
    json.member("outcome", certified.whole ? "completed" : "interrupted");
    json.key("all");
    if (certified.all)
        write_all(json, *certified.all);
    else
        json.null();
    json.member("swirl_version", version());
    json.end_object();
    json.finish();
    return text.substr(0, text.rfind("\n}"));
}

void print_certified(const CertifyOptions& options, const Certified& certified) {
    const auto units = options.scene.units();
    fmt::print("{}\n{}", scene_in_words(certified.scene), units_in_words(units));
    if (certified.all) {
        const proof::AllFixedPoints& all = *certified.all;
        if (!all.none.empty()) fmt::print("  no fixed point exists: {}\n", all.none);
        fmt::print(
            "  {} fixed points with tau <= {}, {}\n", all.proven.size(), with_unit(all.max_time, units, "1/omega_s"),
            all.complete() ? "proven to be all" : fmt::format("{} parts of the plane undecided", all.open.size()));
        for (const proof::OpenCell& cell : all.open)
            fmt::print("  undecided: tau {:.9g} to {:.9g}{}, phi {:.9g} to {:.9g}: {}\n",
                       in_units(cell.tau_low, units, "1/omega_s"), in_units(cell.tau_high, units, "1/omega_s"),
                       units ? " s" : "", cell.phi_low, cell.phi_high, cell.reason);
    }
    if (!certified.whole) fmt::print("  interrupted: some cycles were not tried\n");
    if (!certified.found) fmt::print("  no cycle found\n");
    if (certified.orbits.empty()) return;
    if (!certified.all) fmt::print("  {} of {} proven\n", certified.proven(), certified.orbits.size());
    print_table(in_units(orbit_table(certified.along), units), certified.orbits);
}

}  // namespace swirl::apps::certify
