// A flight, what touches the wall on it, and an impact of a vertex that is named beforehand, all as smooth functions of
// the state, the time and two parameters: no search, no branch but the contact mode. For cycles on the borders of the
// map, where its own first contact is one thing on one side and another on the other.
#pragma once

#include "map/derivative/linearised_collision.hpp"
#include "map/first_contact/vertices.hpp"
#include "map/model/parameter.hpp"
#include "map/numbers/jets.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>

namespace swirl {

/// By z (in the section's order), the time, the first and the second parameter.
template <class T, Shape shape>
struct ItineraryUnknowns {
    static constexpr int count = section_dimension<shape> + 3;
    using Row = Eigen::Matrix<T, 1, count>;
};

/// g = |x|² − 1 of a vertex (disk: |X|² − (1 − α)²) and g′ at a time, with their derivatives.
template <class T, Shape shape>
struct ItineraryTouch {
    T gap{}, rate{};
    typename ItineraryUnknowns<T, shape>::Row gap_by, rate_by;
};

/// What decides the contact mode of an impact (map/README.md, "Impact"): zero where F is continuous and DF jumps. p_k
/// is the impulse at which slip would stop (of a disk with e_t be returned, (1 + e_t) times that); meaningless where it
/// never does (`stops` false).
template <class T, Shape shape>
struct ModeMargins {
    using Row = typename ItineraryUnknowns<T, shape>::Row;
    bool stops = false;
    T slip{}, late{}, held{};  ///< p_k − p_end; C(p_k); |B₃| − μB₁
    Row slip_by, late_by, held_by;
};

/// The state after the impact of a vertex at a time, as if it were on the wall then.
template <class T, Shape shape>
struct ItineraryCollision {
    ItineraryTouch<T, shape> touch;  ///< of the vertex that strikes
    std::array<T, section_dimension<shape>> after;
    Eigen::Matrix<T, section_dimension<shape>, ItineraryUnknowns<T, shape>::count> after_by;
    ContactMode mode = ContactMode::frictionless;
    ModeMargins<T, shape> margins;
};

namespace detail {

/// From the state after an impact and its impulse: u before it is that after it with B₂p + B₃q and −B₃p − B₁q added.
template <class T, Shape shape, ImpactRule rule, class Jet>
ModeMargins<T, shape> margins_of(const CollisionMap<Jet, shape, rule>& map, const Collision<Jet>& collision) {
    ModeMargins<T, shape> margins;
    if constexpr (rule == ImpactRule::frictionless) return margins;
    const ContactKinematics<Jet> after = contact_kinematics(map.body(), collision.after);
    const Jet p = collision.impulse.normal, q = collision.impulse.tangential;
    const Jet b1 = after.b1(), b2 = after.b2(), b3 = after.b3(), stick = map.scene().mu * b1;
    const Jet un = after.un + b2 * p + b3 * q, ut = after.ut - b3 * p - b1 * q;
    const Jet sign = Jet(T(plain(ut) < 0 ? -1 : 1));
    const Jet slowing = stick - sign * b3;
    margins.stops = plain(slowing) > 0;
    const Jet stopped = (Jet(T(1)) + map.body().tangential_restitution) * (sign * ut / slowing);
    const Jet late = (b2 - map.scene().mu * sign * b3) * stopped - un;
    const Jet held = (plain(b3) < 0 ? -b3 : b3) - stick;
    const Jet slip = stopped - p;
    margins.slip = slip.a;
    margins.late = late.a;
    margins.held = held.a;
    margins.slip_by = slip.v.transpose();
    margins.late_by = late.v.transpose();
    margins.held_by = held.v.transpose();
    return margins;
}

/// The flight from z and its moment `time`, in Jets of all unknowns.
template <class T, Shape shape, ImpactRule rule>
struct SeededFlight {
    using Jet = ceres::Jet<T, ItineraryUnknowns<T, shape>::count>;

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
        int seed = 0;
        std::transform(c.begin(), c.end(), seeds.begin(), [&](const T& x) { return Jet(x, seed++); });
        flight = flight_from(map.body(), post_impact_state(section_point<shape>(seeds)));
        at = instant_at<shape>(flight, Jet(time, dimension));
        if constexpr (shape == Shape::polygon) arm = map.body().turned_to_vertex(at.arm, vertex);
    }

    ItineraryTouch<T, shape> touch() const {
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
ItineraryTouch<T, shape> touch_by_itinerary(const Scene<T>& scene, Parameter first, Parameter second,
                                            const SectionPoint<T>& z, const T& time, int vertex) {
    return detail::SeededFlight<T, shape, rule>(scene, first, second, z, time, vertex).touch();
}

/// Cost: some eight collisions. An approach of u_n < 0 counts as u_n = 0.
template <class T, Shape shape, ImpactRule rule>
ItineraryCollision<T, shape> collide_by_itinerary(const Scene<T>& scene, Parameter first, Parameter second,
                                                  const SectionPoint<T>& z, const T& time, int vertex) {
    using Seeded = detail::SeededFlight<T, shape, rule>;
    const Seeded seeded(scene, first, second, z, time, vertex);
    Collision<typename Seeded::Jet> collision;
    seeded.map.strike(seeded.flight, seeded.at, shape == Shape::disk ? seeded.at.centre : seeded.arm, 0, collision);
    ItineraryCollision<T, shape> result;
    result.touch = seeded.touch();
    const auto next = coordinates<shape>(section_point(collision.after));
    for (int i = 0; i < section_dimension<shape>; ++i) {
        result.after[static_cast<std::size_t>(i)] = next[static_cast<std::size_t>(i)].a;
        result.after_by.row(i) = next[static_cast<std::size_t>(i)].v.transpose();
    }
    result.mode = collision.impulse.mode;
    result.margins = detail::margins_of<T, shape, rule>(seeded.map, collision);
    return result;
}

}  // namespace swirl
