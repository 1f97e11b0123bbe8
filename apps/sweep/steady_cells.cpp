#include "apps/command_line/parallel_pieces.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/sweep/starts.hpp"
#include "apps/sweep/sweep_command.hpp"

#include <memory>

namespace swirl::apps::sweep {

bool find_steady_modes(const SweepOptions& options, Sweep& sweep) {
    if (sweep.shard) return true;  // whoever joins them finds them
    sweep.steady.resize(cell_count(sweep.grid));
    Progress progress("sweep: steady modes", static_cast<double>(sweep.steady.size()), options.output.quiet);
    return run_pieces(sweep.steady.size(), options.output.threads, progress, [&](std::size_t c) -> KeepResult {
        if (!sweep.is_visited(c)) return [] {};
        std::vector<SettledRun> runs;
        for (const RunResult& run : sweep.cell(c)) runs.push_back({kind_of(run), run.mean_spin});
        auto modes =
            std::make_shared<std::vector<SteadyShare>>(steady_shares(cell_scene(options.scene, sweep.grid, c), runs));
        return [&sweep, c, modes] { sweep.steady[c] = std::move(*modes); };
    });
}

void find_basins(Sweep& sweep) {
    if (!sweep.shard && are_all_of_the_start(sweep.grid)) sweep.basins = basins_of(sweep.results, sweep.visited);
}

}  // namespace swirl::apps::sweep
