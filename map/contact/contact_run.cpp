#include "map/contact/contact_run.hpp"

#include "map/contact/contact_watch.hpp"
#include "map/contact/rim_pendulum.hpp"
#include "map/map_list.hpp"
#include "map/numbers/quad.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>

namespace swirl {

namespace {

using contact_detail::Condition, contact_detail::Failure, contact_detail::Problem, contact_detail::State,
    contact_detail::Step;
using std::abs, std::isfinite;

/// A step whose sixteen parts are short against the swirl and the body's own motion (a disk's spin moves no contact).
template <class T>
T longest_step(const ContactScene<T>& scene, Support support, const ContactState<T>& z) {
    const T spin = support == Support::rim ? T(0) : T(abs(z.spin));
    return 1 / (1 + spin + abs(normal_rate(scene, support, z)));
}

/// Bound of the last terms of a step; the truncation error is smaller by a factor (step)/(distance to the nearest
/// singularity).
template <class T>
T local_error() {
    return tolerance<T>(1e-16);
}

/// False where the motion is so fast that the series has left the numbers.
template <class T>
bool is_finite(const State<T>& y) {
    return std::all_of(y.value.begin(), y.value.end(), [](const T& value) { return isfinite(value); });
}

/// Shows a step to a sink, in parts short enough to interpolate between. Sums are rounded once, as those of a phase
/// are: the last moment of a piece is its end, and does not fall into the next one.
///   before      sums of what came before the piece
///   time, next  of the piece, at the begin of the step and after a time h of it
template <class T>
void show(const Problem<T>& problem, const Step<T>& step, const ContactSums<T>& before, const T& time, const T& next,
          const T& h, const ContactSink& sink) {
    constexpr int parts = 4;
    const auto number = [](const T& x) { return static_cast<double>(x); };
    for (int part = 1; part <= parts; ++part) {
        const T t = part == parts ? h : T(h * part / parts);
        const State<T> at = step.at(t);
        const T now = part == parts ? next : T(time + t);
        sink({number(T(before.time + now)), number(T(before.turned + at.value[4])),
              number(T(before.work + at.value[5]))},
             problem.support, problem.motion, in_double(at.contact()));
    }
}

/// What is left of a slip that jams: from where B₂ − sμB₃ is `painleve_margin` to where it is zero, at the rates that
/// it has. A time of order ε.
template <class T>
struct Border {
    T time{};
    State<T> state;
};

template <class T>
Border<T> at_border(const Problem<T>& problem, const Step<T>& step, const T& time) {
    Border<T> border{T(0), step.at(time)};
    const ContactState<T> z = border.state.contact();
    const Reaction<T> r = reaction_of(problem.scene, problem.support, problem.motion, z);
    const T falls = -derivative_at(step.series().stiffness, time);
    if (!(falls > 0) || !(r.stiffness > 0)) return border;
    border.time = r.stiffness / falls;
    const T rates[] = {z.ut - 1, z.spin - z.ut, r.ut_rate, r.spin_rate, z.spin, T(r.friction * (z.ut - 1))};
    for (std::size_t i = 0; i < contact_detail::state_size; ++i) border.state.value[i] += rates[i] * border.time;
    return border;
}

/// A disk's pendulum is advanced in closed form if that saves so many steps, and if contact and friction hold with more
/// than this margin, relative to the scale of the forces, all along the pendulum's orbit: then no event can end it.
constexpr double long_contact = 20;
constexpr double hold_margin = 1e-9;

bool holds_throughout(const ContactScene<double>& scene, Support support, ContactMotion motion,
                      const ContactState<double>& z) {
    if (support != Support::rim || (scene.mu > 0 && motion != ContactMotion::sticking)) return false;
    const RimPendulum pendulum = rim_pendulum(scene, z);
    const double scale = (1 + scene.mu) * (scene.body.beta + scene.body.inner * (1 + 2 * pendulum.height));
    return least_hold(scene, pendulum) > hold_margin * scale;
}

/// The whole duration at once. Of S the integral is −ρ(t + Δψ)/α rolling; friction's is IΔS/α, at u_t = 0.
ContactEnd<double> advanced_at_once(const ContactScene<double>& scene, const ContactState<double>& start,
                                    double duration) {
    const ContactState<double> to = advance_rim(scene, start, duration);
    const double inverse_alpha = 1 / scene.body.alpha;
    const bool rolls = scene.mu > 0;
    const double turned =
        rolls ? -scene.body.inner * inverse_alpha * (duration + (to.psi - start.psi)) : start.spin * duration;
    const double work = rolls ? -scene.body.inertia * inverse_alpha * (to.spin - start.spin) : 0;
    return {ContactEvent::horizon, to, {duration, turned, work}, false, 1};
}

/// The contact of a pendulum that no event can end, in closed form, where that saves steps; nothing otherwise. In
/// double whatever T is: no impact comes of it, and what it is reported in is double.
template <class T>
std::optional<ContactEnd<T>> endless_contact(const ContactScene<T>& scene, Support support, ContactMotion motion,
                                             const ContactState<T>& start, const T& duration) {
    if (scene.floor.drags) return {};  // a pendulum with drag has no closed form
    if (support != Support::rim || !(duration > T(long_contact) * longest_step(scene, support, start))) return {};
    if constexpr (std::is_same_v<T, double>) {
        if (!holds_throughout(scene, support, motion, start)) return {};
        return advanced_at_once(scene, start, duration);
    } else {
        const auto end =
            endless_contact<double>(in_double(scene), support, motion, in_double(start), static_cast<double>(duration));
        if (!end) return {};
        const ContactState<double>& to = end->state;
        return ContactEnd<T>{ContactEvent::horizon,
                             {T(to.psi), T(to.chi), T(to.ut), T(to.spin)},
                             {duration, T(end->sums.turned), T(end->sums.work)},
                             false,
                             1};
    }
}

}  // namespace

template <class T>
ContactEnd<T> run_contact(const ContactScene<T>& scene, Support support, ContactMotion motion,
                          const ContactState<T>& start, const Plain<T>& duration, const ContactSink& sink,
                          long most_steps, const ContactSums<T>& before) {
    const Problem<T> problem{scene, support, motion};
    if (!sink)
        if (const auto end = endless_contact(scene, support, motion, start, duration)) return *end;
    State<T> y{{start.psi, start.chi, start.ut, start.spin, T(0), T(0)}, {}};
    ContactEnd<T> end;
    T time(0);
    const auto finish = [&](ContactEvent event, const State<T>& at, const T& t) {
        end.event = event;
        end.state = at.contact();
        end.sums = {t, at.value[4], at.value[5]};
        return end;
    };
    // Ends at: an event, the duration, the step limit, or a motion too fast for numbers, which is cut short as well.
    while (time < duration && end.steps < most_steps) {
        ++end.steps;
        const Step<T> step(problem, y);
        const T h = std::min(
            {step_of(step.series(), local_error<T>()), longest_step(scene, support, y.contact()), T(duration - time)});
        const State<T> next = step.at(h);
        if (!is_finite(next)) break;
        const Failure<T> failure = first_failure(problem, step, h);
        if (failure.found) {
            const Condition<T> condition = conditions_of(problem, y)[failure.which];
            end.first_lifts = condition.first_lifts;
            const T ends = time + failure.time;
            if (sink && failure.time > 0) show(problem, step, before, time, ends, failure.time, sink);
            if (condition.event == ContactEvent::jam) {
                const Border<T> border = at_border(problem, step, failure.time);
                return finish(condition.event, border.state, T(ends + border.time));
            }
            return finish(condition.event, failure.time > 0 ? step.at(failure.time) : y, ends);
        }
        const T later = duration - time <= h ? duration : T(time + h);
        if (sink) show(problem, step, before, time, later, h, sink);
        y = next;
        time = later;
    }
    return finish(ContactEvent::horizon, y, time);
}

#define SWIRL_COMPILE_RUN_CONTACT(T)                                                                           \
    template ContactEnd<T> run_contact(const ContactScene<T>&, Support, ContactMotion, const ContactState<T>&, \
                                       const Plain<T>&, const ContactSink&, long, const ContactSums<T>&);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_RUN_CONTACT)

}  // namespace swirl
