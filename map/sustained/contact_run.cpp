#include "map/sustained/contact_run.hpp"

#include "map/sustained/contact_series.hpp"
#include "map/sustained/rim_pendulum.hpp"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace swirl {

namespace {

constexpr std::size_t size = 6;  // ψ, χ, u_t, S, ∫S dt, ∫f(u_t − 1)dt
using Components = std::array<double, size>;

/// A state as value + rest: a step adds its small change, and nothing of it is lost in the sum. Over 100 periods of a
/// pendulum this is the difference between 5e-10 and 1e-11.
struct State {
    Components value{};
    Components rest{};

    ContactState contact() const { return {value[0], value[1], value[2], value[3]}; }
    /// |χ| below `widest`: a neighbour's small rebounds, of height below the rounding of χ, begin exactly there.
    double room(double widest) const {
        return (widest - std::abs(value[1])) - (value[1] < 0 ? -rest[1] : rest[1]);
    }
};

struct Problem {
    const ContactScene& scene;
    Support support;
    ContactMotion motion;

    bool sticks() const { return motion == ContactMotion::sticking; }
};

/// The motion from a state on.
class Step {
public:
    Step(const Problem& problem, const State& from)
        : from_(from),
          series_(contact_series(problem.scene, problem.support, problem.motion, from.contact(), from.rest[0])) {}

    const ContactSeries& series() const { return series_; }

