// What the program's commands are, as plain values: of these its manual and the completion of shells are made.
#pragma once

#include "apps/command_line/flags.hpp"

#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

/// Before the words of Flag::offer in the name of the check that keeps them.
inline constexpr const char* offered_words_prefix = "offers\n";

struct OptionDefinition {
    std::vector<std::string> flags;  ///< "-o", "--output"; none of an argument that is given by its place alone
    std::string place;               ///< what --help calls it where it may stand without a flag
    int values = 0;                  ///< that follow a flag; 0: it is given or not
    std::string value;               ///< what --help calls them: "K", "FILE.h5"; often nothing
    std::string range;               ///< of a number, in words; often nothing
    std::vector<std::string> words;  ///< that it may be or begin with
    std::string help, group;
    bool required = false;
    bool several = false;  ///< it may be repeated, or take more than one value
};

struct CommandDefinition {
    std::string name, does, details;
    std::vector<OptionDefinition> options;  ///< in the order of --help
};

struct ProgramDefinition {
    std::string name, does, details;
    std::vector<OptionDefinition> options;
    std::vector<CommandDefinition> commands;

    /// Null if there is none of that name.
    const CommandDefinition* command(const std::string& name) const;
};

ProgramDefinition definition_of(CLI::App& program);

/// The suffix of a file that a value names, ".h5" of FILE.h5, "" of FILE, which may have any; nothing if it names none.
std::optional<std::string> suffix_of(const OptionDefinition& option);

}  // namespace swirl::apps
