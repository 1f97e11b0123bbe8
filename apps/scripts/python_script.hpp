// The Python scripts that read records, and the interpreter that runs them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace swirl::apps::scripts {

/// A script of notebooks-export by its name: in the folder that the environment's SWIRL_FIGURES names; else where it is
/// installed, relative to this program; else in the source tree that the program was built from. @throws BadInput
/// naming what to do
std::filesystem::path find_script(const std::string& name);

/// This process becomes Python running `script`, so exit codes and signals are the script's own. @throws BadInput if
/// there is no such Python
[[noreturn]] void become_python(const std::filesystem::path& script, const std::vector<std::string>& arguments);

/// Python runs `script` in a child process, for a record on which the library beneath may crash: the child's exit code.
///   seconds  of computing, at most
/// @throws BadInput if it crashed, or took longer
int run_python(const std::filesystem::path& script, const std::vector<std::string>& arguments, unsigned seconds);

}  // namespace swirl::apps::scripts
