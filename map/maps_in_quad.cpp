#include "map/collision_map.hpp"

namespace swirl {

template class CollisionMap<Quad, Shape::disk, ImpactRule::frictionless>;
template class CollisionMap<Quad, Shape::disk, ImpactRule::poisson>;
template class CollisionMap<Quad, Shape::polygon, ImpactRule::frictionless>;
template class CollisionMap<Quad, Shape::polygon, ImpactRule::poisson>;
template class CollisionMap<Quad, Shape::polygon, ImpactRule::newton>;
template class CollisionMap<Quad, Shape::polygon, ImpactRule::stronge>;

}  // namespace swirl
