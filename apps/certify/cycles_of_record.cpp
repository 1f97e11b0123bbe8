#include "apps/certify/certified_orbit.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/record/flag_text.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/system/letter.hpp"
#include "apps/system/section_coordinates.hpp"
#include "apps/system/shooting_map.hpp"
#include "map/derivative/parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace swirl::apps::certify {

namespace {

/// A diagram's record does not say the parameter that it moves along: there the scene has the first cycle's.
Scene<double> scene_of(const RecordReader& record, const std::optional<Parameter>& moved,
                       const std::vector<double>& values) {
    Scene<double> scene;
    scene.sides = sides_from(flag_text_of(record.attribute("/scene", "sides")).value_or(""));
    for (const Parameter parameter : all_parameters) {
        const std::string name = record_name(name_of(parameter));
        const bool is_told = record.has_attribute("/scene", name) || parameter != moved || values.empty();
        number_of(scene, parameter) = is_told ? record.attribute<double>("/scene", name) : values.front();
    }
    scene.law = law_from(record.attribute<std::string>("/scene", "law"));
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

}  // namespace

Candidate candidate_at(const CyclePlace& place) {
    const Scene<double>& scene = place.scene;
    Candidate candidate;
    const analysis::ShootingMap map = shooting_map_of(scene);
    for (const SectionPoint<double>& z : place.points) {
        const analysis::ShootingStep step = map.step(coordinates_of(z, scene.is_disk()), 0);
        if (!step.alive) {
            candidate.reason = "the map ends on the cycle";
            return candidate;
        }
        const Letter letter = letter_from(step.letter);
        if (letter.through_contact) {
            candidate.reason = "the cycle leads through sustained contact";
            return candidate;
        }
        candidate.claim.points.push_back(z);
        candidate.claim.times.push_back(step.duration);
        candidate.claim.word.push_back({letter.vertex_step, letter.mode, 0});
    }
    return candidate;
}

namespace {

RecordCycles cycles_in(const RecordReader& record, const std::string& file) {
    const std::string group = record.contains("/branches/points") ? "/branches" : "/orbits";
    if (!record.contains(group + "/points") || !record.contains("/scene"))
        throw BadInput(
            fmt::format("record '{}' holds no cycles; one of swirl orbits, or of continue or bifurcate with "
                        "branches, is needed",
                        file));
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
    }
    result.scene = scene_of(record, parameter, values);
    const std::size_t dimension = result.scene.is_disk() ? disk_dimension : polygon_dimension;
    const auto fits = [&](std::int64_t period) {
        return period >= 1 && static_cast<std::uint64_t>(period) <= shape[1];
    };
    if (shape.size() != 3 || shape[0] != periods.size() || shape[2] != dimension ||
        (parameter && values.size() != periods.size()) || !std::all_of(periods.begin(), periods.end(), fits))
        throw BadInput(fmt::format("record '{}' is damaged: columns of {} do not fit each other", file, group));
    for (std::size_t row = 0; row < periods.size(); ++row) {
        Scene<double> scene = result.scene;
        if (parameter) scene = with_parameter(scene, *parameter, values[row]);
        const auto period = static_cast<std::size_t>(periods[row]);
        result.places.push_back({scene, points_at(points, row, shape[1], shape[2], period)});
    }
    return result;
}

}  // namespace

RecordCycles cycles_of_record(const std::string& file) {
    try {
        return cycles_in(RecordReader(file), file);
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
}

}  // namespace swirl::apps::certify
