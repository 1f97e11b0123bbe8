#include "apps/studies/branches/precise_derivative.hpp"
#include "map/numbers/quad.hpp"

#include <cstddef>

namespace swirl::studies {

template bool precise_derivative(const CollisionMap<Quad, Shape::disk, ImpactRule::frictionless>&, PreciseVector,
                                 std::size_t, PreciseMatrix&);
template bool precise_derivative(const CollisionMap<Quad, Shape::disk, ImpactRule::poisson>&, PreciseVector,
                                 std::size_t, PreciseMatrix&);

}  // namespace swirl::studies
