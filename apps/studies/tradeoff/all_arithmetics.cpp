#include "apps/studies/tradeoff/arithmetic_in.hpp"
#include "map/numbers/quad.hpp"

#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace swirl::studies::tradeoff {

// Compiled in files of their own, arithmetics_in_*.cpp and arithmetics_of_baselines.cpp.
extern template Arithmetic arithmetic<InNumbers<double>>(std::string_view, std::string_view, bool);
extern template Arithmetic arithmetic<InNumbers<long double>>(std::string_view, std::string_view, bool);
extern template Arithmetic arithmetic<InNumbers<Quad>>(std::string_view, std::string_view, bool);
extern template Arithmetic arithmetic<WithSearch<BaselineSearch::paper>>(std::string_view, std::string_view, bool);
extern template Arithmetic arithmetic<WithSearch<BaselineSearch::brent>>(std::string_view, std::string_view, bool);
extern template Arithmetic arithmetic<WithSearch<BaselineSearch::fixed_step>>(std::string_view, std::string_view, bool);

namespace {

constexpr bool has_extended = std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits;

std::vector<Arithmetic> table() {
    std::vector<Arithmetic> arithmetics;
    arithmetics.reserve(6);
    arithmetics.push_back(
        arithmetic<InNumbers<double>>("double", "double precision: the first contact proven, to rounding", true));
    if (has_extended)
        arithmetics.push_back(arithmetic<InNumbers<long double>>("extended", "the same in long double", true));
    arithmetics.push_back(arithmetic<WithSearch<BaselineSearch::paper>>(
        "paper", "the report's solver: guesses, bisection, Newton", false));
    arithmetics.push_back(
        arithmetic<WithSearch<BaselineSearch::brent>>("brent", "changes of sign 0.01 apart, Brent's method", false));
    arithmetics.push_back(
        arithmetic<WithSearch<BaselineSearch::fixed_step>>("fixed-step", "steps of 0.01, put back", false));
    arithmetics.push_back(
        arithmetic<InNumbers<Quad>>("quad", "the same in 113 bits: what the others are compared with", true));
    return arithmetics;
}

}  // namespace

std::span<const Arithmetic> all_arithmetics() {
    static const std::vector<Arithmetic> arithmetics = table();
    return arithmetics;
}

}  // namespace swirl::studies::tradeoff
