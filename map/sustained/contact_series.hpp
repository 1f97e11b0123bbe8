// A contact motion as a power series in time.
//
// Every equation of motion (reaction.hpp) is made of sums, products, sine and cosine and at most one quotient, so the
// coefficients follow from one another by recurrence: one product of series costs k operations for the k-th, all of
// them together a few microseconds. A step is then a polynomial: the state at any moment of it costs no further
// evaluation of forces, and the forces can be bounded on the whole of it.
// Source: À. Jorba, M. Zou, A software package for the numerical integration of ODEs by means of high-order Taylor
// methods, Exp. Math. 14 (2005) 99.
#pragma once

#include "map/sustained/contact_state.hpp"

#include <array>
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
