#include "apps/command_line/interruption.hpp"

#include "apps/command_line/errors.hpp"

#include <unistd.h>

#include <csignal>

namespace swirl::apps {

namespace {
volatile std::sig_atomic_t interrupted = 0;
}

void note_interruptions() {
    const auto note = [](int) { interrupted = 1; };
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
}

bool is_interrupted() {
    return interrupted != 0;
}

void exit_when_interrupted() {
    const auto leave = [](int) { _exit(exit_interrupted); };
    std::signal(SIGINT, leave);
    std::signal(SIGTERM, leave);
}

}  // namespace swirl::apps
