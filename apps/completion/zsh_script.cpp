#include "apps/command_line/documents.hpp"
#include "apps/completion/completion_scripts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace swirl::apps::completion {

namespace {

/// A text within an argument of _arguments, which reads some signs as its own.
std::string escaped(const std::string& text, const std::string& signs) {
    std::string result;
    for (const char c : text) {
        if (signs.find(c) != std::string::npos) result += '\\';
        result += c;
    }
    return result;
}

/// ":MESSAGE:ACTION" of a value.
std::string message_and_action(const ProgramDefinition& program, const OptionDefinition& option) {
    const auto words = words_of(program, option);
    std::string action = " ";
    if (const auto suffix = suffix_of(option)) {
        action = fmt::format("_files{}", suffix->empty() ? std::string() : fmt::format(" -g \"*{}\"", *suffix));
    } else if (!words.empty()) {
        std::vector<std::string> candidates;
        bool begins = false;
        for (const std::string& word : words) {
            begins = begins || word.ends_with('=') || word.ends_with(':');
            candidates.push_back(escaped(word, begins ? "" : "\\ ():"));
        }
        action = begins ? fmt::format("{{compadd -S \"\" -- {}}}", fmt::join(candidates, " "))
                        : fmt::format("({})", fmt::join(candidates, " "));
    }
    const std::string message = option.value.empty() ? std::string("value") : option.value;
    return fmt::format(":{}:{}", escaped(message, ":\\"), action);
}

/// One flag with its value, as _arguments has it.
std::string specification(const ProgramDefinition& program, const OptionDefinition& option, const std::string& flag) {
    std::string text = option.several ? "*" : fmt::format("({})", fmt::join(option.flags, " "));
    text += flag;
    if (option.values > 0) text += flag.starts_with("--") ? "=" : "+";
    text += fmt::format("[{}]", escaped(option.help, "\\[]"));
    for (int i = 0; i < option.values; ++i) text += message_and_action(program, option);
    return in_quotes(text);
}

std::string arguments_of(const ProgramDefinition& program, const std::vector<OptionDefinition>& options) {
    std::string text = "_arguments";
    for (const OptionDefinition& option : options) {
        for (const std::string& flag : option.flags)
            text += fmt::format(" \\\n            {}", specification(program, option, flag));
        if (option.place.empty()) continue;
        const char* how_many = option.several ? "*" : option.required ? "" : ":";
        const std::string place = fmt::format("{}{}", how_many, message_and_action(program, option));
        text += fmt::format(" \\\n            {}", in_quotes(place));
    }
    return text;
}

}  // namespace

std::string zsh_script(const ProgramDefinition& program) {
    std::string text = fmt::format(
        "#compdef swirl\n# Completion of swirl {} for zsh, made by `swirl completion zsh`.\n\n_swirl() {{\n"
        "    local -a commands\n    commands=(\n",
        version());
    for (const CommandDefinition& command : program.commands)
        text += fmt::format("        {}\n", in_quotes(command.name + ":" + escaped(command.does, ":\\")));
    text +=
        "    )\n    if (( CURRENT == 2 )); then\n"
        "        if [[ $words[2] == -* ]]; then\n            " +
        arguments_of(program, program.options) +
        "\n        else\n            _describe -t commands 'swirl command' commands\n        fi\n        return\n    "
        "fi\n"
        "    local command=$words[2]\n    shift words\n    (( CURRENT-- ))\n    case $command in\n";
    for (const CommandDefinition& command : program.commands)
        text += fmt::format("    {})\n        {} ;;\n", command.name, arguments_of(program, command.options));
    text += "    esac\n}\n\n";
    // As a file of the function path it is called; by eval it is made known.
    return text + "if [[ $funcstack[1] == _swirl ]]; then _swirl \"$@\"; else compdef _swirl swirl; fi\n";
}

}  // namespace swirl::apps::completion
