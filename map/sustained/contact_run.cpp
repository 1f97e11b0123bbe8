#include "map/sustained/contact_run.hpp"

#include "map/sustained/contact_watch.hpp"
#include "map/sustained/rim_pendulum.hpp"

#include <algorithm>
#include <cmath>

namespace swirl {

namespace {

using contact_detail::Condition, contact_detail::Failure, contact_detail::Problem, contact_detail::State,
    contact_detail::Step;

/// A step whose sixteen parts are short against the swirl and the body's own motion (a disk's spin moves no contact).
double longest_step(const ContactScene& scene, Support support, const ContactState& z) {
    const double spin = support == Support::rim ? 0 : std::abs(z.spin);
    return 1 / (1 + spin + std::abs(normal_rate(scene, support, z)));
}

/// Bound of the last terms of a step; the truncation error is smaller by a factor (step)/(distance to the nearest
/// singularity).
constexpr double local_error = 1e-16;

/// False where the motion is so fast that the series has left the numbers.
bool is_finite(const State& y) {
    return std::all_of(y.value.begin(), y.value.end(), [](double value) { return std::isfinite(value); });
}

/// Shows a step to a sink, in parts short enough to interpolate between.
void show(const Problem& problem, const Step& step, double time, double h, const ContactSink& sink) {
    constexpr int parts = 4;
    for (int part = 1; part <= parts; ++part) {
        const double t = part == parts ? h : h * part / parts;
        const State at = step.at(t);
        sink({time + t, at.value[4], at.value[5]}, problem.support, problem.motion, at.contact());
    }
}

/// A disk's pendulum is advanced in closed form if that saves so many steps, and if contact and friction hold with more
/// than this margin, relative to the scale of the forces, all along the pendulum's orbit: then no event can end it.
constexpr double long_contact = 20;
constexpr double hold_margin = 1e-9;

bool holds_throughout(const ContactScene& scene, Support support, ContactMotion motion, const ContactState& z) {
    if (support != Support::rim || (scene.mu > 0 && motion != ContactMotion::sticking)) return false;
    const RimPendulum pendulum = rim_pendulum(scene, z);
    const double scale = (1 + scene.mu) * (scene.body.beta + scene.body.inner * (1 + 2 * pendulum.height));
    return least_hold(scene, pendulum) > hold_margin * scale;
}

/// The whole duration at once. Of S the integral is −ρ(t + Δψ)/α rolling; friction's is IΔS/α, at u_t = 0.
ContactEnd advanced_at_once(const ContactScene& scene, const ContactState& start, double duration) {
    const ContactState to = advance_rim(scene, start, duration);
    const double per_alpha = 1 / scene.body.alpha;
    const bool rolls = scene.mu > 0;
    const double turned =
        rolls ? -scene.body.inner * per_alpha * (duration + (to.psi - start.psi)) : start.spin * duration;
    const double work = rolls ? -scene.body.inertia * per_alpha * (to.spin - start.spin) : 0;
    return {ContactEvent::horizon, to, {duration, turned, work}, false, 1};
}

}  // namespace

ContactEnd run_contact(const ContactScene& scene, Support support, ContactMotion motion, const ContactState& start,
                       double duration, const ContactSink& sink, long most_steps) {
    const Problem problem{scene, support, motion};
    if (!sink && duration > long_contact * longest_step(scene, support, start) &&
        holds_throughout(scene, support, motion, start))
        return advanced_at_once(scene, start, duration);
    State y{{start.psi, start.chi, start.ut, start.spin, 0, 0}, {}};
    ContactEnd end;
    double time = 0;
    const auto finish = [&](ContactEvent event, const State& at, double t) {
        end.event = event;
        end.state = at.contact();
        end.sums = {t, at.value[4], at.value[5]};
        return end;
    };
    // Ends at: an event, the duration, the step limit, or a motion too fast for numbers, which is cut short as well.
    while (time < duration && end.steps < most_steps) {
        ++end.steps;
        const Step step(problem, y);
        const double h =
            std::min({step_of(step.series(), local_error), longest_step(scene, support, y.contact()), duration - time});
        const State next = step.at(h);
        if (!is_finite(next)) break;
        const Failure failure = first_failure(problem, step, h);
        if (failure.found) {
            const Condition condition = conditions_of(problem, y)[failure.which];
            end.first_lifts = condition.first_lifts;
            if (sink && failure.time > 0) show(problem, step, time, failure.time, sink);
            return finish(condition.event, failure.time > 0 ? step.at(failure.time) : y, time + failure.time);
        }
        if (sink) show(problem, step, time, h, sink);
        y = next;
        time = duration - time <= h ? duration : time + h;
    }
    return finish(ContactEvent::horizon, y, time);
}

}  // namespace swirl
