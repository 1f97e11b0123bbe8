#include "map/sustained/contact_phase.hpp"

#include "map/sustained/motion_choice.hpp"

#include <cmath>
#include <utility>

namespace swirl {

namespace {

/// After more consecutive pieces of zero duration contact is called unresolved.
constexpr int most_idle_pieces = 50;

/// After so many pieces contact is not followed further.
constexpr std::size_t most_pieces = 100'000;

/// True if the neighbour's chatter, while a vertex is in contact, has ended: its remaining rebounds move it by less
/// than rounding (vT as in chatter_completion.hpp), with L|χ″| its acceleration towards the wall.
bool ends_second_chatter(const ContactScene& scene, ContactMotion motion, const ContactState& z) {
    const Reaction r = reaction_of(scene, Support::vertex, motion, z);
    const double side = z.chi > 0 ? -1 : 1;
    const double lever = scene.body.alpha * std::abs(std::sin(z.chi) - std::sin(z.chi + side * scene.body.spacing));
    const double acceleration = lever * side * -(r.spin_rate - r.ut_rate);
    const double v = scene.restitution * lever * std::abs(z.spin - z.ut);
    return acceleration > 0 &&
           2 * v * v <= 16 * std::numeric_limits<double>::epsilon() * acceleration * (1 - scene.restitution);
}

struct Follower {
    const ContactScene& scene;
    const ContactSink& sink;
    ContactPhase phase;
    double settled_jacobi = 0;  ///< change of J when a neighbour came to rest: part of the next piece's landing
    long steps_left = most_contact_steps;

    void finish(ContactEvent event, const PostImpactState<double>& post_impact, int vertex_step) {
        phase.finish = event;
        phase.strike.after = post_impact;
        phase.vertex_step = vertex_step;
    }

    void jam(const MotionChoice& choice) {
        PostImpactState<double> post_impact = post_impact_state(scene, choice.state);
        phase.strike.impulse = jam_once(scene, post_impact, phase.strike);
        phase.resolved = phase.strike.impulse.normal > 0;
        finish(ContactEvent::jam, post_impact, choice.vertex_step);
    }

    void strike(const ContactSegment& segment, bool plastic) {
        ContactState z = segment.to;
        z.chi = std::copysign(scene.widest_chi, z.chi);
        phase.strike = strike_in_contact(scene, post_impact_state(scene, z), plastic);
        phase.resolved = phase.strike.resolved;
        finish(ContactEvent::strike, phase.strike.after, segment.vertex_step + (z.chi > 0 ? -1 : 1));
    }

    /// A neighbour on the wall that does not approach, its rebound being below rounding: it rests there, without an
    /// impact.
    std::optional<MotionChoice> settled_neighbour(const ContactSegment& segment) {
        ContactState z = segment.to;
        z.chi = std::copysign(scene.widest_chi, z.chi);
        const PostImpactState<double> completion = post_impact_state(scene, z);
        if (contact_kinematics(scene.body, seen_from_neighbour(scene, completion)).un > 0) return {};
        const Strike rest = strike_in_contact(scene, completion, true);
        const ChatterCompletion on = chatter_completion(scene, rest.after);
        if (!on.in_contact || on.support != Support::edge) return {};
        settled_jacobi = rest.jacobi_restitution + rest.jacobi_friction + on.jacobi;
        phase.sums.work += settled_jacobi;
        const int step = segment.vertex_step + (z.chi > 0 ? -1 : 1) + on.vertex_step;
        return MotionChoice{true, Support::edge, ContactMotion::sticking, on.state, step, ContactEvent::strike};
    }

    /// One piece; returns the next state to choose a motion at, or nothing if the phase is over.
    std::optional<MotionChoice> piece(const MotionChoice& choice, ContactEvent begin, double left) {
        const ContactSink shifted =
            !sink ? ContactSink{} : [&](const ContactSums& sums, Support s, ContactMotion m, const ContactState& z) {
                sink({phase.sums.time + sums.time, phase.sums.turned + sums.turned, phase.sums.work + sums.work}, s, m,
                     z);
            };
        const ContactEnd end =
            run_contact(scene, choice.support, choice.motion, choice.state, left, shifted, steps_left);
        steps_left -= end.steps;
        const double start = phase.sums.time;
        phase.sums.time += end.sums.time;
        phase.sums.turned += end.sums.turned;
        phase.sums.work += end.sums.work;
        phase.segments.push_back({start, phase.sums.time, choice.vertex_step, choice.support, choice.motion, begin,
                                  end.event, choice.state, end.state, end.sums.turned, end.sums.work,
                                  std::exchange(settled_jacobi, 0), 0, end.steps});
        const ContactSegment& segment = phase.segments.back();
        MotionChoice next = choice;
        next.state = end.state;
        switch (end.event) {
            case ContactEvent::strike:
                if (const auto settled = settled_neighbour(segment)) return settled;
                strike(segment, ends_second_chatter(scene, segment.motion, segment.to));
                return {};
            case ContactEvent::jam:
                jam(next);
                return {};
            case ContactEvent::horizon:
            case ContactEvent::release:
                finish(end.event, post_impact_state(scene, end.state), choice.vertex_step);
                return {};
            case ContactEvent::stick:
                next.state.ut = 0;
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

    void follow(MotionChoice at, ContactEvent begin, double horizon) {
        int idle = 0;
        while (true) {  // ends at: an end of the phase, the horizon, or too many idle pieces
            const bool broken = begin == ContactEvent::slip;
            const MotionChoice choice = choose_motion(scene, at.support, at.state, at.vertex_step, broken);
            if (!choice.stays) {
                if (choice.ends == ContactEvent::jam) return jam(choice);
                return finish(ContactEvent::release, post_impact_state(scene, choice.state), choice.vertex_step);
            }
            if (phase.segments.size() >= most_pieces)
                return finish(ContactEvent::horizon, post_impact_state(scene, choice.state), choice.vertex_step);
            const double before = phase.sums.time;
            const auto next = piece(choice, begin, horizon - phase.sums.time);
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

ContactPhase follow_contact(const ContactScene& scene, const ChatterCompletion& completion, double horizon,
                            const ContactSink& sink, long most_steps) {
    Follower follower{scene, sink, {}};
    follower.steps_left = most_steps;
    follower.follow({true, completion.support, ContactMotion::sticking, completion.state, completion.vertex_step,
                     ContactEvent::release},
                    ContactEvent::landing, horizon);
    follower.phase.cut = follower.phase.resolved && follower.phase.finish == ContactEvent::horizon &&
                         follower.phase.sums.time < horizon * (1 - 1e-12);  // a sum of pieces
    if (!follower.phase.segments.empty()) {
        follower.phase.segments.front().landing_jacobi += completion.jacobi;
        follower.phase.segments.front().error = completion.error;
    }
    return follower.phase;
}

ContactPhase struck_at_once(const ContactScene& scene, const PostImpactState<double>& post_impact) {
    Follower follower{scene, {}, {}};
    ContactSegment segment;
    segment.from = segment.to = contact_state(scene, post_impact);
    segment.finish = ContactEvent::strike;
    follower.phase.segments.push_back(segment);
    follower.strike(segment, false);
    return follower.phase;
}

}  // namespace swirl
