#include "apps/simulate/impact_sinks.hpp"

#include "apps/output/impact_fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace swirl::apps::simulate {

namespace {

/// A number of the table: six decimals, or an exponent where they would show nothing or not fit.
std::string cell(double value, int width) {
    const double size = std::abs(value);
    const bool fixed = value == 0 || (size >= 1e-5 && size < std::pow(10, width - 8));
    return fixed ? fmt::format("{:>{}.6f}", value, width) : fmt::format("{:>{}.2e}", value, width);
}

}  // namespace

JsonImpacts::JsonImpacts(JsonWriter& json, bool disk) : json_(json), disk_(disk) {
    json_.key("collisions");
    json_.begin_array(JsonLayout::rows);
}

void JsonImpacts::add(const ImpactRow& row) {
    json_.begin_object();
    json_.member("number", row.number);
    for (const auto& field : impact_fields)
        if (belongs(field, disk_)) json_.member(field.name, row.*field.member);
    json_.member("vertex", row.vertex);
    json_.member("contact_mode", name_of(row.contact_mode));
    json_.member("simultaneous", row.simultaneous);
    json_.end_object();
}

void JsonImpacts::finish() {
    json_.end_array();
    json_.key("contacts");
    json_.begin_array(JsonLayout::rows);
    for (const ContactRow& row : contacts_) {
        json_.begin_object();
        json_.member("t_start", row.t_start);
        json_.member("t_end", row.t_end);
        json_.key("vertices");
        json_.begin_array();
        for (const int vertex : row.vertices) json_.value(vertex);
        json_.end_array();
        json_.member("begin", row.begin);
        json_.member("end", row.end);
        json_.member("motion", row.motion);
        json_.member("mean_S", row.mean_spin);
        json_.member("jacobi_friction", row.jacobi_friction);
        json_.member("landing_jacobi", row.landing_jacobi);
        json_.member("landing_error", row.landing_error);
        json_.end_object();
    }
    json_.end_array();
}

TableImpacts::TableImpacts(bool disk) : disk_(disk) {
    fmt::print("{:>9} {:>14} {:>7} {:>10}{} {:>10} {:>10} {:>10} {:>10} {:>10} {:>10} {:<12}\n", "impact", "t",
               "vertex", "psi", disk ? "" : fmt::format(" {:>10}", "chi"), "vn", "vt", "S", "p", "q", "J", "mode");
}

void TableImpacts::add(const ImpactRow& row) {
    std::string line = fmt::format("{:>9} {} {:>7} {}", row.number, cell(row.t, 14), row.vertex, cell(row.psi, 10));
    if (!disk_) line += " " + cell(row.chi, 10);
    for (const double value : {row.vn, row.vt, row.spin, row.impulse_normal, row.impulse_tangential, row.jacobi})
        line += " " + cell(value, 10);
    fmt::print("{} {}{}\n", line, name_of(row.contact_mode), row.simultaneous ? " simultaneous" : "");
}

void TableImpacts::add(const ContactRow& row) {
    fmt::print("  contact {} to {}  {:<8} on {}: {}, then {}\n", cell(row.t_start, 14), cell(row.t_end, 14), row.motion,
               fmt::join(row.vertices, "+"), row.begin, row.end);
}

namespace {

std::vector<std::string> event_names() {
    std::vector<std::string> names;
    for (int event = 0; event <= static_cast<int>(ContactEvent::landing); ++event)
        names.emplace_back(name_of(static_cast<ContactEvent>(event)));
    return names;
}

const std::vector<std::string> motion_names = {"sliding", "sticking", "rolling"};

std::uint8_t index_in(const std::vector<std::string>& names, std::string_view name) {
    return static_cast<std::uint8_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace

RecordContacts::RecordContacts(RecordGroup group) {
    const std::vector<std::string> along{"contact"};
    group.dimension("contact", growing);
    index_.push_back(group.column<std::int64_t>("contact", along, {"1", "number of the piece of contact, from 1", {}}));
    numbers_.push_back(group.column<double>("t_start", along, {"1/omega_s", "when it began", {}}));
    numbers_.push_back(group.column<double>("t_end", along, {"1/omega_s", "when it ended", {}}));
    numbers_.push_back(group.column<double>("mean_S", along, {"omega_s", "time mean of S", {}}));
    numbers_.push_back(group.column<double>("jacobi_friction", along,
                                            {"m R_c^2 omega_s^2", "change of J by friction, int f (u_t - 1) dt", {}}));
    numbers_.push_back(group.column<double>(
        "landing_jacobi", along, {"m R_c^2 omega_s^2", "change of J by the chatter summed up before it", {}}));
    numbers_.push_back(group.column<double>(
        "landing_error", along, {"1", "what summing up chatter did to place and velocities (an estimate)", {}}));
    vertices_.push_back(group.column<std::int32_t>("vertex", along, {"1", "vertex on the wall", {}}));
    vertices_.push_back(
        group.column<std::int32_t>("second_vertex", along, {"1", "an edge's other vertex; -1: none", {}}));
    names_.push_back(group.column<std::uint8_t>("begin", along, {"1", "what began it", event_names()}));
    names_.push_back(group.column<std::uint8_t>("end", along, {"1", "what ended it", event_names()}));
    names_.push_back(group.column<std::uint8_t>("motion", along, {"1", "how the body moved", motion_names}));
}

void RecordContacts::add(const ContactRow& row) {
    index_[0].append(++count_);
    const double values[] = {row.t_start,         row.t_end,          row.mean_spin,
                             row.jacobi_friction, row.landing_jacobi, row.landing_error};
    for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i].append(values[i]);
    vertices_[0].append(std::int32_t{row.vertices[0]});
    vertices_[1].append(std::int32_t{row.vertices.size() > 1 ? row.vertices[1] : -1});
    const std::vector<std::string> events = event_names();
    names_[0].append(index_in(events, row.begin));
    names_[1].append(index_in(events, row.end));
    names_[2].append(index_in(motion_names, row.motion));
}

RecordImpacts::RecordImpacts(RecordGroup group, bool disk) {
    group.dimension("collision", growing);
    index_.push_back(group.column<std::int64_t>("collision", {"collision"}, {"1", "number of the impact, from 1", {}}));
    for (const auto& field : impact_fields)
        if (belongs(field, disk))
            numbers_.push_back(
                {field.member, group.column<double>(field.name, {"collision"}, {field.units, field.long_name, {}})});
    vertex_.push_back(group.column<std::int32_t>("vertex", {"collision"}, {"1", "vertex that struck", {}}));
    std::vector<std::string> modes;
    for (int mode = 0; mode <= static_cast<int>(ContactMode::r_reversed); ++mode)
        modes.emplace_back(name_of(static_cast<ContactMode>(mode)));
    mode_.push_back(group.column<std::uint8_t>("contact_mode", {"collision"}, {"1", "contact mode", modes}));
    simultaneous_.push_back(
        group.column<bool>("simultaneous", {"collision"}, {"", "another vertex struck at the same time", {}}));
}

void RecordImpacts::add(const ImpactRow& row) {
    index_.front().append(std::int64_t{row.number});
    for (auto& named : numbers_) named.column.append(row.*named.member);
    vertex_.front().append(std::int32_t{row.vertex});
    mode_.front().append(static_cast<std::uint8_t>(row.contact_mode));
    simultaneous_.front().append(row.simultaneous);
}

}  // namespace swirl::apps::simulate
