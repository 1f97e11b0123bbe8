// Where curves of a plane begin: special points of branches along lines through it.
#pragma once

#include "apps/studies/bifurcation_curves/border_cycle.hpp"
#include "apps/studies/bifurcation_curves/plane.hpp"
#include "apps/studies/parallel/run_control.hpp"

#include <complex>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::studies::bifurcation_curves {

/// A cycle at which a curve begins, both ways.
struct StartingPoint {
    std::string kind;  ///< fold, flip, neimark-sacker, or a border's name
    analysis::CyclePoints points;
    Eigen::Vector2d p{0, 0};
    std::complex<double> multiplier;  ///< the critical one
    /// Of a border: the times of the flights, and the vertices on at their ends. Empty through sustained contact.
    std::vector<double> times{};
    std::vector<int> vertices{};
    /// Of stick-slip: the contact modes before and behind the border.
    std::vector<ContactMode> modes_before{}, modes_behind{};
    /// Of a point of a curve on a border, where all of this is known.
    std::optional<BorderCycle> border{};
};

/// Of multipliers the pair nearest to the unit circle, Im > 0; NaN if all are real.
std::complex<double> critical_pair(const std::vector<std::complex<double>>& multipliers);

/// Sets `times` and `vertices` of a starting point from the steps of its cycle, or of one beside it.
void name_flights(StartingPoint& start, const std::vector<analysis::ShootingStep>& steps);

struct LineOptions {
    int lines = 12;      ///< through the plane, each way, evenly spaced
    int columns = 24;    ///< of the diagram along a line
    int starts = 2;      ///< of a column
    int max_period = 4;  ///< of the cycles that are followed
    RunControl control = {};
};

/// Diagrams along lines through the plane (../diagrams), every cycle of a period followed along its line,
/// stable or not, with the branches that flips and branch points lead to; their special points. Start r of every column
/// is the random one of seed 1 + r. Cost: some 0.5 s a line.
std::vector<StartingPoint> starting_points_on_lines(const Scene<double>& scene, const Plane& plane,
                                                    const LineOptions& options);

/// Starting points from a cycle at p, followed along one axis of the plane for a tenth of it each way.
std::vector<StartingPoint> starting_points_about(const Scene<double>& scene, const Plane& plane,
                                                 const analysis::CyclePoints& cycle, const Eigen::Vector2d& p, int axis,
                                                 const LineOptions& options);

/// A run of a map: start `run` of the scene at p, with the map's seed and speed.
struct MapRun {
    Eigen::Vector2d p{0, 0};
    std::uint64_t run = 0;
};
struct MapStarts {
    std::uint64_t seed = 1;
    double speed = 0;
    std::int64_t transient = 0, collisions = 0;
};

/// Starting points from the cycles that runs of a map came to, followed along both lines through the run's cell.
std::vector<StartingPoint> starting_points_of_runs(const Scene<double>& scene, const Plane& plane,
                                                   const std::vector<MapRun>& runs, const MapStarts& starts,
                                                   const LineOptions& options);

}  // namespace swirl::studies::bifurcation_curves
