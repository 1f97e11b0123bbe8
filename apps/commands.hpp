// The list of the commands.
#pragma once

#include "apps/command_line/program.hpp"

namespace swirl::apps {

/// Adds every command, in the order of --help.
void add_commands(Program& program);

}  // namespace swirl::apps
