// The map's laws of impact as the functions that a fit takes.
#pragma once

#include "analysis/fits/measured_impact.hpp"

#include <vector>

namespace swirl::studies {

/// Poisson's, Newton's and Stronge's law with Coulomb friction (map/model/impact.hpp), by these names, with their
/// derivatives by Jets. All are homogeneous: any units of length and time.
std::vector<analysis::NamedImpactLaw> impact_laws();

}  // namespace swirl::studies
