// What is computed beside the bare map, each piece with and without, so that it can be priced on a scene.
#pragma once

#include "apps/studies/tradeoff/drawn_flights.hpp"
#include "apps/studies/tradeoff/timing.hpp"

#include <string>
#include <vector>

namespace swirl::studies::tradeoff {

/// One piece of the model.
struct ModelPiece {
    std::string name;
    std::string paid_by;      ///< which commands pay for it on this scene; "nothing" and why
    TimedWork with, without;  ///< `without` is empty of the bare map
};

/// The pieces that a scene has or could have. Empty where no flight was drawn.
///   drawn  is referred to
std::vector<ModelPiece> model_pieces(const Scene<double>& scene, const DrawnFlights& drawn);

}  // namespace swirl::studies::tradeoff
