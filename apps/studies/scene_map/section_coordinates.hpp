// Points of the section as vectors, and back: (ψ, χ, v_n, v_t, S), of a disk the four (ψ, v_n, v_t, S).
#pragma once

#include "analysis/section_map.hpp"
#include "map/derivative/linearised_collision.hpp"

namespace swirl::studies {

inline constexpr int disk_dimension = section_dimension<Shape::disk>;
inline constexpr int polygon_dimension = section_dimension<Shape::polygon>;

template <int D>
inline constexpr Shape shape_of = D == disk_dimension ? Shape::disk : Shape::polygon;

template <int D>
analysis::Vector<D> coordinates_of(const SectionPoint<double>& z) {
    const auto c = swirl::coordinates<shape_of<D>>(z);
    return analysis::Vector<D>(c.data());
}

inline Eigen::VectorXd coordinates_of(const SectionPoint<double>& z, bool disk) {
    if (disk) return coordinates_of<disk_dimension>(z);
    return coordinates_of<polygon_dimension>(z);
}

/// Of a vector of either length.
template <class V>
SectionPoint<double> section_point_of(const Eigen::MatrixBase<V>& z) {
    if (z.size() == disk_dimension) return {z[0], 0, z[1], z[2], z[3]};
    return {z[0], z[1], z[2], z[3], z[4]};
}

}  // namespace swirl::studies
