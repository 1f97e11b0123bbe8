#include "map/collision_map.hpp"

namespace swirl {

template class CollisionMap<double, Shape::disk, ImpactRule::frictionless>;
template class CollisionMap<double, Shape::disk, ImpactRule::poisson>;
template class CollisionMap<double, Shape::polygon, ImpactRule::frictionless>;
template class CollisionMap<double, Shape::polygon, ImpactRule::poisson>;
template class CollisionMap<double, Shape::polygon, ImpactRule::newton>;
template class CollisionMap<double, Shape::polygon, ImpactRule::stronge>;

}  // namespace swirl
