#include "apps/studies/diagrams/column_shares.hpp"

#include "apps/studies/modes/attractors.hpp"

namespace swirl::studies::diagrams {

std::vector<ColumnShare> shares_of(const DiagramColumn& column, std::size_t number) {
    std::vector<const Attractor*> starts;
    for (const Attractor& attractor : column.attractors)
        if (attractor.origin == Origin::random) starts.push_back(&attractor);
    if (starts.empty())
        for (const Attractor& attractor : column.attractors) starts.push_back(&attractor);
    std::vector<RunVerdict> runs;
    for (const Attractor* start : starts) {
        RunVerdict run;
        run.mode = start->mode;
        run.kind = start->kind;
        run.outcome = start->outcome;
        run.period = start->period;
        run.mean_spin = start->mean_spin;
        run.mean_spin_per_impact = start->mean_spin_per_impact;
        run.mean_errors = start->mean_errors;
        run.growth = start->growth;
        run.limit_spin = start->limit_spin;
        runs.push_back(run);
    }
    std::vector<ColumnShare> shares;
    for (const auto& shared : attractors_of(runs))
        shares.push_back({&column, number, static_cast<double>(shared.runs.size()) / static_cast<double>(runs.size()),
                          starts[shared.runs.front()], shared.mean_spin, shared.mean_spin_error});
    return shares;
}

}  // namespace swirl::studies::diagrams
