// One step of a motion in contact: its power series from a state on. Internal to the integration of contact.
#pragma once

#include "map/numbers/exact_sum.hpp"
#include "map/sustained/contact_series.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace swirl::contact_detail {

inline constexpr std::size_t state_size = 6;  // ψ, χ, u_t, S, ∫S dt, ∫f(u_t − 1)dt
template <class T>
using Components = std::array<T, state_size>;

/// A state as value + rest: a step's small change is added without rounding error (compensated sum). Over 100 periods
/// of a pendulum the error is 1e-11, without `rest` 5e-10.
template <class T>
struct State {
    Components<T> value{};
    Components<T> rest{};

    ContactState<T> contact() const { return {value[0], value[1], value[2], value[3]}; }
    /// |χ| below `widest`: a neighbour's rebounds whose height is below the rounding of χ need it.
    T room(const T& widest) const {
        using std::abs;
        return (widest - abs(value[1])) - (value[1] < 0 ? T(-rest[1]) : rest[1]);
    }
};

template <class T>
struct Problem {
    const ContactScene<T>& scene;
    Support support;
    ContactMotion motion;

    bool sticks() const { return motion == ContactMotion::sticking; }
};

/// The motion from a state on.
template <class T>
class Step {
public:
    Step(const Problem<T>& problem, const State<T>& from)
        : from_(from),
          series_(contact_series(problem.scene, problem.support, problem.motion, from.contact(), from.rest[0])) {}

    const ContactSeries<T>& series() const { return series_; }
    /// The state at its begin.
    const State<T>& from() const { return from_; }

    /// The state t later.
    State<T> at(const T& t) const {
        const Series<T>* parts[] = {&series_.psi,  &series_.chi,    &series_.ut,
                                    &series_.spin, &series_.turned, &series_.work};
        State<T> to;
        for (std::size_t i = 0; i < state_size; ++i) {
            const ExactSum<T> sum = exact_sum(from_.value[i], T(from_.rest[i] + change_at<T>(*parts[i], t)));
            to.value[i] = sum.sum;
            to.rest[i] = sum.rest;
        }
        return to;
    }

private:
    State<T> from_;
    ContactSeries<T> series_;
};

}  // namespace swirl::contact_detail
