#include "apps/simulate/samples.hpp"

namespace swirl::apps::simulate {

namespace {

struct SampleField {
    const char* name;
    double SampleRow::*member;
    const char* units;
    const char* long_name;
};

constexpr SampleField sample_fields[] = {
    {"t", &SampleRow::t, "1/omega_s", "time"},
    {"x", &SampleRow::x, "R_c", "place of the body's centre, laboratory"},
    {"y", &SampleRow::y, "R_c", "place of the body's centre, laboratory"},
    {"angle", &SampleRow::angle, "rad", "direction of vertex 0, unwound"},
    {"spin", &SampleRow::spin, "omega_s", "S"},
};

}  // namespace

void JsonSamples::finish() {
    json_.key("samples");
    json_.begin_array(JsonLayout::rows);
    for (const SampleRow& row : rows_) {
        json_.begin_object();
        for (const auto& field : sample_fields) json_.member(field.name, row.*field.member);
        json_.member("in_contact", row.in_contact);
        json_.end_object();
    }
    json_.end_array();
}

RecordSamples::RecordSamples(RecordGroup group) {
    group.dimension("sample", growing);
    for (const auto& field : sample_fields)
        numbers_.push_back(group.column<double>(field.name, {"sample"}, {field.units, field.long_name, {}}));
    in_contact_.push_back(group.column<bool>("in_contact", {"sample"}, {"", "on the wall, not in flight", {}}));
}

void RecordSamples::add(const SampleRow& row) {
    for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i].append(row.*sample_fields[i].member);
    in_contact_.front().append(row.in_contact);
}

}  // namespace swirl::apps::simulate
