// Apart from branches.cpp, since the map in 113 bits takes seconds to compile for each shape and rule.
#include "apps/studies/branches/branches.hpp"
#include "map/derivative/saltation.hpp"
#include "map/model/parameter.hpp"
#include "map/orbit/maps_in_quad.hpp"

#include <array>
#include <cstddef>

namespace swirl::studies {

namespace {

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

}  // namespace

analysis::HigherForms scene_forms(const Scene<double>& scene, Parameter parameter, const analysis::CyclePoints& points,
                                  double p) {
    const std::size_t k = points.size();
    return analysis::difference_forms<Quad>(
        [scene, parameter, k](const PreciseVector& z, const Quad& value, PreciseMatrix& product) {
            const Scene<Quad> there = with_parameter(scene_in<Quad>(scene), parameter, value);
            return with_collision_map(there, [&](const auto& map) { return precise_derivative(map, z, k, product); });
        },
        points.front(), p);
}

}  // namespace swirl::studies
