// `swirl bifurcate`: what orbits settle on, over one parameter, with the branches that lie beneath.
#pragma once

#include "apps/branches/branch_document.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/output/table.hpp"
#include "apps/ranks/hand_out.hpp"
#include "apps/studies/diagrams/column_shares.hpp"
#include "apps/studies/diagrams/diagram.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace swirl::apps::bifurcate {

using namespace studies::diagrams;

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
    double risk = 0;                                         ///< of chaos that is called before the limits
    double error = std::numeric_limits<double>::infinity();  ///< of their mean S, to which it is followed on

    void add_to(Flags& command);
};

extern const char* const bifurcate_details;

/// What the diagram is to be of.
DiagramSettings settings_of(const BifurcateOptions& options, const ParameterRange& along);

/// What other ranks do for `sample_columns`.
NamedWork work_of(const BifurcateOptions& options, const Diagram& diagram);
/// Samples every column from random starts; start r of every column is `classify --seed SEED + r`'s.
void sample_columns(const BifurcateOptions& options, Diagram& diagram, HandOut& hand_out);

Settings diagram_settings(const BifurcateOptions& options, const Diagram& diagram);
/// The scene without the parameter that varies.
Settings diagram_scene(const BifurcateOptions& options, const Diagram& diagram);

/// What the starts of the columns settle on: one line for each attractor of a column.
Table<ColumnShare> share_table(const Diagram& diagram);

void write_diagram_document(const BifurcateOptions& options, const Diagram& diagram);
void write_diagram_record(RecordWriter& record, const BifurcateOptions& options, const Diagram& diagram);
void print_diagram(const BifurcateOptions& options, const Diagram& diagram);

int bifurcate(BifurcateOptions& options);

}  // namespace swirl::apps::bifurcate
