#include "apps/modes/escape_document.hpp"

#include "apps/output/write_table.hpp"

#include <fmt/format.h>

#include <cmath>

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

std::string in_words(const analysis::EscapeRate& escape, std::int64_t settling) {
    const std::int64_t all = escape.left + escape.remaining;
    if (escape.left == 0)
        return fmt::format(
            "chaos: {} runs were in it after {} impacts, and none of these has left: half-life above {:.3g}", all,
            settling, std::log(2) / escape.most_rate);
    const char* const others = escape.remaining == 0 ? ""
                               : escape.others_will_leave
                                   ? "; the others are to be expected to leave, too"
                                   : "; these escapes are too few, or too early, to say whether the others leave";
    return fmt::format(
        "chaos: {} runs were in it after {} impacts, {} of these have left: half-life {:.3g} impacts (95 %: "
        "{:.3g} to {:.3g}){}",
        all, settling, escape.left, escape.half_life, std::log(2) / escape.most_rate, std::log(2) / escape.least_rate,
        others);
}

}  // namespace swirl::apps
