#include "apps/command_line/documents.hpp"
#include "apps/completion/completion_scripts.hpp"

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

}  // namespace swirl::apps::completion
