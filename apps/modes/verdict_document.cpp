#include "apps/modes/verdict_document.hpp"

#include "apps/modes/mode_fields.hpp"
#include "apps/output/write_table.hpp"

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

Table<NamedMode> verdict_table() {
    using Verdict = analysis::Classification;
    const auto of = [](auto member) { return [member](const NamedMode& named) { return named.verdict.*member; }; };
    return {{},
            {{"mode", of(&Verdict::mode)},
             kind_field<NamedMode>(of(&Verdict::kind)),
             period_field<NamedMode>(of(&Verdict::period)),
             {"mean_S", of(&Verdict::mean)},
             {"mean_S_per_impact", of(&Verdict::mean_per_step)},
             {"recurrence_rate", of(&Verdict::recurrence_rate)},
             {"recurrence_rate_without_diagonal", of(&Verdict::recurrence_rate_without_diagonal)},
             {"largest_exponent", of(&Verdict::largest_exponent)},
             {"largest_exponent_error", of(&Verdict::largest_exponent_error)},
             {"rotation_number", of(&Verdict::rotation)},
             {"outcome", &NamedMode::outcome},
             {"impacts", &NamedMode::impacts},
             {"point", of(&Verdict::point)},
             {"multipliers", [](JsonWriter& json, const NamedMode& named) { json.array(named.verdict.multipliers); }}},
            {"mode", "kind", "period", "outcome", "impacts"}};
}

Table<analysis::Evidence> evidence_table() {
    using analysis::Evidence;
    return {{"evidence"},
            {Field<Evidence>{"name", &Evidence::name}.coordinate(),
             {"value", &Evidence::value},
             {"threshold", &Evidence::threshold},
             {"says", &Evidence::says},
             {"changes_if", &Evidence::changes_if}}};
}

}  // namespace

void write_verdict(JsonWriter& json, const NamedMode& named, const analysis::ClassifyOptions& settings) {
    write_members(json, verdict_table(), named);
    write_evidence(json, named.verdict.evidence);
    write_json(json, "settings", settings_of(settings));
}

void write_verdict(const RecordGroup& group, const NamedMode& named, const analysis::ClassifyOptions& settings) {
    write_attributes(group, verdict_table(), named);
    write_attributes(group.group("settings"), settings_of(settings));
    write_evidence(group, named.verdict.evidence);
}

std::string table_of(const NamedMode& named) {
    return fmt::format("  {}; outcome {} after {} impacts\n{}{}", mode_in_words(named.verdict), name_of(named.outcome),
                       named.impacts, lines_of(verdict_table(), named), table_of(named.verdict.evidence));
}

void write_evidence(JsonWriter& json, const std::vector<analysis::Evidence>& evidence) {
    write_json(json, "evidence", evidence_table(), evidence);
}

void write_evidence(const RecordGroup& group, const std::vector<analysis::Evidence>& evidence) {
    if (!evidence.empty()) write_record(group, evidence_table(), evidence);
}

std::string table_of(const std::vector<analysis::Evidence>& evidence) {
    std::string text;
    for (const auto& e : evidence)
        text += fmt::format("  evidence: {:<40} {:>12.4g}  against {:>10.4g}  {}\n            changes if: {}\n", e.name,
                            e.value, e.threshold, e.says, e.changes_if);
    return text;
}

std::string mode_in_words(const analysis::Classification& verdict) {
    return fmt::format("mode {}{}{}", name_of(verdict.mode),
                       verdict.kind == analysis::Kind::none ? "" : fmt::format(" ({})", name_of(verdict.kind)),
                       verdict.period > 0 ? fmt::format(", period {}", verdict.period) : "");
}

}  // namespace swirl::apps
