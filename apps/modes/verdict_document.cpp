#include "apps/modes/verdict_document.hpp"

#include "apps/branches/section_point.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/modes/risk_document.hpp"
#include "apps/modes/verdict_in_words.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace swirl::apps {

namespace {

Settings settings_of(const NamedMode& named, const analysis::ClassifyOptions& s, double risk, double error) {
    Settings settings{{"transient", s.transient},
                      {"collisions", s.collisions},
                      {"exhaustive", s.exhaustive},
                      {"threshold", s.recurrence_threshold},
                      {"sigmas", s.sigmas},
                      {"max_period", s.period.max_period},
                      {"closure", s.period.closure},
                      {"vicinity", s.period.vicinity},
                      {"residual", s.period.residual},
                      {"neutral", analysis::neutral_margin},
                      {"accuracy", std::string(name_of(named.accuracy))}};
    add_risk_settings(settings, risk, error);
    return settings;
}

Table<NamedMode> verdict_table() {
    using Verdict = analysis::Classification;
    const auto of = [](auto member) { return [member](const NamedMode& named) { return named.verdict.*member; }; };
    const auto errors = mean_error_fields<NamedMode>(&NamedMode::mean_errors);
    Table<NamedMode> table{
        {},
        {{"mode", of(&Verdict::mode), no_column},
         kind_field<NamedMode>(of(&Verdict::kind)),
         period_field<NamedMode>(of(&Verdict::period)),
         {"mean_S", of(&Verdict::mean), "1", "time mean of S"},
         {"mean_S_per_impact", of(&Verdict::mean_per_step), "1", "mean of S over impacts"},
         errors.per_time,
         errors.per_impact,
         errors.bound,
         errors.kind,
         {"recurrence_rate", of(&Verdict::recurrence_rate), no_column},
         {"recurrence_rate_without_diagonal", of(&Verdict::recurrence_rate_without_diagonal), no_column},
         {"largest_exponent", of(&Verdict::largest_exponent), no_column},
         {"largest_exponent_error", of(&Verdict::largest_exponent_error), no_column},
         {"rotation_number", of(&Verdict::rotation), no_column},
         {"outcome", &NamedMode::outcome, no_column},
         {"impacts", &NamedMode::impacts, no_column},
         {"point", of(&Verdict::point), no_column},
         {"section_point",
          [](JsonWriter& json, const NamedMode& named) { write_point_or_null(json, named.verdict.point); }},
         {"multipliers", [](JsonWriter& json, const NamedMode& named) { json.array(named.verdict.multipliers); }}},
        {"mode", "kind", "period", "outcome", "impacts"}};
    const auto outcome = std::find_if(table.fields.begin(), table.fields.end(),
                                      [](const Field<NamedMode>& field) { return field.name == "outcome"; });
    const auto driven = driven_fields<NamedMode>(&NamedMode::growth, &NamedMode::limit_spin);
    table.fields.insert(outcome, driven.begin(), driven.end());
    return table;
}

Table<analysis::Evidence> evidence_table() {
    using analysis::Evidence;
    return {{"evidence"},
            {Field<Evidence>{"name", &Evidence::name, "", "what was measured"}.coordinate(),
             {"value", &Evidence::value, "1", "its value, where R_c = omega_s = m = 1"},
             {"threshold", &Evidence::threshold, "1", "what the value is compared with; NaN: nothing"},
             {"says", &Evidence::says, "", "what the value says of the mode"},
             {"changes_if", &Evidence::changes_if, "", "when it would say something else"}}};
}

}  // namespace

void write_verdict(JsonWriter& json, const NamedMode& named, const analysis::ClassifyOptions& settings, double risk,
                   double error) {
    write_members(json, verdict_table(), named);
    write_evidence(json, named.verdict.evidence);
    write_json(json, "settings", settings_of(named, settings, risk, error));
}

void write_verdict(const RecordGroup& group, const NamedMode& named, const analysis::ClassifyOptions& settings,
                   double risk, double error) {
    write_attributes(group, verdict_table(), named);
    write_attributes(group.group("settings"), settings_of(named, settings, risk, error));
    write_evidence(group, named.verdict.evidence);
}

std::string table_of(const NamedMode& named, bool verbose, const std::optional<Units>& units) {
    const analysis::Classification& verdict = named.verdict;
    const std::string mean =
        std::isfinite(verdict.mean) ? fmt::format("; mean S {}", mean_in_words(verdict.mean, named.mean_errors)) : "";
    const std::string text = wrapped(fmt::format("  {}{}; outcome {} after {} impact{}", mode_in_words(verdict), mean,
                                                 name_of(named.outcome), named.impacts, named.impacts == 1 ? "" : "s"),
                                     4) +
                             "\n" + verdict_in_lines(verdict, units);
    return verbose ? text + lines_of(in_units(verdict_table(), units), named) + table_of(verdict.evidence) : text;
}

void write_evidence(JsonWriter& json, const std::vector<analysis::Evidence>& evidence) {
    write_json(json, "evidence", evidence_table(), evidence);
}

void write_evidence(const RecordGroup& group, const std::vector<analysis::Evidence>& evidence) {
    if (!evidence.empty()) write_record(group, evidence_table(), evidence);
}

}  // namespace swirl::apps
