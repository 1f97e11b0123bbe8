#include "apps/modes/risk_document.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/output/write_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace swirl::apps {

namespace {

constexpr const char* group_name = "risk_evidence";
constexpr const char* assumed =
    "the sample is a random one of all runs, drawn without replacement by the seed; nothing is assumed of how orbits "
    "leave "
    "chaos";

Table<RiskEvidence> risk_table() {
    using R = RiskEvidence;
    return {{"call"},
            {{"runs", &R::runs, "1", "runs for which it holds"},
             {"impacts", &R::impacts, "1", "after which chaos is called; 0: at the limits alone"},
             {"least_exponent", &R::least_exponent, "1",
              "mean exponent per impact over a cell's runs from which it is called; NaN: none"},
             {"followed", &R::followed, "1", "candidates of the sample, which were followed to the limits"},
             {"judged", &R::judged, "1", "those of them with that exponent or a larger one (or of the first question)"},
             {"changed", &R::changed, "1", "of these, runs with another verdict at the limits"},
             {"bound", &R::bound, "1", "share of such runs among all that are called, at most (95 %)"}}};
}

}  // namespace

void add_risk_flags(Flags& command, double& risk, double& error) {
    command
        .add_option("--risk", risk,
                    "call chaos before the limits, where less than a share P of such runs differs there (default 0)")
        ->type_name("P")
        ->check(number_below(0, 1));
    command
        .add_option("--error", error,
                    "with --risk: follow mean S of such a run until its error is E at most, or to the limits")
        ->type_name("E");
}

void check_risk(double risk, double error, bool exhaustive) {
    if (!(error > 0)) throw BadInput(fmt::format("error = {:g} is outside its range: above 0", error));
    if (std::isfinite(error) && risk == 0)
        throw BadInput(
            fmt::format("error = {:g} is of means over chaos that is called early: give --risk P, too; at the limits "
                        "mean_S_error says what the error is",
                        error));
    if (risk > 0 && exhaustive)
        throw BadInput(fmt::format("risk = {:g} and exhaustive are both given: one leaves impacts out", risk));
}

void add_risk_settings(Settings& settings, double risk, double error) {
    if (risk > 0) settings.emplace_back("risk", risk);
    if (std::isfinite(error)) settings.emplace_back("error", error);
}

void write_risk(JsonWriter& json, const std::vector<RiskEvidence>& evidence) {
    if (!evidence.empty()) write_json(json, group_name, risk_table(), evidence);
}

void write_risk(const RecordGroup& root, const std::vector<RiskEvidence>& evidence) {
    if (evidence.empty()) return;
    const RecordGroup group = root.group(group_name);
    group.attribute("assumed", std::string(assumed));
    write_record(group, risk_table(), evidence);
}

std::vector<RiskEvidence> read_risk(const RecordReader& record) {
    const std::string group = fmt::format("/{}", group_name);
    if (!record.contains(group)) return {};
    const auto counts = [&](const char* name) { return record.read<std::int64_t>(fmt::format("{}/{}", group, name)); };
    const auto numbers = [&](const char* name) { return record.read<double>(fmt::format("{}/{}", group, name)); };
    const auto runs = counts("runs"), impacts = counts("impacts"), followed = counts("followed"),
               judged = counts("judged"), changed = counts("changed");
    const auto exponent = numbers("least_exponent"), bound = numbers("bound");
    for (const std::size_t size :
         {impacts.size(), followed.size(), judged.size(), changed.size(), exponent.size(), bound.size()})
        if (size != runs.size()) throw BadInput("a record's risk_evidence has columns of several lengths");
    std::vector<RiskEvidence> evidence;
    for (std::size_t i = 0; i < runs.size(); ++i)
        evidence.push_back({runs[i], impacts[i], exponent[i], followed[i], judged[i], changed[i], bound[i]});
    return evidence;
}

std::string in_words(const RiskEvidence& evidence) {
    if (evidence.impacts > 0)
        return fmt::format(
            "chaos was called after {} impacts where the exponent is {:.2g} or more: of {} such runs {} had another "
            "verdict at the limits; so less than {:.2g} % of all have (95 %)",
            evidence.impacts, evidence.least_exponent, evidence.judged, evidence.changed, 100 * evidence.bound);
    if (evidence.judged == 0)
        return fmt::format("all {} runs were followed to the limits: too few are chaotic to tell so small a risk",
                           evidence.runs);
    return fmt::format(
        "all {} runs were followed to the limits: of the {} surest that are chaotic early {} had another verdict "
        "there, "
        "so that up to {:.2g} % might have (95 %)",
        evidence.runs, evidence.judged, evidence.changed, 100 * evidence.bound);
}

}  // namespace swirl::apps
