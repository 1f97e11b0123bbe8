// A sum with what its rounding leaves out.
#pragma once

namespace swirl {

/// a + b = sum + rest, exactly.
template <class T>
struct ExactSum {
    T sum{}, rest{};
};

/// Whichever of the two is larger. Cost: six sums. Source: D. E. Knuth, The Art of Computer Programming 2 (1969),
/// section 4.2.2, theorem B.
template <class T>
inline ExactSum<T> exact_sum(const T& a, const T& b) {
    const T sum = a + b;
    const T kept = sum - a;  // of b
    return {sum, (a - (sum - kept)) + (b - kept)};
}

}  // namespace swirl
