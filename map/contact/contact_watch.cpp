#include "map/contact/contact_watch.hpp"

#include "map/contact/chatter_completion.hpp"
#include "map/contact/contact_series.hpp"
#include "map/contact/motion_choice.hpp"
#include "map/contact/reaction.hpp"
#include "map/map_list.hpp"
#include "map/numbers/quad.hpp"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace swirl::contact_detail {

namespace {

using std::abs, std::ldexp;

/// An open condition: a series a − |b| that bounds do not prove to hold all along a step.
template <class T>
struct OpenCondition {
    const Series<T>* falls = nullptr;    ///< a
    const Series<T>* against = nullptr;  ///< b, null if there is none
    T factor = T(1), border = T(0);      ///< factor a − |b| − border > 0 while the condition holds
    T rounding = T(0);                   ///< values below this are rounding
    T dips_below = T(0);                 ///< a minimum below this is examined
    T curvature = T(0);                  ///< bounds its second derivative from above, on the step

    T at(const T& t) const {
        using std::abs;
        return factor * value_at(*falls, t) - (against ? T(abs(value_at(*against, t))) : T(0)) - border;
    }
    T rate_at(const T& t) const {
        using std::copysign;
        const T rate = factor * derivative_at(*falls, t);
        return against ? T(rate - copysign(T(1), value_at(*against, t)) * derivative_at(*against, t)) : rate;
    }

    /// How far the condition may be below the lower of its values at the ends of a time `width`, within it.
    T may_fall(const T& width) const { return T(0.125) * curvature * width * width; }

    /// The moment between two ends of a part at which the condition is lowest, if it falls below `dips_below` there
    /// though it holds at both.
    ///   before, after  the values at the two
    std::optional<T> dip(const T& from, const T& to, const T& before, const T& after) const {
        Lowest lowest{dips_below, T(0), false};
        seek(from, to, before, after, 8, lowest);
        return lowest.found ? std::optional(lowest.time) : std::nullopt;
    }

private:
    struct Lowest {
        T value, time;
        bool found;

        void note(const T& v, const T& t) {
            if (v <= value) *this = {v, t, true};
        }
    };

    /// The bound of the second derivative limits the fall of the condition between two moments and excludes a minimum
    /// where the first derivative does not change its sign; the other intervals are halved.
    void seek(const T& from, const T& to, const T& before, const T& after, int halvings, Lowest& lowest) const {
        const T width = to - from;
        if (std::min(before, after) - may_fall(width) > lowest.value) return;
        const T leaving = rate_at(from), arriving = rate_at(to);
        if (leaving >= curvature * width || arriving <= -curvature * width) return;
        if (leaving < 0 && arriving > 0) {
            const T time = lowest_between(from, to);
            return lowest.note(at(time), time);
        }
        if (halvings == 0) return;
        const T middle = T(0.5) * (from + to), between = at(middle);
        lowest.note(between, middle);
        seek(from, middle, before, between, halvings - 1, lowest);
        seek(middle, to, between, after, halvings - 1, lowest);
    }

    T lowest_between(const T& from, const T& to) const {
        std::uintmax_t iterations = 60;
        return boost::math::tools::toms748_solve(
                   [this](const T& t) { return rate_at(t); }, from, to,
                   boost::math::tools::eps_tolerance<T>(std::numeric_limits<T>::digits / 2 + 4), iterations)
            .first;
    }
};

template <class T>
struct OpenConditions {
    std::array<OpenCondition<T>, most_conditions> list;
    std::size_t count = 0;
    bool all = false;  ///< the forces of an edge at rest are not unique and have no series

    /// Keeps the condition as open unless the bounds of its series prove that it holds for a time h.
    ///   room  it is that of a neighbour (`State::room`), known far below the rounding of χ: the least dip is examined.
    ///         Elsewhere a dip of 10⁻¹³ of the condition's terms is rounding.
    void unless_proven(OpenCondition<T> condition, const T& h, bool room = false) {
        using std::abs;
        const T held =
            condition.factor * (*condition.falls)[0] - (condition.against ? T(abs((*condition.against)[0])) : T(0));
        const T reach = abs(condition.factor) * reach_of(*condition.falls, h) +
                        (condition.against ? reach_of(*condition.against, h) : T(0));
        if (held - condition.border > reach) return;
        condition.rounding = tolerance<T>(1e-9) * (abs(held) + reach);
        condition.dips_below = room ? T(8 * epsilon<T>() * abs(condition.border)) : T(-1e-4 * condition.rounding);
        condition.curvature = abs(condition.factor) * second_derivative_bound(*condition.falls, h) +
                              (condition.against ? second_derivative_bound(*condition.against, h) : T(0));
        list[count++] = condition;
    }

    using Values = std::array<T, most_conditions>;

    Values at(const T& t) const {
        Values values{};
        for (std::size_t i = 0; i < count; ++i) values[i] = list[i].at(t);
        return values;
    }

    bool hold(const Values& values) const {
        for (std::size_t i = 0; i < count; ++i)
            if (!(values[i] > list[i].rounding)) return false;
        return !all;
    }

