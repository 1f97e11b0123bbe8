#include "apps/studies/tradeoff/rung_with_search.hpp"

namespace swirl::studies::tradeoff {

template Rung rung<WithSearch<BaselineSearch::paper>>(std::string_view, std::string_view, bool);
template Rung rung<WithSearch<BaselineSearch::brent>>(std::string_view, std::string_view, bool);
template Rung rung<WithSearch<BaselineSearch::fixed_step>>(std::string_view, std::string_view, bool);

}  // namespace swirl::studies::tradeoff
