#include "apps/recurrence/recurrence_command.hpp"

#include "apps/command_line/numbers.hpp"
#include "apps/recurrence/convention_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>

namespace swirl::apps::recurrence {

void ConventionOptions::add_to(Flags& command) {
    using namespace recurrence_names;
    Flags conventions = command.under("Conventions");
    const auto text = [&](const char* flag, std::string& target, const std::string& help) {
        return conventions.add_option(flag, target, "NAME", help);
    };
    const auto number = [&](const char* flag, std::optional<int>& target, int least, const char* help) {
        add_whole_number(conventions, flag, target, "K", least, 1'000'000'000, help);
    };
    text("--convention", convention,
         fmt::format("as a package does: {}", fmt::join(analysis::recurrence::preset_names(), ", ")))
        ->offer(analysis::recurrence::preset_names());
    text("--norm", norm, "euclidean (default), maximum or manhattan")->offer(words_of(norms));
    number("--theiler", theiler, 0, "leave out pairs less than W apart (default 1: the main diagonal; cross: 0)");
    number("--min-diagonal", min_diagonal, 1, "shortest diagonal line (default 2)");
    number("--min-vertical", min_vertical, 1, "shortest vertical line (default 2)");
    conventions.add_flag("--strict", strict, "recurrent when distance < threshold, instead of <=");
    text("--rate-pairs", rate_pairs, "what RR is divided by: outside-window (default) or all pairs")
        ->offer(words_of(pairs));
    text("--recurrence-time", recurrence_time, "midpoints (default), white-lines or line-starts")
        ->offer(words_of(times));
    text("--triangles", triangles, "diagonal lines of both triangles (default) or one")
        ->offer(words_of(triangle_choices));
    text("--border-lines", border_lines, "lines cut by the border: counted (default) or discarded")
        ->offer(words_of(borders));
    text("--logarithm", logarithm, "of the entropies: natural (default), binary or decimal")
        ->offer(words_of(logarithms));
}

analysis::recurrence::Settings ConventionOptions::settings() const {
    using namespace recurrence_names;
    analysis::recurrence::Settings s;
    if (!convention.empty()) s = analysis::recurrence::preset(convention);
    choose("norm", norm, norms, s.norm);
    choose("rate-pairs", rate_pairs, pairs, s.rate_pairs);
    choose("recurrence-time", recurrence_time, times, s.recurrence_time);
    choose("triangles", triangles, triangle_choices, s.triangles);
    choose("border-lines", border_lines, borders, s.border_lines);
    choose("logarithm", logarithm, logarithms, s.logarithm);
    if (theiler) s.theiler = theiler;
    if (min_diagonal) s.min_diagonal = *min_diagonal;
    if (min_vertical) s.min_vertical = *min_vertical;
    if (strict) s.strict = true;
    // White lines at the border belong to the convention's recurrence time; another one goes without.
    if (s.recurrence_time != analysis::recurrence::RecurrenceTime::white_lines) s.border_white_lines = false;
    analysis::recurrence::validate(s);
    return s;
}

analysis::recurrence::Deviation ConventionOptions::deviation() const {
    std::string lower = convention;
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    return lower == "pyunicorn" ? analysis::recurrence::Deviation::population : analysis::recurrence::Deviation::sample;
}

}  // namespace swirl::apps::recurrence