    /// Do all hold between two moments `width` apart, by the bound of their second derivatives?
    bool hold_between(const T& width, const Values& before, const Values& after) const {
        for (std::size_t i = 0; i < count; ++i)
            if (!(std::min(before[i], after[i]) - list[i].may_fall(width) > list[i].rounding)) return false;
        return !all;
    }

    /// Moments to examine between two others: where a condition may fail and hold again at the second.
    std::vector<T> dips(const T& from, const T& to, const Values& before, const Values& after) const {
        std::vector<T> moments;
        for (std::size_t i = 0; i < count; ++i)
            if (const auto moment = list[i].dip(from, to, before[i], after[i])) moments.push_back(*moment);
        std::sort(moments.begin(), moments.end());
        return moments;
    }
};

/// A contact is released where λ is below zero by this margin, so that the flight certainly accelerates away from the
/// wall.
template <class T>
T release_margin() {
    return tolerance<T>(1e-13);
}

/// A condition that is zero at the start, with second derivative b, comes above ε only if it holds for √(8ε/b). That of
/// a neighbour at the wall is known better than to ε (`State::room`), and is followed until its velocity is rounding:
/// it holds for that over b. More halvings than these find rounding.
template <class T>
constexpr int most_halvings(std::size_t k) {
    constexpr int digits = std::numeric_limits<T>::digits;
    return k == strike_condition ? digits + 4 : digits / 2 + 4;
}

/// The moment in (from, to] at which condition k fails, known to fail at `to`: on the side on which it fails.
///   margin  what the condition leaves to rounding: the moment is that at which it is so much
template <class T>
T locate(const Problem<T>& problem, const Step<T>& step, T from, const T& to, std::size_t k, const T& margin = T(0)) {
    const auto value = [&](const T& t) { return T(conditions_of(problem, step.at(t))[k].value - margin); };
    T before = value(from);
    const T after = value(to);
    for (int halving = 1; !(before > 0); ++halving) {  // it may start at zero, rise, and fall again
        if (halving > most_halvings<T>(k)) return from;
        const T nearer = from + ldexp(T(to - from), -halving);
        before = value(nearer);
        if (before > 0) from = nearer;
    }
    if (after == 0) return to;
    std::uintmax_t iterations = 80;
    return boost::math::tools::toms748_solve(value, from, to, before, after,
                                             boost::math::tools::eps_tolerance<T>(std::numeric_limits<T>::digits - 2),
                                             iterations)
        .second;
}

/// Number of parts in which a step is examined whose series does not prove that no event ends the motion.
constexpr int parts_per_step = 16;

template <class T>
OpenConditions<T> open_conditions(const Problem<T>& problem, const ContactSeries<T>& z, const T& h) {
    OpenConditions<T> conditions;
    const bool on_edge = problem.support == Support::edge, on_vertex = problem.support == Support::vertex;
    conditions.all = on_edge && problem.sticks();
    if (conditions.all) return conditions;
    conditions.unless_proven({&z.normal}, h);
    if (on_edge) conditions.unless_proven({&z.second}, h);
    if (on_vertex) conditions.unless_proven({&z.chi, &z.chi, T(0), -problem.scene.widest_chi}, h, true);  // χ_m − |χ|
    if (problem.scene.mu == 0) return conditions;
    if (problem.sticks()) {
        conditions.unless_proven({&z.normal, &z.friction, problem.scene.mu}, h);  // μλ − |f|
        return conditions;
    }
    if (on_vertex) conditions.unless_proven({&z.stiffness, nullptr, T(1), painleve_margin<T>()}, h);
    conditions.unless_proven({&z.ut, nullptr, problem.motion == ContactMotion::sliding_backward ? T(-1) : T(1)}, h);
    return conditions;
}

/// Does the neighbour move outwards at a time of the step, beyond rounding?
template <class T>
bool approaches(const Step<T>& step, const T& time) {
    const State<T> at = step.at(time);
    const T rate = derivative_at(step.series().chi, time);
    const T rates = 1 + abs(at.value[2]) + abs(at.value[3]);
    return (at.value[1] < 0 ? T(-rate) : rate) > 64 * epsilon<T>() * rates;
}

/// True if the neighbour, already at the wall, moves outwards: it might be back inside before the first moment
/// examined.
template <class T>
bool strikes_at_once(const Problem<T>& problem, const Step<T>& step) {
    if (problem.support != Support::vertex) return false;
    return !(step.from().room(problem.scene.widest_chi) > 0) && approaches(step, T(0));
}

/// Does a flight (or a jam) follow on the end of sticking? Where no slip is consistent (Painlevé) λ falls to zero at
/// once, so that a margin would make it late in first order; a slip begins with u_t′ = 0 and forgives it.
template <class T>
bool ends_abruptly(const Problem<T>& problem, const State<T>& at) {
    return !choose_motion(problem.scene, problem.support, at.contact(), 0, ContactEvent::slip).stays;
}

/// The moment in (from, to] at which condition k ends the motion.
template <class T>
T moment_of_failure(const Problem<T>& problem, const Step<T>& step, const T& from, const T& to, std::size_t k) {
    const T time = locate(problem, step, from, to, k);
    if (k != hold_condition || !problem.sticks()) return time;
    const State<T> at = step.at(time);
    if (!ends_abruptly(problem, at)) return time;
    return locate(problem, step, from, time, k, stick_margin(problem.scene, at.contact()));
}

/// The first of the conditions that fail at `to`.
template <class T>
Failure<T> failure_by(const Problem<T>& problem, const Step<T>& step, const T& from, const T& to) {
    const Conditions<T> now = conditions_of(problem, step.at(to));
    Failure<T> first;
    for (std::size_t k = 0; k < most_conditions; ++k) {
        if (!(now[k].value < 0)) continue;
        const T time = moment_of_failure(problem, step, from, to, k);
        if (!first.found || time < first.time) first = {time, k, true};
    }
    return first;
}

/// The first failure in the parts [first, last) of a step of length h: halved for as long as they are not proven to
/// hold, down to single parts.
///   before, after  the conditions at the two ends
template <class T>
Failure<T> failure_in_parts(const Problem<T>& problem, const Step<T>& step, const OpenConditions<T>& conditions,
                            const T& h, int first, int last, const typename OpenConditions<T>::Values& before,
                            const typename OpenConditions<T>::Values& after) {
    const auto moment_of = [&](int part) { return T(h * part / parts_per_step); };
    const T from = moment_of(first), to = moment_of(last);
    if (conditions.hold_between(T(to - from), before, after)) return {};
    if (last - first > 1) {
        const int middle = (first + last) / 2;
        const auto between = conditions.at(moment_of(middle));
        const Failure<T> failure = failure_in_parts(problem, step, conditions, h, first, middle, before, between);
        return failure.found ? failure : failure_in_parts(problem, step, conditions, h, middle, last, between, after);
    }
    for (const T& moment : conditions.dips(from, to, before, after)) {
        const Failure<T> failure = failure_by(problem, step, from, moment);
        if (failure.found && (failure.which != strike_condition || approaches(step, failure.time))) return failure;
    }
    return conditions.hold(after) ? Failure<T>{} : failure_by(problem, step, from, to);
}

}  // namespace

