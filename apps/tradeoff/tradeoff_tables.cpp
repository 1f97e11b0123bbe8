#include "apps/tradeoff/tradeoff_tables.hpp"

#include "apps/modes/mode_fields.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps::tradeoff {

namespace {

using analysis::Kind;

/// "231 ns", "62.1 us": three digits.
std::string in_seconds(const Value& value) {
    const double seconds = std::get<double>(value);
    if (std::isnan(seconds)) return "-";
    for (const auto& [unit, name] : {std::pair(1e-6, "ns"), std::pair(1e-3, "us"), std::pair(1.0, "ms")})
        if (std::abs(seconds) < unit) return fmt::format("{:.3g} {}", seconds / (unit * 1e-3), name);
    return fmt::format("{:.3g} s", seconds);
}

ColumnFormat seconds_format(const char* heading) {
    return {heading, [heading](const Value& value) { return fmt::format(fmt::runtime(heading), in_seconds(value)); }};
}

/// "2 of 10000 (1e-05 to 9e-04)"; "0 of 10000 (below 3e-04)".
std::string rate_in_words(std::int64_t k, std::int64_t n, const analysis::RateInterval& rate) {
    if (n == 0) return "-";
    if (k == 0) return fmt::format("0 of {} (below {:.1e})", n, rate.most);
    return fmt::format("{} of {} ({:.1e} to {:.1e})", k, n, rate.least, rate.most);
}

/// NaN where the arithmetic has no flights to compare.
template <class Read>
auto of_flights(Read read) {
    return [read](const ArithmeticRow& row) {
        return row.flights && row.flights->flights > 0 ? static_cast<double>(read(*row.flights)) : std::nan("");
    };
}

template <class Read>
auto of_orbit(Read read) {
    return [read](const ArithmeticRow& row) { return row.orbit ? read(*row.orbit) : std::nan(""); };
}

std::string verdict_in_words(const ArithmeticRow& row) {
    if (!row.orbit) return "-";
    if (row.orbit->outcome != Outcome::completed) return std::string(name_of(row.orbit->outcome));
    const std::string period = row.orbit->period > 0 ? fmt::format(" {}", row.orbit->period) : "";
    const Kind kind = row.orbit->kind;
    return std::string(kind == Kind::none ? name_of(row.orbit->mode) : name_of(kind)) + period;
}

using ArithmeticField = Field<ArithmeticRow>;

/// Errors after one flight and ten.
void add_errors(std::vector<ArithmeticField>& fields) {
    using C = FlightComparison;
    const auto one = [](auto member) { return of_flights([member](const C& c) { return c.one.*member; }); };
    const auto ten_of = [](auto member) { return of_flights([member](const C& c) { return c.ten.*member; }); };
    using E = ErrorSpread;
    fields.insert(
        fields.end(),
        {ArithmeticField{"error", one(&E::median), "1", "of one step, median, against the last accuracy"}.shown(
             "error", " {:>7.2g}"),
         ArithmeticField{"error_99", one(&E::most_of), "1", "of one step, 99 % are below"}.shown("99 %", " {:>7.2g}"),
         ArithmeticField{"error_largest", one(&E::largest), "1", "of one step, largest"}.shown("largest", " {:>7.2g}"),
         ArithmeticField{"error_of_ten", ten_of(&E::median), "1", "of ten steps, median"}.shown("of ten", " {:>7.2g}"),
         ArithmeticField{"error_of_ten_99", ten_of(&E::most_of), "1", "of ten steps, 99 % are below"},
         ArithmeticField{"error_of_ten_largest", ten_of(&E::largest), "1", "of ten steps, largest"}.shown("largest",
                                                                                                          " {:>7.2g}"),
         ArithmeticField{"error_in_condition", of_flights([](const C& c) { return c.largest_in_condition; }), "1",
                         "largest error of one step over epsilon and the step's condition"}
             .shown("/(eps c)", " {:>8.2g}")});
}

/// How often something happened, of all flights, with its interval.
void add_rate(std::vector<ArithmeticField>& fields, const std::string& name, std::int64_t FlightComparison::*times,
              analysis::RateInterval FlightComparison::*rate, const char* heading) {
    const auto part = [rate](auto member) {
        return of_flights([rate, member](const FlightComparison& c) { return (c.*rate).*member; });
    };
    using R = analysis::RateInterval;
    fields.push_back(ArithmeticField{name + "_rate", part(&R::rate), "1", "of all flights"});
    fields.push_back(ArithmeticField{name + "_rate_least", part(&R::least), "1", "at 95 %"});
    fields.push_back(ArithmeticField{name + "_rate_most", part(&R::most), "1", "at 95 %"});
    fields.push_back(ArithmeticField{name,
                                     [times, rate](const ArithmeticRow& row) {
                                         if (!row.flights) return std::string("-");
                                         return rate_in_words((*row.flights).*times, row.flights->flights,
                                                              (*row.flights).*rate);
                                     },
                                     no_column}
                         .table_only()
                         .shown(heading, "  {:<34}"));
}

void add_missed(std::vector<ArithmeticField>& fields) {
    using C = FlightComparison;
    fields.insert(fields.end(),
                  {ArithmeticField{"flights", of_flights([](const C& c) { return c.flights; }), "1", "compared"},
                   ArithmeticField{"missed_contacts", of_flights([](const C& c) { return c.missed; }), "1",
                                   "flights on which it missed the first contact: it found none, or a later one"}});
    add_rate(fields, "missed", &C::missed, &C::missed_rate, "missed contacts (95 %)");
    fields.push_back(ArithmeticField{"misordered_contacts", of_flights([](const C& c) { return c.misordered; }), "1",
                                     "flights on which it found another vertex, or an earlier contact"});
    add_rate(fields, "misordered", &C::misordered, &C::misordered_rate, "out of order (95 %)");
}

void add_orbits(std::vector<ArithmeticField>& fields) {
    using O = ArithmeticOrbit;
    const auto count = [](auto member) {
        return of_orbit([member](const O& o) { return static_cast<double>(o.*member); });
    };
    const auto number = [](auto member) { return of_orbit([member](const O& o) { return o.*member; }); };
    const auto name = [](auto member) {
        return
            [member](const ArithmeticRow& row) { return std::string(row.orbit ? name_of((*row.orbit).*member) : ""); };
    };
    const auto or_null = [](auto member) {
        return [member](const ArithmeticRow& row) -> std::optional<std::string> {
            if (!row.orbit || name_of((*row.orbit).*member) == name_of(Kind::none)) return std::nullopt;
            return std::string(name_of((*row.orbit).*member));
        };
    };
    fields.insert(
        fields.end(),
        {ArithmeticField{"mode", name(&O::mode), "", "mode of the orbit in this accuracy"}.json_as(or_null(&O::mode)),
         ArithmeticField{"kind", name(&O::kind), "", "its kind"}.json_as(or_null(&O::kind)),
         ArithmeticField{"period", count(&O::period), "1", "period, 0: none"}.json_as(
             [](const ArithmeticRow& row) -> std::optional<std::int64_t> {
                 if (!row.orbit || row.orbit->period == 0) return std::nullopt;
                 return row.orbit->period;
             }),
         ArithmeticField{"outcome", name(&O::outcome), "", "how that orbit ended"}.json_as(or_null(&O::outcome)),
         ArithmeticField{"impacts", count(&O::impacts), "1", "of the orbit in this accuracy"},
         ArithmeticField{"verdict", &verdict_in_words, no_column}.table_only().shown("verdict", " {:<13}"),
         ArithmeticField{"verdict_differs",
                         [](const ArithmeticRow& row) {
                             return row.verdict_differs ? (*row.verdict_differs ? 1.0 : 0.0) : std::nan("");
                         },
                         "1", "mode, period or outcome is not that of the last accuracy"}
             .json_as([](const ArithmeticRow& row) { return row.verdict_differs; }),
         ArithmeticField{"mean_S", number(&O::mean_spin), "1", "time mean of S"},
         ArithmeticField{"mean_S_error", number(&O::mean_spin_error), "1", "its sampling error"}.shown("S sampled to",
                                                                                                       " {:>12.1g}"),
         ArithmeticField{"mean_S_off", &ArithmeticRow::mean_spin_off, "1", "mean S less that of the last accuracy"}
             .shown("off by", " {:>8.1g}"),
         ArithmeticField{"largest_exponent", number(&O::largest_exponent), "1", "per impact"},
         ArithmeticField{"largest_exponent_error", number(&O::largest_exponent_error), "1", "its standard error"},
         ArithmeticField{"exponent_off", &ArithmeticRow::exponent_off, "1",
                         "largest exponent less that of the last accuracy"}
             .shown("exponent off", " {:>12.1g}"),
         ArithmeticField{"jacobi_drift", number(&O::jacobi_drift), "m R_c^2 omega_s^2",
                         "|sum of J after - before - what impacts and contact say| per impact"}
             .shown("J drift", " {:>8.1g}")});
}

/// "551 to 580 ns"
std::string quartiles_in_words(const Timing& time) {
    if (time.batches == 0) return "-";
    return fmt::format("{} to {}", in_seconds(time.lower), in_seconds(time.upper));
}

/// A time with its quartiles.
template <class Row>
void add_time(std::vector<Field<Row>>& fields, const std::string& name, const char* heading, const std::string& of,
              Timing Row::*member) {
    const auto read = [member](auto part) { return [member, part](const Row& row) { return (row.*member).*part; }; };
    fields.push_back(
        Field<Row>{name, read(&Timing::median), "s", of + ", median"}.shown(heading, seconds_format(" {:>9}")));
    fields.push_back(Field<Row>{name + "_lower", read(&Timing::lower), "s", of + ", lower quartile"});
    fields.push_back(Field<Row>{name + "_upper", read(&Timing::upper), "s", of + ", upper quartile"});
}

ArithmeticField name_field() {
    return ArithmeticField{"name", [](const ArithmeticRow& row) { return row.arithmetic->name; }, "",
                           "a name of --accuracy"}
        .shown("accuracy", "  {:<11}");
}

}  // namespace

