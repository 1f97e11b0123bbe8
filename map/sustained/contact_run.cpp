#include "map/sustained/contact_run.hpp"

#include <boost/math/tools/roots.hpp>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace swirl {

namespace {

constexpr std::size_t size = 6;  // ψ, χ, u_t, S, ∫S dt, ∫f(u_t − 1)dt
using Components = std::array<double, size>;

/// A state as value + rest: GSL steps the small change since a step's beginning, and nothing of it is lost in the sum.
/// Over 100 periods of a pendulum this is the difference between 5e-10 and 1e-11.
struct State {
    Components value{};
    Components rest{};

    ContactState contact() const { return {value[0], value[1], value[2], value[3]}; }
};

struct Problem {
    const ContactScene& scene;
    Support support;
    ContactMotion motion;
    Components base{};  ///< the value at the beginning of the step that is being taken

    bool sticks() const { return motion == ContactMotion::sticking; }
};

int rates(double, const double change[], double out[], void* parameters) {
    const auto& problem = *static_cast<const Problem*>(parameters);
    const Components& base = problem.base;
    const ContactState z{base[0] + change[0], base[1] + change[1], base[2] + change[2], base[3] + change[3]};
    const Reaction r = reaction_of(problem.scene, problem.support, problem.motion, z);
    const double turning = normal_rate(problem.scene, problem.support, z);
    out[0] = turning - 1;
    out[1] = problem.support == Support::vertex ? z.spin - turning : 0;
    out[2] = r.ut_rate;
    out[3] = r.spin_rate;
    out[4] = z.spin;
    out[5] = r.friction * (z.ut - 1);
    return GSL_SUCCESS;
}

/// GSL's stepper; each trial starts from a state given by value, so that a step can be taken again.
class Stepper {
public:
    explicit Stepper(Problem& problem)
        : problem_(problem), system_{&rates, nullptr, size, &problem},
          step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, size)) {}

    /// The state h later, and the largest local error in any component relative to max(1, its size).
    State step(const State& from, double h, double& error) const {
        Components change = from.rest, errors{};
        problem_.base = from.value;
        gsl_odeiv2_step_apply(step_.get(), 0, h, change.data(), errors.data(), nullptr, nullptr, &system_);
        State to;
        error = 0;
        for (std::size_t i = 0; i < size; ++i) {
            to.value[i] = from.value[i] + change[i];
            const double kept = to.value[i] - from.value[i];
            to.rest[i] = (from.value[i] - (to.value[i] - kept)) + (change[i] - kept);  // Knuth's two-sum
            if (i < 4) error = std::max(error, std::abs(errors[i]) / std::max(1.0, std::abs(to.value[i])));
        }
        return to;
    }
    State step(const State& from, double h) const {
        double error;
        return step(from, h, error);
    }

private:
    struct Free {
        void operator()(gsl_odeiv2_step* s) const { gsl_odeiv2_step_free(s); }
    };
    Problem& problem_;
    gsl_odeiv2_system system_;
    std::unique_ptr<gsl_odeiv2_step, Free> step_;
};

/// A condition that holds along the motion, and what ends it when it no longer does.
struct Condition {
    double value;  ///< ≥ 0 while it holds
    ContactEvent event;
    bool first_lifts = false;
};

constexpr std::size_t most_conditions = 4;
using Conditions = std::array<Condition, most_conditions>;
constexpr Condition always{1, ContactEvent::horizon};

/// A contact is released where λ is just negative, so that the flight begins away from the wall beyond doubt.
constexpr double release_margin = 1e-13;
/// Where B₂ − sμB₃ is below this the normal force is called unbounded.
constexpr double painleve_margin = 1e-9;

Conditions conditions_of(const Problem& problem, const State& y) {
    const ContactState z = y.contact();
    const Reaction r = reaction_of(problem.scene, problem.support, problem.motion, z);
    const double scale = problem.scene.body.beta + z.ut * z.ut + problem.scene.body.alpha * z.spin * z.spin;
    Conditions c{always, always, always, always};
    if (problem.support == Support::edge) {
        if (!problem.sticks()) {
            c[0] = {r.normal + release_margin * scale, ContactEvent::lift, true};
            c[2] = {r.second + release_margin * scale, ContactEvent::lift, false};
        }
    } else {
        c[0] = {r.normal + release_margin * scale, ContactEvent::release};
    }
    if (problem.sticks())
        c[1] = {r.reserve + stick_margin(problem.scene, z), ContactEvent::slip};
    else if (problem.scene.mu > 0)
        c[1] = {problem.motion == ContactMotion::sliding_forward ? z.ut : -z.ut, ContactEvent::stick};
    if (problem.support == Support::vertex) {
        c[2] = {problem.scene.widest_chi - std::abs(z.chi), ContactEvent::strike};
        if (!problem.sticks() && problem.scene.mu > 0) c[3] = {r.stiffness - painleve_margin, ContactEvent::jam};
    }
    return c;
}

