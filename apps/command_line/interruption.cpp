#include "apps/command_line/interruption.hpp"

#include "apps/command_line/caller.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/record/output_file.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <memory>
#include <string_view>

namespace swirl::apps {

namespace {

// Half a second less what it takes to start, to write and to leave on a machine that is busy.
constexpr long grace_ns = 300'000'000;

// Written by a handler, on whichever thread the signal comes to, and read by all of them.
std::atomic<bool> interrupted = false;
std::atomic<bool> finishing = false;
std::atomic<bool> is_told = false;
static_assert(std::atomic<bool>::is_always_lock_free, "handlers may use these alone");
timer_t grace_timer;
bool has_grace_timer = false;

void leave(int) {
    remove_unfinished_files();
    constexpr std::string_view words = "swirl: interrupted\n";
    if (is_told && write(STDERR_FILENO, words.data(), words.size()) < 0) _exit(exit_interrupted);
    _exit(exit_interrupted);
}

void set_grace_timer(long nanoseconds) {
    itimerspec time{};
    time.it_value.tv_nsec = nanoseconds;
    timer_settime(grace_timer, 0, &time, nullptr);
}

void note(int) {
    const int error = errno;  // of the call that the signal has come into
    interrupted = true;
    if (!finishing) set_grace_timer(grace_ns);
    errno = error;
}

bool ignores_hangup() {
    struct sigaction now {};
    return sigaction(SIGHUP, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

bool hangup_is_ignored = false;

void handle(void (*handler)(int)) {
    std::signal(SIGINT, handler);
    std::signal(SIGTERM, handler);
    hangup_is_ignored = hangup_is_ignored || ignores_hangup();
    std::signal(SIGHUP, hangup_is_ignored ? SIG_IGN : handler);
}

}  // namespace

void keep_ignored_hangup() {
    hangup_is_ignored = ignores_hangup();
}

void exit_when_interrupted() {
    if (const auto caller = caller_of_this_thread()) {
        if (caller->is_stopped()) throw Interrupted();
        return;
    }
    handle(leave);
    if (interrupted) leave(0);
}

void tell_interruption() {
    if (!caller_of_this_thread()) is_told = true;
}

void note_interruptions() {
    if (const auto caller = caller_of_this_thread()) return caller->set_finishing(false);
    finishing = false;
    if (!has_grace_timer) {
        sigevent event{};
        event.sigev_notify = SIGEV_SIGNAL;
        event.sigev_signo = SIGALRM;
        has_grace_timer = timer_create(CLOCK_MONOTONIC, &event, &grace_timer) == 0;
    }
    std::signal(SIGALRM, leave);
    handle(has_grace_timer ? note : leave);  // without a timer nothing would end work that does not look
}

bool is_interrupted() {
    const auto caller = caller_of_this_thread();
    return caller ? caller->is_stopped() : interrupted.load();
}

std::function<bool()> interruption() {
    if (const auto caller = caller_of_this_thread()) return [caller] { return caller->is_stopped(); };
    return [] { return interrupted.load(); };
}

void finish_up() {
    if (const auto caller = caller_of_this_thread()) return caller->set_finishing(true);
    finishing = true;
    if (has_grace_timer) set_grace_timer(0);
}

}  // namespace swirl::apps
