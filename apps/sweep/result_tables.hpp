// What a sweep found beside its cells, each described once: basins and their boundaries, attractors and their tracks.
#pragma once

#include "apps/output/table.hpp"
#include "apps/record/record_writer.hpp"
#include "apps/studies/basins/basins.hpp"
#include "apps/studies/basins/saddles.hpp"
#include "apps/studies/basins/tracks.hpp"
#include "apps/sweep/sweep_command.hpp"

#include <vector>

namespace swirl::apps::sweep {

Table<Basin> basin_table();

Table<BoundaryPlace> place_table(const std::vector<GridAxis>& grid);
Table<Saddle> saddle_table();

///   tracked  with `cell` (in a record), `track` and `point`
Table<CellAttractor> cell_attractor_table(bool tracked = false);
Table<Tracking> tracking_table();
Table<Track> track_table();

/// The cells' attractors as rows of a record, and how often cycles were carried as attributes. @throws RecordError
void write_attractors(const RecordGroup& group, const Sweep& sweep);

}  // namespace swirl::apps::sweep
