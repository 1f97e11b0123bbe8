#include "apps/orbits/recorded_cycles.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/record/flag_text.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"
#include "map/model/parameter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace swirl::apps::orbits {

namespace {

/// A diagram's record does not say the parameter that it moves along: there the scene has the first cycle's.
Scene<double> scene_of(const RecordReader& record, const std::optional<Parameter>& moved,
                       const std::vector<double>& values) {
    Scene<double> scene;
    scene.sides = sides_from(flag_text_of(record.attribute("/scene", "sides")).value_or(""));
    for (const Parameter parameter : all_parameters) {
        const std::string name = record_name(name_of(parameter));
        const bool is_extension = parameter == Parameter::drag || parameter == Parameter::tangential_restitution ||
                                  parameter == Parameter::corner;
        if (is_extension && parameter != moved && !record.has_attribute("/scene", name)) continue;
        const bool is_told = record.has_attribute("/scene", name) || parameter != moved || values.empty();
        number_of(scene, parameter) = is_told ? record.attribute<double>("/scene", name) : values.front();
    }
    scene.law = law_from(record.attribute<std::string>("/scene", "law"));
    if (record.has_attribute("/scene", "spin_drag")) scene.spin_drag = record.attribute<double>("/scene", "spin_drag");
    for (const auto& [name, member] : {std::pair("floor_friction", &Scene<double>::floor_friction),
                                       std::pair("gravity_ratio", &Scene<double>::gravity_ratio)})
        if (record.has_attribute("/scene", name)) scene.*member = record.attribute<double>("/scene", name);
    if (record.has_attribute("/scene", "floor"))
        scene.floor = floor_from(record.attribute<std::string>("/scene", "floor"));
    return validated(scene);
}

/// The parameter of a record of `continue` or `bifurcate`; empty: none (a family's own S, say).
std::string parameter_of(const RecordReader& record) {
    if (!record.has_attribute("/settings", "along")) return {};
    return record.attribute<std::string>("/settings", "along");
}

std::vector<SectionPoint<double>> points_at(const std::vector<double>& all, std::size_t row, std::size_t longest,
                                            std::size_t dimension, std::size_t period) {
    std::vector<SectionPoint<double>> points;
    for (std::size_t i = 0; i < period; ++i) {
        Eigen::VectorXd z(static_cast<Eigen::Index>(dimension));
        for (std::size_t a = 0; a < dimension; ++a)
            z[static_cast<Eigen::Index>(a)] = all[(row * longest + i) * dimension + a];
        points.push_back(section_point_of(z));
    }
    return points;
}

/// Steady modes, of `describe`.
RecordCycles steady_modes_in(const RecordReader& record, const std::string& file) {
    RecordCycles result;
    result.scene = scene_of(record, {}, {});
    const std::size_t dimension = result.scene.is_disk() ? disk_dimension : polygon_dimension;
    const auto shape = record.info("/steady_modes/point").shape;
    if (shape.size() != 2 || shape[1] != dimension)
        throw BadInput(fmt::format("record '{}' is damaged: columns of /steady_modes do not fit each other", file));
    const auto points = record.read<double>("/steady_modes/point");
    for (std::size_t row = 0; row < shape[0]; ++row)
        result.places.push_back({result.scene, points_at(points, row, 1, dimension, 1), row + 1});
    return result;
}

/// The cycle through a point that a verdict has; its other points are the images of the first.
CyclePlace cycle_through(const Scene<double>& scene, const std::vector<double>& point, std::int64_t period,
                         const std::string& file) {
    const std::size_t dimension = scene.is_disk() ? disk_dimension : polygon_dimension;
    constexpr std::int64_t longest = 1'000'000;  // that classify looks for
    if (point.size() != dimension || period < 1 || period > longest)
        throw BadInput(fmt::format("record '{}' is damaged: the point and period of its verdict are none", file));
    const auto first = points_at(point, 0, 1, dimension, 1).front();
    const auto points = analysis::orbit_from(shooting_map_of(scene), coordinates_of(first, scene.is_disk()), 0,
                                             static_cast<int>(period));
    if (points.empty()) throw BadInput(fmt::format("record '{}': the map ends on the cycle of its verdict", file));
    CyclePlace place{scene, {}};
    for (const auto& z : points) place.points.push_back(section_point_of(z));
    return place;
}

/// The cycle that a verdict found, of `classify`.
RecordCycles cycle_of_verdict(const RecordReader& record, const std::string& file) {
    RecordCycles result;
    result.scene = scene_of(record, {}, {});
    result.places.push_back(cycle_through(result.scene, record.attribute<std::vector<double>>("/mode", "point"),
                                          record.attribute<std::int64_t>("/mode", "period"), file));
    return result;
}

/// Those among the attractors of `classify --runs`.
RecordCycles cycles_of_runs(const RecordReader& record, const std::string& file) {
    RecordCycles result;
    result.scene = scene_of(record, {}, {});
    const auto shape = record.info("/attractors/point").shape;
    const auto points = record.read<double>("/attractors/point");
    const auto periods = record.read<std::int64_t>("/attractors/period");
    const auto kinds = record.read_strings("/attractors/kind");
    if (shape.size() != 2 || shape[0] != periods.size() || shape[0] != kinds.size())
        throw BadInput(fmt::format("record '{}' is damaged: columns of /attractors do not fit each other", file));
    for (std::size_t row = 0; row < periods.size(); ++row) {
        const auto begin = points.begin() + static_cast<std::ptrdiff_t>(row * shape[1]);
        const std::vector<double> point(begin, begin + static_cast<std::ptrdiff_t>(shape[1]));
        const bool is_cycle = !point.empty() && std::isfinite(point.front());
        result.others.push_back(is_cycle ? "" : kinds[row]);
        if (!is_cycle) continue;
        result.places.push_back(cycle_through(result.scene, point, periods[row], file));
        result.places.back().number = row + 1;
    }
    if (result.places.empty())
        throw BadInput(fmt::format("record '{}' holds no cycles: its attractors are {}", file, fmt::join(kinds, ", ")));
    return result;
}

/// Those of `orbits`, or along the branches of `continue` and `bifurcate`.
RecordCycles cycles_in_rows(const RecordReader& record, const std::string& group, const std::string& file) {
    RecordCycles result;
    const auto shape = record.info(group + "/points").shape;
    const auto points = record.read<double>(group + "/points");
    const auto periods = record.read<std::int64_t>(group + "/period");
    std::vector<double> values;
    std::optional<Parameter> parameter;
    if (group == "/branches") {
        result.along = parameter_of(record);
        parameter = parameter_named(result.along);
        if (parameter) values = record.read<double>("/branches/parameter");
        if (!parameter) result.along.clear();
        if (parameter && record.has_attribute("/settings", "range"))
            result.range = flag_text_of(record.attribute("/settings", "range")).value_or("");
        if (parameter && record.contains("/branches/branch"))
            result.branches = record.read<std::int64_t>("/branches/branch");
    }
    result.scene = scene_of(record, parameter, values);
    const std::size_t dimension = result.scene.is_disk() ? disk_dimension : polygon_dimension;
    const auto fits = [&](std::int64_t period) {
        return period >= 1 && static_cast<std::uint64_t>(period) <= shape[1];
    };
    if (shape.size() != 3 || shape[0] != periods.size() || shape[2] != dimension ||
        (parameter && values.size() != periods.size()) ||
        (!result.branches.empty() && result.branches.size() != periods.size()) ||
        !std::all_of(periods.begin(), periods.end(), fits))
        throw BadInput(fmt::format("record '{}' is damaged: columns of {} do not fit each other", file, group));
    for (std::size_t row = 0; row < periods.size(); ++row) {
        Scene<double> scene = result.scene;
        if (parameter) scene = with_parameter(scene, *parameter, values[row]);
        const auto period = static_cast<std::size_t>(periods[row]);
        result.places.push_back({scene, points_at(points, row, shape[1], shape[2], period), row + 1});
    }
    return result;
}

RecordCycles cycles_in(const RecordReader& record, const std::string& file) {
    if (record.contains("/scene")) {
        for (const char* const group : {"/branches", "/orbits"})
            if (record.contains(group + std::string("/points"))) return cycles_in_rows(record, group, file);
        if (record.contains("/steady_modes/point")) return steady_modes_in(record, file);
        if (record.contains("/attractors/point") && record.contains("/runs")) return cycles_of_runs(record, file);
        if (record.contains("/mode") && record.has_attribute("/mode", "point")) return cycle_of_verdict(record, file);
    }
    throw BadInput(
        fmt::format("record '{}' holds no cycles; one of swirl orbits, of continue or bifurcate with branches, of "
                    "describe with steady modes, or of classify on a cycle is needed",
                    file));
}

}  // namespace

