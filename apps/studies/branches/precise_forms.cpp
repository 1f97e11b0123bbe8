#include "apps/studies/branches/branches.hpp"
#include "apps/studies/branches/precise_derivative.hpp"
#include "map/derivative/parameter.hpp"
#include "map/numbers/quad.hpp"

#include <cstddef>

namespace swirl::studies {

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
