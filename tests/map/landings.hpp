// Landings of random orbits, and the way from there through contact to the impact after it, in any number type.
#pragma once

#include "map/orbit/orbit.hpp"
#include "tests/map/contact_scenes.hpp"
#include "tests/map/random_scenes.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace swirl::tests {

inline char digit(Support support) {
    return static_cast<char>('0' + static_cast<int>(support));
}

/// A landing and the impact that ends the contact after it.
template <class T>
struct ContactReturn {
    PostImpactState<T> after;
    T time{}, turned{}, work{};  ///< from the start; `work` also by the impacts on the way
    T exchanged{};               ///< Σ of the magnitudes of J's changes
    std::string way;             ///< the supports and how they ended: returns are compared where it is the same
    std::string supports;        ///< the supports alone, the last event and the impact
    double landing_error = 0;
};

/// From just after an impact through chatter and the next contact, to the impact after it.
template <class Map>
std::optional<ContactReturn<typename Map::Number>> contact_return(const Map& map,
                                                                  const PostImpactState<typename Map::Number>& z) {
    using T = typename Map::Number;
    using std::abs;
    const ReturnMap<Map> returns(map);
    ContactReturn<T> p;
    PostImpactState<T> at = z;
    for (int i = 0; i < 1000; ++i) {
        const ReturnStep<T> step = returns.advance(at, 50);
        if (step.outcome != Outcome::completed) return {};
        const Collision<T>& c = step.collision;
        p.time += c.flight_time;
        p.turned += step.turned;
        p.work += c.jacobi_restitution + c.jacobi_friction + step.contact_work;
        p.exchanged += abs(c.jacobi_restitution) + abs(c.jacobi_friction) + abs(step.contact_work);
        at = p.after = c.after;
        if (step.contacts.empty()) continue;
        for (const ContactSegment& piece : step.contacts)
            if (piece.end > piece.start || piece.finish == ContactEvent::strike)
                for (const std::string_view itinerary : {name_of(piece.support, piece.motion), name_of(piece.finish)})
                    p.way.append(itinerary).append(1, digit(piece.support)).append(", ");
        p.way += name_of(c.impulse.mode);
        for (const ContactSegment& piece : step.contacts)
            if (piece.end > piece.start && (p.supports.empty() || p.supports.back() != digit(piece.support)))
                p.supports += digit(piece.support);
        p.supports.insert(0, 1, ' ').insert(0, name_of(step.contacts.back().finish));
        p.supports.append(1, ' ').append(std::to_string(c.vertex_step)).append(1, ' ').append(name_of(c.impulse.mode));
        p.landing_error = step.contacts.front().error;
        return p;
    }
    return {};
}

/// A state in T. A u_n (e = 0) or u_t (the impact stuck) that is rounding in double is zero, as it would be in
/// T.
template <class T>
PostImpactState<T> widened(const Body<T>& body, const PostImpactState<double>& narrow) {
    using std::abs;
    const T rounding(1e-14);
    const SectionPoint<double> z = section_point(narrow);
    PostImpactState<T> wide = post_impact_state(SectionPoint<T>{T(z.psi), T(z.chi), T(z.vn), T(z.vt), T(z.spin)});
    const ContactKinematics<T> u = contact_kinematics(body, wide);
    if (abs(u.un) < rounding) wide.vn -= u.un;
    if (abs(u.ut) < rounding) wide.vt -= u.ut;
    return wide;
}

/// A scene and an impact from which chatter and contact follow.
struct Landing {
    Scene<double> scene;
    PostImpactState<double> from;
};

/// The first landing of an orbit of a random scene, if it has one that leads on to an impact. Not in the midst of
/// rocking, where it depends on the digits at which impact contact begins and the next impact is that of a vertex
/// within 10⁻⁷ of the wall.
inline std::optional<Landing> random_landing(Random& random, int sides) {
    const Law law = static_cast<Law>(random.one_of({0, 1, 2}));
    const double e = random.chance(0.3) ? 0 : random.between(0, 0.8),
                 mu = random.chance(0.2) ? 0 : random.between(0, 1);
    const Scene<double> scene = random_scene(random, sides, mu, e, law);
    const SectionPoint<double> z = random_point(random, scene, 0.2);
    return with_collision_map(scene, [&](const auto& map) -> std::optional<Landing> {
        const ReturnMap returns(map);
        PostImpactState<double> at = post_impact_state(z);
        for (int i = 0; i < 1000; ++i) {
            const ReturnStep<double> step = returns.advance(at, 50);
            if (step.outcome != Outcome::completed) return {};
            if (!step.contacts.empty() && step.contacts.back().end < 1e-3) return {};
            if (!step.contacts.empty()) return Landing{scene, at};
            at = step.collision.after;
        }
        return {};
    });
}

}  // namespace swirl::tests
