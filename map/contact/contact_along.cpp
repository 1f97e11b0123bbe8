#include "map/contact/contact_along.hpp"

#include "map/contact/contact_series.hpp"
#include "map/contact/contact_watch.hpp"

#include <cmath>
#include <cstddef>

namespace swirl {

namespace {

using contact_detail::Problem, contact_detail::State, contact_detail::Step;

/// The derivatives of `z` at the values that the phase has.
template <class J>
ContactState<J> with_values(ContactState<J> z, const ContactState<double>& at) {
    z.psi.a = at.psi;
    z.chi.a = at.chi;
    z.ut.a = at.ut;
    z.spin.a = at.spin;
    return z;
}

/// The last step of a piece, and the time on it at which the piece ends.
template <class J>
struct LastStep {
    Step<J> step;
    double time;
};

template <class J>
LastStep<J> last_step(const Problem<J>& problem, const ContactState<J>& from, double duration, long& steps) {
    constexpr double local_error = 1e-16;  // as in contact_run.cpp
    State<J> y{{from.psi, from.chi, from.ut, from.spin, J(0), J(0)}, {}};
    double left = duration;
    while (true) {  // ends with the duration: the phase was integrated in such steps, or in shorter ones
        ++steps;
        const Step<J> step(problem, y);
        const double h = step_of(step.series(), local_error);
        if (!(h < left) || left - h == left) return {step, left};
        y = step.at(J(h));
        left -= h;
    }
}

/// What vanishes at the end of a piece, differentiated at a fixed time, and its rate.
template <class J>
struct Vanishing {
    J value;
    double rate;

    /// The event's time, less what it is in plain numbers.
    J shift() const {
        J later(0);
        later.v = -value.v / rate;
        return later;
    }
};

template <class J>
Vanishing<J> along(const Series<J>& series, const J& t) {
    return {value_at(series, t), derivative_at(series, t).a};
}

template <class J>
Vanishing<J> vanishing(const Problem<J>& problem, ContactEvent event, bool first_lifts, const ContactSeries<J>& z,
                       const J& t) {
    switch (event) {
        case ContactEvent::release:
            return along(z.normal, t);
        case ContactEvent::lift:
            return along(first_lifts ? z.normal : z.second, t);
        case ContactEvent::slip: {
            if (problem.support == Support::edge) return along(z.psi, t);  // alone moves: it is where friction ends
            const Vanishing<J> normal = along(z.normal, t), friction = along(z.friction, t);
            const double sign = friction.value.a < 0 ? -1 : 1;
            const J& mu = problem.scene.mu;
            return {mu * normal.value - sign * friction.value, mu.a * normal.rate - sign * friction.rate};
        }
        case ContactEvent::stick:
            return along(z.ut, t);
        case ContactEvent::strike: {  // |χ| = χ_m
            const Vanishing<J> chi = along(z.chi, t);
            const J& widest = problem.scene.widest_chi;
            return {chi.value.a > 0 ? J(chi.value - widest) : J(chi.value + widest), chi.rate};
        }
        case ContactEvent::jam:
            return along(z.stiffness, t);
        case ContactEvent::horizon:
        case ContactEvent::landing:
            break;
    }
    return {J(0), 1};
}

/// A vertex (rim) that sticks: friction stops a neighbour that slips, by impulses that leave u_n at zero. Which way it
/// slips does not matter: B₂p + B₃q = 0, B₃p + B₁q = −u_t.
template <class J>
ContactState<J> stopped(const ContactScene<J>& scene, Support support, ContactState<J> z) {
    const J slip = z.ut;
    z.ut = J(0);
    if (support == Support::edge) return z;
    const ContactKinematics<J> at = contact_kinematics(scene.body, post_impact_state(scene, z));
    const J q = -slip / (at.b1() - at.b3() * at.b3() / at.b2()), p = -at.b3() * q / at.b2();
    z.spin += (at.rn * q + at.rt * p) * scene.body.inverse_inertia;
    return z;
}

template <class J>
struct SegmentFollower {
    const ContactScene<J>& scene;
    ContactState<J> z;
    int vertex_step = 0;
    long steps = 0;

