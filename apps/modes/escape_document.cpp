#include "apps/modes/escape_document.hpp"

#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace swirl::apps {

namespace {

/// What a document, a record says of it.
Table<analysis::EscapeRate> escape_table() {
    using E = analysis::EscapeRate;
    return {{},
            {{"left", &E::left, no_column},
             {"remaining", &E::remaining, no_column},
             {"impacts", &E::steps, no_column},
             {"rate", &E::rate, no_column},
             {"least_rate", &E::least_rate, no_column},
             {"most_rate", &E::most_rate, no_column},
             {"half_life", &E::half_life, no_column},
             {"others_will_leave", &E::others_will_leave, no_column}}};
}

}  // namespace

void write_escape(JsonWriter& json, const std::optional<analysis::EscapeRate>& escape) {
    escape ? write_object(json, escape_table(), *escape) : json.null();
}

void write_escape(const RecordGroup& group, const analysis::EscapeRate& escape) {
    write_attributes(group, escape_table(), escape);
}

namespace {

/// How many runs were seen in chaos, for how long, how many left, and so how long half of them stay.
std::string seen_in_words(const analysis::EscapeRate& escape, std::int64_t settling) {
    const std::int64_t all = escape.left + escape.remaining;
    const std::string seen = fmt::format("chaos: {} run{} in it after {} impacts, for {:.3g} more in all", all,
                                         all == 1 ? " was" : "s were", settling, escape.steps);
    if (escape.left == 0)
        return fmt::format("{}; none of these has left: half-life above {:.3g} impacts (95 %)", seen,
                           std::log(2) / escape.most_rate);
    return fmt::format("{}; {} of these {} left: half-life {:.3g} impacts (95 %: {:.3g} to {:.3g})", seen, escape.left,
                       escape.left == 1 ? "has" : "have", escape.half_life, std::log(2) / escape.most_rate,
                       std::log(2) / escape.least_rate);
}

}  // namespace

std::string in_words(const analysis::EscapeRate& escape, std::int64_t settling) {
    const char* const others = escape.left == 0 || escape.remaining == 0 ? ""
                               : escape.others_will_leave
                                   ? "; the others are to be expected to leave, too"
                                   : "; these escapes are too few, or too early, to say whether the others leave";
    return seen_in_words(escape, settling) + others;
}

std::string chaos_in_words(std::span<const JudgedRun> runs) {
    std::int64_t longest = 0;
    std::set<std::size_t> chaotic;  // cells
    for (const JudgedRun& run : runs) {
        if (run.kind != analysis::Kind::chaotic) continue;
        longest = std::max(longest, run.impacts);
        chaotic.insert(run.cell);
    }
    if (longest == 0) return "";
    std::vector<analysis::ChaoticStay> stays;  // a slow cycle of a cell without chaos has left none
    for (const JudgedRun& run : runs)
        if (chaotic.contains(run.cell)) stays.push_back(stay_as_judged(run.kind, run.outcome, run.impacts));
    const analysis::EscapeRate escape = analysis::escape_rate(stays, chaos_begins);
    std::string text =
        fmt::format("chaos was followed for {} impacts a run, at most: too few to say how long it lasts", longest);
    if (escape.remaining > 0) {
        text = seen_in_words(escape, chaos_begins) + ", on the mean of all runs of cells with a chaotic one";
        if (escape.left > 0) text += ", and if what came late to a cycle, or to stay on the wall, was in chaos before";
        text += fmt::format("; a run is called chaotic for the {} impacts, at most, that it was followed", longest);
    }
    return wrapped(text, 4) + "\n";
}

}  // namespace swirl::apps
