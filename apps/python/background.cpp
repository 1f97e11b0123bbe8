#include "apps/python/background.hpp"

#include <pybind11/pybind11.h>

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace swirl::python {

namespace {

namespace py = pybind11;
using std::chrono::milliseconds;

std::atomic<int> left_alone = 0;

/// Threads that were left alone use what the end of the process takes away: it ends without that.
void leave_without_them(int code, void*) {
    if (left_alone == 0) return;
    std::fflush(nullptr);
    ::_exit(code);
}

struct Ending {
    std::mutex mutex;
    std::condition_variable changed;
    bool over = false;

    /// True if it is over within that time.
    bool within(milliseconds time) {
        std::unique_lock lock(mutex);
        return changed.wait_for(lock, time, [this] { return over; });
    }
};

/// An exception of the handler of a signal, or of `look`.
std::exception_ptr raised_by(const std::function<void()>& look) {
    try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (look) look();
    } catch (...) {
        return std::current_exception();
    }
    return nullptr;
}

bool is_over_soon(Ending& ending, const Watch& watch) {
    if (ending.within(milliseconds(300))) return true;
    while (watch.is_finishing && watch.is_finishing())
        if (ending.within(milliseconds(20))) return true;
    return ending.within(milliseconds(0));
}

}  // namespace

Background run_beside(std::function<void()> work, const Watch& watch) {
    const auto ending = std::make_shared<Ending>();
    std::thread thread([ending, work = std::move(work)]() mutable {
        work();
        work = nullptr;
        const std::lock_guard lock(ending->mutex);
        ending->over = true;
        ending->changed.notify_all();
    });
    Background background;
    while (true) {
        bool over = false;
        {
            const py::gil_scoped_release others_go_on;
            over = ending->within(milliseconds(20));
        }
        if (over) break;
        background.raised = raised_by(watch.look);
        if (!background.raised) continue;
        if (watch.stop) watch.stop();
        const py::gil_scoped_release others_go_on;
        background.is_over = is_over_soon(*ending, watch);
        break;
    }
    if (background.is_over) {
        thread.join();
        return background;
    }
    if (left_alone++ == 0) ::on_exit(leave_without_them, nullptr);
    thread.detach();
    return background;
}

}  // namespace swirl::python
