// `swirl bifurcate`: what orbits settle on, over one parameter, with the branches that lie beneath.
#pragma once

#include "apps/bifurcate/attractor.hpp"
#include "apps/branches/branches.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/modes/steady_shares.hpp"
#include "apps/ranks/hand_out.hpp"

#include <string>
#include <vector>

namespace swirl::apps::bifurcate {

struct BifurcateOptions {
    SceneOptions scene;
    StartOptions start;
    OutputOptions output;
    SampleSettings settings;
    std::string along;
    std::string observable = "S";
    std::int64_t starts = 4;
    bool follow = false;
    bool branches = false;
    int longest_branch = 12;

    void add_to(Flags& command);
};

extern const char* const bifurcate_details;

struct DiagramColumn {
    double parameter = 0;
    bool complete = true;               ///< false: interrupted before all of its orbits were followed
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
    bool interrupted = false;
};

/// The scene of a column. @throws std::invalid_argument out of range
Scene<double> column_scene(const BifurcateOptions& options, const ParameterRange& along, double value);

/// What other ranks do for `sample_columns`.
NamedWork work_of(const BifurcateOptions& options, const Diagram& diagram);
/// Samples every column from random starts; start r of every column is `classify --seed SEED + r`'s.
void sample_columns(const BifurcateOptions& options, Diagram& diagram, HandOut& hand_out);
/// Follows the attractor from column to column, upwards and downwards.
void follow_columns(const BifurcateOptions& options, Diagram& diagram);
/// The attracting steady modes of every column.
void find_steady_modes(const BifurcateOptions& options, Diagram& diagram);
/// Leaves out the orbits that an interruption cut short, and the columns that have no other.
void keep_finished(Diagram& diagram);
/// Continues every periodic attractor over the whole range, each branch once, and compares.
void continue_attractors(const BifurcateOptions& options, Diagram& diagram);

/// The mode and period that most random starts of a column have; the first of them on a tie.
const Attractor& typical(const DiagramColumn& column);

Settings diagram_settings(const BifurcateOptions& options, const Diagram& diagram);
/// The scene without the parameter that varies.
Settings diagram_scene(const BifurcateOptions& options, const Diagram& diagram);

void write_diagram_document(const BifurcateOptions& options, const Diagram& diagram);
void write_diagram_record(RecordWriter& record, const BifurcateOptions& options, const Diagram& diagram);
void print_diagram(const BifurcateOptions& options, const Diagram& diagram);

int bifurcate(BifurcateOptions& options);

}  // namespace swirl::apps::bifurcate
