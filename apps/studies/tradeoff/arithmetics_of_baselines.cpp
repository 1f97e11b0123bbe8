#include "apps/studies/tradeoff/arithmetic_in.hpp"

#include <string_view>

namespace swirl::studies::tradeoff {

template Arithmetic arithmetic<WithSearch<BaselineSearch::paper>>(std::string_view, std::string_view, bool);
template Arithmetic arithmetic<WithSearch<BaselineSearch::brent>>(std::string_view, std::string_view, bool);
template Arithmetic arithmetic<WithSearch<BaselineSearch::fixed_step>>(std::string_view, std::string_view, bool);

}  // namespace swirl::studies::tradeoff
