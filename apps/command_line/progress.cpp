#include "apps/command_line/progress.hpp"

#include "apps/command_line/standard_streams.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace swirl::apps {

namespace {

constexpr double first_line = 3, between_lines = 10, shortest_between = 3;  // seconds
constexpr double worth_a_line = 0.1;                                        // share of the whole

constexpr double minute = 60, hour = 3600, day = 24 * hour, year = 365 * day;

/// "12 s", "4 min", "2.5 h", "3 days": two digits are what an estimate is good for.
std::string duration_in_words(double seconds) {
    if (seconds < 100) return fmt::format("{:.0f} s", seconds);
    if (seconds < 100 * minute) return fmt::format("{:.0f} min", seconds / minute);
    if (seconds < 2 * day) return fmt::format("{:.1f} h", seconds / hour);
    if (seconds < 2 * year) return fmt::format("{:.0f} days", seconds / day);
    return fmt::format("{:.2g} years", seconds / year);
}

}  // namespace

Progress::Progress(std::string task, double total, bool quiet)
    : task_(std::move(task)),
      total_(total),
      caller_(caller_of_this_thread()),
      shown_(!quiet),
      on_terminal_(isatty(STDERR_FILENO) != 0) {
    if (caller_) caller_->begin_task(task_, total_);
}

Progress::~Progress() {
    if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void Progress::at(double done) {
    if (caller_) return caller_->at(done);
    const auto now = Clock::now();
    if (!shown_ || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    const double share = total_ > 0 ? std::clamp(done / total_, 0.0, 1.0) : 0;
    const double spent = std::chrono::duration<double>(now - begin_).count();
    on_terminal_ ? draw_bar(share, spent) : say_at_times(share, spent);
}

void Progress::draw_bar(double share, double spent) {
    const int width = 30;
    const int filled = static_cast<int>(share * width);
    std::string line =
        fmt::format("\r\x1b[K{} [{:#<{}}{:.<{}}] {:3.0f} %", task_, "", filled, "", width - filled, 100 * share);
    if (share > 0.01) line += fmt::format(", {} left", duration_in_words(spent / share - spent));
    std::fputs(line.c_str(), stderr);
    drawn_ = true;
}

void Progress::say_at_times(double share, double spent) {
    const bool is_first = told_at_ == 0;
    const double since = spent - told_at_;
    const bool is_time =
        is_first ? spent >= first_line
                 : since >= between_lines || (since >= shortest_between && share - told_share_ >= worth_a_line);
    if (!is_time || share <= 0 || share >= 1 || (is_first && spent / share < between_lines)) return;
    const std::string left = duration_in_words(spent / share - spent);
    report(is_first ? fmt::format("swirl: {}: {:.3g} % done in {}, about {} to go", task_, 100 * share,
                                  duration_in_words(spent), left)
                    : fmt::format("swirl: {}: {:.0f} % done, about {} left", task_, 100 * share, left));
    told_share_ = share;
    told_at_ = spent;
}

}  // namespace swirl::apps
