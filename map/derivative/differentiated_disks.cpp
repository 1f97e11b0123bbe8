#include "map/derivative/derivative.hpp"

namespace swirl {

template class DifferentiatedMap<double, Shape::disk, ImpactRule::frictionless>;
template class DifferentiatedMap<double, Shape::disk, ImpactRule::poisson>;

}  // namespace swirl