/// The first condition that fails within a step, and when.
struct Failure {
    double time = 0;
    std::size_t which = 0;
    bool found = false;
};

/// The moment in (from, to] at which condition k fails, known to fail at `to`: on the side on which it fails.
double locate(const Problem& problem, const Stepper& stepper, const State& y, double from, double to, std::size_t k) {
    const auto value = [&](double t) {
        return conditions_of(problem, t > 0 ? stepper.step(y, t) : y)[k].value;
    };
    double before = value(from);
    const double after = value(to);
    for (int halving = 1; !(before > 0); ++halving) {  // it may begin at its border, rise, and fall again
        if (halving > 30) return from;
        const double nearer = from + std::ldexp(to - from, -halving);
        before = value(nearer);
        if (before > 0) from = nearer;
    }
    if (after == 0) return to;
    std::uintmax_t iterations = 80;
    return boost::math::tools::toms748_solve(value, from, to, before, after,
                                             boost::math::tools::eps_tolerance<double>(51), iterations).second;
}

/// Looks at a step's quarters in turn. A condition that begins at its border (λ = 0 after a release that did not happen,
/// |χ| = χ_m after a strike) and moves inwards holds: only a negative value fails.
Failure first_failure(const Problem& problem, const Stepper& stepper, const State& y, const State& end, double h) {
    for (int quarter = 1; quarter <= 4; ++quarter) {
        const double from = 0.25 * (quarter - 1) * h, to = quarter == 4 ? h : 0.25 * quarter * h;
        const Conditions now = conditions_of(problem, quarter == 4 ? end : stepper.step(y, to));
        Failure first;
        for (std::size_t k = 0; k < most_conditions; ++k) {
            if (!(now[k].value < 0)) continue;
            const double time = locate(problem, stepper, y, from, to, k);
            if (!first.found || time < first.time) first = {time, k, true};
        }
        if (first.found) return first;
    }
    return {};
}

/// A step whose quarters are short against the swirl and the body's own motion (a disk's spin moves nothing).
double longest_step(const ContactScene& scene, Support support, const ContactState& z) {
    const double spin = support == Support::rim ? 0 : std::abs(z.spin);
    return 0.25 / (1 + spin + std::abs(normal_rate(scene, support, z)));
}

constexpr double local_error = 1e-15;

}  // namespace

ContactEnd run_contact(const ContactScene& scene, Support support, ContactMotion motion, const ContactState& start,
                       double duration, const ContactSink& sink) {
    Problem problem{scene, support, motion};
    const Stepper stepper(problem);
    State y{{start.psi, start.chi, start.ut, start.spin, 0, 0}, {}};
    ContactEnd end;
    double time = 0;
    double trial = longest_step(scene, support, start);
    long steps = 0;
    const auto finish = [&](ContactEvent event, const State& at, double t) {
        end.event = event;
        end.state = at.contact();
        end.sums = {t, at.value[4], at.value[5]};
        return end;
    };
    while (time < duration && ++steps <= most_contact_steps) {  // ends at: an event, the duration, or the step limit
        double h = std::min({trial, longest_step(scene, support, y.contact()), duration - time});
        double error;
        State to = stepper.step(y, h, error);
        while (error > local_error && h > 1e-9) {
            h *= 0.5;
            to = stepper.step(y, h, error);
        }
        const Failure failure = first_failure(problem, stepper, y, to, h);
        if (failure.found) {
            const Conditions conditions = conditions_of(problem, y);
            end.first_lifts = conditions[failure.which].first_lifts;
            const State at = failure.time > 0 ? stepper.step(y, failure.time) : y;
            return finish(conditions[failure.which].event, at, time + failure.time);
        }
        y = to;
        time = duration - time <= h ? duration : time + h;
        trial = 2 * h;
        if (sink) sink({time, y.value[4], y.value[5]}, support, motion, y.contact());
    }
    return finish(ContactEvent::horizon, y, time);
}

}  // namespace swirl
