#include "map/orbit/return_map.hpp"

namespace swirl {

template class ReturnMap<CollisionMap<long double, Shape::disk, ImpactRule::frictionless>>;
template class ReturnMap<CollisionMap<long double, Shape::disk, ImpactRule::poisson>>;
template class ReturnMap<CollisionMap<long double, Shape::polygon, ImpactRule::frictionless>>;
template class ReturnMap<CollisionMap<long double, Shape::polygon, ImpactRule::poisson>>;
template class ReturnMap<CollisionMap<long double, Shape::polygon, ImpactRule::newton>>;
template class ReturnMap<CollisionMap<long double, Shape::polygon, ImpactRule::stronge>>;

}  // namespace swirl
