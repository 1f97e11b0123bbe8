#include "apps/studies/tradeoff/arithmetic_in.hpp"
#include "map/orbit/maps_in_quad.hpp"

#include <string_view>

namespace swirl::studies::tradeoff {

template Arithmetic arithmetic<InNumbers<Quad>>(std::string_view, std::string_view, bool);

}  // namespace swirl::studies::tradeoff
