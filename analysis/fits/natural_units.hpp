// Measured impacts in units of their own, so that no tolerance of a fit depends on the table's.
#pragma once

#include "analysis/fits/fit_impacts.hpp"
#include "analysis/fits/measured_impact.hpp"

#include <span>

namespace swirl::analysis {

/// Powers of two, which change no digit.
struct NaturalUnits {
    double speed = 1;   ///< next to the median over the impacts of the largest change of a component of the velocity
    double length = 1;  ///< next to the median of |r|
};

/// 1 where a median is 0. O(impacts).
NaturalUnits natural_units(std::span<const MeasuredImpact> impacts);

/// v over the speed, S over speed/length, r over the length, errors alike.
MeasuredImpact in_units(const MeasuredImpact& impact, const NaturalUnits& units);
/// The way back.
inline MeasuredImpact from_units(const MeasuredImpact& impact, const NaturalUnits& units) {
    return in_units(impact, {1 / units.speed, 1 / units.length});
}

/// A number of an impact, in natural units, that is no measurement: a fit leaves the impact out.
inline constexpr double gross_error = 1e6;
bool has_gross_error(const MeasuredImpact& impact);

// What fit_impacts() does, of impacts in natural units.

/// Speeds and offsets about 1 (natural_units.hpp), at least `fewest_impacts` impacts, none with a gross error, one law
/// or more: see fit_impacts().
ImpactFit fit_in_natural_units(std::span<const MeasuredImpact> impacts, std::span<const NamedImpactLaw> laws,
                               const ImpactFitSettings& settings);

}  // namespace swirl::analysis
