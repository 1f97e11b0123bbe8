#include "map/contact/contact_phase.hpp"

#include "map/contact/contact_watch.hpp"
#include "map/contact/motion_choice.hpp"
#include "map/map_list.hpp"
#include "map/numbers/quad.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace swirl {

namespace {

using std::copysign;

/// After more consecutive pieces of zero duration contact is called unresolved.
constexpr int most_idle_pieces = 50;

/// After so many pieces contact is not followed further.
constexpr std::size_t most_pieces = 100'000;

template <class T>
struct Follower {
    const ContactScene<T>& scene;
    const ContactSink& sink;
    ContactPhase<T> phase;
    T settled_jacobi{};  ///< change of J when a neighbour came to rest: part of the next piece's landing
    long steps_left = most_contact_steps;

    void finish(ContactEvent event, const PostImpactState<T>& post_impact, int vertex_step) {
        phase.finish = event;
        phase.strike.after = post_impact;
        phase.vertex_step = vertex_step;
    }

    void jam(const MotionChoice<T>& choice) {
        PostImpactState<T> post_impact = post_impact_state(scene, choice.state);
        phase.strike.impulse = jam_once(scene, post_impact, phase.strike);
        phase.resolved = phase.strike.impulse.normal > 0;
        finish(ContactEvent::jam, post_impact, choice.vertex_step);
    }

    /// The neighbour of a vertex in contact strikes, at the end `z` of a piece.
    void strike(ContactState<T> z, int vertex_step, bool plastic) {
        z.chi = copysign(scene.widest_chi, z.chi);
        phase.strike = strike_in_contact(scene, post_impact_state(scene, z), plastic);
        phase.resolved = phase.strike.resolved;
        finish(ContactEvent::strike, phase.strike.after, vertex_step + (z.chi > 0 ? -1 : 1));
    }

    /// A neighbour on the wall that does not approach, its rebound being below rounding: it rests there, without an
    /// impact.
    std::optional<MotionChoice<T>> settled_neighbour(ContactState<T> z, int vertex_step) {
        z.chi = copysign(scene.widest_chi, z.chi);
        const PostImpactState<T> completion = post_impact_state(scene, z);
        if (contact_kinematics(scene.body, seen_from_neighbour(scene, completion)).un > 0) return {};
        const Strike<T> rest = strike_in_contact(scene, completion, true);
        const ChatterCompletion<T> on = chatter_completion(scene, rest.after);
        if (!on.in_contact || on.support != Support::edge) return {};
        settled_jacobi = rest.jacobi_restitution + rest.jacobi_friction + on.jacobi;
        phase.sums.work += settled_jacobi;
        const int step = vertex_step + (z.chi > 0 ? -1 : 1) + on.vertex_step;
        return MotionChoice<T>{true, Support::edge, ContactMotion::sticking, on.state, step, ContactEvent::strike};
    }

    /// Adds a piece to the sums and to what is reported.
    void add(const MotionChoice<T>& choice, ContactEvent begin, const ContactEnd<T>& end) {
        const auto number = [](const T& x) { return static_cast<double>(x); };
        steps_left -= end.steps;
        const double start = number(phase.sums.time);
        phase.sums.time += end.sums.time;
        phase.sums.turned += end.sums.turned;
        phase.sums.work += end.sums.work;
        phase.segments.push_back({start, number(phase.sums.time), choice.vertex_step, choice.support, choice.motion,
                                  begin, end.event, in_double(choice.state), in_double(end.state),
                                  number(end.sums.turned), number(end.sums.work),
                                  number(std::exchange(settled_jacobi, T(0))), 0, end.steps});
    }

