#include "apps/boundaries/starting_points_of_record.hpp"

#include "analysis/cycles/cycle.hpp"
#include "apps/boundaries/read_planes.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/record/flag_text.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace swirl::apps::boundaries {

void require_same_scene(const RecordReader& record, const std::string& what, const std::string& group,
                        const Settings& scene, const std::vector<std::string>& varied) {
    for (const auto& [name, value] : scene) {
        if (std::find(varied.begin(), varied.end(), name) != varied.end() || !record.has_attribute(group, name))
            continue;
        const std::string there = flag_text_of(record.attribute(group, name)).value_or("?"),
                          here = flag_text_of(value).value_or("?");
        if (there != here) throw BadInput(fmt::format("{} has {} = {}; the scene has {}", what, name, there, here));
    }
    constexpr std::pair<const char*, const char*> unknown[] = {{"drag", "is of a floor that drags"},
                                                               {"spin_drag", "is of a floor that drags"},
                                                               {"floor_friction", "is of a floor with dry friction"},
                                                               {"tangential_restitution", "has tangential restitution"},
                                                               {"corner", "has rounded corners"}};
    for (const auto& [name, words] : unknown)  // scenes without have them not among their settings
        if (record.has_attribute(group, name) && record.attribute<double>(group, name) != 0)
            throw BadInput(fmt::format("{} {}, to which curves are not extended", what, words));
}

