#include "map/sustained/contact_watch.hpp"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace swirl::contact_detail {

namespace {

constexpr Condition always{1, ContactEvent::horizon};

/// A contact is released where λ is below zero by this margin, so that the flight certainly accelerates away from the
/// wall.
constexpr double release_margin = 1e-13;
/// Where B₂ − sμB₃ is below this the normal force is called unbounded.
constexpr double painleve_margin = 1e-9;

/// The moment in (from, to] at which condition k fails, known to fail at `to`: on the side on which it fails.
double locate(const Problem& problem, const Step& step, double from, double to, std::size_t k) {
    const auto value = [&](double t) { return conditions_of(problem, step.at(t))[k].value; };
    double before = value(from);
    const double after = value(to);
    for (int halving = 1; !(before > 0); ++halving) {  // it may start at zero, rise, and fall again
        if (halving > 30) return from;
        const double nearer = from + std::ldexp(to - from, -halving);
        before = value(nearer);
        if (before > 0) from = nearer;
    }
    if (after == 0) return to;
    std::uintmax_t iterations = 80;
    return boost::math::tools::toms748_solve(value, from, to, before, after,
                                             boost::math::tools::eps_tolerance<double>(51), iterations)
        .second;
}

/// Number of parts in which a step is examined whose series does not prove that no event ends the motion.
constexpr int parts_per_step = 16;

/// An open condition: a series a − |b| that bounds do not prove to hold all along a step.
struct OpenCondition {
    const Series* falls = nullptr;    ///< a
    const Series* against = nullptr;  ///< b, null if there is none
    double factor = 1, border = 0;    ///< factor a − |b| − border > 0 while the condition holds
    double rounding = 0;              ///< values below this are rounding
    double bend = 0;                  ///< bounds its second derivative from above, on the step

    double at(double t) const {
        return factor * value_at(*falls, t) - (against ? std::abs(value_at(*against, t)) : 0) - border;
    }
    double rate_at(double t) const {
        const double rate = factor * derivative_at(*falls, t);
        return against ? rate - std::copysign(1.0, value_at(*against, t)) * derivative_at(*against, t) : rate;
    }

    /// The moment between two ends of a part at which the condition is lowest, if it fails there beyond rounding (some
    /// 10⁻¹³ of its terms) though it holds at both.
    ///   before, after  the values at the two
    std::optional<double> dip(double from, double to, double before, double after) const {
        Lowest lowest{-1e-4 * rounding, 0, false};
        seek(from, to, before, after, 8, lowest);
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

    /// The bound of the second derivative limits the fall of the condition between two moments and excludes a minimum
    /// where the first derivative does not change its sign; the other intervals are halved.
    void seek(double from, double to, double before, double after, int halvings, Lowest& lowest) const {
        const double width = to - from;
        if (std::min(before, after) - 0.125 * bend * width * width > lowest.value) return;
        const double leaving = rate_at(from), arriving = rate_at(to);
        if (leaving >= bend * width || arriving <= -bend * width) return;
        if (leaving < 0 && arriving > 0) {
            const double time = lowest_between(from, to);
            return lowest.note(at(time), time);
        }
        if (halvings == 0) return;
        const double middle = 0.5 * (from + to), between = at(middle);
        lowest.note(between, middle);
        seek(from, middle, before, between, halvings - 1, lowest);
        seek(middle, to, between, after, halvings - 1, lowest);
    }

    double lowest_between(double from, double to) const {
        std::uintmax_t iterations = 60;
        return boost::math::tools::toms748_solve([this](double t) { return rate_at(t); }, from, to,
                                                 boost::math::tools::eps_tolerance<double>(30), iterations)
            .first;
    }
};

struct OpenConditions {
    std::array<OpenCondition, most_conditions> list;
    std::size_t count = 0;
    bool all = false;  ///< the forces of an edge at rest are not unique and have no series

    /// Keeps the condition as open unless the bounds of its series prove that it holds for a time h.
    void unless_proven(OpenCondition condition, double h) {
        const double held =
            condition.factor * (*condition.falls)[0] - (condition.against ? std::abs((*condition.against)[0]) : 0);
        const double reach = std::abs(condition.factor) * reach_of(*condition.falls, h) +
                             (condition.against ? reach_of(*condition.against, h) : 0);
        if (held - condition.border > reach) return;
        condition.rounding = 1e-9 * (std::abs(held) + reach);
        condition.bend = std::abs(condition.factor) * bend_of(*condition.falls, h) +
                         (condition.against ? bend_of(*condition.against, h) : 0);
        list[count++] = condition;
    }

    using Values = std::array<double, most_conditions>;

    Values at(double t) const {
        Values values{};
        for (std::size_t i = 0; i < count; ++i) values[i] = list[i].at(t);
        return values;
    }

    bool hold(const Values& values) const {
        for (std::size_t i = 0; i < count; ++i)
            if (!(values[i] > list[i].rounding)) return false;
        return !all;
    }

    /// Moments to examine between two others: where a condition may fail and hold again at the second.
    std::vector<double> dips(double from, double to, const Values& before, const Values& after) const {
        std::vector<double> moments;
        for (std::size_t i = 0; i < count; ++i)
            if (const auto moment = list[i].dip(from, to, before[i], after[i])) moments.push_back(*moment);
        std::sort(moments.begin(), moments.end());
        return moments;
    }
};

OpenConditions open_conditions(const Problem& problem, const ContactSeries& z, double h) {
    OpenConditions conditions;
    const bool on_edge = problem.support == Support::edge, on_vertex = problem.support == Support::vertex;
    conditions.all = on_edge && problem.sticks();
    if (conditions.all) return conditions;
    conditions.unless_proven({&z.normal}, h);
    if (on_edge) conditions.unless_proven({&z.second}, h);
    if (on_vertex) conditions.unless_proven({&z.chi, &z.chi, 0, -problem.scene.widest_chi}, h);  // χ_m − |χ|
    if (problem.scene.mu == 0) return conditions;
    if (problem.sticks()) {
        conditions.unless_proven({&z.normal, &z.friction, problem.scene.mu}, h);  // μλ − |f|
        return conditions;
    }
    if (on_vertex) conditions.unless_proven({&z.stiffness, nullptr, 1, painleve_margin}, h);
    conditions.unless_proven({&z.ut, nullptr, problem.motion == ContactMotion::sliding_backward ? -1.0 : 1.0}, h);
    return conditions;
}

/// True if the neighbour, already at the wall, moves outwards: it might be back inside before the first moment
/// examined.
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

}  // namespace

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

Failure first_failure(const Problem& problem, const Step& step, double h) {
    if (strikes_at_once(problem, step)) return {0, strike_condition, true};
    const OpenConditions conditions = open_conditions(problem, step.series(), h);
    if (!conditions.all && conditions.count == 0) return {};
    OpenConditions::Values before = conditions.at(0);
    for (int part = 1; part <= parts_per_step; ++part) {
        const double from = h * (part - 1) / parts_per_step, to = h * part / parts_per_step;
        const OpenConditions::Values after = conditions.at(to);
        for (const double moment : conditions.dips(from, to, before, after))
            if (const Failure failure = failure_by(problem, step, from, moment); failure.found) return failure;
        before = after;
        if (conditions.hold(after)) continue;
        if (const Failure failure = failure_by(problem, step, from, to); failure.found) return failure;
    }
    return {};
}

}  // namespace swirl::contact_detail
