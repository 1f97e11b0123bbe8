#include "apps/branches/branches.hpp"
#include "map/derivative/parameter.hpp"
#include "map/numbers/real.hpp"

namespace swirl::apps {

namespace {

using State = Eigen::Matrix<Quad, Eigen::Dynamic, 1>;
using Square = Eigen::Matrix<Quad, Eigen::Dynamic, Eigen::Dynamic>;

/// D(Fᵏ)(z) in 113 bits; false where an orbit has no next impact, or goes through sustained contact.
template <Shape shape, ImpactRule rule>
bool derivative_of(const CollisionMap<Quad, shape, rule>& map, State z, std::size_t k, Square& product) {
    constexpr int dimension = section_dimension<shape>;
    const DifferentiatedMap differentiated(map);
    product = Square::Identity(dimension, dimension);
    for (std::size_t i = 0; i < k; ++i) {
        std::array<Quad, dimension> c;
        for (int j = 0; j < dimension; ++j) c[static_cast<std::size_t>(j)] = z[j];
        const auto step = differentiated.linearise(section_point<shape>(c));
        if (step.collision.outcome != FirstContactOutcome::contact) return false;
        product = (Square(step.derivative) * product).eval();
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
        [scene, parameter, k](const State& z, const Quad& value, Square& product) {
            const Scene<Quad> there = with_parameter(scene_in<Quad>(scene), parameter, value);
            return with_collision_map(there, [&](const auto& map) { return derivative_of(map, z, k, product); });
        },
        points.front(), p);
}

}  // namespace swirl::apps