    /// One piece; returns the next state to choose a motion at, or nothing if the phase is over.
    std::optional<MotionChoice<T>> piece(const MotionChoice<T>& choice, ContactEvent begin, const T& left) {
        const ContactEnd<T> end =
            run_contact(scene, choice.support, choice.motion, choice.state, left, sink, steps_left, phase.sums);
        add(choice, begin, end);
        MotionChoice<T> next = choice;
        next.state = end.state;
        switch (end.event) {
            case ContactEvent::strike:
                if (const auto settled = settled_neighbour(end.state, choice.vertex_step)) return settled;
                strike(end.state, choice.vertex_step,
                       contact_detail::ends_second_chatter(scene, choice.motion, end.state));
                return {};
            case ContactEvent::jam:
                jam(next);
                return {};
            case ContactEvent::horizon:
            case ContactEvent::release:
                finish(end.event, post_impact_state(scene, end.state), choice.vertex_step);
                return {};
            case ContactEvent::stick:
                next.state.ut = T(0);
                return next;
            case ContactEvent::lift:
                next.support = Support::vertex;
                if (end.first_lifts) {
                    next.state = {end.state.psi + 2 * scene.half_chord, scene.widest_chi, end.state.ut, end.state.spin};
                    ++next.vertex_step;
                }
                return next;
            default:
                return next;
        }
    }

    void follow(MotionChoice<T> at, ContactEvent begin, double horizon) {
        int idle = 0;
        while (true) {  // ends at: an end of the phase, the horizon, or too many idle pieces
            const MotionChoice<T> choice = choose_motion(scene, at.support, at.state, at.vertex_step, begin);
            if (!choice.stays) {
                if (choice.ends == ContactEvent::jam) return jam(choice);
                return finish(ContactEvent::release, post_impact_state(scene, choice.state), choice.vertex_step);
            }
            if (phase.segments.size() >= most_pieces)
                return finish(ContactEvent::horizon, post_impact_state(scene, choice.state), choice.vertex_step);
            const T before = phase.sums.time;
            const auto next = piece(choice, begin, T(horizon - phase.sums.time));
            if (!next) return;
            begin = phase.segments.back().finish;
            idle = phase.sums.time > before ? 0 : idle + 1;
            at = *next;
            if (idle < most_idle_pieces) continue;
            phase.resolved = false;
            return finish(ContactEvent::horizon, post_impact_state(scene, at.state), at.vertex_step);
        }
    }
};

}  // namespace

template <class T>
ContactPhase<T> follow_contact(const ContactScene<T>& scene, const ChatterCompletion<T>& completion, double horizon,
                               const ContactSink& sink, long most_steps) {
    Follower<T> follower{scene, sink, {}};
    follower.steps_left = most_steps;
    follower.follow({true, completion.support, ContactMotion::sticking, completion.state, completion.vertex_step,
                     ContactEvent::release},
                    ContactEvent::landing, horizon);
    follower.phase.cut = follower.phase.resolved && follower.phase.finish == ContactEvent::horizon &&
                         follower.phase.sums.time < horizon * (1 - 1e-12);  // a sum of pieces
    if (!follower.phase.segments.empty()) {
        follower.phase.segments.front().landing_jacobi += static_cast<double>(completion.jacobi);
        follower.phase.segments.front().error = static_cast<double>(completion.error);
    }
    return follower.phase;
}

template <class T>
ContactPhase<T> struck_at_once(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    const ContactSink unseen;
    Follower<T> follower{scene, unseen, {}};
    const ContactState<T> state = contact_state(scene, post_impact);
    ContactSegment segment;
    segment.from = segment.to = in_double(state);
    segment.finish = ContactEvent::strike;
    follower.phase.segments.push_back(segment);
    follower.strike(state, 0, false);
    return follower.phase;
}

#define SWIRL_COMPILE_CONTACT_PHASE(T)                                                                   \
    template ContactPhase<T> follow_contact(const ContactScene<T>&, const ChatterCompletion<T>&, double, \
                                            const ContactSink&, long);                                   \
    template ContactPhase<T> struck_at_once(const ContactScene<T>&, const PostImpactState<T>&);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_CONTACT_PHASE)

}  // namespace swirl
