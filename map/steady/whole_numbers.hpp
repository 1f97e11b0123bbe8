// Where a smooth function of one variable is a whole number.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace swirl::steady {

struct WholeNumber {
    double at = 0;
    long long value = 0;
};

struct WholeNumbers {
    std::vector<WholeNumber> found;  ///< by rising `at`
    double complete_to = 0;          ///< all of [from, this] are listed; less than `to` if there were more than allowed
};

/// All x in [from, to] with f(x) ∈ ℤ: f at `cells` + 1 points, which lie closer towards both ends (a root of the
/// distance from an end is smooth in them); where it turns between them the extremum is located and added, so that two
/// roots about it are both found. Missed is only what f does by turning twice within a cell.
/// At most `most` are listed, those of the cells from `from` on. Each root is bracketed to rounding. Cost: `cells`
/// values of f and some ten for each extremum and root.
WholeNumbers whole_numbers(const std::function<double(double)>& f, double from, double to, int cells, std::size_t most);

}  // namespace swirl::steady
