#include "apps/studies/tradeoff/arithmetic_in.hpp"

#include <string_view>

namespace swirl::studies::tradeoff {

template Arithmetic arithmetic<InNumbers<double>>(std::string_view, std::string_view, bool);

}  // namespace swirl::studies::tradeoff
