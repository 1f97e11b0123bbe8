// The starts of a scene that runs begin from: one that was given, or random ones from a seed on.
#pragma once

#include "apps/studies/scene_map/start.hpp"

namespace swirl::studies::tradeoff {

/// Seeds that may be used, from the first on: with 64, one verdict that differs still tells of less than 10 % at 95 %.
inline constexpr int most_starts = 64;

struct OrbitStarts {
    Start<double> first;
    bool is_random = false;
    double speed = 0;        ///< of random ones
    std::uint64_t seed = 0;  ///< of the first
    std::int64_t count = 1;  ///< how many there are

    Start<double> start(double beta, std::int64_t run) const {
        return is_random ? random_start(beta, speed, seed + static_cast<std::uint64_t>(run), 0) : first;
    }
};

}  // namespace swirl::studies::tradeoff
