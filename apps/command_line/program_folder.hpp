#pragma once

#include <filesystem>

namespace swirl::apps {

/// Where the file of the program that runs lies: what was installed with it is found from there, wherever the prefix
/// was moved to. Empty where the system does not tell.
std::filesystem::path folder_of_this_program();

}  // namespace swirl::apps
