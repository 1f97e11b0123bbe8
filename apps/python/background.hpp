// Work beside Python: on a thread of its own, without the interpreter's lock, while the thread that called looks at
// signals.
#pragma once

#include <exception>
#include <functional>

namespace swirl::python {

/// What the waiting thread does meanwhile; the two functions are called with the interpreter's lock.
struct Watch {
    std::function<void()> look = {};          ///< some fifty times a second; may throw, which stops the work
    std::function<void()> stop = {};          ///< once, where a signal's handler (Ctrl-C) or `look` has thrown
    std::function<bool()> is_finishing = {};  ///< what is finished is being written: waited for, however long
};

struct Background {
    std::exception_ptr raised;  ///< what stopped the work; none: nothing
    bool is_over = true;        ///< false: it has not ended 0.3 s after its stop, and is left to end by itself
};

/// Calls `work`, which throws nothing and shares or owns all that it uses, and comes back when it is over. A work of
/// some microseconds costs a thread more, some 20 µs.
Background run_beside(std::function<void()> work, const Watch& watch);

}  // namespace swirl::python
