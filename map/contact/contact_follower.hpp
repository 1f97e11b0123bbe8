// Contact from its landing on, piece by piece, whatever moves the body in a piece. Internal to what follows contact.
#pragma once

#include "map/contact/contact_phase.hpp"
#include "map/contact/motion_choice.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace swirl::contact_detail {

/// After more consecutive pieces of zero duration contact is called unresolved.
inline constexpr int most_idle_pieces = 50;

/// After so many pieces contact is not followed further.
inline constexpr std::size_t most_pieces = 100'000;

/// Follows contact through its pieces.
///
/// What moves the body, `Motions`, has
///     MotionChoice<T> choose(const MotionChoice<T>& at, ContactEvent before)     the motion that begins
///     ContactEnd<T> run(const MotionChoice<T>&, const T& duration, const ContactSink&, long most_steps,
///                       const ContactSums<T>& before)                            a piece, until its event
///     bool ends_second_chatter(const MotionChoice<T>&, const ContactState<T>&)   has the neighbour's chatter ended?
///     ChatterCompletion<T> completion(const PostImpactState<T>&)                 where contact goes on after an impact
template <class T, class Motions>
struct Follower {
    const ContactScene<T>& scene;
    Motions& motions;
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
        using std::copysign;
        z.chi = copysign(scene.widest_chi, z.chi);
        phase.strike = strike_in_contact(scene, post_impact_state(scene, z), plastic);
        phase.resolved = phase.strike.resolved;
        finish(ContactEvent::strike, phase.strike.after, vertex_step + (z.chi > 0 ? -1 : 1));
    }

    /// A neighbour on the wall that does not approach, its rebound being below rounding: it rests there, without an
    /// impact.
    std::optional<MotionChoice<T>> settled_neighbour(ContactState<T> z, int vertex_step) {
        using std::copysign;
        z.chi = copysign(scene.widest_chi, z.chi);
        const PostImpactState<T> completion = post_impact_state(scene, z);
        if (contact_kinematics(scene.body, seen_from_neighbour(scene, completion)).un > 0) return {};
        const Strike<T> rest = strike_in_contact(scene, completion, true);
        const ChatterCompletion<T> on = motions.completion(rest.after);
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
        const ContactEnd<T> end = motions.run(choice, left, sink, steps_left, phase.sums);
        add(choice, begin, end);
        MotionChoice<T> next = choice;
        next.state = end.state;
        switch (end.event) {
            case ContactEvent::strike:
                if (const auto settled = settled_neighbour(end.state, choice.vertex_step)) return settled;
                strike(end.state, choice.vertex_step, motions.ends_second_chatter(choice, end.state));
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
            const MotionChoice<T> choice = motions.choose(at, begin);
            phase.resolved = choice.resolved;
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

    /// From a landing on.
    ContactPhase<T> follow_from(const ChatterCompletion<T>& completion, double horizon, long most_steps) {
        steps_left = most_steps;
        follow({true, completion.support, ContactMotion::sticking, completion.state, completion.vertex_step,
                ContactEvent::release},
               ContactEvent::landing, horizon);
        phase.cut = phase.resolved && phase.finish == ContactEvent::horizon &&
                    phase.sums.time < horizon * (1 - 1e-12);  // a sum of pieces
        if (!phase.segments.empty()) {
            phase.segments.front().landing_jacobi += static_cast<double>(completion.jacobi);
            phase.segments.front().error = static_cast<double>(completion.error);
        }
        return phase;
    }
};

}  // namespace swirl::contact_detail
