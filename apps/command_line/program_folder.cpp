#include "apps/command_line/program_folder.hpp"

#include <system_error>

namespace swirl::apps {

std::filesystem::path folder_of_this_program() {
    std::error_code unknown;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
    return unknown ? std::filesystem::path() : program.parent_path();
}

}  // namespace swirl::apps
