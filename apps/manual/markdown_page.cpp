#include "apps/manual/pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

namespace swirl::apps::manual {

namespace {

/// What Markdown would take for a sign of its own is a letter; what stands between backquotes is left alone.
std::string escaped(const std::string& text) {
    std::string result;
    bool code = false;
    for (const char c : text) {
        if (c == '`') code = !code;
        if (!code && std::string_view("\\*_<>[]|#$").find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

std::string fenced(const std::string& language, const std::vector<std::string>& lines) {
    return fmt::format("\n```{}\n{}\n```\n", language, fmt::join(lines, "\n"));
}

std::string described(const std::vector<Block>& blocks) {
    std::string text;
    for (const Block& block : blocks)
        text += block.kept ? fenced("text", block.lines) : fmt::format("\n{}\n", escaped(block.lines.front()));
    return text;
}

std::string row(const OptionDefinition& option) {
    std::string name = fmt::format("{}", fmt::join(option.flags, ", "));
    if (!option.flags.empty() && option.values > 0) name += fmt::format(" {}", value_shown(option));
    if (!option.place.empty()) name.insert(0, place_shown(option) + (option.flags.empty() ? "" : ", "));
    std::string cell;  // a bar would end it
    for (const char c : name) cell += c == '|' ? std::string("\\|") : std::string(1, c);
    return fmt::format("| `{}` | {} |\n", cell, escaped(help_in_full(option)));
}

std::string options_section(const std::vector<OptionDefinition>& options) {
    std::string text = "\n## Options\n";
    for (const OptionGroup& group : groups_of(options)) {
        if (group.heading != "Options") text += fmt::format("\n### {}\n", escaped(group.heading));
        text += "\n| option | |\n| --- | --- |\n";
        for (const OptionDefinition* option : group.options) text += row(*option);
    }
    return text;
}

std::string exit_section() {
    std::string text = "\n## Exit status\n\n| code | |\n| --- | --- |\n";
    for (const ExitStatus& status : exit_statuses()) text += fmt::format("| {} | {} |\n", status.code, status.meaning);
    return text;
}

std::string program_page(const ProgramDefinition& program) {
    std::string text = mark_of(PageForm::markdown) + "# swirl\n\n```sh\nswirl COMMAND [OPTIONS]\n```\n\n";
    text += escaped(program.does) + "\n" + described(details_of(program.details).blocks);
    text += "\n## Commands\n\n| command | |\n| --- | --- |\n";
    for (const CommandDefinition& command : program.commands)
        text += fmt::format("| [`swirl {}`]({}) | {} |\n", command.name, file_name(&command, PageForm::markdown),
                            escaped(command.does));
    text += options_section(program.options) + exit_section() + "\n## Environment\n\n| name | |\n| --- | --- |\n";
    for (const EnvironmentName& known : environment_names())
        text += fmt::format("| `{}` | {} |\n", known.name, escaped(known.meaning));
    return text;
}

std::string command_page(const CommandDefinition& command) {
    const Details details = details_of(command.details);
    std::string places;
    for (const std::string& place : places_of(command.options)) places += place + " ";
    std::string text =
        fmt::format("{}# swirl {}\n\n{}\n\n```sh\nswirl {} {}[OPTIONS]\n```\n", mark_of(PageForm::markdown),
                    command.name, escaped(as_sentence(command.does)), command.name, places);
    text += described(details.blocks) + options_section(command.options);
    if (!details.examples.empty()) text += fmt::format("\n## Examples\n{}", fenced("sh", details.examples));
    return text + exit_section() + fmt::format("\nAll commands: [swirl]({})\n", file_name(nullptr, PageForm::markdown));
}

}  // namespace

std::string markdown_page_of(const ProgramDefinition& program, const CommandDefinition* command) {
    return command == nullptr ? program_page(program) : command_page(*command);
}

}  // namespace swirl::apps::manual
