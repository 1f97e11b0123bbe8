#include "apps/studies/tradeoff/rung_in.hpp"
#include "map/numbers/quad.hpp"

namespace swirl::studies::tradeoff {

template Rung rung<InNumbers<Quad>>(std::string_view, std::string_view, bool);

}  // namespace swirl::studies::tradeoff
