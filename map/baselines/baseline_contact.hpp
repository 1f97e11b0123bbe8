// Searches for the next contact to compare with only: what others do, each with its own way to miss a contact.
// map/baselines/README.md
//
// Each takes what `first_contact` takes and returns what it returns, `steps` being the moments at which the flight was
// evaluated. The vertex that began the flight counts as inside at τ = 0. None proves anything: the contact found need
// not be the first. `simultaneous` is never set. The work is bounded: `unresolved` where nothing was found within it.
#pragma once

#include "map/first_contact/first_contact.hpp"

namespace swirl {

/// ε of the report's solver: a point touches where 1 − |x| < ε.
inline constexpr double paper_tolerance = 1e-13;

/// The report's solver, as its appendix describes it. Four guesses: the times at which the centre, moving freely, has
/// gone so far that the circumscribed circle touches, or that two vertices touch, a circle at rest about the swirl's
/// centre with radius 1 − β, and one with 1 + β. In each interval between 0 and the guesses, and for each vertex, ten
/// bisections (the earlier half, if both see a change of sign), then Newton's method to |1 − |x|| < ε. A solution
/// counts if its vertex moves outward and no vertex is outside by more than ε; the earliest counts. Two roots in one
/// interval are seen as none, so that a contact is passed.
/// Cost: N times some 50 moments.
FirstContact<double> paper_contact(const Body<double>& body, const Flight<double>& flight);

/// Default spacing of `brent_contact`, in 1/ω_s: 628 moments in a turn of the swirl.
inline constexpr double brent_spacing = 0.01;

/// The exact flight at equally spaced moments; where a vertex's gap has changed its sign from inside to outside,
/// Brent's method (GSL) between the two, to rounding; the earliest of these roots. A vertex that is outside for less
/// than the spacing may be passed.
///   spacing  between moments, in 1/ω_s, > 0
/// Cost: τ/spacing moments of N vertices, those aside at which the circumscribed circle is inside.
/// Outcome: `unresolved` after 10⁶ moments or 5·10⁶ gaps.
FirstContact<double> brent_contact(const Body<double>& body, const Flight<double>& flight,
                                   double spacing = brent_spacing);

/// Default step of `fixed_step_contact`, in 1/ω_s: what 60 steps a second with ten sub-steps each are to a swirl of one
/// turn a second.
inline constexpr double fixed_step_length = 0.01;

/// As game physics does: steps of fixed length; at the first step at whose end a vertex is outside and moves outward,
/// the deepest one touches, and the body is put back so that this vertex is on the wall. The contact is late by up to
/// one step.
///   step  in 1/ω_s, > 0
/// Cost and outcome: as `brent_contact`.
FirstContact<double> fixed_step_contact(const Body<double>& body, const Flight<double>& flight,
                                        double step = fixed_step_length);

enum class BaselineSearch { paper, brent, fixed_step };

/// The search of that name, with its default spacing.
FirstContact<double> baseline_contact(BaselineSearch search, const Body<double>& body, const Flight<double>& flight);

namespace detail {

/// Bounds of the searches at equally spaced moments: some tenth of a second of work.
inline constexpr int most_moments = 1'000'000;
inline constexpr long most_gaps = 5'000'000;

}  // namespace detail

}  // namespace swirl
