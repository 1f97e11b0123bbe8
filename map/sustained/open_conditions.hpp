// Conditions of a motion in contact that bounds of its series do not prove to hold along a step, and where they may
// fail. Internal to the integration of contact.
#pragma once

#include "map/sustained/contact_series.hpp"
#include "map/sustained/contact_watch.hpp"

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

}  // namespace swirl::contact_detail
