#include "apps/tradeoff/tradeoff_document.hpp"

#include "apps/command_line/documents.hpp"
#include "apps/modes/escape_document.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/tradeoff/tradeoff_tables.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace swirl::apps::tradeoff {

namespace {

Settings settings_of(const TradeoffOptions& options, const Amounts& amounts) {
    return {{"budget", options.budget},
            {"transient", amounts.transient},
            {"flights", amounts.flights},
            {"orbit", amounts.orbit},
            {"most_collisions", amounts.most_collisions},
            {"starts", amounts.runs},
            {"risk_runs", amounts.risk_runs},
            {"late_contact", late_contact},
            {"may_change", may_change},
            {"mean_may_differ", mean_may_differ},
            {"roundings_at_knee", roundings_at_knee},
            {"chaos_judged_after", chaos_judged_after}};
}

/// What was compared; no times.
Settings flights_of(const Tradeoff& found) {
    return {{"compared", found.compared},
            {"drawn", static_cast<std::int64_t>(found.drawn.flights.size())},
            {"after_transient", found.drawn.after_transient},
            {"steps", found.drawn.steps},
            {"through_contact", found.drawn.through_contact},
            {"outcome", std::string(name_of(found.drawn.outcome))},
            {"impacts", found.drawn.impacts}};
}

std::string_view name_or_nothing(const Arithmetic* arithmetic) {
    return arithmetic != nullptr ? arithmetic->name : "";
}

/// Empty texts and 0 stand for what there is not.
Settings result_of(const Tradeoff& found) {
    return {{"recommended", std::string(name_or_nothing(found.recommended))},
            {"knee", std::string(name_or_nothing(found.knee))},
            {"enough_collisions", found.enough_collisions},
            {"recommended_risk", found.recommended_risk},
            {"reason", found.reason},
            {"advice", found.advice},
            {"cut_short", found.cut_short}};
}

void write_text(JsonWriter& json, std::string_view key, std::string_view text) {
    json.key(key);
    text.empty() ? json.null() : json.value(text);
}

void print_flights(const Tradeoff& found) {
    const DrawnFlights& drawn = found.drawn;
    fmt::print("arithmetic: {}", found.compared == 0 ? "no flights" : fmt::format("{} flights", found.compared));
    if (found.compared > 0)
        fmt::print(", {}", drawn.after_transient
                               ? "of the orbit after its transient"
                               : "of beginnings of orbits too: after its transient this one has too few");
    if (drawn.through_contact > 0)
        fmt::print("; {} of {} steps lead through contact and are left out", drawn.through_contact, drawn.steps);
    fmt::print("\n");
}

void print_advice(const Tradeoff& found) {
    if (found.recommended == nullptr) {
        fmt::print("{}\n", wrapped("recommended: none; " + found.reason, 2));
        return;
    }
    if (found.knee != nullptr)
        fmt::print("knee: {}, the cheapest whose steps are right to {:g} roundings of a double\n", found.knee->name,
                   roundings_at_knee);
    fmt::print("{}\n{}\n", wrapped(fmt::format("recommended: {}; {}", found.recommended->name, found.reason), 2),
               wrapped(found.advice, 2));
}

}  // namespace

void write_document(const TradeoffOptions& options, const Scene<double>& scene, const Amounts& amounts,
                    const Tradeoff& found) {
    print_document([&](JsonWriter& json) {
        write_scene(json, scene, options.scene, &options.start);
        write_json(json, "rungs", arithmetic_table(), found.arithmetics);
        write_json(json, "evidence", evidence_table(), found.evidence.rows);
        json.key("escape");
        write_escape(json, found.evidence.escape);
        write_json(json, "risk", risk_table(), found.risk);
        json.key("recommended_risk");
        found.risk.empty() ? json.null() : json.value(found.recommended_risk);
        write_json(json, "model", model_table(), found.model);
        write_text(json, "recommended", name_or_nothing(found.recommended));
        write_text(json, "knee", name_or_nothing(found.knee));
        json.key("enough_collisions");
        found.enough_collisions > 0 ? json.value(found.enough_collisions) : json.null();
        json.member("reason", found.reason);
        write_text(json, "advice", found.advice);
        json.member("cut_short", found.cut_short);
        write_json(json, "flights", flights_of(found));
        write_json(json, "settings", settings_of(options, amounts));
    });
}

void write_record(const RecordGroup& root, const TradeoffOptions& options, const Scene<double>& scene,
                  const Amounts& amounts, const Tradeoff& found) {
    write_scene(root, scene, &options.start);
    write_attributes(root.group("settings"), settings_of(options, amounts));
    write_attributes(root.group("flights"), flights_of(found));
    write_attributes(root.group("result"), result_of(found));
    apps::write_record(root.group("rungs"), arithmetic_table(), found.arithmetics);
    if (!found.evidence.rows.empty()) apps::write_record(root.group("evidence"), evidence_table(), found.evidence.rows);
    if (found.evidence.escape) write_escape(root.group("escape"), *found.evidence.escape);
    if (!found.risk.empty()) apps::write_record(root.group("risk"), risk_table(), found.risk);
    if (!found.model.empty()) apps::write_record(root.group("model"), model_table(), found.model);
}

void print_tables(const TradeoffOptions& options, const Scene<double>& scene, const Tradeoff& found) {
    const auto units = options.scene.units();
    fmt::print("{}\n{}", scene_in_words(scene), units_in_words(units));
    print_flights(found);
    print_table(errors_table(), found.arithmetics);
    print_table(contacts_table(), found.arithmetics);
    fmt::print("orbits: one in each accuracy, judged by its own map\n");
    print_table(in_units(orbits_table(), units), found.arithmetics);
    if (!found.evidence.rows.empty()) {
        fmt::print("evidence: the verdict on so many impacts after as many, of the first start and of all\n");
        print_table(in_units(evidence_table(), units), found.evidence.rows);
        print_table(starts_table(), found.evidence.rows);
    }
    if (found.evidence.escape)
        fmt::print("{}", all_wrapped("  " + in_words(*found.evidence.escape, chaos_judged_after), 4));
    if (!found.risk.empty()) {
        fmt::print(
            "risk: runs from random starts to the limits of classify, and what --risk would have said of them\n");
        print_table(risk_table(), found.risk);
    }
    if (!found.model.empty()) {
        fmt::print("model: in double, per collision\n");
        print_table(model_table(), found.model);
    }
    if (found.cut_short)
        fmt::print("cut short: this machine is too busy, or too slow, for all of it in {:g} s\n", options.budget);
    print_advice(found);
}

}  // namespace swirl::apps::tradeoff
