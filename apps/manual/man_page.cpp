#include "apps/command_line/documents.hpp"
#include "apps/manual/pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <vector>

namespace swirl::apps::manual {

namespace {

/// Text as troff prints it: a minus that can be copied, and no letter that it would set as another.
std::string set(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '\\':
                result += "\\e";
                break;
            case '-':
                result += "\\-";
                break;
            case '\'':
                result += "\\(aq";
                break;
            case '`':
                result += "\\(ga";
                break;
            case '^':
                result += "\\(ha";
                break;
            case '~':
                result += "\\(ti";
                break;
            default:
                result += c;
        }
    }
    return result.starts_with('.') ? "\\&" + result : result;
}

/// In sentences `code` is bold.
std::string set_sentences(const std::string& text) {
    std::string result;
    bool bold = false;
    std::size_t begin = 0;
    for (auto end = text.find('`'); end != std::string::npos; begin = end + 1, end = text.find('`', begin)) {
        result += set(text.substr(begin, end - begin)) + (bold ? "\\fR" : "\\fB");
        bold = !bold;
    }
    result += set(text.substr(begin)) + (bold ? "\\fR" : "");
    return result.starts_with('.') ? "\\&" + result : result;
}

std::string capital(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
    return text;
}

std::string kept(const std::vector<std::string>& lines) {
    std::string text = ".PP\n.EX\n";
    for (const std::string& line : lines) text += set(line) + "\n";
    return text + ".EE\n";
}

std::string described(const std::vector<Block>& blocks) {
    std::string text;
    for (const Block& block : blocks)
        text += block.kept ? kept(block.lines) : fmt::format(".PP\n{}\n", set_sentences(block.lines.front()));
    return text;
}

std::string entry(const OptionDefinition& option) {
    std::vector<std::string> names;
    if (!option.place.empty()) names.push_back(fmt::format("\\fI{}\\fR", set(place_shown(option))));
    for (const std::string& flag : option.flags) names.push_back(fmt::format("\\fB{}\\fR", set(flag)));
    std::string tag = fmt::format("{}", fmt::join(names, ", "));
    if (option.values > 0 && !option.flags.empty()) tag += fmt::format(" \\fI{}\\fR", set(value_shown(option)));
    return fmt::format(".TP\n{}\n{}\n", tag, set_sentences(help_in_full(option)));
}

std::string options_section(const std::vector<OptionDefinition>& options) {
    std::string text = ".SH OPTIONS\n";
    for (const OptionGroup& group : groups_of(options)) {
        if (group.heading != "Options") text += fmt::format(".SS \"{}\"\n", set(group.heading));
        for (const OptionDefinition* option : group.options) text += entry(*option);
    }
    return text;
}

std::string exit_section() {
    std::string text = ".SH \"EXIT STATUS\"\n";
    for (const ExitStatus& status : exit_statuses())
        text += fmt::format(".TP\n.B {}\n{}\n", status.code, set_sentences(status.meaning));
    return text;
}

std::string environment_section() {
    std::string text = ".SH ENVIRONMENT\n";
    for (const EnvironmentName& known : environment_names())
        text += fmt::format(".TP\n.B {}\n{}\n", known.name, set_sentences(known.meaning));
    return text;
}

std::string head(const std::string& name, const std::string& does) {
    return fmt::format("{}.TH {} 1 \"\" \"swirl {}\" \"Swirl\"\n.SH NAME\n{} \\- {}\n", mark_of(PageForm::man),
                       set(capital(name)), version(), set(name), set(does));
}

std::string program_page(const ProgramDefinition& program) {
    std::string text = head("swirl", "follow a body in a swirled circular container, and name its mode");
    text +=
        ".SH SYNOPSIS\n.B swirl\n.I COMMAND\n[\\fIOPTIONS\\fR]\n.br\n.B swirl COMMAND \\-\\-help\n.SH DESCRIPTION\n";
    text += set_sentences(program.does) + "\n" + described(details_of(program.details).blocks) + ".SH COMMANDS\n";
    for (const CommandDefinition& command : program.commands)
        text += fmt::format(".TP\n.BR swirl\\-{} (1)\n{}\n", set(command.name), set_sentences(command.does));
    return text + options_section(program.options) + exit_section() + environment_section();
}

std::string command_page(const CommandDefinition& command) {
    const Details details = details_of(command.details);
    std::string text = head("swirl-" + command.name, command.does);
    text += fmt::format(".SH SYNOPSIS\n.B swirl {}\n", set(command.name));
    for (const std::string& place : places_of(command.options)) text += fmt::format("\\fI{}\\fR\n", set(place));
    text += "[\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n";
    text +=
        set_sentences(as_sentence(command.does)) + "\n" + described(details.blocks) + options_section(command.options);
    if (!details.examples.empty()) text += fmt::format(".SH EXAMPLES\n{}", kept(details.examples));
    return text + exit_section() + ".SH \"SEE ALSO\"\n.BR swirl (1)\n";
}

}  // namespace

std::string man_page_of(const ProgramDefinition& program, const CommandDefinition* command) {
    return command == nullptr ? program_page(program) : command_page(*command);
}

}  // namespace swirl::apps::manual
