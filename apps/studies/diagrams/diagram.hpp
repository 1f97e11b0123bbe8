// The attractor diagram: what orbits settle on over one parameter, with the branches that lie beneath.
//
// Formula: at each value p of the parameter (a column) R orbits of z ↦ F(z; p) are followed from random starts until
// they settle, or from column to column from where the last one ended (hysteresis); what is kept is one period of each,
// or its impacts after a transient. Beneath lie the branches of their cycles, followed by pseudo-arclength.
// Source: the branches by E. L. Allgower and K. Georg, Introduction to Numerical Continuation Methods (2003).
#pragma once

#include "apps/studies/branches/branches.hpp"
#include "apps/studies/diagrams/attractor.hpp"
#include "apps/studies/modes/attractors.hpp"
#include "apps/studies/modes/early_chaos.hpp"
#include "apps/studies/parallel/run_control.hpp"
#include "apps/studies/scene_map/parameter_range.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace swirl::studies::diagrams {

/// What a diagram is of.
struct DiagramSettings {
    Scene<double> scene;     ///< at any value of the parameter
    ParameterRange along;    ///< with its columns
    SampleSettings samples;  ///< of each orbit
    double speed = paper_speed;
    std::uint64_t seed = 1;   ///< of random start 0; start r has seed + r, in every column
    std::int64_t starts = 4;  ///< random ones in a column
    int longest_branch = 12;  ///< the longest period that is continued
    double risk = 0;          ///< of chaos that is called before the limits, of the random starts (early_chaos.hpp)
    double error = std::numeric_limits<double>::infinity();  ///< of their mean S, to which they are followed on
};

struct DiagramColumn {
    double parameter = 0;
    bool complete = true;               ///< false: stopped before all of its orbits were followed
    std::vector<Attractor> attractors;  ///< random starts first, then those followed up and down
    std::vector<SteadyShare> steady;    ///< the attracting steady modes, with their shares of the random starts
};

/// How well samples and branches agree.
struct Agreement {
    std::int64_t compared = 0;  ///< periodic attractors whose cycle a stable branch with |multiplier| < 0.99 gives too
    std::int64_t without = 0;   ///< periodic attractors (period ≤ longest_branch, attracting) that lie on no branch
    std::int64_t in_families = 0;  ///< members of families, which no branch over the parameter goes through
    double largest = 0;            ///< the largest difference of S between the two
    double distance = 0;           ///< the largest distance of such an orbit's samples from its cycle
};

struct Diagram {
    ParameterRange along;
    std::vector<DiagramColumn> columns;
    std::vector<analysis::Branch> branches;
    Agreement agreement;
    std::vector<RiskEvidence> risk;  ///< when chaos of the random starts was called, if a risk was allowed
    bool interrupted = false;
};

/// The scene of a column. @throws std::invalid_argument out of range
Scene<double> column_scene(const DiagramSettings& settings, double value);

/// Random start number `run` of a column's scene.
Start<double> column_start(const DiagramSettings& settings, const Scene<double>& scene, std::int64_t run);

/// Follows the attractor from column to column, upwards and downwards: one more of each column a way.
void follow_columns(const DiagramSettings& settings, const RunControl& control, Diagram& diagram);
/// The attracting steady modes of every column, with their shares of its random starts.
void find_steady_modes(const DiagramSettings& settings, const RunControl& control, Diagram& diagram);
/// Leaves out the orbits that a stop cut short, and the columns that have no other.
void keep_finished(Diagram& diagram);
/// Continues every periodic attractor over the whole range, each branch once, and compares.
void continue_attractors(const DiagramSettings& settings, const RunControl& control, Diagram& diagram);

/// The mode and period that most random starts of a column have; the first of them on a tie.
const Attractor& typical(const DiagramColumn& column);

}  // namespace swirl::studies::diagrams
