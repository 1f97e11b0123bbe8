#include "apps/bifurcate/bifurcate_command.hpp"

#include <map>

namespace swirl::apps {

namespace {

constexpr const char* origins[] = {"random", "up", "down"};

/// Where the observable stands in a state.
Eigen::Index place_of(const std::string& observable, Eigen::Index size) {
    constexpr const char* polygon[] = {"psi", "chi", "vn", "vt", "S"};
    constexpr const char* disk[] = {"psi", "vn", "vt", "S"};
    for (Eigen::Index i = 0; i < size; ++i)
        if (observable == (size == 4 ? disk[i] : polygon[i])) return i;
    return size - 1;
}

Settings settings_of(const BifurcateOptions& options, const Diagram& diagram) {
    return {{"along", diagram.along.name}, {"range", options.along}, {"observable", options.observable},
            {"starts", options.starts}, {"speed", options.start.speed()},
            {"seed", options.start.seed()}, {"transient", options.settings.transient},
            {"collisions", options.settings.collisions}, {"follow", std::int64_t{options.follow}},
            {"branches", std::int64_t{options.branches}}, {"longest_branch", std::int64_t{options.longest_branch}}};
}

/// The scene without the parameter that varies.
Settings scene_of(const BifurcateOptions& options, const Diagram& diagram) {
    Settings settings;
    for (const auto& item : scene_settings(column_scene(options, diagram.along, diagram.along.low)))
        if (item.first != diagram.along.name && !(item.first == "inertia_factor" && diagram.along.name == "inertia-factor"))
            settings.push_back(item);
    return settings;
}

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
    json.member("kind", name_of(attractor.kind));
    json.key("period");
    if (attractor.period > 0) json.value(attractor.period);
    else json.null();
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
    json.key("period");
    if (usual.period > 0) json.value(usual.period);
    else json.null();
    json.key("attractors");
    json.begin_array();
    for (const auto& attractor : column.attractors) write_attractor(json, options, attractor);
    json.end_array();
    json.end_object();
}

}  // namespace

void write_diagram_document(const BifurcateOptions& options, const Diagram& diagram) {
    JsonWriter json(stdout);
    json.begin_object(JsonLayout::rows);
    write_json(json, "scene", scene_of(options, diagram));
    if (const auto units = options.scene.units()) write_json(json, "units", unit_settings(*units));
    json.member("along", diagram.along.name);
    json.key("columns");
    json.begin_array(JsonLayout::rows);
    for (const auto& column : diagram.columns)
        if (column.done) write_column(json, options, column);
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
        json.end_object();
    }
    json.member("outcome", diagram.interrupted ? "interrupted" : "completed");
    write_json(json, "settings", settings_of(options, diagram));
    json.member("swirl_version", std::string_view(version()));
    json.end_object();
    json.finish();
}

void write_diagram_record(RecordWriter& record, const BifurcateOptions& options, const Diagram& diagram) {
    const RecordGroup root = record.root();
    write_attributes(root.group("scene"), scene_of(options, diagram));
    write_attributes(root.group("settings"), settings_of(options, diagram));
    std::vector<double> parameter, spin, value, column_parameter;
    std::vector<std::int64_t> number, start, origin, period;
    std::vector<std::string> mode;
    std::int64_t c = 0;
    for (const auto& column : diagram.columns) {
        if (!column.done) continue;
        column_parameter.push_back(column.parameter);
        period.push_back(typical(column).period);
        mode.emplace_back(name_of(typical(column).mode));
        for (const auto& attractor : column.attractors)
            for (const auto& z : attractor.states) {
                parameter.push_back(column.parameter);
                spin.push_back(z[z.size() - 1]);
                value.push_back(z[place_of(options.observable, z.size())]);
                number.push_back(c);
                start.push_back(attractor.start);
                origin.push_back(static_cast<std::int64_t>(attractor.origin));
            }
        ++c;
    }
    if (c > 0) {
        const RecordGroup group = root.group("columns");
        group.dimension("column", column_parameter.size());
        group.write<double>("parameter", {"column"}, column_parameter, {"1", "parameter " + diagram.along.name, {}});
        group.write<std::int64_t>("period", {"column"}, period, {"1", "of most starts; 0: none", {}});
        group.write_strings("mode", {"column"}, mode);
    }
    if (!spin.empty()) {
        const RecordGroup group = root.group("samples");
        group.dimension("sample", spin.size());
        group.write<double>("parameter", {"sample"}, parameter, {"1", "parameter " + diagram.along.name, {}});
        group.write<double>("S", {"sample"}, spin, {"omega_s", "S just after an impact", {}});
        if (options.observable != "S")
            group.write<double>("value", {"sample"}, value, {"1", "observable " + options.observable, {}});
        group.write<std::int64_t>("column", {"sample"}, number, {"1", "column", {}});
        group.write<std::int64_t>("start", {"sample"}, start, {"1", "number of the random start", {}});
        group.write<std::int64_t>("origin", {"sample"}, origin, {"1", "0 random start, 1 followed up, 2 followed down", {}});
    }
    if (options.branches)
        write_branches(root, scene_branches(column_scene(options, diagram.along, diagram.along.low), diagram.along),
                       diagram.branches);
    record.finish();
}

void print_diagram(const BifurcateOptions& options, const Diagram& diagram) {
    std::map<std::string, std::int64_t> counts;
    std::int64_t all = 0;
    std::string last;
    fmt::print("  {:>14} {:>14} {:>7} {:>15}\n", diagram.along.name, "mode", "period", "mean S");
    for (const auto& column : diagram.columns) {
        if (!column.done) continue;
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
    print_branches(scene_branches(column_scene(options, diagram.along, diagram.along.low), diagram.along), diagram.along,
                   diagram.branches);
    fmt::print("{} cycles on stable branches (|multiplier| < 0.99): S differs by {:.1e} at most, the orbits' own last "
               "states by {:.1e}; {} on no branch\n",
               diagram.agreement.compared, diagram.agreement.largest, diagram.agreement.distance,
               diagram.agreement.without);
}

}  // namespace swirl::apps
