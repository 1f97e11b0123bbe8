// What an orbit does, shown by other means than the classification's: a longer orbit, its own returns, and how fast a
// neighbour parts from it. Only a torus is known by an equal rotation number, of the longer orbit.
#pragma once

#include "analysis/classification/mode.hpp"
#include "apps/studies/scene_map/start.hpp"

#include <cstdint>
#include <optional>

namespace swirl::studies {

struct TruthOptions {
    std::int64_t transient = 40'000;  ///< impacts before those that are looked at
    std::int64_t tail = 20'000;
};

struct Truth {
    analysis::Mode mode = analysis::Mode::undecided;
    std::int64_t period = 0;
    std::int64_t nearly = 0;  ///< the period to 10⁻⁷: rounding that contact magnifies dithers by more than 10⁻⁹
    double exponent = 0, exponent_error = 0;
    bool ended = false;  ///< no impact any more before all were seen
};

/// In this order: the smallest k ≤ tail/2 with |z_{i+k} − z_i| ≤ 10⁻⁹ all along the tail's last quarter (k = 1 steady,
/// else quasi-steady; undecided if the orbit loses the period, to 10⁻⁷, when it is shaken by 10⁻¹³ at every impact:
/// where chaos lies between superstable landings, it is an accident of rounding); a largest exponent over 5
/// standard errors (and growth of e²⁰ at least, more than a bounded sum leaves), from a neighbour 10⁻⁸ away that is
/// drawn back there after every impact, no derivative: chaotic; a rotation number and a size that lasts: quasi-steady.
/// None of these: undecided.
Truth truth_of(const Scene<double>& scene, const Start<double>& start, const TruthOptions& options);

}  // namespace swirl::studies
