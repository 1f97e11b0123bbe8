// The scripts that `swirl completion` prints.
#pragma once

#include "apps/command_line/definitions.hpp"

#include <string>
#include <vector>

namespace swirl::apps::completion {

/// For bash 4.4 and newer; needs no package bash-completion.
std::string bash_script(const ProgramDefinition& program);

/// For zsh 5: the file `_swirl` of its function path, which eval can take as well.
std::string zsh_script(const ProgramDefinition& program);

/// The words that a value may be or begin with: those that it offers, or the names of the commands.
std::vector<std::string> words_of(const ProgramDefinition& program, const OptionDefinition& option);

/// A word as both shells read it: between single quotes.
std::string in_quotes(const std::string& word);

}  // namespace swirl::apps::completion
