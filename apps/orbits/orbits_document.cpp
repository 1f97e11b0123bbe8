#include "apps/branches/branches.hpp"
#include "apps/orbits/orbits_command.hpp"
#include "apps/output/write_table.hpp"
#include "apps/system/shooting_map.hpp"

#include <cmath>

namespace swirl::apps::orbits {

using analysis::Cycle;

namespace {

void write_family(JsonWriter& json, const analysis::ShootingMap& map, const Cycle& cycle) {
    if (!cycle.is_family()) return json.null();
    json.begin_object();
    json.member("dimension", static_cast<std::int64_t>(cycle.tangents.cols()));
    json.key("tangents");
    json.begin_array();
    for (Eigen::Index j = 0; j < cycle.tangents.cols(); ++j) write_point(json, cycle.tangents.col(j));
    json.end_array();
    if (cycle.tangents.cols() == 1) {
        const FamilyRange range = range_of(map, cycle);
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
           (c.is_family() ? fmt::format(", a family of {}", c.tangents.cols()) : "");
}

/// The cycles of a map. `longest`: the longest period, to which lists of points are filled up.
Table<Cycle> cycle_table(const analysis::ShootingMap& map, std::size_t longest) {
    using F = Field<Cycle>;
    const auto d = static_cast<std::size_t>(map.dimension);
    const auto family = [map](JsonWriter& json, const Cycle& c) { write_family(json, map, c); };
    const auto re = [](const Cycle& c) { return parts_of(c, std::real); };
    const auto im = [](const Cycle& c) { return parts_of(c, std::imag); };
    return {
        {"orbit"},
        {F{"period", &Cycle::period, "1", "k"}.shown("period", "  {:>6}"),
         F{"points", coordinates_of, "1", "section points; NaN beyond the period"}
             .along({"phase", "coordinate"}, longest * d)
             .json_written(write_points),
         F{"return_time", &Cycle::return_time, "1/omega_s", "sum of the flights"}.shown("return time", " {:>14.10f}"),
         F{"S", [](const Cycle& c) { return c.points.front().tail(1)[0]; }}.table_only().shown("S", " {:>16.12f}"),
         F{"mean_S", &Cycle::mean, "omega_s", "time mean of S"}.shown("mean S", " {:>16.12f}"),
         F{"mean_S_per_impact", mean_spin_per_impact}.json_only(),
         {"multipliers", [](JsonWriter& json, const Cycle& c) { json.array(c.multipliers); }},
         F{"multiplier_re", re, "1", "real part"}.along({"multiplier_index"}, d).record_only(),
         F{"multiplier_im", im, "1", "imaginary part"}.along({"multiplier_index"}, d).record_only(),
         {"index", &Cycle::index, "1", "multipliers outside the unit circle"},
         {"stability", &Cycle::stability},
         F{"residual", &Cycle::residual, "1", "largest |F(z_i) - z_(i+1)|"}.shown("residual", " {:>9.1e}"),
         {"word", [](JsonWriter& json, const Cycle& c) { write_word(json, c.word); }},
         F{"family", [](const Cycle& c) { return c.tangents.cols(); }, "1", "parameters of the family; 0: isolated"}
             .json_written(family),
         F{"largest_multiplier", [](const Cycle& c) { return std::abs(c.multipliers.front()); }}.table_only().shown(
             "|multiplier|", " {:>14.10f}"),
         F{"words", stability_in_words}.table_only().shown("stability", "  {}")},
        {"period", "index", "family", "mean_S", "return_time", "residual", "stability", "multiplier_re",
         "multiplier_im"},
        {"period", "S", "mean_S"}};
}

constexpr const char* none_reason =
    "no cycle exists: with e < 1 every impact lowers J (without friction) or the energy (without swirl)";

}  // namespace

Settings orbits_settings(const OrbitsOptions& options) {
    const auto [first, last] = options.periods();
    return {{"first_period", std::int64_t{first}},
            {"last_period", std::int64_t{last}},
            {"near", options.near},
            {"pin", options.pin},
            {"starts", options.candidates.starts},
            {"trajectories", options.candidates.trajectories},
            {"collisions", options.candidates.collisions},
            {"seed", options.candidates.seed}};
}

void write_orbits_document(const OrbitsOptions& options, const Scene<double>& scene, const FoundOrbits& found) {
    print_document([&](JsonWriter& json) {
        write_scene(json, scene, options.scene);
        write_json(json, "orbits", cycle_table(shooting_map_of(scene), 1), found.cycles);
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

void print_orbits(const Scene<double>& scene, const FoundOrbits& found) {
    fmt::print("{}\n  {} candidates, {} led to a cycle{}\n", scene_in_words(scene), found.tried, found.converged,
               found.interrupted ? "; interrupted" : "");
    for (const auto& limit : found.limits) fmt::print("  {}\n", limit);
    if (std::isfinite(found.distance)) fmt::print("  nearest point of a cycle at {:.3g} from --near\n", found.distance);
    if (found.cycles.empty()) {
        fmt::print("  {}\n", found.none_exist ? none_reason : "no cycle found");
        return;
    }
    print_table(cycle_table(shooting_map_of(scene), 1), found.cycles);
}

void write_orbits_record(RecordWriter& record, const OrbitsOptions& options, const Scene<double>& scene,
                         const FoundOrbits& found) {
    const RecordGroup root = record.root();
    write_attributes(root.group("scene"), scene_settings(scene));
    write_attributes(root.group("settings"), orbits_settings(options));
    const RecordGroup group = root.group("orbits");
    if (!found.cycles.empty()) {
        const auto map = shooting_map_of(scene);
        std::size_t longest = 1;
        for (const auto& c : found.cycles) longest = std::max(longest, c.period());
        const auto names = coordinate_names(map.dimension);
        group.dimension("orbit", found.cycles.size());
        group.dimension("multiplier_index", names.size());
        group.dimension("phase", longest);
        group.dimension("coordinate", names.size());
        group.write_strings("coordinate", {"coordinate"}, names);
        write_columns(group, cycle_table(map, longest), found.cycles);
    }
    record.finish();
}

}  // namespace swirl::apps::orbits
