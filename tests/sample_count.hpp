// How many random cases a test runs: all of them, or fewer where a sanitizer makes each one slow.
#pragma once

namespace swirl::tests {

/// `full` cases in an ordinary build; a twentieth (at least one) in a sanitizer build, which looks for memory errors
/// and undefined behaviour in the same code paths and takes about that many times longer.
constexpr long sample_count(long full) {
#ifdef SWIRL_SANITIZED
    return full < 20 ? 1 : full / 20;
#else
    return full;
#endif
}

}  // namespace swirl::tests
