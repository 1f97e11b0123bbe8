#include "apps/tradeoff/tradeoff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swirl::apps::tradeoff {

namespace {

/// Why a rung that was measured is not to be used; empty: it is.
std::string objection_to(const ArithmeticRung& row) {
    if (row.flights && row.flights->missed_rate.least > 0)
        return fmt::format("missed {} of {} contacts", row.flights->missed, row.flights->flights);
    if (row.verdict_differs.value_or(false)) return "its verdict differs";
    return "";
}

/// The fewest impacts from which on no start's mode differs from that on the most; 0: there are none below the most.
std::int64_t enough(const std::vector<EvidenceRung>& rungs) {
    std::int64_t least = 0;
    for (std::size_t k = rungs.size(); k-- > 0 && rungs[k].changed == 0;)
        if (k + 1 < rungs.size()) least = rungs[k].collisions;
    return least;
}

/// What there is to say of the number of impacts.
std::string evidence_in_words(const Tradeoff& found) {
    const auto& rungs = found.evidence.rungs;
    if (rungs.empty()) return "";
    const auto used = std::find_if(rungs.begin(), rungs.end(), [&](const EvidenceRung& rung) {
        return rung.collisions == (found.enough_collisions > 0 ? found.enough_collisions : rungs.back().collisions);
    });
    std::string words = fmt::format(" with {0} + {0} impacts ({1:.2g} s an orbit; ", used->collisions, used->seconds);
    if (used + 1 == rungs.end())
        return words + fmt::format("fewer change the mode of {} in {} starts)",
                                   rungs.size() > 1 ? rungs[rungs.size() - 2].changed : 0, used->runs);
    return words + fmt::format("of {} starts none has another mode on {}: below {:.2g} % at 95 %)", used->runs,
                               rungs.back().collisions, 100 * used->changed_rate.most);
}

/// What a cycle's points can be trusted to.
std::string digits_in_words(const Tradeoff& found, const ArithmeticRung& row) {
    const ArithmeticRung& last = found.rungs.back();
    if (&row == &last) return "";
    const double one = row.flights->one.largest, of_ten = row.flights->ten.largest;
    std::string words;
    if (one > 0) words = fmt::format(" (one step is off by at most {:.1g}", one);
    if (one > 0) words += of_ten > 0 ? fmt::format(", ten by {:.1g})", of_ten) : ")";
    return words + fmt::format(", and {} where more digits are wanted, at {:.2g} times the time", last.rung->name,
                               last.time.median / row.time.median);
}

const ArithmeticRung* cheapest(const Tradeoff& found) {
    const ArithmeticRung* best = nullptr;
    for (const ArithmeticRung& row : found.rungs)
        if (row.rung->is_exact && objection_to(row).empty() && (!best || row.time.median < best->time.median))
            best = &row;
    return best;
}

/// Why nothing can be recommended; empty: something can.
std::string obstacle(const Tradeoff& found) {
    const DrawnFlights& drawn = found.drawn;
    if (drawn.flights.empty() && drawn.steps > 0)
        return "every step of this orbit leads through contact, and rungs are compared on flights: nothing to compare";
    if (drawn.flights.empty())
        return fmt::format("no flight ends in an impact: {} after {} impacts", name_of(drawn.outcome), drawn.impacts);
    if (found.compared == 0 || !found.rungs.back().orbit)
        return "the budget was spent before rungs were compared: give a larger --budget";
    return "";
}

}  // namespace

void recommend(Tradeoff& found) {
    found.enough_collisions = enough(found.evidence.rungs);
    found.reason = obstacle(found);
    if (!found.reason.empty()) return;
    const ArithmeticRung* best = cheapest(found);  // the last one at least
    found.recommended = best->rung;
    for (const ArithmeticRung& row : found.rungs)
        if (row.rung->is_exact && !objection_to(row).empty())
            found.reason += fmt::format("{}: {}; ", row.rung->name, objection_to(row));
    const std::string_view last = found.rungs.back().rung->name;
    if (best->flights)
        found.reason += fmt::format("{} missed {} of {} contacts (below {:.1e} at 95 %), and {}", best->rung->name,
                                    best->flights->missed, best->flights->flights, best->flights->missed_rate.most,
                                    best->verdict_differs ? fmt::format("its verdict is that of {}", last)
                                                          : "its orbit is too short to compare verdicts");
    else
        found.reason += fmt::format("{} is what the others are compared with", best->rung->name);
    found.advice = fmt::format("for a map over parameters use {}{}; for a cycle use {}{}", best->rung->name,
                               evidence_in_words(found), best->rung->name, digits_in_words(found, *best));
}

}  // namespace swirl::apps::tradeoff
