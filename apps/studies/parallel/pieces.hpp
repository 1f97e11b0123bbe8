// Independent pieces of work in parallel, of which a stop loses no finished one.
#pragma once

#include "apps/studies/parallel/run_control.hpp"

#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace swirl::studies {

/// Puts the result of a piece in its place. Empty: the piece was stopped, and has none.
using KeepResult = std::function<void()>;

/// Calls work(0) … work(count − 1), on `control.threads`, and what each of them gives under a lock, in the order in
/// which they end. A stop is heeded within 0.2 s, whatever a piece is at: pieces that have not ended by then are left
/// to end by themselves, and nothing more is kept. So `work` owns what it uses, or shares it.
///   task  named to `control.begin_task`, with `count` as its total; empty: nothing is reported
/// @return false if not all are done: it was stopped. Exceptions of a piece are passed on.
bool run_pieces(std::size_t count, const std::string& task, const RunControl& control,
                const std::function<KeepResult(std::size_t)>& work);

/// Results that a piece gives one by one, so that those before a stop are kept, whatever it is at. Pieces that
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

}  // namespace swirl::studies
