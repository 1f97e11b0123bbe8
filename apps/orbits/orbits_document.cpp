#include "apps/branches/section_point.hpp"
#include "apps/orbits/orbits_command.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/cycles/family_members.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::apps::orbits {

using analysis::Cycle;

namespace {

/// What the fields of a cycle are read with.
struct CycleTable {
    const Scene<double>& scene;
    analysis::ShootingMap map;
    const FoundOrbits& found;
};

void write_family(JsonWriter& json, const CycleTable& at, const Cycle& cycle) {
    if (!cycle.is_family()) return json.null();
    json.begin_object();
    json.member("dimension", static_cast<std::int64_t>(cycle.tangents.cols()));
    json.key("tangents");
    json.begin_array();
    for (Eigen::Index j = 0; j < cycle.tangents.cols(); ++j) write_point(json, cycle.tangents.col(j));
    json.end_array();
    if (cycle.tangents.cols() == 1) {
        const FamilyRange range = range_of(at.scene, at.map, at.found.steady, cycle);
        json.member("least_S", range.least_spin);
        json.member("most_S", range.most_spin);
        json.member("shortest_return_time", range.shortest);
        json.member("longest_return_time", range.longest);
        json.member("closed", range.closed);
    }
    json.end_object();
}

void write_points(JsonWriter& json, const Cycle& cycle) {
    json.begin_array();
    for (const auto& z : cycle.points) write_point(json, z);
    json.end_array();
}

/// All coordinates of all points, one after another.
std::vector<double> coordinates_of(const Cycle& cycle) {
    std::vector<double> values;
    for (const auto& z : cycle.points) values.insert(values.end(), z.begin(), z.end());
    return values;
}

std::vector<double> parts_of(const Cycle& cycle, double (*part)(const std::complex<double>&)) {
    std::vector<double> values;
    for (const auto& m : cycle.multipliers) values.push_back(part(m));
    return values;
}

std::string stability_in_words(const Cycle& c) {
    return std::string(analysis::name_of(c.stability)) +
           (c.is_family() ? fmt::format(", family of {}", c.tangents.cols()) : "");
}

/// The cycles of a map. `longest`: the longest period, to which lists of points are filled up.
Table<Cycle> cycle_table(const Scene<double>& scene, const FoundOrbits& found, std::size_t longest) {
    using F = Field<Cycle>;
    const CycleTable at{scene, shooting_map_of(scene, found.accuracy), found};
    const auto d = static_cast<std::size_t>(at.map.dimension);
    const auto family = [at](JsonWriter& json, const Cycle& c) { write_family(json, at, c); };
    const auto re = [](const Cycle& c) { return parts_of(c, std::real); };
    const auto im = [](const Cycle& c) { return parts_of(c, std::imag); };
    return {
        {"orbit"},
        {F{"number", [&found](const Cycle& c) { return &c - found.cycles.data() + 1; }, no_column}.table_only().shown(
             "orbit", " {:>5}"),
         F{"period", &Cycle::period, "1", "k"}.shown("period", " {:>6}"),
         F{"points", coordinates_of, "1", "section points; NaN beyond the period"}
             .along({"phase", "coordinate"}, longest * d)
             .json_written(write_points),
         F{"return_time", &Cycle::return_time, "1/omega_s", "sum of the flights"}.shown("return time", " {:>11.8f}"),
         F{"S", [](const Cycle& c) { return c.points.front().tail(1)[0]; }, "1", "S of its first point"}
             .table_only()
             .shown("S", " {:>14.10f}"),
         F{"mean_S", &Cycle::mean, "1", "time mean of S"}.shown("mean S", " {:>14.10f}"),
         F{"mean_S_per_impact", mean_spin_per_impact, no_column},
         {"multipliers", [](JsonWriter& json, const Cycle& c) { json.array(c.multipliers); }},
         F{"multiplier_re", re, "1", "real part"}.along({"multiplier_index"}, d).record_only(),
         F{"multiplier_im", im, "1", "imaginary part"}.along({"multiplier_index"}, d).record_only(),
         {"index", &Cycle::index, "1", "multipliers outside the unit circle"},
         {"stability", &Cycle::stability, "", "by the multipliers"},
         F{"residual", &Cycle::residual, "1", "largest |F(z_i) - z_(i+1)|"}.shown("residual", " {:>8.1e}"),
         {"word", [](JsonWriter& json, const Cycle& c) { write_itinerary(json, c.itinerary); }},
         F{"family", [](const Cycle& c) { return c.tangents.cols(); }, "1", "parameters of the family; 0: isolated"}
             .json_written(family),
         F{"largest_multiplier", [](const Cycle& c) { return std::abs(c.multipliers.front()); }, no_column}
             .table_only()
             .shown("|multiplier|", " {:>12.8g}"),
         F{"found", &Cycle::found, "1", "candidates that led to it; 0: from the steady modes' equations, or --near"},
         F{"words", stability_in_words, no_column}.table_only().shown("stability", "  {}")},
        {"period", "index", "family", "mean_S", "return_time", "residual", "stability", "multiplier_re",
         "multiplier_im"},
        {"number", "period", "S", "mean_S"}};
}

constexpr const char* none_reason =
    "no cycle exists: with e < 1 every impact lowers J (without friction) or the energy (without swirl)";

/// How each period was searched.
Table<PeriodSearch> search_table(bool has_drag) {
    using F = Field<PeriodSearch>;
    const char* const period_of = has_drag ? "of the cycles" : "of period 1 those through contact alone";
    const char* const cycles_of =
        has_drag ? "of that period that candidates led to" : "of that period, through contact if it is 1";
    const auto of = [](auto member) { return [member](const PeriodSearch& s) { return s.unseen.*member; }; };
    using analysis::UnseenCycles;
    return {
        {"search"},
        {F{"period", &PeriodSearch::period, "1", period_of},
         F{"candidates", &PeriodSearch::tried, "1", "points at which Newton's method began"},
         F{"converged", &PeriodSearch::converged, "1", "candidates that led to a cycle"},
         F{"cycles", of(&UnseenCycles::found), "1", cycles_of},
         F{"from_equations", &PeriodSearch::from_equations, "1", "cycles that only the steady modes' equations led to"}
             .when(has_drag),
         F{"samples", of(&UnseenCycles::samples), "1", "candidates that led to one of them"},
         F{"found_once", of(&UnseenCycles::once), "1", "cycles that one candidate led to"},
         F{"found_twice", of(&UnseenCycles::twice), "1", "cycles that two candidates led to"},
         F{"missed", of(&UnseenCycles::missed), "1", "estimate of cycles not found (Chao 1984)"},
         F{"least_missed", of(&UnseenCycles::least_missed), "1", "its interval at 95 %"},
         F{"most_missed", of(&UnseenCycles::most_missed), "1", "its interval at 95 %"}}};
}

std::string in_words(const SteadySearch& steady, const std::optional<Units>& units) {
    const auto time = [&](double tau) { return with_unit(tau, units, "1/omega_s"); };
    const std::string_view none = why_none(steady.set);
    if (!none.empty()) return fmt::format("period 1, impacts alone: {}", none);
    const char* kind = steady.set == SteadySet::families ? "families of fixed points" : "fixed points";
    if (steady.not_fixed > 0)
        return fmt::format(
            "period 1, impacts alone: this accuracy has {} of the exact map's {} {} with tau <= {}; it may have "
            "others",
            steady.found, steady.found + steady.not_fixed, kind, time(steady.max_time));
    const std::string all = fmt::format("period 1, impacts alone: all {} {} with tau <= {}", steady.found, kind,
                                        time(std::min(steady.complete_to, steady.max_time)));
    return steady.is_complete() ? all : all + "; there are more";
}

std::string in_words(const PeriodSearch& search, const FoundOrbits& found) {
    const auto& u = search.unseen;
    const bool through_contact = search.period == 1 && found.steady;  // the others are known from their equations
    std::string words = fmt::format("period {}{}: {} cycles from {} candidates", search.period,
                                    through_contact ? ", through contact" : "", u.found, search.tried);
    if (search.from_equations > 0)
        return words + fmt::format(
                           ", and {} more from the equations of steady modes, on a grid: strongly unstable ones "
                           "are hard to come to, so that candidates don't tell how many are missing",
                           search.from_equations);
    if (u.found == 0) return words;
    words += fmt::format("; {} were found once, {} twice: ", u.once, u.twice);
    words += u.missed < 0.5 ? "fewer than one is missing, if all are as easy to find"
                            : fmt::format("some {:.0f} more are to be expected (95 %: {:.0f} to {:.0f})", u.missed,
                                          u.least_missed, u.most_missed);
    if (search.period == 1 && !found.steady) words += "; strongly unstable ones are harder to find";
    return words;
}

void write_steady(JsonWriter& json, const std::optional<SteadySearch>& steady) {
    if (!steady) return json.null();
    json.begin_object();
    json.member("max_time", steady->max_time);
    json.member("set", name_of(steady->set));
    json.member("found", static_cast<std::int64_t>(steady->found));
    json.member("complete", steady->is_complete());
    json.member("complete_to", steady->complete_to);
    json.member("not_fixed", static_cast<std::int64_t>(steady->not_fixed));
    json.end_object();
}

}  // namespace

