#include "apps/completion/completion_command.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/completion/completion_scripts.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace swirl::apps::completion {

const char* const completion_details =
    R"text(Prints a script that lets the shell complete commands, flags, the words that a flag takes (--law, --kind, ...) and the names
of files with the right suffix. `cmake --install` and the Debian package put it into the folders that both shells search.
By hand, one line does it:
  bash  in ~/.bashrc:                 eval "$(swirl completion bash)"
  zsh   in ~/.zshrc, after compinit:  eval "$(swirl completion zsh)"

Examples:
  swirl completion bash
  swirl completion zsh)text";

void CompletionOptions::add_to(Flags& command) {
    program = &command.program();
    command.add_option("SHELL", shell, "SHELL", "bash or zsh")->offer({"bash", "zsh"})->required();
}

int completion(CompletionOptions& options) {
    const bool bash = options.shell == "bash";
    if (!bash && options.shell != "zsh")
        throw BadInput(fmt::format("shell = '{}' is none of: bash, zsh", options.shell));
    const ProgramDefinition program = definition_of(*options.program);
    const std::string text = bash ? bash_script(program) : zsh_script(program);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return exit_done;
}

}  // namespace swirl::apps::completion
