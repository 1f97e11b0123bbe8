// Flags of the commands that name modes: how far orbits are followed, and how close is a recurrence.
#pragma once

#include "analysis/classification/classify.hpp"
#include "apps/command_line/flags.hpp"
#include "apps/command_line/numbers.hpp"

#include <cstdint>

namespace swirl::apps {

/// What --help says of the flags that tell how far an orbit is followed, and the most impacts that may be kept.
struct TailHelp {
    const char* transient;
    const char* collisions;
    std::int64_t most_collisions;
};

/// --transient, --collisions and --exhaustive; `settings` (`transient`, `collisions`, `exhaustive`) keeps what is not
/// given.
template <class Settings>
void add_tail_flags(Flags& command, Settings& settings, const TailHelp& help) {
    add_whole_number(command, "--transient", settings.transient, "K", 0, 1'000'000'000, help.transient);
    add_whole_number(command, "--collisions", settings.collisions, "K", 64, help.most_collisions, help.collisions);
    command.add_flag("--exhaustive", settings.exhaustive,
                     "follow every orbit through all of these impacts, whatever its verdict needs");
}

/// --transient, --collisions, --exhaustive and --threshold; `settings` keeps what is not given.
void add_classify_flags(Flags& command, analysis::ClassifyOptions& settings);

}  // namespace swirl::apps
