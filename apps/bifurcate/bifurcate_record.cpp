#include "apps/bifurcate/bifurcate_command.hpp"

namespace swirl::apps::bifurcate {

namespace {

void write_columns(const RecordGroup& root, const Diagram& diagram) {
    std::vector<double> parameter;
    std::vector<std::int64_t> period;
    std::vector<std::string> mode;
    for (const auto& column : diagram.columns) {
        parameter.push_back(column.parameter);
        period.push_back(typical(column).period);
        mode.emplace_back(name_of(typical(column).mode));
    }
    if (parameter.empty()) return;
    const RecordGroup group = root.group("columns");
    group.dimension("column", parameter.size());
    group.write<double>("parameter", {"column"}, parameter, {"1", "parameter " + diagram.along.name, {}});
    group.write<std::int64_t>("period", {"column"}, period, {"1", "of most starts; 0: none", {}});
    group.write_strings("mode", {"column"}, mode);
}

/// What each orbit settled on, samples or not.
void write_attractors(const RecordGroup& root, const Diagram& diagram) {
    std::vector<double> parameter, mean;
    std::vector<std::int64_t> number, start, origin, period, samples;
    std::vector<std::string> mode, kind, outcome;
    for (std::size_t c = 0; c < diagram.columns.size(); ++c)
        for (const auto& attractor : diagram.columns[c].attractors) {
            parameter.push_back(diagram.columns[c].parameter);
            mean.push_back(attractor.mean_spin);
            number.push_back(static_cast<std::int64_t>(c));
            start.push_back(attractor.start);
            origin.push_back(static_cast<std::int64_t>(attractor.origin));
            period.push_back(attractor.period);
            samples.push_back(static_cast<std::int64_t>(attractor.states.size()));
            mode.emplace_back(name_of(attractor.mode));
            kind.emplace_back(name_of(attractor.kind));
            outcome.emplace_back(name_of(attractor.outcome));
        }
    if (parameter.empty()) return;
    const RecordGroup group = root.group("attractors");
    group.dimension("attractor", parameter.size());
    group.write<double>("parameter", {"attractor"}, parameter, {"1", "parameter " + diagram.along.name, {}});
    group.write<double>("mean_S", {"attractor"}, mean, {"omega_s", "time mean of S", {}});
    group.write<std::int64_t>("column", {"attractor"}, number, {"1", "column", {}});
    group.write<std::int64_t>("start", {"attractor"}, start, {"1", "number of the random start", {}});
    group.write<std::int64_t>("origin", {"attractor"}, origin,
                              {"1", "0 random start, 1 followed up, 2 followed down", {}});
    group.write<std::int64_t>("period", {"attractor"}, period, {"1", "0: none", {}});
    group.write<std::int64_t>("samples", {"attractor"}, samples,
                              {"1", "how many follow in the group samples, in this order", {}});
    group.write_strings("mode", {"attractor"}, mode);
    group.write_strings("kind", {"attractor"}, kind);
    group.write_strings("outcome", {"attractor"}, outcome);
}

void write_samples(const RecordGroup& root, const BifurcateOptions& options, const Diagram& diagram) {
    std::vector<double> parameter, spin, value;
    std::vector<std::int64_t> number, start, origin;
    for (std::size_t c = 0; c < diagram.columns.size(); ++c)
        for (const auto& attractor : diagram.columns[c].attractors)
            for (const auto& z : attractor.states) {
                parameter.push_back(diagram.columns[c].parameter);
                spin.push_back(z[z.size() - 1]);
                value.push_back(z[place_of(options.observable, z.size())]);
                number.push_back(static_cast<std::int64_t>(c));
                start.push_back(attractor.start);
                origin.push_back(static_cast<std::int64_t>(attractor.origin));
            }
    if (parameter.empty()) return;
    const RecordGroup group = root.group("samples");
    group.dimension("sample", spin.size());
    group.write<double>("parameter", {"sample"}, parameter, {"1", "parameter " + diagram.along.name, {}});
    group.write<double>("S", {"sample"}, spin, {"omega_s", "S just after an impact", {}});
    if (options.observable != "S")
        group.write<double>("value", {"sample"}, value, {"1", "observable " + options.observable, {}});
    group.write<std::int64_t>("column", {"sample"}, number, {"1", "column", {}});
    group.write<std::int64_t>("start", {"sample"}, start, {"1", "number of the random start", {}});
    group.write<std::int64_t>("origin", {"sample"}, origin,
                              {"1", "0 random start, 1 followed up, 2 followed down", {}});
}

}  // namespace

void write_diagram_record(RecordWriter& record, const BifurcateOptions& options, const Diagram& diagram) {
    const RecordGroup root = record.root();
    write_attributes(root.group("scene"), diagram_scene(options, diagram));
    write_attributes(root.group("settings"), diagram_settings(options, diagram));
    write_columns(root, diagram);
    write_attractors(root, diagram);
    write_samples(root, options, diagram);
    if (options.branches)
        write_branches(root, scene_branches(column_scene(options, diagram.along, diagram.along.low), diagram.along),
                       diagram.branches, options.observable);
    record.finish();
}

}  // namespace swirl::apps::bifurcate
