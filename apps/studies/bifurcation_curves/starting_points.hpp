// Where curves of a plane begin: special points of branches along lines through it.
#pragma once

#include "apps/studies/bifurcation_curves/border_cycle.hpp"
#include "apps/studies/bifurcation_curves/plane.hpp"
#include "apps/studies/parallel/run_control.hpp"

#include <complex>
#include <cstddef>
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

/// Does the only impact of a fixed point vanish? On the line beyond which there is room to turn without a touch (alpha
/// + beta = 1), or at a flight time of 2π, where no other cycle goes on: a border that is known, and not followed.
bool has_vanishing_impact(const analysis::ShootingResidual& shooting);
inline constexpr const char* vanishing_kind = "vanishing-impact";  ///< a starting point's kind there

/// Sets `times` and `vertices` of a starting point from the steps of its cycle, or of one beside it.
void name_flights(StartingPoint& start, const std::vector<analysis::ShootingStep>& steps);

/// Which cycles are followed along a line.
enum class LineCycles {
    settled_on,  ///< those that orbits settle on (../diagrams)
    all,         ///< attracting or not: all fixed points of impacts alone, from their two equations (map/steady), and
                 ///< the longer ones that a search finds (../cycles)
};

struct LineOptions {
    int lines = 12;      ///< through the plane, each way, evenly spaced
    int columns = 24;    ///< places on a line where cycles are looked for
    int starts = 2;      ///< of a column, whose orbits settle
    int max_period = 4;  ///< of the cycles that are followed
    LineCycles cycles = LineCycles::settled_on;
    double max_time = 12;     ///< flight time of `all` fixed points, in 1/ω_s
    int search_columns = 2;   ///< places on a line where `all` longer cycles are searched for, …
    int search_starts = 300;  ///< … each from so many random section points of a period and the close returns of …
    int search_orbits = 4;    ///< … so many orbits
    RunControl control = {};
};

/// A line along one axis of the plane.
struct Line {
    int axis = 0;
    Eigen::Vector2d p{0, 0};  ///< of which only the other axis counts
    /// Of its columns, in their spacing: no two lines have theirs at the same places, so that a band which is narrower
    /// than the spacing but runs across lines is met.
    double offset = 0.5;
};

/// Of the columns of line number i.
double offset_of_line(int i);
/// Evenly spaced, `count` along either axis.
std::vector<Line> lines_through(const Plane& plane, int count);

/// What searches for cycles of one period found, one at each of some places on lines.
struct CycleSearches {
    int period = 2;
    std::size_t places = 0;
    std::int64_t found = 0;  ///< cycles of all places together …
    double missed = 0;       ///< … and of those that none of a place's candidates led to, Chao's estimate
};

/// Adds it to the entry of its period.
void add_search(std::vector<CycleSearches>& all, const CycleSearches& search);

/// The starting points of one line, and the searches on it, by period.
struct LineStarts {
    std::vector<StartingPoint> points;
    std::vector<CycleSearches> searches;
};

/// Every cycle found in a line's columns is followed along the whole line, stable or not, with the branches that flips
/// and branch points lead to; their special points, of each line by itself. Where orbits settle, start r of every
/// column is the random one of seed 1 + r. A line that a stop left has none.
/// Cost: some 0.5 s a line where orbits settle; of all fixed points with τ ≤ 12 some 3 s; of longer cycles minutes.
std::vector<LineStarts> starting_points_of_lines(const Scene<double>& scene, const Plane& plane,
                                                 const std::vector<Line>& lines, const LineOptions& options);

/// Those of all evenly spaced lines.
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
