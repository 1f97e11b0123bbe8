#include "apps/bifurcate/bifurcate_command.hpp"

#include "apps/modes/kind_document.hpp"

#include <map>

namespace swirl::apps::bifurcate {

namespace {

constexpr const char* origins[] = {"random", "up", "down"};

void write_values(JsonWriter& json, std::string_view key, const Attractor& attractor, Eigen::Index place) {
    if (!key.empty()) json.key(key);
    json.begin_array();
    for (const auto& z : attractor.states) json.value(z[place]);
    json.end_array();
}

void write_attractor(JsonWriter& json, const BifurcateOptions& options, const Attractor& attractor) {
    json.begin_object();
    json.member("origin", origins[static_cast<int>(attractor.origin)]);
    json.member("start", attractor.start);
    json.member("outcome", name_of(attractor.outcome));
    json.member("mode", name_of(attractor.mode));
    write_kind(json, attractor.kind);
    write_period(json, attractor.period);
    json.member("mean_S", attractor.mean_spin);
    const Eigen::Index size = attractor.states.empty() ? 1 : attractor.states.front().size();
    write_values(json, "S", attractor, size - 1);
    if (options.observable != "S") write_values(json, "values", attractor, place_of(options.observable, size));
    json.end_object();
}

void write_column(JsonWriter& json, const BifurcateOptions& options, const DiagramColumn& column) {
    const Attractor& usual = typical(column);
    json.begin_object();
    json.member("parameter", column.parameter);
    json.key("S");
    json.begin_array();
    for (const auto& attractor : column.attractors)
        for (const auto& z : attractor.states) json.value(z[z.size() - 1]);
    json.end_array();
    json.member("mode", name_of(usual.mode));
    write_period(json, usual.period);
    if (!column.complete) json.member("interrupted", true);
    json.key("attractors");
    json.begin_array();
    for (const auto& attractor : column.attractors) write_attractor(json, options, attractor);
    json.end_array();
    json.end_object();
}

}  // namespace

Settings diagram_settings(const BifurcateOptions& options, const Diagram& diagram) {
    return {{"along", diagram.along.name},
            {"range", options.along},
            {"observable", options.observable},
            {"starts", options.starts},
            {"speed", options.start.speed()},
            {"seed", options.start.seed()},
            {"transient", options.settings.transient},
            {"collisions", options.settings.collisions},
            {"follow", std::int64_t{options.follow}},
            {"branches", std::int64_t{options.branches}},
            {"longest_branch", std::int64_t{options.longest_branch}}};
}

Settings diagram_scene(const BifurcateOptions& options, const Diagram& diagram) {
    Settings settings;
    for (const auto& item : scene_settings(column_scene(options, diagram.along, diagram.along.low)))
        if (item.first != diagram.along.name &&
            !(item.first == "inertia_factor" && diagram.along.name == "inertia-factor"))
            settings.push_back(item);
    return settings;
}

void write_diagram_document(const BifurcateOptions& options, const Diagram& diagram) {
    JsonWriter json(stdout);
    json.begin_object(JsonLayout::rows);
    write_json(json, "scene", diagram_scene(options, diagram));
    if (const auto units = options.scene.units()) write_json(json, "units", unit_settings(*units));
    json.member("along", diagram.along.name);
    json.key("columns");
    json.begin_array(JsonLayout::rows);
    for (const auto& column : diagram.columns) write_column(json, options, column);
    json.end_array();
    if (options.branches) {
        const auto scene = scene_branches(column_scene(options, diagram.along, diagram.along.low), diagram.along);
        write_branches(json, scene, diagram.branches);
        json.key("agreement");
        json.begin_object();
        json.member("compared", diagram.agreement.compared);
        json.member("largest_difference_of_S", diagram.agreement.largest);
        json.member("largest_distance_of_orbit", diagram.agreement.distance);
        json.member("without_branch", diagram.agreement.without);
        json.member("in_families", diagram.agreement.in_families);
        json.end_object();
    }
    json.member("outcome", diagram.interrupted ? "interrupted" : "completed");
    write_json(json, "settings", diagram_settings(options, diagram));
    json.member("swirl_version", std::string_view(version()));
    json.end_object();
    json.finish();
}

void print_diagram(const BifurcateOptions& options, const Diagram& diagram) {
    std::map<std::string, std::int64_t> counts;
    std::int64_t all = 0;
    std::string last;
    fmt::print("  {:>14} {:>14} {:>7} {:>15}\n", diagram.along.name, "mode", "period", "mean S");
    for (const auto& column : diagram.columns) {
        const Attractor& usual = typical(column);
        if (diagram.columns.size() <= 100)
            fmt::print("  {:>14.10g} {:>14} {:>7} {:>15.10f}\n", column.parameter, name_of(usual.mode),
                       usual.period > 0 ? fmt::format("{}", usual.period) : "-", usual.mean_spin);
        for (const auto& attractor : column.attractors) {
            ++counts[std::string(name_of(attractor.mode))];
            ++all;
        }
    }
    std::string shares;
    for (const auto& [mode, count] : counts)
        shares += fmt::format("{}{} {:.2f} %", shares.empty() ? "" : ", ", mode,
                              100.0 * static_cast<double>(count) / static_cast<double>(all));
    fmt::print("{} columns, {} orbits: {}\n", diagram.columns.size(), all, shares);
    if (!options.branches) return;
    print_branches(scene_branches(column_scene(options, diagram.along, diagram.along.low), diagram.along),
                   diagram.along, diagram.branches);
    fmt::print(
        "{} cycles on stable branches (|multiplier| < 0.99): S differs by {:.1e} at most, the orbits' own last "
        "states by {:.1e}; {} on no branch, {} members of families\n",
        diagram.agreement.compared, diagram.agreement.largest, diagram.agreement.distance, diagram.agreement.without,
        diagram.agreement.in_families);
}

}  // namespace swirl::apps::bifurcate