RecordCycles cycles_of_record(const std::string& file) {
    try {
        return cycles_in(RecordReader(file), file);
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
}

CyclePlace cycle_of_record(const std::string& file, const std::optional<std::int64_t>& number) {
    const RecordCycles cycles = cycles_of_record(file);
    const std::size_t count = std::max(cycles.places.size(), cycles.others.size());
    if (!number && cycles.places.size() != 1)
        throw BadInput(
            fmt::format("record '{}' holds {} cycles: choose one by --orbit I, 1 to {} (swirl show lists them)", file,
                        cycles.places.size(), count));
    if (!number) return cycles.places.front();
    for (const CyclePlace& place : cycles.places)
        if (std::cmp_equal(place.number, *number)) return place;
    if (*number >= 1 && std::cmp_less_equal(*number, count))
        throw BadInput(fmt::format("orbit = {}: attractor {} of record '{}' is no cycle but {}", *number, *number, file,
                                   cycles.others[static_cast<std::size_t>(*number - 1)]));
    throw BadInput(
        fmt::format("orbit = {} is outside its range: record '{}' holds the cycles 1 to {}", *number, file, count));
}

std::string point_as_flag(const SectionPoint<double>& z, bool disk) {
    const Eigen::VectorXd coordinates = coordinates_of(z, disk);
    return fmt::format("{}", fmt::join(coordinates.begin(), coordinates.end(), ","));
}

}  // namespace swirl::apps::orbits
