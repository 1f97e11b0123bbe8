// The flights on which arithmetics are compared, and the orbits that they are taken from.
#pragma once

#include "apps/studies/scene_map/scene_map.hpp"
#include "apps/studies/scene_map/start.hpp"
#include "apps/studies/tradeoff/timing.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace swirl::studies::tradeoff {

// The starts of a scene that runs begin from: one that was given, or random ones from a seed on.

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

/// What rounding is compared over, beside one step.
inline constexpr int ten = 10;

/// A flight of an orbit in double.
struct DrawnFlight {
    PostImpactState<double> state;  ///< just after the impact that it begins with
    int in_a_row = 1;               ///< flights that follow one another from there, this one counted, at most ten
    bool begins_ten = false;        ///< one of the chains of ten, which do not overlap
    /// How much a relative change of the state, of α and of β grows over the flight and its impact, in the largest
    /// coordinate: max_i (Σ_j |∂F_i/∂z_j| max(1, |z_j|) + α |∂F_i/∂α| + β |∂F_i/∂β|) / max(1, |F_i|), and 1 for the
    /// rounding of the result itself.
    double condition = 1;
};

struct DrawnFlights {
    std::vector<DrawnFlight> flights;  ///< no two nearer to each other than 10⁻⁶ in every coordinate, nearly
    /// False where they come from the way there, too: the orbit ends, or returns to fewer than a hundred states.
    bool after_transient = true;
    std::int64_t steps = 0;                ///< looked at
    std::int64_t through_contact = 0;      ///< of these, on which sustained contact came between: left out
    Outcome outcome = Outcome::completed;  ///< how the first orbit ended within its transient and the steps after it
    std::int64_t impacts = 0;              ///< it then had
    /// Where arithmetics and models follow the orbit from: after the transient, or its first impact if it ends before.
    std::optional<PostImpactState<double>> begin;
    std::int64_t stretch = 0;                    ///< impacts that follow there, 4,096 at most
    std::vector<PostImpactState<double>> timed;  ///< starts of chains that are timed, of the orbit from `begin` on
    int timed_steps = ten;                       ///< 1 where the orbit has no ten flights in a row
};

/// Draws up to `count` flights: those after `transient` impacts of the first start; where these are too few, the
/// beginnings of this and further starts. A pure function of its arguments unless the budget is spent.
DrawnFlights draw_flights(const Scene<double>& scene, const OrbitStarts& starts, std::int64_t transient,
                          std::int64_t count, const Budget& budget);

}  // namespace swirl::studies::tradeoff
