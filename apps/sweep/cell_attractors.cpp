#include "apps/sweep/cell_attractors.hpp"

#include "apps/modes/attractors.hpp"
#include "apps/modes/mode_fields.hpp"

namespace swirl::apps::sweep {

namespace {

RunVerdict verdict_of(const RunResult& run) {
    RunVerdict verdict;
    verdict.mode = mode_of(run);
    verdict.kind = kind_of(run);
    verdict.outcome = static_cast<Outcome>(static_cast<int>(run.outcome));
    verdict.period = static_cast<std::int64_t>(run.period);
    verdict.mean_spin = run.mean_spin;
    verdict.mean_spin_per_impact = run.mean_spin_per_impact;
    return verdict;
}

}  // namespace

std::vector<CellAttractor> cell_attractors(std::span<const RunResult> runs) {
    std::vector<RunVerdict> verdicts;
    verdicts.reserve(runs.size());
    for (const RunResult& run : runs) verdicts.push_back(verdict_of(run));
    std::vector<CellAttractor> found;
    const auto all = static_cast<double>(runs.size());
    for (const SharedAttractor& shared : attractors_of(verdicts)) {
        const double share = static_cast<double>(shared.runs.size()) / all;
        found.push_back(
            {runs[shared.runs.front()], share, wilson_interval(share, all), shared.mean_spin, shared.mean_spin_error});
    }
    return found;
}

Table<CellAttractor> cell_attractor_table() {
    using Row = CellAttractor;
    return {{"attractor"},
            {{"mode", [](const Row& row) { return mode_of(row.first); }},
             kind_field<Row>([](const Row& row) { return kind_of(row.first); }),
             {"outcome", [](const Row& row) { return static_cast<Outcome>(static_cast<int>(row.first.outcome)); }},
             period_field<Row>([](const Row& row) { return static_cast<std::int64_t>(row.first.period); }),
             {"share", &Row::share},
             {"share_low", [](const Row& row) { return row.interval.low; }},
             {"share_high", [](const Row& row) { return row.interval.high; }},
             {"mean_S", &Row::mean_spin},
             {"mean_S_error", &Row::spin_error}}};
}

}  // namespace swirl::apps::sweep