Settings orbits_settings(const OrbitsOptions& options) {
    const auto [first, last] = options.periods();
    return {{"first_period", std::int64_t{first}},
            {"last_period", std::int64_t{last}},
            {"near", options.near},
            {"pin", options.pin},
            {"starts", options.candidates.starts},
            {"max_time", options.max_time},
            {"complete", options.complete},
            {"stable", options.stable},
            {"most_starts", options.most_starts},
            {"trajectories", options.candidates.trajectories},
            {"collisions", options.candidates.collisions},
            {"seed", options.candidates.seed},
            {"accuracy", options.output.accuracy_name}};
}

void write_orbits_document(const OrbitsOptions& options, const Scene<double>& scene, const FoundOrbits& found) {
    print_document([&](JsonWriter& json) {
        write_scene(json, scene, options.scene);
        write_json(json, "orbits", cycle_table(scene, found, 1), found.cycles);
        json.key("fixed_points");
        write_steady(json, found.steady);
        write_json(json, "searches", search_table(scene.has_drag()), found.searches);
        json.member("candidates", found.tried);
        json.member("converged", found.converged);
        if (found.none_exist) json.member("none_exist", none_reason);
        if (!options.near.empty()) {
            json.member("iterations", std::int64_t{found.iterations});
            json.member("residual", found.reached);
            json.member("distance", found.distance);
        }
        if (!found.limits.empty()) json.list("limits", found.limits);
        json.member("outcome", found.interrupted ? "interrupted" : "completed");
        write_json(json, "settings", orbits_settings(options));
    });
}

