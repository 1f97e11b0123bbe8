#include "apps/boundaries/read_planes.hpp"
#include "apps/boundaries/starting_points_of_record.hpp"
#include "apps/record/flag_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace swirl::apps::boundaries {

namespace {

/// The places of the codes of these names among an attribute's.
std::vector<bool> are_named(const RecordReader& record, const std::string& attribute,
                            const std::vector<std::string>& names) {
    std::vector<bool> chosen;
    for (const auto& name : record.attribute<std::vector<std::string>>("/settings", attribute))
        chosen.push_back(std::find(names.begin(), names.end(), name) != names.end());
    return chosen;
}

MappedPlane read_plane(const RecordReader& record, const std::string& file, const Scene<double>& scene,
                       const Plane& plane) {
    if (!record.contains("/sweep/run_period"))
        throw BadInput(fmt::format("--against '{}' is no record of swirl sweep over a grid", file));
    const auto dimensions = record.info("/sweep/run_period").dimensions;
    const std::string names[] = {record_name(plane.axes[0].name), record_name(plane.axes[1].name)};
    const bool straight = dimensions.size() == 3 && dimensions[0] == names[0] && dimensions[1] == names[1];
    const bool turned = dimensions.size() == 3 && dimensions[0] == names[1] && dimensions[1] == names[0];
    if (!straight && !turned)
        throw BadInput(fmt::format("--against '{}' is no sweep over {} and {} alone", file, names[0], names[1]));
    if (record.contains("/sweep/visited"))
        throw BadInput(fmt::format(
            "--against '{}' is a refined sweep, where cells that were not run hold their neighbours' verdict: give one "
            "without --refine",
            file));
    require_same_scene(record, fmt::format("--against '{}'", file), "/settings", scene_settings_of(scene, plane));
    MappedPlane map;
    for (std::size_t axis = 0; axis < 2; ++axis) map.values[axis] = record.read<double>("/sweep/" + names[axis]);
    const auto periods = record.read<std::int64_t>("/sweep/run_period");
    const auto spins = record.read<double>("/sweep/run_mean_S");
    const auto kinds = record.read<std::uint8_t>("/sweep/run_kind");
    const auto periodic = are_named(record, "kinds", {"fixed-point", "cycle"});
    const auto families = are_named(record, "kinds", {"family"});
    const auto undecided = are_named(record, "kinds", {"none", "transient"});
    if (map.cells() == 0 || periods.empty() || periods.size() % map.cells() != 0 || spins.size() != periods.size() ||
        kinds.size() != periods.size() || periodic.size() != undecided.size() ||
        *std::max_element(kinds.begin(), kinds.end()) >= periodic.size())
        throw BadInput(fmt::format("--against '{}' is damaged: its runs do not fit its grid", file));
    map.runs = periods.size() / map.cells();
    map.starts = {record.attribute<std::uint64_t>("/settings", "seed"), record.attribute<double>("/settings", "speed"),
                  record.attribute<std::int64_t>("/settings", "transient"),
                  record.attribute<std::int64_t>("/settings", "collisions")};
    map.all.resize(periods.size());
    const std::size_t n0 = map.values[0].size(), n1 = map.values[1].size();
    for (std::size_t i = 0; i < map.all.size(); ++i) {
        const std::size_t cell = i / map.runs, run = i % map.runs;
        const std::size_t from = turned ? (cell % n1 * n0 + cell / n1) * map.runs + run : i;
        map.all[i] = {periodic[kinds[from]], undecided[kinds[from]], families[kinds[from]], periods[from], spins[from]};
    }
    return map;
}

}  // namespace

MappedPlane mapped_plane(const std::string& file, const Scene<double>& scene, const Plane& plane) {
    try {
        return read_plane(RecordReader(file), file, scene, plane);
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
}

}  // namespace swirl::apps::boundaries
