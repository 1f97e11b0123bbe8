// D(Fᵏ) in 113 bits: a file for every two maps, since the map in that precision takes seconds to compile for each.
#pragma once

#include "map/derivative/saltation.hpp"
#include "map/numbers/quad.hpp"
#include "map/numbers/real.hpp"

#include <array>
#include <cstddef>

namespace swirl::studies {

using PreciseVector = Eigen::Matrix<Quad, Eigen::Dynamic, 1>;
using PreciseMatrix = Eigen::Matrix<Quad, Eigen::Dynamic, Eigen::Dynamic>;

/// D(Fᵏ)(z); false where an orbit has no next impact, or goes through sustained contact.
template <Shape shape, ImpactRule rule>
bool precise_derivative(const CollisionMap<Quad, shape, rule>& map, PreciseVector z, std::size_t k,
                        PreciseMatrix& product) {
    constexpr int dimension = section_dimension<shape>;
    product = PreciseMatrix::Identity(dimension, dimension);
    for (std::size_t i = 0; i < k; ++i) {
        std::array<Quad, dimension> c;
        for (int j = 0; j < dimension; ++j) c[static_cast<std::size_t>(j)] = z[j];
        const auto step = linearise_by_saltation(map, section_point<shape>(c));
        if (step.collision.outcome != FirstContactOutcome::contact) return false;
        product = (PreciseMatrix(step.derivative) * product).eval();
        const auto next = coordinates<shape>(section_point(step.collision.after));
        for (int j = 0; j < dimension; ++j) z[j] = next[static_cast<std::size_t>(j)];
    }
    return true;
}

extern template bool precise_derivative(const CollisionMap<Quad, Shape::disk, ImpactRule::frictionless>&, PreciseVector,
                                        std::size_t, PreciseMatrix&);
extern template bool precise_derivative(const CollisionMap<Quad, Shape::disk, ImpactRule::poisson>&, PreciseVector,
                                        std::size_t, PreciseMatrix&);
extern template bool precise_derivative(const CollisionMap<Quad, Shape::polygon, ImpactRule::frictionless>&,
                                        PreciseVector, std::size_t, PreciseMatrix&);
extern template bool precise_derivative(const CollisionMap<Quad, Shape::polygon, ImpactRule::poisson>&, PreciseVector,
                                        std::size_t, PreciseMatrix&);
extern template bool precise_derivative(const CollisionMap<Quad, Shape::polygon, ImpactRule::newton>&, PreciseVector,
                                        std::size_t, PreciseMatrix&);
extern template bool precise_derivative(const CollisionMap<Quad, Shape::polygon, ImpactRule::stronge>&, PreciseVector,
                                        std::size_t, PreciseMatrix&);

}  // namespace swirl::studies
