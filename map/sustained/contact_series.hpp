// A contact motion as a power series in time.
//
// Every equation of motion (reaction.hpp) is made of sums, products, sine and cosine and at most one quotient, so the
// coefficients follow from one another by recurrence: one product of series costs k operations for the k-th, all of
// them together a few microseconds. A step is then a polynomial: the state at any moment of it costs no further
// evaluation of forces, and the forces can be bounded on the whole of it.
// Source: À. Jorba, M. Zou, A software package for the numerical integration of ODEs by means of high-order Taylor
// methods, Exp. Math. 14 (2005) 99.
#pragma once

#include "map/sustained/contact_run.hpp"

#include <array>

namespace swirl {

/// Order of the series. Steps are some ε^(1/24) = 0.22 of the distance to the nearest singularity; from 20 to 28 the
/// cost of a unit of time changes by less than a tenth.
inline constexpr int series_order = 24;

using Series = std::array<double, series_order + 1>;

/// Coefficients of tᵏ. Quantities that a motion does not have are zero.
struct ContactSeries {
    Series psi{}, chi{}, ut{}, spin{};
    Series turned{};     ///< ∫ S dt, from 0
    Series work{};       ///< ∫ f(u_t − 1) dt, from 0
    Series normal{};     ///< λ, to order − 1, as all that follows
    Series second{};     ///< λ of an edge's other vertex
    Series friction{};   ///< f
    Series stiffness{};  ///< B₂ − sμB₃ of a vertex that slides
};

/// The motion from a state on.
///   psi_rest  the rounding error of ψ, to be added to it
ContactSeries contact_series(const ContactScene& scene, Support support, ContactMotion motion,
                             const ContactState& start, double psi_rest = 0);

/// Σ cₖ tᵏ over k ≥ 1: the change until time t.
double change_at(const Series& series, double t);

/// Σ cₖ tᵏ, and its derivative.
double value_at(const Series& series, double t);
double derivative_at(const Series& series, double t);

/// Bounds the second derivative within t: Σ k(k − 1)|cₖ| tᵏ⁻².
double bend_of(const Series& series, double t);

/// The largest step whose last terms are below `tolerance` of max(1, |value|) in each of ψ, χ, u_t, S and the sums;
/// infinite for a motion whose last terms vanish.
double step_of(const ContactSeries& series, double tolerance);

/// Bounds Σ |cₖ| tᵏ over k ≥ 1.
double reach_of(const Series& series, double t);

}  // namespace swirl
