#include "apps/simulate/sinks.hpp"

#include "apps/impacts/impact_fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace swirl::apps::simulate {

namespace {

/// A number of the table: four decimals, fewer where they would not fit, an exponent where they would show nothing.
std::string number_in(double value, int width) {
    const double size = std::abs(value);
    for (int decimals = 4; size >= 1e-3 && decimals >= 0; --decimals)
        if (const auto text = fmt::format("{:.{}f}", value, decimals); static_cast<int>(text.size()) <= width)
            return fmt::format("{:>{}}", text, width);
    std::string text = value == 0 ? "0" : fmt::format("{:.1e}", value);  // "-1.2e-04" becomes "-1.2e-4"
    if (const auto zero = text.find("e-0"); zero != std::string::npos) text.erase(zero + 2, 1);
    return fmt::format("{:>{}}", text, width);
}

ColumnFormat number_of_width(int width) {
    return {fmt::format(" {{:>{}}}", width),
            [width](const Value& value) { return fmt::format(" {}", number_in(std::get<double>(value), width)); }};
}

/// Group `collisions`.
Table<ImpactRow> impact_table(const Scene<double>& scene) {
    using F = Field<ImpactRow>;
    const ColumnFormat simultaneous{"", [](const Value& value) { return std::get<bool>(value) ? " *" : ""; }};
    const ColumnFormat mode{" {:<10}", column_format_of(" {}").text};
    Table<ImpactRow> table{{"collision"}, {}, {}, {"number", "t", "vertex", "psi", "chi", "vn", "vt", "S"}};
    table.fields.push_back(
        F{"number", &ImpactRow::number, "1", "number of the impact, from 1"}.coordinate().shown("impact", "{:>6}"));
    for (const auto& field : impact_fields) {
        F number(field.name, field.member, field.units, field.long_name);
        if (*field.heading != '\0') number.shown(field.heading, number_of_width(field.member == &ImpactRow::t ? 9 : 7));
        table.fields.push_back(number.when(belongs(field, scene.is_disk())));
    }
    table.fields.push_back(
        F{"S", &ImpactRow::spin, "1", "S just after the impact"}.table_only().shown("S", number_of_width(7)));
    table.fields.push_back(F{"vertex", &ImpactRow::vertex, "1", "vertex that struck"}
                               .stored_as(ElementType::int32)
                               .shown("vertex", " {:>6}"));
    table.fields.push_back(F{"contact_mode", &ImpactRow::contact_mode, "", "contact mode"}
                               .flags(names_up_to(ContactMode::r_reversed))
                               .shown("mode", mode));
    if (scene.mu == 0) table.fields.back().column_format.reset();  // all are frictionless
    table.fields.push_back(
        F{"simultaneous", &ImpactRow::simultaneous, "1", "another vertex struck at the same time"}.shown("",
                                                                                                         simultaneous));
    return table;
}

/// Group `contacts`: the pieces of sustained contact.
Table<ContactRow> contact_table() {
    using Row = ContactRow;
    using F = Field<Row>;
    const auto events = names_up_to(ContactEvent::landing);
    const auto second_vertex = [](const Row& row) { return row.vertices.size() > 1 ? row.vertices[1] : -1; };
    return {
        {"contact"},
        {F{"number", &Row::number, "1", "number of the piece of contact, from 1"}.coordinate().record_only(),
         {"t_start", &Row::t_start, "1/omega_s", "when it began"},
         {"t_end", &Row::t_end, "1/omega_s", "when it ended"},
         {"vertices", [](JsonWriter& json, const Row& row) { json.array(row.vertices); }},
         F{"vertex", [](const Row& row) { return row.vertices[0]; }, "1", "vertex on the wall"}
             .stored_as(ElementType::int32)
             .record_only(),
         F{"second_vertex", second_vertex, "1", "an edge's other vertex; -1: none"}
             .stored_as(ElementType::int32)
             .record_only(),
         F{"begin", &Row::begin, "", "what began it"}.flags(events),
         F{"end", &Row::end, "", "what ended it"}.flags(events),
         F{"motion", &Row::motion, "", "how the body moved"}.flags({"sliding", "sticking", "rolling", "resting"}),
         {"mean_S", &Row::mean_spin, "1", "time mean of S"},
         {"jacobi_friction", &Row::jacobi_friction, "m R_c^2 omega_s^2", "change of J by friction, int f (u_t - 1) dt"},
         {"landing_jacobi", &Row::landing_jacobi, "m R_c^2 omega_s^2",
          "change of J by the chatter summed up before it"},
         {"landing_error", &Row::landing_error, "1",
          "error that summing up chatter leaves in position and velocities (an estimate)"}},
        {"number", "t_start", "t_end", "mean_S", "jacobi_friction", "landing_jacobi", "landing_error"}};
}

/// A line of the table of impacts.
///   time  1/ω_s in its units
std::string contact_in_words(const ContactRow& row, double time) {
    return fmt::format("  contact {} to {}  {:<8} on {}: {}, then {}\n", number_in(row.t_start * time, 12),
                       number_in(row.t_end * time, 12), row.motion, fmt::join(row.vertices, "+"), row.begin, row.end);
}

constexpr std::size_t shortest_chatter = 4;    // rows: fewer say more themselves
constexpr std::size_t longest_chatter = 1024;  // rows that are held back

/// Does this impact follow on the other as in a chatter: of the same vertex, after a shorter flight?
bool fades(const ImpactRow& before, const ImpactRow& row) {
    return row.number == before.number + 1 && row.vertex == before.vertex && row.flight_time < before.flight_time;
}

/// The impacts between a chatter's first and the landing, in a line of the table.
std::string chatter_in_words(const std::vector<ImpactRow>& rows, double time) {
    const ImpactRow &second = rows[1], &last = rows.back();
    return fmt::format("  chatter {} to {}  impacts {} to {} on {}: flights from {:.2e} down to {:.2e}\n",
                       number_in(second.t * time, 12), number_in(last.t * time, 12), second.number, last.number,
                       last.vertex, second.flight_time * time, last.flight_time * time);
}

/// Group `samples`.
Table<SampleRow> sample_table() {
    return {
        {"sample"},
        {{"t", &SampleRow::t, "1/omega_s", "time"},
         {"x", &SampleRow::x, "R_c", "position of the body's centre, laboratory"},
         {"y", &SampleRow::y, "R_c", "position of the body's centre, laboratory"},
         {"angle", &SampleRow::angle, "rad", "direction of vertex 0, unwound"},
         {"spin", &SampleRow::spin, "omega_s", "S"},
         {"in_contact", &SampleRow::in_contact, "1", "on the wall, not in flight"},
         {"normal_force", &SampleRow::normal_force, "m R_c omega_s^2", "lambda: the wall's force is -lambda n + f t"},
         {"friction", &SampleRow::friction, "m R_c omega_s^2", "f"},
         {"slip", &SampleRow::slip, "R_c omega_s", "u_t, velocity of the body along the wall where it touches"}}};
}

}  // namespace

