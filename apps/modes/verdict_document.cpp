#include "apps/modes/verdict_document.hpp"

#include "apps/modes/evidence_document.hpp"
#include "apps/modes/kind_document.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>

namespace swirl::apps {

namespace {

Settings settings_of(const analysis::ClassifyOptions& s) {
    return {{"transient", s.transient},
            {"collisions", s.collisions},
            {"threshold", s.recurrence_threshold},
            {"sigmas", s.sigmas},
            {"max_period", s.period.max_period},
            {"closure", s.period.closure},
            {"vicinity", s.period.vicinity},
            {"residual", s.period.residual},
            {"neutral", analysis::neutral_margin}};
}

struct NamedNumber {
    const char* name;
    double value;
};

std::vector<NamedNumber> numbers_of(const analysis::Classification& v) {
    return {{"mean_S", v.mean},
            {"mean_S_per_impact", v.mean_per_step},
            {"recurrence_rate", v.recurrence_rate},
            {"recurrence_rate_without_diagonal", v.recurrence_rate_without_diagonal},
            {"largest_exponent", v.largest_exponent},
            {"largest_exponent_error", v.largest_exponent_error},
            {"rotation_number", v.rotation}};
}

}  // namespace

void write_verdict(JsonWriter& json, const NamedMode& named, const analysis::ClassifyOptions& settings) {
    const auto& v = named.verdict;
    json.member("mode", name_of(v.mode));
    write_kind(json, v.kind);
    write_period(json, v.period);
    for (const auto& number : numbers_of(v)) json.member(number.name, number.value);
    json.member("outcome", name_of(named.outcome));
    json.member("impacts", named.impacts);
    json.key("point");
    json.begin_array();
    for (const double c : v.point) json.value(c);
    json.end_array();
    json.key("multipliers");
    json.begin_array();
    for (const auto& m : v.multipliers) {
        json.begin_array();
        json.value(m.real());
        json.value(m.imag());
        json.end_array();
    }
    json.end_array();
    write_evidence(json, v.evidence);
    write_json(json, "settings", settings_of(settings));
}

void write_verdict(const RecordGroup& group, const NamedMode& named, const analysis::ClassifyOptions& settings) {
    const auto& v = named.verdict;
    group.attribute("mode", std::string(name_of(v.mode)));
    group.attribute("kind", std::string(name_of(v.kind)));
    group.attribute("period", v.period);
    group.attribute("outcome", std::string(name_of(named.outcome)));
    group.attribute("impacts", std::int64_t{named.impacts});
    for (const auto& number : numbers_of(v)) group.attribute(number.name, number.value);
    if (!v.point.empty()) group.attribute("point", v.point);
    write_attributes(group.group("settings"), settings_of(settings));
    write_evidence(group, v.evidence);
}

std::string table_of(const NamedMode& named) {
    const auto& v = named.verdict;
    std::string text;
    const auto add = [&](const std::string& line) { text += line + "\n"; };
    add(fmt::format("  mode {}{}{}; outcome {} after {} impacts", name_of(v.mode),
                    v.kind == analysis::Kind::none ? "" : fmt::format(" ({})", name_of(v.kind)),
                    v.period > 0 ? fmt::format(", period {}", v.period) : "", name_of(named.outcome), named.impacts));
    for (const auto& number : numbers_of(v))
        if (std::isfinite(number.value)) add(fmt::format("  {:<33} {:>16.8g}", number.name, number.value));
    return text + table_of(v.evidence);
}

}  // namespace swirl::apps
