// The words of a command line as they stand, before CLI11 reads them.
#pragma once

#include "apps/command_line/flags.hpp"

#include <string>
#include <vector>

namespace swirl::apps {

/// Refuses what CLI11 would silently take for something else: an empty word, which it takes for an option that was not
/// given; `--name=` without a value and an option that follows one that wants a value, each of which would become the
/// name of a file (`--output= --json`, `-o --json`). What is no command and no flag of it is refused with the nearest
/// that is, as far as a third of its letters may be wrong.
///   words  without the program's name; the first names the command
/// @throws BadInput naming the word
void check_words(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace swirl::apps
