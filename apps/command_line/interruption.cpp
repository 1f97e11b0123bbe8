#include "apps/command_line/interruption.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/record/unfinished_files.hpp"

#include <unistd.h>

#include <csignal>
#include <ctime>

namespace swirl::apps {

namespace {

// Half a second less what it takes to start, to write and to leave on a machine that is busy.
constexpr long patience_ns = 300'000'000;

volatile std::sig_atomic_t interrupted = 0;
volatile std::sig_atomic_t finishing = 0;
timer_t patience;
bool has_patience = false;

void leave(int) {
    remove_unfinished_files();
    _exit(exit_interrupted);
}

void set_patience(long nanoseconds) {
    itimerspec time{};
    time.it_value.tv_nsec = nanoseconds;
    timer_settime(patience, 0, &time, nullptr);
}

void note(int) {
    interrupted = 1;
    if (finishing == 0) set_patience(patience_ns);
}

void handle(void (*handler)(int)) {
    std::signal(SIGINT, handler);
    std::signal(SIGTERM, handler);
    if (std::signal(SIGHUP, handler) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

}  // namespace

void exit_when_interrupted() {
    handle(leave);
    if (interrupted != 0) leave(0);
}

void note_interruptions() {
    finishing = 0;
    if (!has_patience) {
        sigevent event{};
        event.sigev_notify = SIGEV_SIGNAL;
        event.sigev_signo = SIGALRM;
        has_patience = timer_create(CLOCK_MONOTONIC, &event, &patience) == 0;
    }
    std::signal(SIGALRM, leave);
    handle(has_patience ? note : leave);  // without a timer nothing would end work that does not look
}

bool is_interrupted() {
    return interrupted != 0;
}

void finish_up() {
    finishing = 1;
    if (has_patience) set_patience(0);
}

}  // namespace swirl::apps
