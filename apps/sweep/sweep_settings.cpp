#include "apps/modes/risk_document.hpp"
#include "apps/record/flag_text.hpp"
#include "apps/sweep/start_settings.hpp"
#include "apps/sweep/sweep_command.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace swirl::apps::sweep {

Settings settings_of(const SweepOptions& options, const std::vector<GridAxis>& grid) {
    const Scene<double> first = scene_of_cell(options.scene, grid, 0);
    Settings settings{{"swirl_version", std::string(version())}};
    std::vector<std::string> axes;
    for (const auto& axis : grid) axes.push_back(axis.text);
    settings.emplace_back("grid", axes);
    if (!options.sample.empty()) settings.emplace_back("sample", options.sample);
    if (!options.scenes.empty()) settings.emplace_back("scenes", static_cast<std::int64_t>(cell_count(grid)));
    if (options.refine > 0) settings.emplace_back("refine", std::int64_t{options.refine});
    if (options.track) settings.emplace_back("track", true);
    if (options.saddles > 0) settings.emplace_back("saddles", options.saddles);
    const auto gridded = [&](const std::string& name) { return has_axis(grid, name); };
    for (const auto& parameter : scene_settings(first)) {
        const bool inertia = parameter.first == "inertia_factor";
        const std::string axis = flag_name(parameter.first);
        if (gridded(axis)) continue;
        // The lamina's κ depends on N and, of rounded corners, on r/α.
        const bool varies = gridded("sides") || gridded("corner") || (first.is_rounded() && gridded("alpha"));
        if (inertia && varies && !options.scene.has("inertia-factor"))
            settings.emplace_back("inertia_factor", std::string("uniform"));
        else
            settings.push_back(parameter);
    }
    settings.emplace_back("runs", options.runs);
    for (const auto& [name, value] : start_settings(options.start, first, grid)) settings.emplace_back(name, value);
    settings.emplace_back("seed", options.start.seed());
    settings.emplace_back("transient", options.settings.transient);
    settings.emplace_back("collisions", options.settings.collisions);
    settings.emplace_back("exhaustive", options.settings.exhaustive);
    add_risk_settings(settings, options.risk, options.error);
    settings.emplace_back("threshold", options.settings.recurrence_threshold);
    settings.emplace_back("accuracy", options.output.accuracy_name);
    return settings;
}

GridStudy study_of(const SweepOptions& options, const std::vector<GridAxis>& grid) {
    GridStudy study;
    study.grid = grid;
    study.scene = scene_of_cell(options.scene, grid, 0);
    study.uniform = !options.scene.has("inertia-factor");
    study.runs = options.runs;
    study.seed = options.start.seed();
    if (!starts_are_placed(grid)) {
        if (!has_axis(grid, "speed")) study.speed = options.start.speed();
    } else if (!options.start.is_random()) {
        study.placed = std::get<LabStart<double>>(options.start.start(study.scene));
        study.at_centre = !options.start.gives("x");
    }
    study.settings = options.settings;
    study.accuracy = options.output.accuracy();
    study.risk = options.risk;
    study.error = options.error;
    return study;
}

}  // namespace swirl::apps::sweep