Table<ArithmeticRow> errors_table() {
    std::vector<ArithmeticField> fields = {name_field()};
    fields.push_back(
        ArithmeticField{"what", [](const ArithmeticRow& row) { return row.arithmetic->what; }, "", "what it is"});
    add_time(fields, "seconds_per_collision", "time", "of a collision", &ArithmeticRow::time);
    fields.push_back(
        ArithmeticField{"quartiles", [](const ArithmeticRow& row) { return quartiles_in_words(row.time); }, no_column}
            .table_only()
            .shown("quartiles", "  {:<18}"));
    add_errors(fields);
    return {{"rung"}, std::move(fields)};
}

Table<ArithmeticRow> contacts_table() {
    std::vector<ArithmeticField> fields = {name_field()};
    add_missed(fields);
    return {{"rung"}, std::move(fields)};
}

Table<ArithmeticRow> orbits_table() {
    std::vector<ArithmeticField> fields = {name_field()};
    add_orbits(fields);
    return {{"rung"}, std::move(fields)};
}

Table<ArithmeticRow> arithmetic_table() {
    Table<ArithmeticRow> table = errors_table();
    for (const auto& more : {contacts_table(), orbits_table()})  // all begin with the name
        table.fields.insert(table.fields.end(), more.fields.begin() + 1, more.fields.end());
    return table;
}

