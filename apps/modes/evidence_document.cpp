#include "apps/modes/evidence_document.hpp"

#include <fmt/format.h>

namespace swirl::apps {

void write_evidence(JsonWriter& json, const std::vector<analysis::Evidence>& evidence) {
    json.key("evidence");
    json.begin_array(JsonLayout::rows);
    for (const auto& e : evidence) {
        json.begin_object();
        json.member("name", std::string_view(e.name));
        json.member("value", e.value);
        json.member("threshold", e.threshold);
        json.member("says", std::string_view(e.says));
        json.member("changes_if", std::string_view(e.changes_if));
        json.end_object();
    }
    json.end_array();
}

void write_evidence(const RecordGroup& group, const std::vector<analysis::Evidence>& evidence) {
    if (evidence.empty()) return;
    group.dimension("evidence", evidence.size());
    std::vector<std::string> names, says, changes;
    std::vector<double> values, thresholds;
    for (const auto& e : evidence) {
        names.push_back(e.name);
        says.push_back(e.says);
        changes.push_back(e.changes_if);
        values.push_back(e.value);
        thresholds.push_back(e.threshold);
    }
    group.write_strings("evidence", {"evidence"}, names);
    group.write<double>("value", {"evidence"}, values);
    group.write<double>("threshold", {"evidence"}, thresholds);
    group.write_strings("says", {"evidence"}, says);
    group.write_strings("changes_if", {"evidence"}, changes);
}

std::string table_of(const std::vector<analysis::Evidence>& evidence) {
    std::string text;
    for (const auto& e : evidence)
        text += fmt::format("  evidence: {:<40} {:>12.4g}  against {:>10.4g}  {}\n            changes if: {}\n", e.name,
                            e.value, e.threshold, e.says, e.changes_if);
    return text;
}

}  // namespace swirl::apps
