#include "apps/tradeoff/tradeoff_command.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/run_control.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"
#include "apps/tradeoff/tradeoff_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace swirl::apps::tradeoff {

const char* const tradeoff_details =
    R"(Measures, on this machine and this scene, what accuracy costs, in four tables:
  arithmetic  each --accuracy on the same flights of the scene's orbit: seconds per collision (median of
              batches in turn, with quartiles), errors after one flight and after ten against quad,
              contacts missed and contacts out of order, with 95 % intervals (Clopper and Pearson; 0 of n
              says how large the rate may be all the same). Then each on its own orbit: verdict, mean S
              beside its sampling error, largest exponent, drift of J
  evidence    the verdict after 100 + 100, 300 + 300 ... impacts from up to 64 random starts (one, if it
              is given): how many have another mode after the most impacts, mean S and largest exponent,
              and how fast chaos ends, or how slowly at least. Fewer impacts are recommended where, on
              these and all larger numbers, less than 10 % of the starts have another mode at 95 %, and
              mean S differs by less than 0.05
  risk        what --risk (of sweep, bifurcate, classify --runs) would save on this scene: random starts are
              followed to the limits of classify, and for each risk it is counted which of them would have
              been called chaotic before, how many of these otherwise at the limits, and the time. The
              smallest that saves half of what the largest saves is recommended, if that is a tenth at all
  model       each piece of the model with and without, and which commands pay for it; no command pays for
              what the scene does not need
The cheapest --accuracy is recommended that missed and misordered no contact and whose verdict, where it can be compared, is
that of quad. The knee is the cheapest of all that found every contact and errs in a step by no more than 50 roundings of a
double times the step's condition.

What is counted depends on scene, start and budget, not on the machine; times do, and so do starts beyond the first eight. A
machine on which that takes more than the budget leaves the rest out, and the output says so.

Examples:
  swirl tradeoff --sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1 --budget 2
  swirl tradeoff --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 --budget 2 --json)";

void TradeoffOptions::add_to(Flags& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    command.add_option("--budget", budget, "SECONDS", "seconds that all of it may take (default 10)");
}

namespace {

constexpr double least_budget = 0.1, most_budget = 1e5;  // a day

OrbitStarts starts_of(const TradeoffOptions& options, const Scene<double>& scene, const Amounts& amounts) {
    OrbitStarts starts{options.start.start<double>(scene), options.start.is_random(), 0, 0, 1};
    if (!starts.is_random) return starts;
    options.start.require_seeds(static_cast<std::uint64_t>(std::max<std::int64_t>(most_starts, amounts.risk_runs)));
    starts.speed = options.start.speed();
    starts.seed = options.start.seed();
    starts.count = amounts.runs;
    return starts;
}

/// A start that is none is found before any work.
void check_start(const Scene<double>& scene, const Start<double>& start) {
    with_scene_map(scene, [&](const auto& map) { begin_orbit(map, start); });
}

}  // namespace

int tradeoff(TradeoffOptions& options) {
    const Budget budget(options.budget);
    if (!(options.budget >= least_budget && options.budget <= most_budget))
        throw BadInput(fmt::format("budget = {} is outside its range: {} to {} seconds", options.budget, least_budget,
                                   most_budget));
    options.scene.read_file(options.output.quiet);
    options.start.take_from(options.scene);
    const Scene<double> scene = options.scene.scene<double>();
    options.output.require_double("tradeoff measures all of them");
    const Amounts amounts(options.budget);
    const OrbitStarts starts = starts_of(options, scene, amounts);
    check_start(scene, starts.first);
    std::optional<RecordWriter> record = open_record(options.output, "Accuracy and cost of a swirled polygon's map",
                                                     {options.scene.file()}, options.scene.units());
    exit_when_interrupted();
    const Tradeoff found = measure(scene, starts, amounts, budget, run_control(options.output));
    exit_when_interrupted();
    if (record) {
        write_record(record->root(), options, scene, amounts, found);
        record->finish();
    }
    if (options.output.json)
        write_document(options, scene, amounts, found);
    else if (!options.output.quiet)
        print_tables(options, scene, found);
    return exit_done;
}

}  // namespace swirl::apps::tradeoff
