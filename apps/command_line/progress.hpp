// How far a task is, on standard error, unless quiet: a bar on a terminal, elsewhere (a batch job's log) a line at
// times. A command that runs for another program tells that instead.
#pragma once

#include "apps/command_line/caller.hpp"

#include <chrono>
#include <memory>
#include <string>

namespace swirl::apps {

class Progress {
public:
    Progress(std::string task, double total, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// How much of the total is done. A bar is drawn at most ten times a second. Lines are for tasks that will take 10
    /// s or more: an estimate after 3 s of work, then one every 10 s, or every 10 % if these are 3 s apart. Cheap
    /// enough for every thousandth impact.
    void at(double done);

private:
    using Clock = std::chrono::steady_clock;

    void draw_bar(double share, double spent);
    void say_at_times(double share, double spent);

    std::string task_;
    double total_;
    std::shared_ptr<Caller> caller_;
    bool shown_, on_terminal_;
    bool drawn_ = false;
    double told_share_ = 0, told_at_ = 0;  ///< of the last line: share, seconds
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_ = begin_;
};

}  // namespace swirl::apps
