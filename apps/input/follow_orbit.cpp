#include "apps/input/orbit_columns.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/impacts/impact_fields.hpp"
#include "apps/studies/scene_map/in_digits.hpp"
#include "map/orbit/dry_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace swirl::apps {

namespace {

const ImpactField* field_of(const std::string& column) {
    for (const auto& field : impact_fields)
        if (column == field.name) return &field;
    return nullptr;
}

template <class T>
void follow(SceneOrbit<T>& orbit, const ImpactRange& range, bool quiet, TrajectorySegmenter& cutter,
            OrbitColumns& columns) {
    std::vector<const ImpactField*> fields;
    for (const auto& name : columns.names) fields.push_back(field_of(column_of_observable(name)));
    const std::int64_t limit = range.transient + range.collisions;
    Progress progress("orbit", static_cast<double>(limit), quiet);
    const ContactSink sink = cutter.sink();
    while (orbit.impacts() < limit && orbit.advance(contact_horizon, sink)) {
        const auto& trajectory = cutter.passed(orbit, true);
        // Over a floor that acts S and the velocity change in flight, too.
        const bool by_segments = !orbit.contacts().empty() || cutter.bends_flights();
        if (const auto kept = orbit.impacts() - range.transient; kept > 1 && by_segments)
            columns.contacts.push_back({static_cast<std::size_t>(kept - 2), trajectory});
        if (orbit.impacts() > range.transient) {
            const ImpactRow row = impact_row(orbit);
            for (std::size_t k = 0; k < fields.size(); ++k) columns.values[k].push_back(row.*(fields[k]->member));
        }
        if (orbit.impacts() % 1024 != 0) continue;
        progress.at(static_cast<double>(orbit.impacts()));
        if (is_interrupted()) break;
    }
    columns.impacts = orbit.impacts();
    // The last impact that was asked for may be the one that ends the orbit: nothing is missing then.
    columns.outcome = columns.impacts == limit ? "completed"
                      : is_interrupted()       ? "interrupted"
                                               : std::string(name_of(orbit.outcome()));
}

template <class T>
void follow_in(const SceneOptions& scene_options, const StartOptions& start_options, const ImpactRange& range,
               const OutputOptions& output, OrbitColumns& columns) {
    const Scene<T> scene = scene_options.scene<T>(Extensions::followed);
    const Start<T> start = start_options.start<T>(scene);
    SceneOrbit<T> orbit(scene, start, baseline_for(scene, output.accuracy()));
    std::visit(
        [&](const auto& s) {
            TrajectorySegmenter cutter(scene, s);
            if constexpr (std::is_same_v<T, double>) cutter.take_paths_from(dry_paths(scene));
            columns.contact_scene = cutter.scene();
            follow(orbit, range, output.quiet, cutter, columns);
        },
        start);
}

}  // namespace

std::string column_of_observable(const std::string& observable) {
    return observable == "S" ? "spin" : observable;
}

double period_of(const std::string& column) {
    return column == "psi" || column == "chi" || column == "angle" ? 2 * pi<double>() : 0;
}

void require_observables(const std::vector<std::string>& names, bool disk) {
    for (const auto& name : names) {
        const ImpactField* field = field_of(column_of_observable(name));
        if (field != nullptr && belongs(*field, disk)) continue;
        std::string known = "S";
        for (const auto& f : impact_fields)
            if (belongs(f, disk)) known += std::string(", ") + f.name;
        throw BadInput(fmt::format("observable = '{}' is none of{}: {}", name, disk ? " a disk's" : "", known));
    }
}

OrbitColumns follow_orbit(const SceneOptions& scene_options, const StartOptions& start_options,
                          const OutputOptions& output, const ImpactRange& range,
                          const std::vector<std::string>& names) {
    const Scene<double> scene = scene_options.scene<double>(Extensions::followed);
    OrbitColumns columns;
    columns.scene = scene_settings(scene);
    columns.start = start_settings(start_options, scene);
    if (const auto units = scene_options.units()) columns.units = unit_settings(*units);
    columns.beta = scene.beta;
    columns.disk = scene.is_disk();
    require_observables(names, columns.disk);
    columns.names = names;
    columns.values.resize(names.size());
    note_interruptions();
    with_number_of(output.accuracy(),
                   [&]<class T>(const T&) { follow_in<T>(scene_options, start_options, range, output, columns); });
    return columns;
}

}  // namespace swirl::apps
