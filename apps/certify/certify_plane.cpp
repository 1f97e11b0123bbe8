// `swirl certify --plane`: a plane of two parameters in proven cells.
#include "apps/boundaries/plane_options.hpp"
#include "apps/certify/certificate_file.hpp"
#include "apps/certify/certify_command.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/run_control.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/certify/proven_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::apps::certify {

namespace {

using cells::Doubt;
using cells::PlaneCell;

constexpr double default_resolution = 1.0 / 256;
constexpr std::array doubts{Doubt::none,      Doubt::equations, Doubt::longest_flight, Doubt::contact_mode,
                            Doubt::clearance, Doubt::stability, Doubt::not_looked_at};

/// How often each side is halved at most. @throws BadInput
int halvings_of(const CertifyOptions& options) {
    const double resolution = options.resolution.value_or(default_resolution);
    if (!(resolution >= 0x1p-20 && resolution <= 1))
        throw BadInput(fmt::format("resolution = {:g} is outside its range: {:.3g} to 1, of the plane's sides",
                                   resolution, 0x1p-20));
    return static_cast<int>(std::floor(-std::log2(resolution) + 1e-9));
}

Table<PlaneCell> cell_table(const Plane& plane) {
    using F = Field<PlaneCell>;
    const auto edge = [](std::size_t i, bool low) {
        return [i, low](const PlaneCell& cell) { return low ? cell.low[i] : cell.high[i]; };
    };
    const auto box = [plane](JsonWriter& json, const PlaneCell& cell) {
        json.begin_object();
        for (std::size_t i = 0; i < 2; ++i)
            json.list(plane.axes[i].name, std::vector<double>{cell.low[i], cell.high[i]});
        json.end_object();
    };
    const auto if_proven = [](int PlaneCell::*count) {
        return [count](const PlaneCell& cell) {
            return cell.proven ? std::optional<std::int64_t>(cell.*count) : std::nullopt;
        };
    };
    std::vector<std::string> names;
    names.reserve(std::size(doubts));
    for (const Doubt doubt : doubts) names.emplace_back(name_of(doubt));
    const auto doubt = [](const PlaneCell& cell) { return std::string(name_of(cell.doubt)); };
    return {
        {"cell"},
        {{"box", box},
         F{"first_low", edge(0, true), "1", "of the parameter named by settings: first"}.record_only(),
         F{"first_high", edge(0, false), "1", "of the parameter named by settings: first"}.record_only(),
         F{"second_low", edge(1, true), "1", "of the parameter named by settings: second"}.record_only(),
         F{"second_high", edge(1, false), "1", "of the parameter named by settings: second"}.record_only(),
         F{"fixed_points", &PlaneCell::fixed_points, "1", "with tau <= max_time; 0 where nothing is proven"}.json_as(
             if_proven(&PlaneCell::fixed_points)),
         F{"attracting", &PlaneCell::attracting, "1", "all multipliers inside the unit circle"}.json_as(
             if_proven(&PlaneCell::attracting)),
         F{"saddles", &PlaneCell::saddles, "1", "multipliers on both sides of the unit circle"}.json_as(
             if_proven(&PlaneCell::saddles)),
         F{"repelling", &PlaneCell::repelling, "1", "all multipliers outside the unit circle"}.json_as(
             if_proven(&PlaneCell::repelling)),
         F{"proven", &PlaneCell::proven, "1", "the counts hold for all parameters of the cell"},
         F{"doubt", doubt, "", "what is not certain of a cell that is not proven"}.flags(names).json_as(
             [doubt](const PlaneCell& cell) {
                 return cell.proven ? std::nullopt : std::optional<std::string>(doubt(cell));
             }),
         F{"depth", &PlaneCell::depth, "1", "how often the plane was halved"}},
        {},
        {}};
}

Table<DepthShare> depth_table(bool with_seconds) {
    using F = Field<DepthShare>;
    const auto percent = [](const DepthShare& d) { return 100 * d.proven_area; };
    return {
        {"depth"},
        {F{"depth", &DepthShare::depth, "1", "halvings of the plane"}.shown("halvings", "  {:>8}"),
         F{"cells", &DepthShare::cells, "1", "that were looked at"}.shown("cells", " {:>9}"),
         F{"proven_area", &DepthShare::proven_area, "1", "share of the plane, this depth and those before"},
         F{"percent", percent, no_column}.table_only().shown("% proven", " {:>9.3f}"),
         F{"seconds", &DepthShare::seconds, no_column}.table_only().shown("core s", " {:>9.1f}").when(with_seconds)},
        {},
        {}};
}

Settings settings_of(const ProvenPlane& found) {
    const Plane& plane = found.plane;
    return {{"first", plane.axes[0].name},      {"first_low", plane.axes[0].low},
            {"first_high", plane.axes[0].high}, {"second", plane.axes[1].name},
            {"second_low", plane.axes[1].low},  {"second_high", plane.axes[1].high},
            {"max_time", found.max_time},       {"resolution", std::ldexp(1.0, -found.halvings)}};
}

std::string outcome_of(const ProvenPlane& found) {
    return found.whole ? "completed" : "interrupted";
}

/// κ as check and proof take it: the uniform lamina's own, or the decimal.
std::string inertia_of(const Scene<double>& scene) {
    return scene.inertia_factor == uniform_inertia_factor<double>(scene.sides) ? "uniform lamina" : "as given";
}

std::string document_of(const CertifyOptions& options, const Scene<double>& scene, const ProvenPlane& found) {
    std::string text;
    JsonWriter json(text);
    json.begin_object(JsonLayout::rows);
    json.member("certificate", "swirl");
    write_json(json, "scene", boundaries::scene_settings_of(scene, found.plane));
    if (const auto units = options.scene.units()) write_json(json, "units", unit_settings(*units));
    json.member("inertia", inertia_of(scene));
    json.key("plane");
    json.begin_object();
    for (const ParameterRange& axis : found.plane.axes) json.list(axis.name, std::vector<double>{axis.low, axis.high});
    json.end_object();
    write_json(json, "cells", cell_table(found.plane), found.cells);
    json.member("proven", static_cast<std::int64_t>(found.proven()));
    json.member("proven_area", found.proven_area());
    write_json(json, "depths", depth_table(false), found.depths);
    json.member("outcome", outcome_of(found));
    write_json(json, "settings", settings_of(found));
    json.member("swirl_version", version());
    json.end_object();
    json.finish();
    return with_checksum(text.substr(0, text.rfind("\n}")));
}

void write_plane_record(RecordWriter& record, const Scene<double>& scene, const ProvenPlane& found) {
    const auto root = record.root();
    write_attributes(root.group("scene"), boundaries::scene_settings_of(scene, found.plane));
    write_attributes(root.group("settings"), settings_of(found));
    write_attributes(root.group("result"), {{"outcome", outcome_of(found)},
                                            {"proven_area", found.proven_area()},
                                            {"proven", static_cast<std::int64_t>(found.proven())}});
    write_record(root.group("cells"), cell_table(found.plane), found.cells);
    if (!found.depths.empty()) write_record(root.group("depths"), depth_table(false), found.depths);
}

void print_plane(const CertifyOptions& options, const ProvenPlane& found) {
    const auto units = options.scene.units();
    const ParameterRange &a = found.plane.axes[0], &b = found.plane.axes[1];
    fmt::print("{} = {:g} to {:g}, {} = {:g} to {:g}: fixed points with tau <= {}\n", a.name, a.low, a.high, b.name,
               b.low, b.high, with_unit(found.max_time, units, "1/omega_s"));
    print_table(depth_table(true), found.depths);
    std::map<std::array<int, 2>, double> shares;  // by fixed points, and attracting ones among them
    std::map<Doubt, std::size_t> why;
    for (const PlaneCell& cell : found.cells) {
        if (cell.proven)
            shares[{cell.fixed_points, cell.attracting}] += std::ldexp(1.0, -cell.depth);
        else
            ++why[cell.doubt];
    }
    fmt::print("  {:.3f} % of the plane is proven, in {} cells\n", 100 * found.proven_area(), found.proven());
    for (const auto& [counts, share] : shares)
        fmt::print("    {:>3} fixed point{} of which {} attracting: {:.3f} %\n", counts[0],
                   counts[0] == 1 ? ", " : "s,", counts[1], 100 * share);
    for (const auto& [doubt, count] : why) fmt::print("  not proven, {}: {} cells\n", name_of(doubt), count);
    if (!found.whole) fmt::print("  interrupted: cells were not looked at\n");
}

/// What is said of a parameter twice, or backwards. @throws BadInput
void require_one_plane(const CertifyOptions& options, const Plane& plane) {
    for (std::size_t i = 0; i < 2; ++i) {
        const ParameterRange& axis = plane.axes[i];
        if (axis.falling) throw BadInput(fmt::format("plane {}: NAME=A:B with A < B is wanted", options.plane[i]));
        if (!options.scene.flag(axis.name, "").empty())
            throw BadInput(fmt::format("--{0} and --plane {0}=... are both given: give one of them", axis.name));
    }
}

}  // namespace

int certify_plane(CertifyOptions& options) {
    options.scene.read_file(options.output.quiet);
    const Plane plane = boundaries::plane_from(options.plane);
    require_one_plane(options, plane);
    const Scene<double> scene = boundaries::scene_of(options.scene, plane);
    studies::certify::ProvenPlaneOptions how;
    how.max_time = options.scene.longest_flight(options.longest, how.max_time, 1000);
    how.halvings = halvings_of(options);
    studies::certify::require_isolated(scene, plane);
    CertifyFiles files = open_files(options, "Proven cells of a plane of a swirled polygon");
    note_interruptions();
    how.control = run_control(options.output);
    const ProvenPlane found = studies::certify::proven_plane(scene, plane, how);
    finish_up();
    if (files.record) {
        write_plane_record(*files.record, scene, found);
        files.record->finish();
    }
    give(
        options, files.certificate.get(), [&] { return document_of(options, scene, found); },
        [&] { print_plane(options, found); });
    return found.whole ? exit_done : exit_interrupted;
}

}  // namespace swirl::apps::certify
