#include "apps/completion/completion_scripts.hpp"

#include "apps/command_line/documents.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace swirl::apps::completion {

namespace {

/// What does not depend on the commands. Bash breaks words at = and : (COMP_WORDBREAKS): `--law=st` is three words, of
/// which the last is replaced, and `--grid alpha=0.2:` goes on with numbers that nobody can guess. A word in a quote
/// that is open begins with it, and what replaces it stands behind it as it is.
const char* const common = R"sh(
_swirl_words() {
    local candidate
    for candidate; do
        [[ $candidate == "$word"* ]] || continue
        if [[ -n $quote ]]; then COMPREPLY+=("$candidate"); else COMPREPLY+=("$(printf %q "$candidate")"); fi
        if [[ $candidate == "$word"*[=:] ]]; then compopt -o nospace 2>/dev/null; fi
    done
}

_swirl_files() {
    compopt -o filenames 2>/dev/null
    local suffix=$1 found
    while IFS= read -r found; do
        [[ -d $found || $found == *"$suffix" ]] && COMPREPLY+=("$found")
    done < <(compgen -f -- "$word")
}

_swirl() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} quote=
    COMPREPLY=()
    if [[ $word == [\"\']* ]]; then quote=${word:0:1} word=${word:1}; fi
    if (( COMP_CWORD == 1 )); then
        _swirl_values '' commands
        return
    fi
    if [[ $word == '=' ]]; then
        word=
    elif [[ $before == '=' ]]; then
        before=${COMP_WORDS[COMP_CWORD-2]}
        [[ $before == -* ]] || return
    fi
    [[ $before == ':' || $word == ':' ]] && return
    if [[ $before == -* ]] && _swirl_values "$command" "$before"; then return; fi
    if [[ $word == -* ]]; then
        _swirl_values "$command" flags
    else
        _swirl_values "$command" places
    fi
}

complete -F _swirl swirl
)sh";

/// What completes a value, as a line of the script.
std::string action(const ProgramDefinition& program, const OptionDefinition& option) {
    if (const auto suffix = suffix_of(option)) return fmt::format("_swirl_files {}", in_quotes(*suffix));
    const auto words = words_of(program, option);
    if (words.empty()) return ":";
    std::string line = "_swirl_words";
    for (const std::string& word : words) line += fmt::format(" {}", in_quotes(word));
    return line;
}

std::string flags_of(const std::vector<OptionDefinition>& options) {
    std::string line = "_swirl_words";
    for (const OptionDefinition& option : options)
        for (const std::string& flag : option.flags) line += " " + flag;
    return line;
}

std::string cases_of(const ProgramDefinition& program, const CommandDefinition& command) {
    std::string text = fmt::format("    '{} flags') {} ;;\n", command.name, flags_of(command.options));
    for (const OptionDefinition& option : command.options) {
        const std::string line = action(program, option);
        std::vector<std::string> patterns;
        if (!option.place.empty()) patterns.push_back(fmt::format("'{} places'", command.name));
        if (option.values > 0)
            for (const std::string& flag : option.flags) patterns.push_back(fmt::format("'{} {}'", command.name, flag));
        if (!patterns.empty()) text += fmt::format("    {}) {} ;;\n", fmt::join(patterns, "|"), line);
    }
    return text;
}

}  // namespace

std::string bash_script(const ProgramDefinition& program) {
    std::string text = fmt::format(
        "# Completion of swirl {} for bash, made by `swirl completion bash`.\n\n"
        "# _swirl_values COMMAND FLAG: what may follow the flag; false if nothing follows it, or it is none.\n"
        "_swirl_values() {{\n    case \"$1 $2\" in\n",
        version());
    std::string commands = flags_of(program.options);
    for (const CommandDefinition& command : program.commands) commands += " " + command.name;
    text += fmt::format("    ' commands') {} ;;\n", commands);
    for (const CommandDefinition& command : program.commands) text += cases_of(program, command);
    return text + "    *) return 1 ;;\n    esac\n    return 0\n}\n" + common;
}

std::vector<std::string> words_of(const ProgramDefinition& program, const OptionDefinition& option) {
    if (option.value != "COMMAND") return option.words;
    std::vector<std::string> names;
    for (const CommandDefinition& command : program.commands) names.push_back(command.name);
    return names;
}

std::string in_quotes(const std::string& word) {
    std::string result = "'";
    for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

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
