#include "apps/studies/tradeoff/rung_with_search.hpp"
#include "map/numbers/quad.hpp"

#include <limits>

namespace swirl::studies::tradeoff {

// Compiled in files of their own, rungs_in_*.cpp and rungs_of_baselines.cpp.
extern template Rung rung<InNumbers<double>>(std::string_view, std::string_view, bool);
extern template Rung rung<InNumbers<long double>>(std::string_view, std::string_view, bool);
extern template Rung rung<InNumbers<Quad>>(std::string_view, std::string_view, bool);
extern template Rung rung<WithSearch<BaselineSearch::paper>>(std::string_view, std::string_view, bool);
extern template Rung rung<WithSearch<BaselineSearch::brent>>(std::string_view, std::string_view, bool);
extern template Rung rung<WithSearch<BaselineSearch::fixed_step>>(std::string_view, std::string_view, bool);

namespace {

constexpr bool has_extended = std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits;

std::vector<Rung> table() {
    std::vector<Rung> rungs;
    rungs.reserve(6);
    rungs.push_back(rung<InNumbers<double>>("double", "double precision: the first contact proven, to rounding", true));
    if (has_extended) rungs.push_back(rung<InNumbers<long double>>("extended", "the same in long double", true));
    rungs.push_back(
        rung<WithSearch<BaselineSearch::paper>>("paper", "the report's solver: guesses, bisection, Newton", false));
    rungs.push_back(
        rung<WithSearch<BaselineSearch::brent>>("brent", "changes of sign 0.01 apart, Brent's method", false));
    rungs.push_back(rung<WithSearch<BaselineSearch::fixed_step>>("fixed-step", "steps of 0.01, put back", false));
    rungs.push_back(rung<InNumbers<Quad>>("quad", "the same in 113 bits: what the others are compared with", true));
    return rungs;
}

}  // namespace

std::span<const Rung> all_rungs() {
    static const std::vector<Rung> rungs = table();
    return rungs;
}

}  // namespace swirl::studies::tradeoff
