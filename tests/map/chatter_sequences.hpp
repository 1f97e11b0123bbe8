// Chatter followed impact by impact in 113 bits, to compare its sum with.
#pragma once

#include "map/contact/chatter_completion.hpp"
#include "map/contact/motion_choice.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "map/orbit/orbit.hpp"
#include "tests/map/contact_scenes.hpp"

#include <algorithm>

namespace swirl::tests {

/// The limit of a sequence of impacts.
struct Accumulation {
    bool found = false;
    bool sticks = true;  ///< every impact stopped the slip
    bool rests = false;  ///< the last one did
    Quad time{}, psi{}, chi{}, ut{}, spin{};
};

/// Followed until the body leaves the wall at less than `least`.
inline Accumulation impact_by_impact(const Scene<double>& s, PostImpactState<Quad> post_impact, const Quad& least) {
    return with_collision_map(scene_in<Quad>(s), [&](const auto& map) {
        Accumulation end;
        for (int i = 0; i < 1000; ++i) {
            const Quad ut = contact_kinematics(map.body(), post_impact).ut;
            if (-contact_kinematics(map.body(), post_impact).un < least) {
                const SectionPoint<Quad> last = section_point(post_impact);
                return Accumulation{true, end.sticks, end.rests, end.time, last.psi, last.chi, ut, post_impact.spin};
            }
            const Collision<Quad> next = map.advance(post_impact);
            if (next.outcome != FirstContactOutcome::contact || next.vertex_step != 0) return Accumulation{};
            end.rests = ends_in_stick(next.impulse.mode);
            end.sticks = end.sticks && end.rests;
            end.time += next.flight_time;
            post_impact = next.after;
        }
        return Accumulation{};
    });
}

/// The largest difference of place and velocities from `end` if chatter is replaced by contact at once; negative if the
/// contact changes its kind on the way, but for a slip that stops where chatter's stops, too.
template <class T>
double difference_from(const ContactScene<T>& scene, const PostImpactState<T>& post_impact, const Accumulation& end) {
    using std::abs;
    const Support support = scene.is_disk() ? Support::rim : Support::vertex;
    const ChatterCompletion<T> completion{true, support, {}, 0, T(0), T(0)};
    const ContactState<T> landed = landed_like(scene, post_impact, completion, post_impact);
    const MotionChoice<T> choice = choose_motion(scene, support, landed, 0);
    if (!choice.stays) return -1;
    ContactEnd<T> contact = run_contact(scene, support, choice.motion, landed, T(end.time));
    if (end.rests && contact.event == ContactEvent::stick) {
        contact.state.ut = T(0);
        contact = run_contact(scene, support, ContactMotion::sticking, contact.state, T(end.time - contact.sums.time));
    }
    if (contact.event != ContactEvent::horizon) return -1;
    const Vec2<T> n = cis(contact.state.psi), exact = cis(T(end.psi));
    const T velocity =
        std::max(T(abs(contact.state.ut - T(end.ut))), T(scene.body.alpha * abs(contact.state.spin - T(end.spin))));
    if (scene.is_disk())
        return static_cast<double>(std::max(velocity, T(scene.body.inner * detail::magnitude(n - exact))));
    const Vec2<T> arm = cis(T(contact.state.psi + contact.state.chi)) - cis(T(end.psi + end.chi));
    return static_cast<double>(std::max(velocity, detail::magnitude(n - exact - scene.body.alpha * arm)));
}

}  // namespace swirl::tests
