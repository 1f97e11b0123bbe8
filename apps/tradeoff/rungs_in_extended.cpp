#include "apps/tradeoff/rung_in.hpp"

namespace swirl::apps::tradeoff {

template Rung rung<InNumbers<long double>>(std::string_view, std::string_view, bool);

}  // namespace swirl::apps::tradeoff
