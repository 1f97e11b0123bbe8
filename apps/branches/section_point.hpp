// Section points and words as they are listed.
#pragma once

#include "apps/command_line/documents.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace swirl::apps {

/// Where an observable stands in a state of that size: psi, chi, vn, vt or S.
Eigen::Index place_of(const std::string& observable, Eigen::Index size);

/// A section point as a JSON object.
void write_point(JsonWriter& json, const Eigen::VectorXd& z);
/// A list of coordinates, which NaN may fill up, as a JSON object; null of none.
void write_point_or_null(JsonWriter& json, const std::vector<double>& coordinates);
/// An itinerary as a list of {vertex_step, contact_mode}.
void write_itinerary(JsonWriter& json, const std::vector<std::int64_t>& itinerary);
/// The names of a section point's coordinates; a disk's has four.
const std::vector<std::string>& coordinate_names(Eigen::Index size);
/// The unit of one of them.
std::string units_of_coordinate(const std::string& name);
/// A group's dimension `coordinate`, with these names as its coordinate.
void write_coordinate_names(const RecordGroup& group, Eigen::Index size);

}  // namespace swirl::apps
