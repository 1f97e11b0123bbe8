// What fit_impacts() does, of impacts in natural units.
#pragma once

#include "analysis/fits/fit_impacts.hpp"

namespace swirl::analysis {

/// Speeds and offsets about 1 (natural_units.hpp), at least `fewest_impacts` impacts, none with a gross error, one law
/// or more: see fit_impacts().
ImpactFit fit_in_natural_units(std::span<const MeasuredImpact> impacts, std::span<const NamedImpactLaw> laws,
                               const ImpactFitSettings& settings);

}  // namespace swirl::analysis
