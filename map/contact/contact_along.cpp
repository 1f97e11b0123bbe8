#include "map/contact/contact_along.hpp"

#include "map/contact/contact_series.hpp"
#include "map/contact/contact_watch.hpp"
#include "map/contact/segment_follower.hpp"

#include <cmath>
#include <cstddef>

namespace swirl {

namespace {

using contact_detail::Problem, contact_detail::State, contact_detail::Step;

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

/// Over a floor that does not rub: power series.
template <class J>
struct SmoothPieces {
    const ContactScene<double>& plain;
    const ContactScene<J>& scene;
    long steps = 0;

    ContactState<J> end_of(const ContactSegment& piece, bool first_lifts, const ContactState<J>& from) {
        const Problem<J> problem{scene, piece.support, piece.motion};
        const LastStep<J> last = last_step(problem, from, piece.end - piece.start, steps);
        const J t(last.time);
        const auto event = vanishing(problem, piece.finish, first_lifts, last.step.series(), t);
        const double rates = 1 + std::abs(piece.to.ut) + std::abs(piece.to.spin);
        const bool passes = std::abs(event.rate) > 64 * epsilon<double>() * rates;
        return last.step.at(passes ? J(t + event.shift()) : t).contact();
    }
    bool ends_second_chatter(const ContactSegment& last) const {
        return contact_detail::ends_second_chatter(plain, last.motion, last.to);
    }
};

}  // namespace

template <class J>
PostImpactState<J> contact_along(const ContactScene<double>& plain, const ContactScene<J>& scene,
                                 const ContactPhase<double>& phase, const ContactState<J>& landing, int vertex_step,
                                 long* steps) {
    SmoothPieces<J> pieces{plain, scene};
    contact_detail::SegmentFollower<J, SmoothPieces<J>> follower{scene, pieces, landing, vertex_step};
    PostImpactState<J> end = follower.follow(phase);
    if (steps) *steps += pieces.steps;
    return end;
}

#define SWIRL_COMPILE_CONTACT_ALONG(J)                                                             \
    template PostImpactState<J> contact_along(const ContactScene<double>&, const ContactScene<J>&, \
                                              const ContactPhase<double>&, const ContactState<J>&, int, long*);
SWIRL_EVERY_CONTACT_JET(SWIRL_COMPILE_CONTACT_ALONG)

}  // namespace swirl
