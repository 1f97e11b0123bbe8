#include "apps/manual/pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <sstream>

namespace swirl::apps::manual {

namespace {

// Details are written in lines of up to 120 characters, and broken a word or two before that where it reads better.
constexpr std::size_t line_with_room = 100;

/// A table's line has columns, what is indented is a table or code.
bool is_set_by_hand(const std::string& line) {
    return line.starts_with("  ") || line.find("   ") != std::string::npos;
}

bool has_room_for(const std::string& line, const std::string& next) {
    return (line.ends_with('.') || line.ends_with(':')) &&
           line.size() + 1 + next.substr(0, next.find(' ')).size() <= line_with_room;
}

}  // namespace

Details details_of(const std::string& text) {
    Details details;
    std::istringstream lines(text);
    std::string before;
    bool examples = false;
    for (std::string line; std::getline(lines, line); before = line) {
        examples = examples || line == "Example:" || line == "Examples:";
        if (examples) {
            if (line.starts_with("  ")) details.examples.push_back(line.substr(2));
            continue;
        }
        if (line.empty()) continue;
        const bool kept = is_set_by_hand(line);
        const bool goes_on = !before.empty() && !details.blocks.empty() && details.blocks.back().kept == kept &&
                             (kept || !has_room_for(before, line));
        if (!goes_on)
            details.blocks.push_back({kept, {line}});
        else if (kept)
            details.blocks.back().lines.push_back(line);
        else
            details.blocks.back().lines.front() += " " + line;
    }
    return details;
}

std::string mark_of(PageForm form) {
    return form == PageForm::man ? ".\\\" Made by swirl manual\n" : "<!-- Made by swirl manual -->\n";
}

std::string file_name(const CommandDefinition* command, PageForm form) {
    return fmt::format("swirl{}{}{}", command == nullptr ? "" : "-", command == nullptr ? "" : command->name,
                       form == PageForm::man ? ".1" : ".md");
}

std::string page_of(const ProgramDefinition& program, const CommandDefinition* command, PageForm form) {
    return form == PageForm::man ? man_page_of(program, command) : markdown_page_of(program, command);
}

const std::vector<ExitStatus>& exit_statuses() {
    static const std::vector<ExitStatus> all = {
        {"0", "Done."},
        {"2", "Bad arguments or input: one line says what, its value and what is allowed; nothing is written."},
        {"3",
         "A numerical ending that is not the one asked for, or nothing found, or not proven. The document says which."},
        {"4", "Reading or writing failed after work had begun."},
        {"130", "Interrupted; what was finished is written where the command can keep parts."}};
    return all;
}

const std::vector<EnvironmentName>& environment_names() {
    static const std::vector<EnvironmentName> all = {
        {"SWIRL_FIGURES", "The folder of plot_record.py and its like, in place of the installed one."},
        {"SWIRL_PYTHON", "The Python that runs them, in place of /usr/bin/python3."}};
    return all;
}

std::vector<OptionGroup> groups_of(const std::vector<OptionDefinition>& options) {
    std::vector<OptionGroup> groups;
    for (const OptionDefinition& option : options) {
        const auto same = [&](const OptionGroup& group) { return group.heading == option.group; };
        auto group = std::find_if(groups.begin(), groups.end(), same);
        if (group == groups.end()) group = groups.insert(groups.end(), OptionGroup{option.group, {}});
        group->options.push_back(&option);
    }
    return groups;
}

std::vector<std::string> places_of(const std::vector<OptionDefinition>& options) {
    std::vector<std::string> places;
    for (const OptionDefinition& option : options) {
        if (option.place.empty()) continue;
        const std::string name = place_shown(option) + (option.several ? "..." : "");
        places.push_back(option.required ? name : "[" + name + "]");
    }
    return places;
}

std::string place_shown(const OptionDefinition& option) {
    std::string name = option.place;
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    return name;
}

std::string value_shown(const OptionDefinition& option) {
    if (option.values == 0) return "";
    if (!option.value.empty() && option.value != "TEXT") return option.value;
    const bool begins = std::any_of(option.words.begin(), option.words.end(),
                                    [](const std::string& word) { return word.ends_with('=') || word.ends_with(':'); });
    return option.words.size() < 2 || begins ? "VALUE" : fmt::format("{}", fmt::join(option.words, "|"));
}

std::string as_sentence(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text + ".";
}

std::string help_in_full(const OptionDefinition& option) {
    std::string help = option.help;
    if (!option.range.empty()) help += fmt::format("; {}", option.range);
    if (option.required) help += "; required";
    if (option.several) help += "; may be given several times";
    return help;
}

}  // namespace swirl::apps::manual