template <class T>
bool ends_second_chatter(const ContactScene<T>& scene, ContactMotion motion, const ContactState<T>& z) {
    const Rocking<T> rocking = rocking_of(scene, motion, z);
    const T v = scene.restitution * rocking.lever * abs(z.spin - z.ut);
    return rocking.acceleration > 0 &&
           2 * v * v <= chatter_tolerance<T>() * rocking.acceleration * (1 - scene.restitution);
}

template <class T>
Conditions<T> conditions_of(const Problem<T>& problem, const State<T>& y) {
    const ContactState<T> z = y.contact();
    const Reaction<T> r = reaction_of(problem.scene, problem.support, problem.motion, z);
    const T scale = problem.scene.body.beta + z.ut * z.ut + problem.scene.body.alpha * z.spin * z.spin;
    const Condition<T> always{T(1), ContactEvent::horizon};
    Conditions<T> c{always, always, always, always};
    if (problem.support == Support::edge) {
        if (!problem.sticks()) {
            c[0] = {r.normal + release_margin<T>() * scale, ContactEvent::lift, true};
            c[2] = {r.second + release_margin<T>() * scale, ContactEvent::lift, false};
        }
    } else {
        c[0] = {r.normal + release_margin<T>() * scale, ContactEvent::release};
    }
    if (problem.sticks())
        c[hold_condition] = {r.reserve + stick_margin(problem.scene, z), ContactEvent::slip};
    else if (problem.scene.mu > 0)
        c[hold_condition] = {problem.motion == ContactMotion::sliding_forward ? z.ut : T(-z.ut), ContactEvent::stick};
    if (problem.support == Support::vertex) {
        c[strike_condition] = {y.room(problem.scene.widest_chi), ContactEvent::strike};
        if (!problem.sticks() && problem.scene.mu > 0) c[3] = {r.stiffness - painleve_margin<T>(), ContactEvent::jam};
    }
    return c;
}

template <class T>
Failure<T> first_failure(const Problem<T>& problem, const Step<T>& step, const T& h) {
    if (strikes_at_once(problem, step)) return {T(0), strike_condition, true};
    const OpenConditions<T> conditions = open_conditions(problem, step.series(), h);
    if (!conditions.all && conditions.count == 0) return {};
    return failure_in_parts(problem, step, conditions, h, 0, parts_per_step, conditions.at(T(0)), conditions.at(h));
}

#define SWIRL_COMPILE_CONTACT_WATCH(T)                                                                \
    template bool ends_second_chatter(const ContactScene<T>&, ContactMotion, const ContactState<T>&); \
    template Conditions<T> conditions_of(const Problem<T>&, const State<T>&);                         \
    template Failure<T> first_failure(const Problem<T>&, const Step<T>&, const T&);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_CONTACT_WATCH)

}  // namespace swirl::contact_detail
