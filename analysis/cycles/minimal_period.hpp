// The minimal period of k points that F maps to each other.
#pragma once

#include <cstddef>

namespace swirl::analysis {

/// The smallest divisor d of k after which every one of the points comes again, to `closure`. One point is not enough:
/// near a flip a cycle of twice the period may nearly come again at some of its points.
///   distance  (i, j) ↦ the distance of points i and j
template <class Distance>
std::size_t minimal_period(std::size_t k, double closure, const Distance& distance) {
    for (std::size_t d = 1; d < k; ++d) {
        if (k % d != 0) continue;
        bool closes = true;
        for (std::size_t i = 0; closes && i < k; ++i) closes = distance(i, (i + d) % k) <= closure;
        if (closes) return d;
    }
    return k;
}

}  // namespace swirl::analysis
