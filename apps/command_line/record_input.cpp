#include "apps/command_line/record_input.hpp"

#include "apps/command_line/standard_streams.hpp"
#include "apps/record/record_checksum.hpp"

#include <fmt/format.h>

namespace swirl::apps {

void warn_without_checksum(const std::string& record, bool quiet) {
    if (quiet || record.empty() || has_checksum(record)) return;
    report(
        fmt::format("swirl: record '{}' has no checksum of what it holds now: damage to it would not be seen", record));
}

}  // namespace swirl::apps