Sinks::Sinks(const SimulateOptions& options, const Scene<double>& scene, RecordWriter* record, JsonWriter* json,
             Film* film)
    : impacts_(impact_table(scene)),
      shown_(shown_fields(in_units(impacts_, options.scene.units()))),
      time_(options.scene.units().value_or(Units{}).time),
      json_(json),
      film_(film),
      prints_(json == nullptr && record == nullptr && film == nullptr && !options.output.quiet),
      samples_(options.sample.has_value() && film == nullptr) {
    if (record != nullptr) {
        record_impacts_.emplace(record->root().group("collisions"), impacts_);
        record_contacts_.emplace(record->root().group("contacts"), contact_table());
        if (samples_) record_samples_.emplace(record->root().group("samples"), sample_table());
    }
    if (json_ != nullptr) {
        json_->key("collisions");
        json_->begin_array(JsonLayout::rows);
    }
    if (prints_) fmt::print("{}", heading_of(shown_));
}

void Sinks::add(const ImpactRow& row) {
    if (record_impacts_) record_impacts_->add(row);
    if (json_ != nullptr) write_object(*json_, impacts_, row);
    if (!prints_) return;
    if (!fading_.empty() && (!fades(fading_.back(), row) || fading_.size() >= longest_chatter)) print_fading();
    fading_.push_back(row);
}

void Sinks::print_fading() {
    for (const ImpactRow& row : fading_) fmt::print("{}", line_of(shown_, row));
    fading_.clear();
}

void Sinks::add(ContactRow row) {
    row.number = ++contact_count_;
    if (record_contacts_) record_contacts_->add(row);
    if (prints_) {
        const bool chatter = row.begin == name_of(ContactEvent::landing) && fading_.size() >= shortest_chatter;
        if (chatter) {
            fmt::print("{}{}", line_of(shown_, fading_.front()), chatter_in_words(fading_, time_));
            fading_.clear();
        }
        print_fading();
        fmt::print("{}", contact_in_words(row, time_));
    }
    if (json_ != nullptr) json_contacts_.push_back(std::move(row));
}

void Sinks::add(const SampleRow& row) {
    if (film_ != nullptr) return film_->add(row);
    if (record_samples_) record_samples_->add(row);
    if (json_ != nullptr) json_samples_.push_back(row);
}

void Sinks::finish() {
    print_fading();
    if (json_ == nullptr) return;
    json_->end_array();
    write_json(*json_, "contacts", contact_table(), json_contacts_);
    if (samples_) write_json(*json_, "samples", sample_table(), json_samples_);
}

}  // namespace swirl::apps::simulate
