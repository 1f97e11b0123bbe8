// The one list of the maps there are: what is compiled once for each of them (collision map, return map)
// or for each number type of theirs (sustained contact) names it here: no loop instantiates templates, hence macros.
#pragma once

// DO(T) for every number type that there are maps over; whoever names Quad includes map/numbers/quad.hpp.
#define SWIRL_EVERY_NUMBER(DO) \
    DO(double)                 \
    DO(long double)            \
    DO(Quad)
// DO(T, SHAPE, RULE) for every map over the number type T.
#define SWIRL_EVERY_DISK_MAP(DO, T)              \
    DO(T, Shape::disk, ImpactRule::frictionless) \
    DO(T, Shape::disk, ImpactRule::poisson)
#define SWIRL_EVERY_POLYGON_MAP(DO, T)              \
    DO(T, Shape::polygon, ImpactRule::frictionless) \
    DO(T, Shape::polygon, ImpactRule::poisson)      \
    DO(T, Shape::polygon, ImpactRule::newton)       \
    DO(T, Shape::polygon, ImpactRule::stronge)
#define SWIRL_EVERY_MAP(DO, T) SWIRL_EVERY_DISK_MAP(DO, T) SWIRL_EVERY_POLYGON_MAP(DO, T)

// What they do: the instances of a class template over (T, SHAPE, RULE), or over the collision map of these.
#define SWIRL_DECLARE_COLLISION_MAP(T, SHAPE, RULE) extern template class CollisionMap<T, SHAPE, RULE>;
#define SWIRL_COMPILE_COLLISION_MAP(T, SHAPE, RULE) template class CollisionMap<T, SHAPE, RULE>;
#define SWIRL_DECLARE_RETURN_MAP(T, SHAPE, RULE) extern template class ReturnMap<CollisionMap<T, SHAPE, RULE>>;
#define SWIRL_COMPILE_RETURN_MAP(T, SHAPE, RULE) template class ReturnMap<CollisionMap<T, SHAPE, RULE>>;
