#include "apps/modes/risk_document.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/output/write_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <variant>

namespace swirl::apps {

namespace {

constexpr const char* group_name = "risk_evidence";
constexpr std::int64_t not_known = -1;  ///< by a record that lacks the column
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
             {"least_runs", &R::least_runs, "1",
              "fewer runs are all followed to the limits; 0: no look is before the transient's end"},
             {"drawn", &R::drawn, "1", "runs of the sample"},
             {"followed", &R::followed, "1", "candidates of the sample, which were followed to the limits"},
             {"judged", &R::judged, "1", "those of them with that exponent or a larger one (or of the first question)"},
             {"changed", &R::changed, "1", "of these, runs with another verdict at the limits"},
             {"bound", &R::bound, "1", "share of such runs among all that are called, at most (95 %)"},
             {"means_followed", &R::means_followed, "1", "runs that are called and whose mean S was followed on"}}};
}

}  // namespace

void add_risk_flags(Flags& command, double& risk, double& error) {
    command
        .add_option("--risk", risk, "P",
                    "call chaos before the limits, where less than a share P of such runs differs there (default 0)")
        ->check(number_below(0, 1));
    command.add_option("--error", error, "E",
                       "with --risk: follow mean S of such a run until its error is E at most, or to the limits");
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

double error_in(const Settings& settings) {
    for (const auto& [name, value] : settings)
        if (name == "error")
            if (const double* error = std::get_if<double>(&value)) return *error;
    return std::numeric_limits<double>::infinity();
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
    // Older records lack these.
    const auto added = [&](const char* name) {
        return record.contains(fmt::format("{}/{}", group, name)) ? counts(name)
                                                                  : std::vector<std::int64_t>(runs.size(), not_known);
    };
    const auto least = added("least_runs"), drawn = added("drawn"), means = added("means_followed");
    for (const std::size_t size : {least.size(), drawn.size(), means.size()})
        if (size != runs.size()) throw BadInput("a record's risk_evidence has columns of several lengths");
    std::vector<RiskEvidence> evidence;
    for (std::size_t i = 0; i < runs.size(); ++i)
        evidence.push_back({runs[i], impacts[i], exponent[i], least[i], drawn[i], followed[i], judged[i], changed[i],
                            bound[i], means[i]});
    return evidence;
}

namespace {

/// Why no chaos was called early.
std::string obstacle_in_words(const RiskEvidence& e) {
    if (e.least_runs == 0) return "the limits leave no room for an early look";
    if (e.runs < e.least_runs)
        return fmt::format("so small a risk wants {} runs or more, here are {}", e.least_runs, e.runs);
    if (e.judged > 0)
        return fmt::format(
            "of the {} surest that are chaotic early {} had another verdict at the limits, so that up to "
            "{:.2g} % might have (95 %)",
            e.judged, e.changed, 100 * e.bound);
    if (e.least_runs < 0) return "too few are chaotic to tell so small a risk";
    // Of many runs a sixteenth is wanted, and a third may be drawn.
    constexpr double least_share = 0.2;
    const double share = static_cast<double>(e.followed) / static_cast<double>(e.drawn);
    return fmt::format("of {} runs drawn {} are candidates, too few to tell so small a risk: {}", e.drawn, e.followed,
                       share > least_share
                           ? fmt::format("{:.0f} runs would do", static_cast<double>(e.least_runs) / share)
                           : "a fifth is wanted");
}

std::string means_in_words(const RiskEvidence& e, double error) {
    if (!std::isfinite(error) || e.means_followed < 0) return "";
    if (e.impacts == 0)
        return fmt::format("; --error {:g} changes nothing: it is of chaos that is called early", error);
    if (e.means_followed == 0)
        return fmt::format("; --error {:g} changes nothing: their means have a smaller error by then", error);
    return fmt::format("; means of {} were followed on, to an error of {:g} or to the limits", e.means_followed, error);
}

}  // namespace

std::string in_words(const RiskEvidence& evidence, double error) {
    const std::string means = means_in_words(evidence, error);
    if (evidence.impacts == 0)
        return fmt::format("no chaos was called early: {}{}", obstacle_in_words(evidence), means);
    return fmt::format(
        "chaos was called after {} impacts where the exponent is {:.2g} or more: of {} such runs {} had another "
        "verdict at the limits; so less than {:.2g} % of all have (95 %){}",
        evidence.impacts, evidence.least_exponent, evidence.judged, evidence.changed, 100 * evidence.bound, means);
}

std::string risk_of_one_in_words(double risk, std::int64_t look, double error) {
    if (risk == 0 || look > 0) return "";
    return fmt::format(
        "chaos is not called early: of one run alone nothing tells a risk of {:g}, of several a sample "
        "does (--runs){}",
        risk, std::isfinite(error) ? fmt::format("; --error {:g} changes nothing", error) : "");
}

}  // namespace swirl::apps