namespace {

Eigen::Index dimension_of(const Scene<double>& scene) {
    return scene.is_disk() ? disk_dimension : polygon_dimension;
}

std::complex<double> critical_multiplier(const std::string& kind, double angle) {
    if (kind == "flip") return -1;
    return kind == "neimark-sacker" ? std::polar(1.0, angle) : std::complex<double>(1);
}

[[noreturn]] void refuse_damaged(const std::string& file, const std::string& group) {
    throw BadInput(fmt::format("record '{}' is damaged: columns of {} do not fit each other", file, group));
}

/// The cycles in the rows of a group with `points`, `period` and `kind`.
std::vector<StartingPoint> cycles_of(const RecordReader& record, const std::string& file, const std::string& group,
                                     Eigen::Index dimension) {
    const auto shape = record.info(group + "/points").shape;
    const auto all = record.read<double>(group + "/points");
    const auto periods = record.read<std::int64_t>(group + "/period");
    const auto fits = [&](std::int64_t period) {
        return period >= 1 && static_cast<std::uint64_t>(period) <= shape[1];
    };
    if (shape.size() != 3 || shape[0] != periods.size() || shape[2] != static_cast<std::uint64_t>(dimension) ||
        all.size() != shape[0] * shape[1] * shape[2] || !std::all_of(periods.begin(), periods.end(), fits))
        refuse_damaged(file, group);
    std::vector<StartingPoint> starting_points;
    for (std::size_t row = 0; row < periods.size(); ++row) {
        StartingPoint start;
        for (std::size_t i = 0; i < static_cast<std::size_t>(periods[row]); ++i) {
            Eigen::VectorXd z(static_cast<Eigen::Index>(shape.at(2)));
            for (std::size_t a = 0; a < shape.at(2); ++a)
                z[static_cast<Eigen::Index>(a)] = all[(row * shape.at(1) + i) * shape.at(2) + a];
            start.points.push_back(std::move(z));
        }
        starting_points.push_back(std::move(start));
    }
    return starting_points;
}

/// Of `continue` and `bifurcate`: special points along one parameter of the plane.
std::vector<StartingPoint> starting_points_of_branches(const RecordReader& record, const std::string& file,
                                                       const Scene<double>& scene, const Plane& plane) {
    const auto along = record.attribute<std::string>("/settings", "along");
    const int axis = along == plane.axes[0].name ? 0 : 1;
    const ParameterRange& other = plane.axes[static_cast<std::size_t>(1 - axis)];
    if (along != plane.axes[static_cast<std::size_t>(axis)].name)
        throw BadInput(fmt::format("record '{}' is along {}, which is no parameter of the plane", file, along));
    const std::string other_name = record_name(other.name), own_name = record_name(along);
    require_same_scene(record, fmt::format("record '{}'", file), "/scene", scene_settings(scene),
                       {own_name, other_name});
    const auto value = record.attribute<double>("/scene", other_name);
    if (!record.contains("/special/points"))
        throw BadInput(fmt::format("record '{}' holds no special points of branches", file));
    auto starting_points = cycles_of(record, file, "/special", dimension_of(scene));
    const auto kinds = record.read_strings("/special/kind");
    const auto parameters = record.read<double>("/special/parameter");
    const auto angles = record.read<double>("/special/form_angle");
    if (kinds.size() != starting_points.size() || parameters.size() != starting_points.size() ||
        angles.size() != starting_points.size())
        refuse_damaged(file, "/special");
    for (std::size_t i = 0; i < starting_points.size(); ++i) {
        starting_points[i].kind = kinds[i];
        starting_points[i].p[axis] = parameters[i];
        starting_points[i].p[1 - axis] = value;
        starting_points[i].multiplier = critical_multiplier(kinds[i], angles[i]);
    }
    for (StartingPoint& start : starting_points) {  // what the map's steps from the cycle say
        const bool touches = start.kind == "grazing" || start.kind == "two-vertices";
        const bool has_angle = start.kind != "neimark-sacker" || std::isfinite(std::abs(start.multiplier));
        if (!touches && has_angle) continue;
        const auto shooting =
            analysis::shooting_residual(shooting_map_of(scene_at(scene, plane, start.p)), start.points, 0);
        if (!shooting.alive) continue;
        if (touches)
            name_flights(start, shooting.steps);
        else
            start.multiplier = critical_pair(analysis::sorted_multipliers(analysis::monodromy(shooting)));
    }
    std::erase_if(starting_points, [](const StartingPoint& start) { return start.kind == "branch-point"; });
    return starting_points;
}

/// What the rows of a record's cycles say of those on a border. @throws BadInput if it is no such thing
class BorderRows {
public:
    BorderRows(const RecordReader& record, const std::string& file, const Scene<double>& scene, std::size_t rows)
        : file_(file), sides_(scene.is_disk() ? 1 : scene.sides) {
        if (!record.contains("/curves/touch"))
            throw BadInput(fmt::format(
                "record '{}' does not say what touches on its border curves: an earlier version wrote it", file));
        touch_ = record.read<std::uint8_t>("/curves/touch");
        vertex_ = record.read<std::int64_t>("/curves/touching_vertex");
        touch_time_ = record.read<double>("/curves/touch_time");
        times_ = record.read<double>("/curves/flight_times");
        vertices_ = record.read<double>("/curves/vertex_steps");
        if (rows == 0 || touch_.size() != rows || vertex_.size() != rows || touch_time_.size() != rows ||
            times_.size() % rows != 0 || vertices_.size() != times_.size())
            refuse_damaged(file, "/curves");
        longest_ = times_.size() / rows;
    }

    BorderCycle at(std::size_t row, const StartingPoint& start) const {
        BorderCycle cycle;
        if (touch_[row] < 1 || touch_[row] > touch_names.size() || start.points.size() > longest_)
            refuse_damaged(file_, "/curves");
        cycle.touch = static_cast<Touch>(touch_[row] - 1);
        const bool grazes = cycle.touch == Touch::grazing;
        if (name_of(cycle.touch) != start.kind || !is_vertex(static_cast<double>(vertex_[row])) ||
            (grazes && !std::isfinite(touch_time_[row])))
            refuse_damaged(file_, "/curves");
        cycle.vertex = static_cast<int>(vertex_[row]);
        cycle.touch_time = grazes ? touch_time_[row] : 0;
        cycle.points = start.points;
        cycle.p = start.p;
        for (std::size_t i = 0; i < start.points.size(); ++i) {
            const double time = times_[row * longest_ + i], vertex = vertices_[row * longest_ + i];
            if (!std::isfinite(time) || !is_vertex(vertex)) refuse_damaged(file_, "/curves");
            cycle.times.push_back(time);
            cycle.vertices.push_back(static_cast<int>(vertex));
        }
        return cycle;
    }

private:
    bool is_vertex(double number) const { return number >= 0 && number < sides_ && number == std::floor(number); }

