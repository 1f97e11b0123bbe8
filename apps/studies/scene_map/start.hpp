// Where an orbit starts: in the laboratory, on the section, or at random.
#pragma once

#include "map/orbit/laboratory.hpp"

#include <cstdint>
#include <variant>

namespace swirl::studies {

/// A start in the laboratory, or a point of the section just after an impact.
template <class T>
using Start = std::variant<LabStart<T>, SectionPoint<T>>;

/// The random start number `run` of a seed: at the container's centre, |V| = speed in a random direction, a random
/// orientation, no spin. Philox 4×64 keyed by the seed, counter = run: any start can be made alone.
LabStart<double> random_start(double beta, double speed, std::uint64_t seed, std::uint64_t run);

/// The speed of Sun 2019 (docs/references.md) at ω_s = 1: |v| = 1 with R_c = 7.
inline constexpr double paper_speed = 1.0 / 7;

}  // namespace swirl::studies
