// What a build without MPI answers.
#include "apps/command_line/errors.hpp"
#include "apps/ranks/ranks.hpp"

#include <fmt/format.h>

namespace swirl::apps {

Ranks::Ranks() {
    const int count = processes_started_together();
    if (count > 1)
        throw BadInput(
            fmt::format("{} processes were started together, and this build of swirl has no MPI: build it where "
                        "MPI is (libopenmpi-dev), or give each a --shard of its own",
                        count));
}

Ranks::~Ranks() = default;
void Ranks::send(int, std::span<const std::byte>) {}

std::optional<Message> Ranks::receive() {
    return {};
}

}  // namespace swirl::apps
