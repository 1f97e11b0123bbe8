// `swirl fit --falls`: from films of falls to the report.
#pragma once

#include "apps/fit/fallen_bodies.hpp"
#include "apps/fit/fit_document.hpp"

namespace swirl::apps::fit {

/// @throws BadInput for what read_falls() refuses, and for falls to which no law can be fitted, saying why
FitReport fit_of_falls(FilmOptions& film, const FallsOptions& options, const analysis::ImpactFitSettings& settings);

}  // namespace swirl::apps::fit