void print_orbits(const OrbitsOptions& options, const Scene<double>& scene, const FoundOrbits& found) {
    fmt::print("{}\n{}{}", scene_in_words(scene), units_in_words(options.scene.units()),
               found.interrupted ? "  interrupted\n" : "");
    if (found.steady) fmt::print("{}\n", wrapped("  " + in_words(*found.steady, options.scene.units()), 4));
    for (const auto& search : found.searches) fmt::print("{}\n", wrapped("  " + in_words(search, found), 4));
    for (const auto& limit : found.limits) fmt::print("  {}\n", limit);
    if (std::isfinite(found.distance)) fmt::print("  nearest point of a cycle at {:.3g} from --near\n", found.distance);
    if (found.cycles.empty()) {
        fmt::print("  {}\n", found.none_exist ? none_reason : "no cycle found");
        return;
    }
    print_table(in_units(cycle_table(scene, found, 1), options.scene.units()), found.cycles);
    if (options.output.record.empty())
        fmt::print("  points: --json; to go on from one: -o FILE.h5, then swirl continue FILE.h5 --orbit I\n");
    else
        fmt::print("  points: swirl show {0}; to go on from one: swirl continue {0} --orbit I\n",
                   options.output.record);
}

void write_orbits_record(RecordWriter& record, const OrbitsOptions& options, const Scene<double>& scene,
                         const FoundOrbits& found) {
    const RecordGroup root = record.root();
    write_attributes(root.group("scene"), scene_settings(scene));
    write_attributes(root.group("settings"), orbits_settings(options));
    if (!found.searches.empty()) write_record(root.group("searches"), search_table(scene.has_drag()), found.searches);
    const RecordGroup group = root.group("orbits");
    if (found.steady) {
        group.attribute("max_time", found.steady->max_time);
        group.attribute("fixed_points", static_cast<std::int64_t>(found.steady->found));
        group.attribute("complete_to", found.steady->complete_to);
        group.attribute("not_fixed", static_cast<std::int64_t>(found.steady->not_fixed));
    }
    if (!found.cycles.empty()) {
        std::size_t longest = 1;
        for (const auto& c : found.cycles) longest = std::max(longest, c.period());
        const Eigen::Index coordinates = found.cycles.front().points.front().size();
        group.dimension("orbit", found.cycles.size());
        group.dimension("multiplier_index", static_cast<std::uint64_t>(coordinates));
        group.dimension("phase", longest);
        write_coordinate_names(group, coordinates);
        write_columns(group, cycle_table(scene, found, longest), found.cycles);
    }
    record.finish();
}

}  // namespace swirl::apps::orbits
