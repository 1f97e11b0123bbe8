#include "apps/command_line/run_control.hpp"
#include "apps/studies/basins/cell_verdicts.hpp"
#include "apps/studies/basins/saddles.hpp"
#include "apps/studies/basins/tracks.hpp"
#include "apps/sweep/sweep_command.hpp"

#include <cstddef>
#include <utility>

namespace swirl::apps::sweep {

bool find_steady_modes(const SweepOptions& options, Sweep& sweep) {
    if (sweep.shard) return true;  // whoever joins them finds them
    auto steady =
        steady_modes_of_cells(study_of(options, sweep.grid), sweep.results, sweep.visited, run_control(options.output));
    if (!steady) return false;
    sweep.steady = std::move(*steady);
    return true;
}

void find_basins(Sweep& sweep) {
    if (!sweep.shard && are_all_of_the_start(sweep.grid)) sweep.basins = basins_of(sweep.results, sweep.visited);
}

bool look_into_results(const SweepOptions& options, Sweep& sweep) {
    if (!find_steady_modes(options, sweep)) return false;
    const GridStudy study = study_of(options, sweep.grid);
    const RunControl control = run_control(options.output);
    if (options.track) {
        auto tracked = track_attractors(study, sweep.results, control);
        if (!tracked) return false;
        sweep.attractors = std::move(tracked->of_cells);
        sweep.tracking = tracked->tracking;
    }
    find_basins(sweep);
    if (options.saddles == 0 || !sweep.basins) return true;
    sweep.boundaries = find_saddles(study, sweep.results, sweep.visited, *sweep.basins,
                                    static_cast<std::size_t>(options.saddles), control);
    return sweep.boundaries.has_value();
}

}  // namespace swirl::apps::sweep
