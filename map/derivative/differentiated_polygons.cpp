#include "map/derivative/derivative.hpp"

namespace swirl {

template class DifferentiatedMap<double, Shape::polygon, ImpactRule::frictionless>;
template class DifferentiatedMap<double, Shape::polygon, ImpactRule::poisson>;

}  // namespace swirl
