// `swirl sweep`: the modes across parameters.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/studies/basins/basins.hpp"
#include "apps/studies/basins/saddles.hpp"
#include "apps/studies/basins/tracks.hpp"
#include "apps/studies/grids/run_cells.hpp"
#include "apps/studies/grids/starts.hpp"
#include "apps/studies/modes/attractors.hpp"
#include "apps/studies/modes/early_chaos.hpp"
#include "apps/sweep/grid_options.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace swirl::apps::sweep {

struct SweepOptions {
    SceneOptions scene;
    StartOptions start;
    OutputOptions output;
    std::vector<std::string> grid;
    std::string sample;  ///< sobol:COUNT, latin:COUNT; empty: a grid
    std::string scenes;  ///< a file of scenes in place of a grid
    std::string shard;   ///< i/n; empty: all of it
    int refine = 0;      ///< levels; 0: the grid
    bool track = false;  ///< attractors are followed from cell to cell
    std::int64_t runs = 1;
    std::int64_t saddles = 0;  ///< so many places on the boundaries of basins are followed to their saddles
    double risk = 0;           ///< of chaos that is called before the limits
    double error = std::numeric_limits<double>::infinity();  ///< of their mean S, to which it is followed on
    analysis::ClassifyOptions settings;

    void add_to(Flags& command);
};

extern const char* const sweep_details;

/// One of n parts of a sweep: the cells whose number is i − 1 modulo n.
struct Shard {
    std::int64_t number = 1, of = 1;
};
/// i/n. @throws BadInput unless 1 ≤ i ≤ n ≤ 10⁶
Shard shard_from(const std::string& text);
/// Everything that the results depend on, in one order. The scene's gridded parameters stand in the grid.
Settings settings_of(const SweepOptions& options, const std::vector<GridAxis>& grid);
/// What is asked of every cell. @throws BadInput, std::invalid_argument if the first cell's scene is none
GridStudy study_of(const SweepOptions& options, const std::vector<GridAxis>& grid);

/// A sweep, whole: what was asked for and what was found. Results of cell c, run r are at c · runs + r.
struct Sweep {
    std::vector<GridAxis> grid;
    std::int64_t runs = 1;
    Settings settings;  ///< everything that the results depend on, in the order in which it is compared
    std::vector<RunResult> results;
    std::vector<std::vector<SteadyShare>> steady;             ///< of each cell
    std::vector<char> visited = {};                           ///< 1 of the cells that were looked at; empty: all
    std::optional<Basins> basins = {};                        ///< of a grid over numbers of the start
    std::vector<std::vector<CellAttractor>> attractors = {};  ///< of each cell, where they are tracked
    Tracking tracking = {};
    std::optional<Boundaries> boundaries = {};  ///< of basins, where they are asked for
    std::vector<RiskEvidence> risk = {};        ///< when chaos is called; of --refine for each round of cells
    std::optional<Shard> shard = {};            ///< whose cells they are
    std::optional<Units> units = {};

    std::span<const SteadyShare> steady_of(std::size_t cell) const {
        return steady.empty() ? std::span<const SteadyShare>() : std::span<const SteadyShare>(steady[cell]);
    }
    bool is_visited(std::size_t cell) const { return visited.empty() || visited[cell] != 0; }
    std::span<const RunResult> cell(std::size_t index) const {
        return std::span(results).subspan(index * static_cast<std::size_t>(runs), static_cast<std::size_t>(runs));
    }
};

/// Leaves the shard's cells.
void take_shard(const Shard& shard, Sweep& sweep);
/// The record of a shard: settings, shard, and the results of its cells. @throws RecordError
void write_shard(const SweepOptions& options, const Sweep& sweep);
/// Reads it into a sweep with the same shard, and settings as read_sweep() wants them. @throws BadInput
bool read_shard(const std::string& path, Sweep& sweep, std::vector<char>& done);

/// The attracting steady modes of every cell, with their shares of the runs. False if interrupted.
bool find_steady_modes(const SweepOptions& options, Sweep& sweep);

/// Of a grid over numbers of the start alone, which start came to what; else nothing.
void find_basins(Sweep& sweep);

/// What is found from the results of all runs, as asked for. False if interrupted.
bool look_into_results(const SweepOptions& options, Sweep& sweep);

/// A record of a finished sweep. @throws RecordError
void write_sweep(const SweepOptions& options, const Sweep& sweep);

/// Reads the results of a record that was made with the same settings, or with fewer runs and else the same. `done`
/// gets 1 at each result that it brought; true if these are all. @throws BadInput naming the first that differs
bool read_sweep(const std::string& path, Sweep& sweep, std::vector<char>& done);

/// True if the cells are the rows of a table of scenes.
bool is_of_scenes(const Sweep& sweep);

void print_sweep(const Sweep& sweep);           ///< the modes, and the shares of all runs
void print_modes(const Sweep& sweep);           ///< of the cells: a table over one parameter, a map over more
void write_sweep_document(const Sweep& sweep);  ///< JSON

int sweep(SweepOptions& options);

struct JoinOptions {
    OutputOptions output;
    std::vector<std::string> shards;

    void add_to(Flags& command);
};
extern const char* const join_details;

/// `swirl join`: the record of a sweep from those of all its shards. @throws BadInput
int join(JoinOptions& options);

}  // namespace swirl::apps::sweep
