#include "map/derivative/derivative.hpp"

namespace swirl {

template class DifferentiatedMap<double, Shape::polygon, ImpactRule::newton>;
template class DifferentiatedMap<double, Shape::polygon, ImpactRule::stronge>;

}  // namespace swirl
