// Work on a number of threads that a user may choose.
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

namespace swirl::analysis {

/// What `work` returns, whose parallel loops (of oneTBB) run on `threads` threads, which may be more than there are
/// processors; 0: on as many as there are.
template <class Work>
auto on_threads(int threads, const Work& work) {
    constexpr auto most = tbb::global_control::max_allowed_parallelism;
    const tbb::global_control allowed(
        most, std::max(static_cast<std::size_t>(threads), tbb::global_control::active_value(most)));
    tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
    return arena.execute(work);
}

}  // namespace swirl::analysis