Table<EvidenceRow> starts_table() {
    using F = Field<EvidenceRow>;
    return {{"rung"},
            {F{"collisions", &EvidenceRow::collisions, no_column}.shown("impacts", "  {:>9}"),
             F{"mean_S_off", &EvidenceRow::mean_spin_off, no_column}.shown("mean S off by", " {:>13.1g}"),
             F{"mean_S_differs", &EvidenceRow::mean_spin_differs, no_column}.shown("off, all starts", " {:>15.1g}"),
             F{"changed_in_words",
               [](const EvidenceRow& row) { return rate_in_words(row.changed, row.runs, row.changed_rate); }, no_column}
                 .shown("starts with another mode (95 %)", "  {}")}};
}

Table<EvidenceRow> evidence_table() {
    using F = Field<EvidenceRow>;
    const auto of = [](auto member) { return [member](const EvidenceRow& row) { return row.verdict.*member; }; };
    return {
        {"rung"},
        {F{"collisions", &EvidenceRow::collisions, "1", "impacts, after as many that are left out"}.shown("impacts",
                                                                                                          " {:>9}"),
         F{"mode", of(&RunVerdict::mode), "", "mode by so many impacts"}.shown("mode", "  {:<12}"),
         kind_field<EvidenceRow>(of(&RunVerdict::kind)).shown("kind", " {:<15}"),
         period_field<EvidenceRow>(of(&RunVerdict::period)).shown("period", dash_for_zero(" {:>6}")),
         F{"outcome", of(&RunVerdict::outcome), "", "how the orbit ended"},
         F{"mean_S", of(&RunVerdict::mean_spin), "1", "time mean of S"}.shown("mean S", " {:>12.6g}"),
         F{"mean_S_error", &EvidenceRow::mean_spin_error, "1", "its standard error, 0 where exact"}.shown("sampled to",
                                                                                                          " {:>10.1g}"),
         F{"mean_S_off", &EvidenceRow::mean_spin_off, "1", "mean S less that of the most impacts"},
         F{"mean_S_differs", &EvidenceRow::mean_spin_differs, "1", "the same, root mean square over the starts"},
         F{"largest_exponent", of(&RunVerdict::largest_exponent), "1", "per impact"}.shown("exponent", " {:>10.4g}"),
         F{"largest_exponent_error", of(&RunVerdict::largest_exponent_error), "1", "its standard error"}.shown(
             "error", " {:>8.1g}"),
         F{"exponent_off", &EvidenceRow::exponent_off, "1", "largest exponent less that of the most impacts"},
         F{"runs", &EvidenceRow::runs, "1", "starts"},
         F{"changed", &EvidenceRow::changed, "1", "of these: another mode on the most impacts"},
         F{"changed_rate_least", [](const EvidenceRow& row) { return row.changed_rate.least; }, "1", "at 95 %"},
         F{"changed_rate_most", [](const EvidenceRow& row) { return row.changed_rate.most; }, "1", "at 95 %"},
         F{"seconds", &EvidenceRow::seconds, "s", "that the first start's verdict took"}.shown(
             "time", seconds_format(" {:>8}"))}};
}

