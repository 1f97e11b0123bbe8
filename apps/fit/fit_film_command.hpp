// `swirl fit --series`: from a film to the report.
#pragma once

#include "apps/fit/fit_document.hpp"

namespace swirl::apps::fit {

/// @throws BadInput for what read_film() refuses, and for a film in which no law can be looked for, saying why
FitReport fit_of_film(FilmOptions& options, const analysis::ImpactFitSettings& settings);

}  // namespace swirl::apps::fit