    const std::string& file_;
    double sides_;
    std::vector<std::uint8_t> touch_;
    std::vector<std::int64_t> vertex_;
    std::vector<double> touch_time_, times_, vertices_;
    std::size_t longest_ = 0;
};

/// Of `boundaries`: of each curve a cycle in the middle of each stretch of it that lies in the plane.
std::vector<StartingPoint> starting_points_of_curves(const RecordReader& record, const std::string& file,
                                                     const Scene<double>& scene, const Plane& plane) {
    for (const auto& [name, axis] : {std::pair("first", 0), std::pair("second", 1)})
        if (record.attribute<std::string>("/settings", name) != plane.axes[static_cast<std::size_t>(axis)].name)
            throw BadInput(fmt::format("record '{}' is of another plane", file));
    require_same_scene(record, fmt::format("record '{}'", file), "/scene", scene_settings_of(scene, plane));
    if (!record.contains("/curves/points")) return {};
    const auto all = cycles_of(record, file, "/curves", dimension_of(scene));
    const auto curve = record.read<std::int64_t>("/curves/curve");
    const auto first = record.read<double>("/curves/first"), second = record.read<double>("/curves/second");
    const auto angles = record.read<double>("/curves/angle");
    const auto kinds = record.read_strings("/curve_ends/kind");
    const auto is_one = [&](std::int64_t c) { return c >= 0 && static_cast<std::size_t>(c) < kinds.size(); };
    if (curve.size() != all.size() || first.size() != all.size() || second.size() != all.size() ||
        angles.size() != all.size() || !std::all_of(curve.begin(), curve.end(), is_one))
        refuse_damaged(file, "/curves");
    const auto lies_in = [&](std::size_t row) { return is_in(plane, {first[row], second[row]}); };
    std::optional<BorderRows> borders;
    std::vector<StartingPoint> starting_points;
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
        end = begin + 1;
        if (!lies_in(begin)) continue;
        while (end < all.size() && curve[end] == curve[begin] && lies_in(end)) ++end;
        const std::size_t middle = begin + (end - begin) / 2;
        StartingPoint start = all[middle];
        start.kind = kinds[static_cast<std::size_t>(curve[begin])];
        start.p = {first[middle], second[middle]};
        start.multiplier = critical_multiplier(start.kind, angles[middle]);
        if (is_on_border(start.kind)) {
            if (!borders) borders.emplace(record, file, scene, all.size());
            start.border = borders->at(middle, start);
        }
        starting_points.push_back(std::move(start));
    }
    return starting_points;
}

}  // namespace

std::vector<StartingPoint> starting_points_of_record(const std::string& file, const Scene<double>& scene,
                                                     const Plane& plane) {
    try {
        const RecordReader record(file);
        if (!record.contains("/scene") || !record.contains("/settings"))
            throw BadInput(
                fmt::format("record '{}' is none of: continue, bifurcate with --branches, boundaries", file));
        if (record.has_attribute("/settings", "along")) return starting_points_of_branches(record, file, scene, plane);
        if (record.has_attribute("/settings", "first")) return starting_points_of_curves(record, file, scene, plane);
        throw BadInput(fmt::format("record '{}' is none of: continue, bifurcate with --branches, boundaries", file));
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
}

}  // namespace swirl::apps::boundaries