Table<RiskRow> risk_table() {
    using F = Field<RiskRow>;
    return {{"risk_level"},
            {F{"risk", &RiskRow::risk, "1", "--risk; 0: all to the limits"}.shown("risk", "  {:>6.3g}"),
             F{"runs", &RiskRow::runs, "1", "random starts"}.shown("runs", " {:>7}"),
             F{"impacts", &RiskRow::impacts, "1", "of all runs together"}.shown("impacts", " {:>12}"),
             F{"seconds", &RiskRow::seconds, "s", "of one core for these"}.shown("time", seconds_format(" {:>9}")),
             F{"runs_called", &RiskRow::runs_called, "1", "of the runs: called chaotic before the limits"}.shown(
                 "called early", " {:>13}"),
             F{"changed", &RiskRow::changed, "1", "of these: another verdict at the limits"}.shown("of these otherwise",
                                                                                                   " {:>19}"),
             F{"share_that_differs", &RiskRow::share_that_differs, "1", "the same, of all runs"}.shown("of all",
                                                                                                       " {:>8.2g}"),
             F{"bound", &RiskRow::bound, "1", "share of such runs among all that are called, at most (95 %)"}.shown(
                 "below", " {:>8.2g}")}};
}

Table<ModelRow> model_table() {
    std::vector<Field<ModelRow>> fields;
    fields.push_back(Field<ModelRow>{"name", &ModelRow::name, "", "piece of the model"}.shown("piece", "  {:<24}"));
    add_time(fields, "seconds_per_collision", "with", "of a collision with it", &ModelRow::with);
    add_time(fields, "seconds_without", "without", "of a collision without it", &ModelRow::without);
    fields.push_back(Field<ModelRow>{"seconds_added", &ModelRow::added, "s", "difference of the medians"}.shown(
        "adds", seconds_format(" {:>10}")));
    fields.push_back(
        Field<ModelRow>{"paid_by", &ModelRow::paid_by, "", "which commands pay for it on this scene"}.shown("paid by",
                                                                                                            "  {}"));
    return {{"rung"}, std::move(fields)};
}

}  // namespace swirl::apps::tradeoff
