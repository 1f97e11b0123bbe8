#include "apps/branches/section_point.hpp"

#include "apps/studies/scene_map/itinerary_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace swirl::apps {

const std::vector<std::string>& coordinate_names(Eigen::Index size) {
    static const std::vector<std::string> of_disk{"psi", "vn", "vt", "S"}, of_polygon{"psi", "chi", "vn", "vt", "S"};
    return size == 4 ? of_disk : of_polygon;
}

std::string units_of_coordinate(const std::string& name) {
    if (name == "S") return "1";
    return name == "psi" || name == "chi" ? "rad" : "R_c omega_s";
}

void write_coordinate_names(const RecordGroup& group, Eigen::Index size) {
    const auto& names = coordinate_names(size);
    group.dimension("coordinate", names.size());
    group.write_strings("coordinate", {"coordinate"}, names, {"", "coordinate of the section point", {}});
}

Eigen::Index place_of(const std::string& observable, Eigen::Index size) {
    const auto& names = coordinate_names(size);
    const auto found = std::find(names.begin(), names.end(), observable);
    return found == names.end() ? size - 1 : found - names.begin();
}

void write_point(JsonWriter& json, const Eigen::VectorXd& z) {
    const auto& names = coordinate_names(z.size());
    json.begin_object();
    for (Eigen::Index i = 0; i < z.size(); ++i) json.member(names[static_cast<std::size_t>(i)], z[i]);
    json.end_object();
}

void write_point_or_null(JsonWriter& json, const std::vector<double>& coordinates) {
    const auto end = std::find_if(coordinates.begin(), coordinates.end(), [](double x) { return std::isnan(x); });
    if (end == coordinates.begin()) return json.null();
    write_point(json, Eigen::Map<const Eigen::VectorXd>(coordinates.data(), end - coordinates.begin()));
}

void write_itinerary(JsonWriter& json, const std::vector<std::int64_t>& itinerary) {
    json.begin_array();
    for (const std::int64_t letter : itinerary) {
        const Letter l = letter_from(letter);
        json.begin_object();
        json.member("vertex_step", std::int64_t{l.vertex_step});
        json.member("contact_mode", name_of(l.mode));
        if (l.through_contact) json.member("through_contact", true);
        json.end_object();
    }
    json.end_array();
}

}  // namespace swirl::apps
