// A progress bar on standard error: only on a terminal, not when quiet.
#pragma once

#include <chrono>
#include <string>

namespace swirl::apps {

class Progress {
public:
    Progress(std::string task, double total, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// How much of the total is done. Draws at most ten times a second; cheap enough for every thousandth impact.
    void at(double done);

private:
    using Clock = std::chrono::steady_clock;

    std::string task_;
    double total_;
    bool shown_;
    bool drawn_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point last_ = begin_;
};

}  // namespace swirl::apps
