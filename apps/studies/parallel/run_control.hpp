// What a study asks of the program that it runs in: when to stop, whom to tell how far it is, and how many threads to
// take.
#pragma once

#include <functional>
#include <string>

namespace swirl::studies {

/// Told how much of a task is done, 0 up to the task's total, by one thread at a time. It is destroyed when the task is
/// over.
using ReportDone = std::function<void(double done)>;

struct RunControl {
    /// Asked often, by any thread; true: end soon, with what is finished. Empty: never.
    std::function<bool()> stop = {};
    int threads = 0;  ///< 0: all
    /// Called as a task begins, with its name and total. Empty: nothing is reported.
    std::function<ReportDone(const std::string& task, double total)> begin_task = {};

    bool is_stopped() const { return stop && stop(); }
    ReportDone begin(const std::string& task, double total) const {
        return begin_task ? begin_task(task, total) : ReportDone([](double) {});
    }
};

}  // namespace swirl::studies