    /// To the other vertex of the edge, where it is another: one number up or down.
    void change_vertex(int to) {
        if (to == vertex_step) return;
        const J side(to > vertex_step ? 1 : -1);
        z.psi += side * J(2) * scene.half_chord;
        z.chi = side * scene.widest_chi;
        vertex_step = to;
    }

    void put_neighbour_at_wall() { z.chi = z.chi.a > 0 ? scene.widest_chi : J(-scene.widest_chi); }

    /// A piece, with its last event; `next` is the piece after it, if there is one.
    void follow(const ContactSegment& piece, const ContactSegment* next) {
        change_vertex(piece.vertex_step);
        z = with_values(z, piece.from);
        const Problem<J> problem{scene, piece.support, piece.motion};
        const double duration = piece.end - piece.start;
        if (duration > 0 && problem.sticks()) z = stopped(scene, piece.support, z);
        const bool first_lifts = next && next->vertex_step != piece.vertex_step;
        if (duration > 0 || piece.finish == ContactEvent::strike) {
            const LastStep<J> last = last_step(problem, z, duration, steps);
            const J t(last.time);
            const auto event = vanishing(problem, piece.finish, first_lifts, last.step.series(), t);
            const double rates = 1 + std::abs(piece.to.ut) + std::abs(piece.to.spin);
            const bool passes = std::abs(event.rate) > 64 * epsilon<double>() * rates;
            z = with_values(last.step.at(passes ? J(t + event.shift()) : t).contact(), piece.to);
        }
        if (piece.finish == ContactEvent::stick) z.ut = J(0);
        if (piece.finish == ContactEvent::strike && next) settle(*next);
    }

    /// The neighbour strikes and rests on the wall: the next piece begins on their edge.
    void settle(const ContactSegment& next) {
        const int struck = vertex_step + (z.chi.a > 0 ? -1 : 1);
        vertex_step = next.vertex_step;
        put_neighbour_at_wall();
        const Strike<J> rest = strike_in_contact(scene, post_impact_state(scene, z), true);
        ChatterCompletion<J> on;
        on.support = Support::edge;
        on.vertex_step = next.vertex_step - struck;
        on.state = with_values(on.state, next.from);
        z = landed_like(scene, rest.after, on, rest.after);
    }

    PostImpactState<J> finish(const ContactScene<double>& plain, const ContactPhase<double>& phase) {
        Strike<J> strike;
        if (phase.finish == ContactEvent::strike) {
            const ContactSegment& last = phase.segments.back();
            const bool plastic = last.steps > 0 && contact_detail::ends_second_chatter(plain, last.motion, last.to);
            put_neighbour_at_wall();
            return strike_in_contact(scene, post_impact_state(scene, z), plastic).after;
        }
        change_vertex(phase.vertex_step);
        PostImpactState<J> end = post_impact_state(scene, z);
        if (phase.finish == ContactEvent::jam) jam_once(scene, end, strike);
        return end;
    }
};

}  // namespace

template <class J>
PostImpactState<J> contact_along(const ContactScene<double>& plain, const ContactScene<J>& scene,
                                 const ContactPhase<double>& phase, const ContactState<J>& landing, int vertex_step,
                                 long* steps) {
    SegmentFollower<J> follower{scene, landing, vertex_step};
    for (std::size_t i = 0; i < phase.segments.size(); ++i)
        follower.follow(phase.segments[i], i + 1 < phase.segments.size() ? &phase.segments[i + 1] : nullptr);
    if (steps) *steps += follower.steps;
    return follower.finish(plain, phase);
}

#define SWIRL_COMPILE_CONTACT_ALONG(J)                                                             \
    template PostImpactState<J> contact_along(const ContactScene<double>&, const ContactScene<J>&, \
                                              const ContactPhase<double>&, const ContactState<J>&, int, long*);
SWIRL_EVERY_CONTACT_JET(SWIRL_COMPILE_CONTACT_ALONG)

}  // namespace swirl
