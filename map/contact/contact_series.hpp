// A contact motion as a power series in time.
//
// Every equation of motion (reaction.hpp) is made of sums, products, sine and cosine and at most one quotient, so the
// coefficients follow from one another by recurrence: one product of series costs k operations for the k-th, all of
// them together a few microseconds. A step is then a polynomial: the state at any moment of it costs no further
// evaluation of forces, and the forces can be bounded on the whole of it.
// Source: À. Jorba, M. Zou, A software package for the numerical integration of ODEs by means of high-order Taylor
// methods, Exp. Math. 14 (2005) 99.
#pragma once

#include "map/contact/contact_state.hpp"
#include "map/numbers/exact_sum.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace swirl {

namespace detail {

constexpr int series_order_for(int digits) {
    return digits <= 53 ? 24 : digits <= 64 ? 30 : 52;
}

}  // namespace detail

/// Order of the series: 24 in double. Steps are some ε^(1/24) = 0.22 of the distance to the nearest singularity; from
/// 20 to 28 the cost of a unit of time changes by less than a tenth. In more digits as many more, so that steps are as
/// long.
template <class T>
inline constexpr int series_order = detail::series_order_for(std::numeric_limits<Plain<T>>::digits);

template <class T>
using Series = std::array<T, series_order<T> + 1>;

/// Coefficients of tᵏ. Quantities that a motion does not have are zero.
template <class T>
struct ContactSeries {
    Series<T> psi{}, chi{}, ut{}, spin{};
    Series<T> turned{};     ///< ∫ S dt, from 0
    Series<T> work{};       ///< ∫ f(u_t − 1) dt, from 0
    Series<T> normal{};     ///< λ, to order − 1, as all that follows
    Series<T> second{};     ///< λ of an edge's other vertex
    Series<T> friction{};   ///< f
    Series<T> stiffness{};  ///< B₂ − sμB₃ of a vertex that slides
};

/// The motion from a state on.
///   psi_rest  the rounding error of ψ, to be added to it
template <class T>
ContactSeries<T> contact_series(const ContactScene<T>& scene, Support support, ContactMotion motion,
                                const ContactState<T>& start, const T& psi_rest = T(0));

/// Σ cₖ tᵏ over k ≥ 1: the change until time t.
template <class T>
T change_at(const Series<T>& series, const T& t);

/// Σ cₖ tᵏ, and its derivative.
template <class T>
T value_at(const Series<T>& series, const T& t);
template <class T>
T derivative_at(const Series<T>& series, const T& t);

/// Bounds the second derivative within t: Σ k(k − 1)|cₖ| tᵏ⁻².
template <class T>
T second_derivative_bound(const Series<T>& series, const T& t);

/// The largest step whose last terms are below `tolerance` of max(1, |value|) in each of ψ, χ, u_t, S and the sums;
/// infinite for a motion whose last terms vanish.
template <class T>
Plain<T> step_of(const ContactSeries<T>& series, const Plain<T>& tolerance);

/// Bounds Σ |cₖ| tᵏ over k ≥ 1.
template <class T>
T reach_of(const Series<T>& series, const T& t);

}  // namespace swirl

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
