// Independent pieces of work in parallel, of which an interruption loses no finished one.
#pragma once

#include "apps/command_line/progress.hpp"

#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace swirl::apps {

/// Puts the result of a piece in its place. Empty: the piece was stopped, and has none.
using KeepResult = std::function<void()>;

/// Calls work(0) … work(count − 1), on so many threads (0: all), and what each of them gives under a lock, in the order
/// in which they end. After note_interruptions() an interruption is heeded within 0.2 s, whatever a piece is at: pieces
/// that have not ended by then are left alone, and nothing more is kept. What they use to their end must live until the
/// process ends, as the options of a command do.
/// @return false if not all are done: it was interrupted. Exceptions of a piece are passed on.
bool run_pieces(std::size_t count, int threads, Progress& progress, const std::function<KeepResult(std::size_t)>& work);

/// Results that a piece gives one by one, so that those before an interruption are kept, whatever it is at. Pieces that
/// are left alone may still add to it: they share it.
template <class Result>
class Gathered {
public:
    void add(Result result) {
        const std::lock_guard lock(mutex_);
        results_.push_back(std::move(result));
    }
    /// All so far, in the order in which they came.
    std::vector<Result> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(results_, {});
    }

private:
    std::mutex mutex_;
    std::vector<Result> results_;
};

}  // namespace swirl::apps
