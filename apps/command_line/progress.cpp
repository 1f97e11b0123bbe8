#include "apps/command_line/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace swirl::apps {

Progress::Progress(std::string task, double total, bool quiet)
    : task_(std::move(task)), total_(total), shown_(!quiet && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void Progress::at(double done) {
    using std::chrono::duration;
    const auto now = Clock::now();
    if (!shown_ || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    const double share = total_ > 0 ? std::clamp(done / total_, 0.0, 1.0) : 0;
    const double spent = duration<double>(now - begin_).count();
    const int width = 30;
    const int filled = static_cast<int>(share * width);
    std::string line =
        fmt::format("\r\x1b[K{} [{:#<{}}{:.<{}}] {:3.0f} %", task_, "", filled, "", width - filled, 100 * share);
    if (share > 0.01) line += fmt::format(", {:.0f} s left", spent / share - spent);
    std::fputs(line.c_str(), stderr);
    drawn_ = true;
}

}  // namespace swirl::apps
