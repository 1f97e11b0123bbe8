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
using State = std::array<double, size>;

struct Problem {
    const ContactScene& scene;
    Support support;
    ContactMotion motion;

    bool sticks() const { return motion == ContactMotion::sticking; }
    static ContactState state_of(const double* y) { return {y[0], y[1], y[2], y[3]}; }
    Reaction reaction(const double* y) const { return reaction_of(scene, support, motion, state_of(y)); }
};

int rates(double, const double y[], double out[], void* parameters) {
    const auto& problem = *static_cast<const Problem*>(parameters);
    const ContactState z = Problem::state_of(y);
    const Reaction r = problem.reaction(y);
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
        : system_{&rates, nullptr, size, &problem}, step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, size)) {}

    /// The state h later, and the largest local error in any component relative to max(1, its size).
    State step(const State& from, double h, double& error) const {
        State to = from, errors{};
        gsl_odeiv2_step_apply(step_.get(), 0, h, to.data(), errors.data(), nullptr, nullptr, &system_);
        error = 0;
        for (std::size_t i = 0; i < 4; ++i) error = std::max(error, std::abs(errors[i]) / std::max(1.0, std::abs(to[i])));
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
    const Reaction r = problem.reaction(y.data());
    const ContactState z = Problem::state_of(y.data());
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
        c[1] = {r.reserve, ContactEvent::slip};
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
    double time;
    std::size_t which;
    bool found = false;
};

/// The moment in (0, h] at which condition k fails, known to hold at 0 and to fail at h: the side on which it fails.
double locate(const Problem& problem, const Stepper& stepper, const State& from, double h, std::size_t k) {
    const auto value = [&](double t) { return conditions_of(problem, stepper.step(from, t))[k].value; };
    std::uintmax_t iterations = 80;
    const double before = conditions_of(problem, from)[k].value;
    if (!(before > 0)) return 0;
    const double after = value(h);
    if (after == 0) return h;
    const auto bracket = boost::math::tools::toms748_solve(value, 0.0, h, before, after,
                                                           boost::math::tools::eps_tolerance<double>(51), iterations);
    return bracket.second;
}

Failure first_failure(const Problem& problem, const Stepper& stepper, const State& from, const State& to, double h) {
    const Conditions start = conditions_of(problem, from);
    const Conditions middle = conditions_of(problem, stepper.step(from, 0.5 * h));
    const Conditions end = conditions_of(problem, to);
    Failure first{h, 0};
    for (std::size_t k = 0; k < most_conditions; ++k) {
        const bool by_middle = middle[k].value < 0;
        if (!by_middle && !(end[k].value < 0)) continue;
        // A condition that begins at its border and moves inwards holds; it counts from where it has held.
        if (start[k].value <= 0 && !by_middle && middle[k].value > 0 && end[k].value >= 0) continue;
        const double time = locate(problem, stepper, from, by_middle ? 0.5 * h : h, k);
        if (!first.found || time < first.time) first = {time, k, true};
    }
    return first;
}

/// A step that is short against the swirl and the body's own motion.
double longest_step(const ContactState& z) { return 0.1 / (1 + std::abs(z.spin) + std::abs(z.ut)); }

constexpr double local_error = 1e-14;

}  // namespace

ContactEnd run_contact(const ContactScene& scene, Support support, ContactMotion motion, const ContactState& start,
                       double duration, const ContactSink& sink) {
    Problem problem{scene, support, motion};
    const Stepper stepper(problem);
    State y{start.psi, start.chi, start.ut, start.spin, 0, 0};
    ContactEnd end;
    double time = 0;
    double trial = longest_step(start);
    const auto finish = [&](ContactEvent event, const State& at, double t) {
        end.event = event;
        end.state = Problem::state_of(at.data());
        end.sums = {t, at[4], at[5]};
        return end;
    };
    while (time < duration) {  // ends at: an event, or the duration (steps have a shortest length)
        double h = std::min({trial, longest_step(Problem::state_of(y.data())), duration - time});
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
        if (sink) sink(time, support, motion, Problem::state_of(y.data()));
    }
    return finish(ContactEvent::horizon, y, time);
}

}  // namespace swirl
