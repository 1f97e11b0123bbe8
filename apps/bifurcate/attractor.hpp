// What one start settles on: its samples, period and mode.
#pragma once

#include "analysis/classification/mode.hpp"
#include "apps/command_line/start_options.hpp"
#include "map/orbit/outcome.hpp"

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace swirl::apps::bifurcate {

struct SampleSettings {
    std::int64_t transient = 2500;  ///< impacts before those that are kept
    std::int64_t collisions = 500;  ///< impacts that are kept
    std::int64_t max_period = 128;
};

/// Where the start of a sample came from.
enum class Origin { random, up, down };

struct Attractor {
    bool finished = false;  ///< false: interrupted, and nothing else is meaningful
    Origin origin = Origin::random;
    std::int64_t start = 0;  ///< number of the random start
    Outcome outcome = Outcome::completed;
    analysis::Mode mode = analysis::Mode::undecided;
    analysis::Kind kind = analysis::Kind::none;
    std::int64_t period = 0;          ///< 0: none found
    double distance = 0;              ///< of the samples from the cycle, where there is one
    double mean_spin = std::nan("");  ///< time mean of S over the kept impacts, or over the period; NaN without
    std::vector<Eigen::VectorXd>
        states;            ///< the kept states; where there is a cycle one period of the orbit, settled on it
    Eigen::VectorXd last;  ///< the orbit's last state; empty without impacts
};

/// Follows a start and names what it settles on: steady or quasi-steady by a period of the kept states (returned to
/// within 10⁻⁹, or an attracting cycle found by Newton's method from the last state within the distance that the
/// orbit's own return suggests), chaotic by a tangent vector that grows by more than 5 standard errors, undecided
/// otherwise. What ends in contact is named as `classify` names it. An interruption is named (`finished` false); apart
/// from that a pure function of its arguments. Cost: one step of the map an impact, for irregular orbits some 5 more
/// for each of 400.
/// @throws std::invalid_argument for a start out of range
Attractor settle(const Scene<double>& scene, const Start<double>& start, const SampleSettings& settings);

}  // namespace swirl::apps::bifurcate
