// What a command has its studies heed: interruptions, --threads, --quiet.
#pragma once

#include "apps/command_line/output_options.hpp"
#include "apps/studies/parallel/run_control.hpp"

namespace swirl::apps {

/// Stops where an interruption was noted (interruption.hpp); tells how far tasks are (progress.hpp).
RunControl run_control(const OutputOptions& output);

}  // namespace swirl::apps
