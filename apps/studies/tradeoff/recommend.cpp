#include "apps/studies/tradeoff/tradeoff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::studies::tradeoff {

namespace {

/// Why an arithmetic that was measured is not to be used; empty: it is.
std::string objection_to(const ArithmeticRow& row) {
    if (row.flights && row.flights->missed + row.flights->misordered > 0)
        return fmt::format("missed {} and misordered {} of {} contacts", row.flights->missed, row.flights->misordered,
                           row.flights->flights);
    if (row.verdict_differs.value_or(false)) return "its verdict differs";
    return "";
}

/// Are so many impacts enough? At 95 % less than `may_change` of the starts have another mode on the most, and their
/// mean S differs by less than `mean_may_differ`.
bool is_enough(const EvidenceRow& row) {
    return row.changed_rate.most < may_change && !(row.mean_spin_differs >= mean_may_differ);
}

/// The fewest impacts that are enough, as all larger numbers are; 0: there are none below the most. Modes need not
/// settle one after another: what a number shows, a larger one may not.
std::int64_t enough(const std::vector<EvidenceRow>& rows) {
    std::int64_t least = 0;
    for (std::size_t k = rows.empty() ? 0 : rows.size() - 1; k-- > 0 && is_enough(rows[k]);) least = rows[k].collisions;
    return least;
}

/// To two digits: "0.31", "3.1", "31", "100".
std::string in_percent(double share) {
    return 100 * share < 10 ? fmt::format("{:.2g}", 100 * share) : fmt::format("{:.0f}", 100 * share);
}

/// "2 of 64 starts have another mode, 11 % at most at 95 %"
std::string changed_in_words(const EvidenceRow& row) {
    return fmt::format("{} of {} start{} {} another mode, {} % at most at 95 %",
                       row.changed > 0 ? fmt::format("{}", row.changed) : "none", row.runs, row.runs == 1 ? "" : "s",
                       row.changed > 1 ? "have" : "has", in_percent(row.changed_rate.most));
}

/// What there is to say of the number of impacts.
std::string evidence_in_words(const Tradeoff& found) {
    const auto& rows = found.evidence.rows;
    if (rows.empty()) return "";
    const auto used = std::find_if(rows.begin(), rows.end(), [&](const EvidenceRow& row) {
        return row.collisions == (found.enough_collisions > 0 ? found.enough_collisions : rows.back().collisions);
    });
    const bool more_are_unknown = used + 1 == rows.end() && !found.evidence.judged_most;
    std::string words = fmt::format(" with {2}{0} + {0} impacts: {1:.2g} s an orbit", used->collisions, used->seconds,
                                    more_are_unknown ? "at least " : "");
    if (used->mean_spin_error > 0) words += fmt::format(", mean S is known to {:.1g}", used->mean_spin_error);
    words += ". ";
    if (used + 1 != rows.end())
        return words + fmt::format("Compared with {0} + {0} impacts {1}; on every number between it is below {2:g} %",
                                   rows.back().collisions, changed_in_words(*used), 100 * may_change);
    if (more_are_unknown) return words + "The budget ended before more were judged: give a larger --budget";
    if (rows.size() < 2) return words + "Fewer were not tried";
    const EvidenceRow& fewer = rows[rows.size() - 2];
    if (fewer.changed_rate.most < may_change)
        return words + fmt::format("After {0} + {0} impacts mean S differs by {1:.1g}; below {2:g} would do",
                                   fewer.collisions, fewer.mean_spin_differs, mean_may_differ);
    return words + fmt::format("After {0} + {0} impacts {1}; below {2:g} % would do", fewer.collisions,
                               changed_in_words(fewer), 100 * may_change);
}

/// What a cycle's points can be trusted to, and what more digits are good for.
std::string digits_in_words(const Tradeoff& found, const ArithmeticRow& row) {
    const ArithmeticRow& last = found.arithmetics.back();
    std::string words;
    const double one = row.flights ? row.flights->one.largest : 0, of_ten = row.flights ? row.flights->ten.largest : 0;
    if (one > 0)
        words = fmt::format(": one step {}is off by at most {:.1g}",
                            found.drawn.after_transient ? "" : "at the beginning of an orbit ", one);
    if (one > 0 && of_ten > 0) words += fmt::format(", ten by {:.1g}", of_ten);
    words += ". orbits and continue round every step to double, so that more digits do not sharpen their cycles";
    if (&row == &last) return words + ".";
    return words + fmt::format("; simulate, recurrence and spectrum keep those of {}, at {:.3g} times the time.",
                               last.arithmetic->name, last.time.median / row.time.median);
}

/// Is a step's error within `roundings_at_knee`? The last arithmetic, with which others are compared, is.
bool is_within_rounding(const ArithmeticRow& row) {
    if (!row.flights) return true;
    const double in_double =
        row.flights->largest_in_condition * row.arithmetic->epsilon / std::numeric_limits<double>::epsilon();
    return row.flights->missed + row.flights->misordered == 0 && in_double <= roundings_at_knee;
}

const Arithmetic* knee_of(const Tradeoff& found) {
    const ArithmeticRow* knee = nullptr;
    for (const ArithmeticRow& row : found.arithmetics)
        if (is_within_rounding(row) && row.time.median < (knee ? knee->time.median : INFINITY)) knee = &row;
    return knee ? knee->arithmetic : nullptr;
}

/// What is known of the verdict of an arithmetic that is recommended.
std::string verdict_in_words(const Tradeoff& found, const ArithmeticRow& row) {
    const std::string_view last = found.arithmetics.back().arithmetic->name;
    if (row.verdict_differs) return fmt::format("its verdict is that of {}", last);
    if (row.orbit && found.arithmetics.back().orbit)
        return fmt::format("its orbit or that of {} is too short to compare verdicts", last);
    return fmt::format("the budget was spent before its verdict was compared with that of {}", last);
}

const ArithmeticRow* cheapest(const Tradeoff& found) {
    const ArithmeticRow* best = nullptr;
    for (const ArithmeticRow& row : found.arithmetics)
        if (row.arithmetic->is_exact && objection_to(row).empty() && (!best || row.time.median < best->time.median))
            best = &row;
    return best;
}

/// Why nothing can be recommended; empty: something can.
std::string obstacle(const Tradeoff& found) {
    const DrawnFlights& drawn = found.drawn;
    if (drawn.flights.empty() && drawn.steps > 0)
        return "every step of this orbit leads through contact, so that it has no flights to compare";
    if (drawn.flights.empty() && drawn.outcome == Outcome::completed)
        return "the budget was spent before flights were drawn: give a larger --budget";
    if (drawn.flights.empty())
        return fmt::format("no flight ends in an impact: {} after {} impacts", name_of(drawn.outcome), drawn.impacts);
    if (found.compared == 0) return "the budget was spent before accuracies were compared: give a larger --budget";
    return "";
}

/// What calling chaos before the limits would save on this scene.
std::string risk_in_words(const Tradeoff& found) {
    if (found.risk.empty()) return "";
    const RiskRow& limits = found.risk.front();
    const auto row = std::find_if(found.risk.begin(), found.risk.end(),
                                  [&](const RiskRow& r) { return r.risk == found.recommended_risk; });
    if (found.recommended_risk == 0)
        return fmt::format(" No --risk up to {:g} saves a tenth of the impacts of {} runs.", found.risk.back().risk,
                           limits.runs);
    return fmt::format(
        " Of many runs, --risk {:g} takes {:.2g} of their impacts: of {} random starts {} are called chaotic early, of "
        "which "
        "{} {} another verdict at the limits.",
        row->risk, static_cast<double>(row->impacts) / static_cast<double>(limits.impacts), row->runs, row->runs_called,
        row->changed > 0 ? fmt::format("{}", row->changed) : "none", row->changed > 1 ? "have" : "has");
}

}  // namespace

void recommend(Tradeoff& found) {
    found.enough_collisions = enough(found.evidence.rows);
    found.recommended_risk = recommended_risk(found.risk);
    found.reason = obstacle(found);
    if (!found.reason.empty()) return;
    const ArithmeticRow* best = cheapest(found);  // the last one at least
    found.recommended = best->arithmetic;
    found.knee = knee_of(found);
    for (const ArithmeticRow& row : found.arithmetics)
        if (row.arithmetic->is_exact && !objection_to(row).empty())
            found.reason += fmt::format("{}: {}; ", row.arithmetic->name, objection_to(row));
    if (best->flights)
        found.reason += fmt::format("{} missed or misordered 0 of {} contacts (below {:.1e} at 95 %), and {}",
                                    best->arithmetic->name, best->flights->flights, best->flights->missed_rate.most,
                                    verdict_in_words(found, *best));
    else
        found.reason += fmt::format("{} is what the others are compared with", best->arithmetic->name);
    found.advice = fmt::format("For a map over parameters use {}{}. For a cycle use {}{}", best->arithmetic->name,
                               evidence_in_words(found), best->arithmetic->name, digits_in_words(found, *best)) +
                   risk_in_words(found);
}

}  // namespace swirl::studies::tradeoff
