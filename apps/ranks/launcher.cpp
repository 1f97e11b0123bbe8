#include "apps/ranks/ranks.hpp"

#include "apps/command_line/caller.hpp"

#include <cstdlib>

namespace swirl::apps {

namespace {

int number_in(const char* name) {
    const char* text = std::getenv(name);
    return text == nullptr ? 0 : std::atoi(text);
}

}  // namespace

int processes_started_together() {
    if (caller_of_this_thread())
        return 1;  // the program for which the command runs shares the work out, if anybody does
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
        if (const int count = number_in(name); count > 0) return count;
    // Slurm sets its count in a batch script, too, where one process stands alone.
    if (std::getenv("PMIX_RANK") != nullptr && number_in("SLURM_NTASKS") > 0) return number_in("SLURM_NTASKS");
    return 1;
}

}  // namespace swirl::apps
