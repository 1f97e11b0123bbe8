#include "apps/simulate/impact_sinks.hpp"

#include "apps/simulate/impact_fields.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace swirl::apps {

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

void JsonImpacts::finish() { json_.end_array(); }

TableImpacts::TableImpacts(bool disk) : disk_(disk) {
    fmt::print("{:>9} {:>14} {:>7} {:>10}{} {:>10} {:>10} {:>10} {:>10} {:>10} {:>10} {:<12}\n", "impact", "t", "vertex",
               "psi", disk ? "" : fmt::format(" {:>10}", "chi"), "vn", "vt", "S", "p", "q", "J", "mode");
}

void TableImpacts::add(const ImpactRow& row) {
    std::string line = fmt::format("{:>9} {} {:>7} {}", row.number, cell(row.t, 14), row.vertex, cell(row.psi, 10));
    if (!disk_) line += " " + cell(row.chi, 10);
    for (const double value : {row.vn, row.vt, row.spin, row.impulse_normal, row.impulse_tangential, row.jacobi})
        line += " " + cell(value, 10);
    fmt::print("{} {}{}\n", line, name_of(row.contact_mode), row.simultaneous ? " simultaneous" : "");
}

RecordImpacts::RecordImpacts(RecordGroup group, bool disk) {
    group.dimension("collision", growing);
    index_.push_back(group.column<std::int64_t>("collision", {"collision"}, {"1", "number of the impact, from 1", {}}));
    for (const auto& field : impact_fields)
        if (belongs(field, disk))
            numbers_.push_back({field.member, group.column<double>(field.name, {"collision"},
                                                                   {field.units, field.long_name, {}})});
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

}  // namespace swirl::apps
