// The details under a command's --help, as blocks that a page can set.
#pragma once

#include "apps/command_line/definitions.hpp"

#include <string>
#include <vector>

namespace swirl::apps::manual {

/// Lines that are kept as they stand, or a paragraph that is set anew.
struct Block {
    bool kept = false;
    std::vector<std::string> lines;  ///< of a paragraph one
};

struct Details {
    std::vector<Block> blocks;
    std::vector<std::string> examples;  ///< command lines, and comments between them
};

/// Indented lines and those of a table are kept. Of others a line that ends a sentence and had room for the next one's
/// first word was ended on purpose: what follows is a paragraph of its own. What stands under a line `Example:` or
/// `Examples:` are the examples.
Details details_of(const std::string& text);

// A page of the manual, of what a command's flags and help say.

/// In what a page is written.
enum class PageForm {
    man,      ///< troff with the macros of man(7)
    markdown  ///< as GitHub reads it
};

/// Begins each page: a file that has it may be replaced by a newer page. `mark_of(man)` is a comment of troff.
std::string mark_of(PageForm form);

/// "swirl.1" of the program (null), "swirl-classify.1", "swirl-classify.md".
std::string file_name(const CommandDefinition* command, PageForm form);

/// The page of a command, or of the program itself with a line for each command (null).
std::string page_of(const ProgramDefinition& program, const CommandDefinition* command, PageForm form);

/// The page in one form; page_of chooses.
std::string man_page_of(const ProgramDefinition& program, const CommandDefinition* command);
std::string markdown_page_of(const ProgramDefinition& program, const CommandDefinition* command);

/// An exit code and what it says, for every command alike.
struct ExitStatus {
    const char* code;
    const char* meaning;
};
const std::vector<ExitStatus>& exit_statuses();

/// A name of the environment and what it is for.
struct EnvironmentName {
    const char* name;
    const char* meaning;
};
const std::vector<EnvironmentName>& environment_names();

/// The options of one heading.
struct OptionGroup {
    std::string heading;
    std::vector<const OptionDefinition*> options;
};

/// In the order in which their first options come.
std::vector<OptionGroup> groups_of(const std::vector<OptionDefinition>& options);

/// "[RECORD]", "RECORD...": the arguments that are given by their place.
std::vector<std::string> places_of(const std::vector<OptionDefinition>& options);

/// "RECORD" of record.
std::string place_shown(const OptionDefinition& option);

/// What stands for the value: its name, its offered words if it has none, else VALUE.
std::string value_shown(const OptionDefinition& option);

/// "Name the mode of a scene." of "name the mode of a scene".
std::string as_sentence(std::string text);

/// Its help with what --help has around it: the range, whether it is wanted or may be repeated.
std::string help_in_full(const OptionDefinition& option);

}  // namespace swirl::apps::manual
