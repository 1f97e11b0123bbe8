// A flight, what touches the wall on it, and an impact of a vertex that is named beforehand, all as smooth functions of
// the state, the time and two parameters: no search, no branch but the contact mode. For cycles on the borders of the
// map, where its own first contact is one thing on one side and another on the other.
#pragma once

#include "map/derivative/parameter.hpp"
#include "map/first_contact/vertices.hpp"

#include <Eigen/Core>

#include <array>

namespace swirl {

/// By z (in the section's order), the time, the first and the second parameter.
template <class T, Shape shape>
struct WordUnknowns {
    static constexpr int count = section_dimension<shape> + 3;
    using Row = Eigen::Matrix<T, 1, count>;
};

/// g = |x|² − 1 of a vertex (disk: |X|² − (1 − α)²) and g′ at a time, with their derivatives.
template <class T, Shape shape>
struct WordTouch {
    T gap{}, rate{};
    typename WordUnknowns<T, shape>::Row gap_by, rate_by;
};

/// The state after the impact of a vertex at a time, as if it were on the wall then.
template <class T, Shape shape>
struct WordCollision {
    WordTouch<T, shape> touch;  ///< of the vertex that strikes
    std::array<T, section_dimension<shape>> after;
    Eigen::Matrix<T, section_dimension<shape>, WordUnknowns<T, shape>::count> after_by;
    ContactMode mode = ContactMode::frictionless;
};

namespace detail {

/// The flight from z and its moment `time`, in Jets of all unknowns.
template <class T, Shape shape, ImpactRule rule>
struct SeededFlight {
    using Jet = ceres::Jet<T, WordUnknowns<T, shape>::count>;

    CollisionMap<Jet, shape, rule> map;
    Flight<Jet> flight;
    Instant<Jet> at;
    Vec2<Jet> arm;  ///< of the vertex

    SeededFlight(const Scene<T>& scene, Parameter first, Parameter second, const SectionPoint<T>& z, const T& time,
                 int vertex)
        : map(in_jets(scene, first, second)) {
        constexpr int dimension = section_dimension<shape>;
        const auto c = coordinates<shape>(z);
        std::array<Jet, dimension> seeds;
        for (int i = 0; i < dimension; ++i) seeds[static_cast<std::size_t>(i)] = Jet(c[static_cast<std::size_t>(i)], i);
        flight = flight_from(map.body(), post_impact_state(section_point<shape>(seeds)));
        at = instant_at<shape>(flight, Jet(time, dimension));
        if constexpr (shape == Shape::polygon) arm = map.body().turned_to_vertex(at.arm, vertex);
    }

    WordTouch<T, shape> touch() const {
        Jet gap, rate;
        if constexpr (shape == Shape::disk) {
            gap = dot(at.centre, at.centre) - map.body().inner * map.body().inner;
            rate = Jet(T(2)) * dot(at.centre, at.drift);
        } else {
            const Vec2<Jet> x = at.centre + arm;
            gap = dot(x, x) - Jet(T(1));
            rate = Jet(T(2)) * dot(x, at.drift + flight.spin * quarter_turned(arm));
        }
        return {gap.a, rate.a, gap.v.transpose(), rate.v.transpose()};
    }

private:
    static Scene<Jet> in_jets(const Scene<T>& scene, Parameter first, Parameter second) {
        constexpr int dimension = section_dimension<shape>;
        Scene<Jet> jets = scene_in<Jet>(scene);
        number_of(jets, first).v[dimension + 1] = T(1);
        number_of(jets, second).v[dimension + 2] = T(1);
        return jets;
    }
};

}  // namespace detail

/// Cost: one flight in Jets of dimension + 3, some four collisions.
template <class T, Shape shape, ImpactRule rule>
WordTouch<T, shape> touch_by_word(const Scene<T>& scene, Parameter first, Parameter second, const SectionPoint<T>& z,
                                  const T& time, int vertex) {
    return detail::SeededFlight<T, shape, rule>(scene, first, second, z, time, vertex).touch();
}

/// Cost: some eight collisions. An approach of u_n < 0 counts as u_n = 0.
template <class T, Shape shape, ImpactRule rule>
WordCollision<T, shape> collide_by_word(const Scene<T>& scene, Parameter first, Parameter second,
                                        const SectionPoint<T>& z, const T& time, int vertex) {
    using Seeded = detail::SeededFlight<T, shape, rule>;
    const Seeded seeded(scene, first, second, z, time, vertex);
    Collision<typename Seeded::Jet> collision;
    seeded.map.strike(seeded.flight, seeded.at, shape == Shape::disk ? seeded.at.centre : seeded.arm, collision);
    WordCollision<T, shape> result;
    result.touch = seeded.touch();
    const auto next = coordinates<shape>(section_point(collision.after));
    for (int i = 0; i < section_dimension<shape>; ++i) {
        result.after[static_cast<std::size_t>(i)] = next[static_cast<std::size_t>(i)].a;
        result.after_by.row(i) = next[static_cast<std::size_t>(i)].v.transpose();
    }
    result.mode = collision.impulse.mode;
    return result;
}

}  // namespace swirl
