// The Python script that draws figures, and the interpreter that runs it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace swirl::apps::plot {

/// plot_record.py: in the folder that the environment's SWIRL_FIGURES names; else where it is installed, relative to
/// this program; else in the source tree that the program was built from. @throws BadInput naming what to do
std::filesystem::path figure_script();

/// This process becomes Python running `script`, so exit codes and signals are the script's own. @throws BadInput if
/// there is no such Python
[[noreturn]] void become_python(const std::filesystem::path& script, const std::vector<std::string>& arguments);

/// The same in a child process, for a record on which the library beneath may crash: the child's exit code. @throws
/// BadInput if it crashed, or took longer than a minute of computing
int run_python(const std::filesystem::path& script, const std::vector<std::string>& arguments);

}  // namespace swirl::apps::plot