    /// The state t later.
    State at(double t) const {
        const Series* parts[] = {&series_.psi,  &series_.chi,    &series_.ut,
                                 &series_.spin, &series_.turned, &series_.work};
        State to;
        for (std::size_t i = 0; i < size; ++i) {
            const double change = from_.rest[i] + change_at(*parts[i], t);
            to.value[i] = from_.value[i] + change;
            const double kept = to.value[i] - from_.value[i];
            to.rest[i] = (from_.value[i] - (to.value[i] - kept)) + (change - kept);  // Knuth's two-sum
        }
        return to;
    }

private:
    State from_;
    ContactSeries series_;
};

/// A condition that holds along the motion, and what ends it when it no longer does.
struct Condition {
    double value;  ///< ≥ 0 while it holds
    ContactEvent event;
    bool first_lifts = false;
};

constexpr std::size_t most_conditions = 4;
constexpr std::size_t strike_condition = 2;  ///< the neighbour's
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
        c[strike_condition] = {y.room(problem.scene.widest_chi), ContactEvent::strike};
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
double locate(const Problem& problem, const Step& step, double from, double to, std::size_t k) {
    const auto value = [&](double t) { return conditions_of(problem, step.at(t))[k].value; };
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

/// How often a step is looked at where its series does not prove that nothing ends the motion.
constexpr int looks_per_step = 16;

/// A condition's series a − |b|, as far as bounds do not prove that it holds all along a step.
struct Doubt {
    const Series* falls = nullptr;   ///< a
    const Series* against = nullptr; ///< b, nothing if there is none
    double factor = 1, border = 0;   ///< factor a − |b| − border > 0 while the condition holds
    double doubtful = 0;             ///< below this rounding decides
    double bend = 0;                 ///< bounds its second derivative from above, on the step

    double at(double t) const {
        return factor * value_at(*falls, t) - (against ? std::abs(value_at(*against, t)) : 0) - border;
    }
    double rate_at(double t) const {
        const double rate = factor * derivative_at(*falls, t);
        return against ? rate - std::copysign(1.0, value_at(*against, t)) * derivative_at(*against, t) : rate;
    }

    /// The moment between two looks at which the condition is lowest, if it fails there beyond rounding (some 10⁻¹³ of its
    /// terms) though it holds at both.
    std::optional<double> dip(double from, double to) const {
        Lowest lowest{-1e-4 * doubtful, 0, false};
        seek(from, to, 8, lowest);
        return lowest.found ? std::optional(lowest.time) : std::nullopt;
    }

private:
    struct Lowest {
        double value, time;
        bool found;

        void note(double v, double t) {
            if (v <= value) *this = {v, t, true};
        }
    };

    /// The second derivative bounds how far the condition falls between two moments, and tells where it only rises or only
    /// falls; what is left is halved.
    void seek(double from, double to, int halvings, Lowest& lowest) const {
        const double width = to - from;
        if (std::min(at(from), at(to)) - 0.125 * bend * width * width > lowest.value) return;
        const double before = rate_at(from), after = rate_at(to);
        if (before >= bend * width || after <= -bend * width) return;
        if (before < 0 && after > 0) {
            const double time = lowest_between(from, to);
            return lowest.note(at(time), time);
        }
        if (halvings == 0) return;
        const double middle = 0.5 * (from + to);
        lowest.note(at(middle), middle);
        seek(from, middle, halvings - 1, lowest);
        seek(middle, to, halvings - 1, lowest);
    }

    double lowest_between(double from, double to) const {
        std::uintmax_t iterations = 60;
        return boost::math::tools::toms748_solve([this](double t) { return rate_at(t); }, from, to,
                                                 boost::math::tools::eps_tolerance<double>(30), iterations).first;
    }
};

struct Doubts {
    std::array<Doubt, most_conditions> list;
    std::size_t count = 0;
    bool all = false;  ///< the forces of an edge at rest are not unique and have no series

    /// Keeps the condition unless no series reaches from its first term to where it would fail within h.
    void unless_proven(Doubt doubt, double h) {
        const double held = doubt.factor * (*doubt.falls)[0] - (doubt.against ? std::abs((*doubt.against)[0]) : 0);
        const double reach = std::abs(doubt.factor) * reach_of(*doubt.falls, h) +
                             (doubt.against ? reach_of(*doubt.against, h) : 0);
        if (held - doubt.border > reach) return;
        doubt.doubtful = 1e-9 * (std::abs(held) + reach);
        doubt.bend = std::abs(doubt.factor) * bend_of(*doubt.falls, h) + (doubt.against ? bend_of(*doubt.against, h) : 0);
        list[count++] = doubt;
    }

    bool hold_at(double t) const {
        if (all) return false;
        return std::all_of(list.begin(), list.begin() + count, [t](const Doubt& d) { return d.at(t) > d.doubtful; });
    }

    /// Moments to look at between two others: where a condition may fail for a time that is over at the second.
    std::vector<double> dips(double from, double to) const {
        std::vector<double> moments;
        for (std::size_t i = 0; i < count; ++i)
            if (const auto moment = list[i].dip(from, to)) moments.push_back(*moment);
        std::sort(moments.begin(), moments.end());
        return moments;
    }
};

Doubts doubts_of(const Problem& problem, const ContactSeries& z, double h) {
    Doubts doubts;
    const bool on_edge = problem.support == Support::edge, on_vertex = problem.support == Support::vertex;
    doubts.all = on_edge && problem.sticks();
    if (doubts.all) return doubts;
    doubts.unless_proven({&z.normal}, h);
    if (on_edge) doubts.unless_proven({&z.second}, h);
    if (on_vertex) doubts.unless_proven({&z.chi, &z.chi, 0, -problem.scene.widest_chi}, h);  // χ_m − |χ|
    if (problem.scene.mu == 0) return doubts;
    if (problem.sticks()) {
        doubts.unless_proven({&z.normal, &z.friction, problem.scene.mu}, h);  // μλ − |f|
        return doubts;
    }
    if (on_vertex) doubts.unless_proven({&z.stiffness, nullptr, 1, painleve_margin}, h);
    doubts.unless_proven({&z.ut, nullptr, problem.motion == ContactMotion::sliding_backward ? -1.0 : 1.0}, h);
    return doubts;
}

/// Does the neighbour, at the wall already, go on outwards? Its strike may be over before the first look.
bool strikes_at_once(const Problem& problem, const Step& step) {
    if (problem.support != Support::vertex) return false;
    const State start = step.at(0);
    if (start.room(problem.scene.widest_chi) > 0) return false;
    const double outwards = start.value[1] < 0 ? -step.series().chi[1] : step.series().chi[1];
    const double rates = 1 + std::abs(start.value[2]) + std::abs(start.value[3]);
    return outwards > 64 * std::numeric_limits<double>::epsilon() * rates;
}

/// The first of the conditions that fail at `to`.
Failure failure_by(const Problem& problem, const Step& step, double from, double to) {
    const Conditions now = conditions_of(problem, step.at(to));
    Failure first;
    for (std::size_t k = 0; k < most_conditions; ++k) {
        if (!(now[k].value < 0)) continue;
        const double time = locate(problem, step, from, to, k);
        if (!first.found || time < first.time) first = {time, k, true};
    }
    return first;
}

/// Looks at a step's parts in turn, where it is not proven that nothing ends the motion: at the series, also where a
/// condition is lowest between two looks, and at the forces themselves where it is close. A condition that begins at its
/// border (λ = 0 after a release that did not happen, |χ| = χ_m after a strike) and moves inwards holds: only a negative
/// value fails.
Failure first_failure(const Problem& problem, const Step& step, double h) {
    if (strikes_at_once(problem, step)) return {0, strike_condition, true};
    const Doubts doubts = doubts_of(problem, step.series(), h);
    if (!doubts.all && doubts.count == 0) return {};
    for (int look = 1; look <= looks_per_step; ++look) {
        const double from = h * (look - 1) / looks_per_step, to = h * look / looks_per_step;
        for (const double moment : doubts.dips(from, to))
            if (const Failure failure = failure_by(problem, step, from, moment); failure.found) return failure;
        if (doubts.hold_at(to)) continue;
        if (const Failure failure = failure_by(problem, step, from, to); failure.found) return failure;
    }
    return {};
}

/// A step whose looks are short against the swirl and the body's own motion (a disk's spin moves nothing).
double longest_step(const ContactScene& scene, Support support, const ContactState& z) {
    const double spin = support == Support::rim ? 0 : std::abs(z.spin);
    return 1 / (1 + spin + std::abs(normal_rate(scene, support, z)));
}

/// Of the last terms of a step; what is left out after them is smaller by the step's ratio to the distance of the
/// nearest singularity.
constexpr double local_error = 1e-16;

/// Shows a step to a sink, in parts short enough to interpolate between.
void show(const Problem& problem, const Step& step, double time, double h, const ContactSink& sink) {
    constexpr int parts = 4;
    for (int part = 1; part <= parts; ++part) {
        const double t = part == parts ? h : h * part / parts;
        const State at = step.at(t);
        sink({time + t, at.value[4], at.value[5]}, problem.support, problem.motion, at.contact());
    }
}

/// A disk's pendulum is advanced in closed form if that spares so many steps' time, and if the contact holds by more
/// than this of its forces' scale wherever the pendulum comes: then nothing can end it.
constexpr double long_contact = 20;
constexpr double holds_beyond_doubt = 1e-9;

bool holds_for_ever(const ContactScene& scene, Support support, ContactMotion motion, const ContactState& z) {
    if (support != Support::rim || (scene.mu > 0 && motion != ContactMotion::sticking)) return false;
    const RimPendulum pendulum = rim_pendulum(scene, z);
    const double scale = (1 + scene.mu) * (scene.body.beta + scene.body.inner * (1 + 2 * pendulum.height));
    return least_hold(scene, pendulum) > holds_beyond_doubt * scale;
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
                       double duration, const ContactSink& sink) {
    const Problem problem{scene, support, motion};
    if (!sink && duration > long_contact * longest_step(scene, support, start) &&
        holds_for_ever(scene, support, motion, start))
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
    // Ends at: an event, the duration, or the step limit.
    while (time < duration && ++end.steps <= most_contact_steps) {
        const Step step(problem, y);
        const double h = std::min({step_of(step.series(), local_error), longest_step(scene, support, y.contact()),
                                   duration - time});
        const Failure failure = first_failure(problem, step, h);
        if (failure.found) {
            const Condition condition = conditions_of(problem, y)[failure.which];
            end.first_lifts = condition.first_lifts;
            if (sink && failure.time > 0) show(problem, step, time, failure.time, sink);
            return finish(condition.event, failure.time > 0 ? step.at(failure.time) : y, time + failure.time);
        }
        if (sink) show(problem, step, time, h, sink);
        y = step.at(h);
        time = duration - time <= h ? duration : time + h;
    }
    return finish(ContactEvent::horizon, y, time);
}

}  // namespace swirl
