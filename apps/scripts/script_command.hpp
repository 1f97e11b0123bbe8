// What `swirl plot`, `animate` and `notebook` share: records in, one file out, and a Python script that makes it.
#pragma once

#include "apps/command_line/flags.hpp"

#include <string>
#include <vector>

namespace swirl::apps::scripts {

/// What is made of records, and by which script.
struct ScriptOutput {
    const char* script;                 ///< of notebooks-export, as `plot_record.py`
    const char* noun;                   ///< in messages: figure, film, notebook
    const char* command;                ///< as it is called: swirl plot
    std::vector<std::string> suffixes;  ///< that the file's name may have
    std::string mark;                   ///< what such a file says of itself: it is replaced without --force
    unsigned seconds = 60;              ///< of computing, at most, of a record without a checksum
};

struct ScriptFiles {
    std::vector<std::string> records;
    std::string output;
    bool json = false;
    bool quiet = false;
    bool force = false;

    /// The record (or several), -o, --force, --json, --quiet.
    void add_to(Flags& command, const ScriptOutput& kind, bool several = false);
};

/// That the output may be made: its suffix, its folder, that it is no input, nor a file that the command did not make.
/// @throws BadInput
void check_output(const ScriptOutput& kind, const ScriptFiles& files);

/// Checks what it can, then becomes the script; of a record without a checksum it runs it in a child process.
///   own  the command's own arguments, after those of the files
/// @return the child's exit code @throws BadInput
int run_script(const ScriptOutput& kind, const ScriptFiles& files, const std::vector<std::string>& own);

/// Appends `--name=value` if there is a value.
void add_argument(std::vector<std::string>& arguments, const char* name, const std::string& value);

}  // namespace swirl::apps::scripts
