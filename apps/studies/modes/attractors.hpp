// What several runs of one scene came to: their verdicts, their attractors, and the share of each.
#pragma once

#include "analysis/classification/growth.hpp"
#include "analysis/classification/mode.hpp"
#include "analysis/special_values.hpp"
#include "apps/studies/modes/means.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "map/model/scene.hpp"
#include "map/orbit/outcome.hpp"
#include "map/steady/steady_modes.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::studies {

// Which of several runs have settled on the same attractor.

/// What is kept of the verdict on one run. NaN where not measured.
struct RunVerdict {
    std::uint64_t seed = 0;
    analysis::Mode mode = analysis::Mode::undecided;
    analysis::Kind kind = analysis::Kind::none;
    Outcome outcome = Outcome::completed;
    std::int64_t impacts = 0;
    std::int64_t period = 0;  ///< 0: none
    double mean_spin = 0, mean_spin_per_impact = 0;
    double recurrence_rate = 0;
    double largest_exponent = 0, largest_exponent_error = 0;
    double ln_multiplier = 0;           ///< of a cycle: ln of its largest |multiplier|
    std::int64_t attractor = 0;         ///< its place among those of all runs
    std::vector<double> point;          ///< of its cycle
    MeanErrors mean_errors;             ///< of its own two means
    analysis::GrowthExponent growth;    ///< of one that is accelerated
    double limit_spin = analysis::nan;  ///< S* of one on a chord
};

/// Calls part(…) with each of its members, for who sends it elsewhere.
template <class Part>
void for_each_part(RunVerdict& run, Part&& part) {
    part(run.seed), part(run.mode), part(run.kind), part(run.outcome), part(run.impacts), part(run.period);
    part(run.mean_spin), part(run.mean_spin_per_impact), part(run.recurrence_rate);
    part(run.largest_exponent), part(run.largest_exponent_error), part(run.ln_multiplier), part(run.attractor);
    part(run.point), part(run.mean_errors), part(run.growth), part(run.limit_spin);
}

/// A set of runs with one verdict, and what they have in common.
struct SharedAttractor {
    std::vector<std::size_t> runs;  ///< their places, in order; the first is the representative
    double mean_spin = 0;           ///< mean over the runs that measured it; so are the next two
    double mean_spin_error = 0;     ///< its standard error over the runs; of one run its own, if that is sampled
    double recurrence_rate = 0;
    double largest_exponent = 0;
};

/// Mean values of S that differ by less than this, relative to max(1, |S|), are one attractor's. A cycle's mean comes
/// from its polished point, exact to rounding; what rests or slides on the wall is constant to 10⁻⁷.
inline constexpr double same_mean = 1e-6;

/// Are two means one attractor's? What neither has measured (NaN) agrees.
bool means_agree(double a, double b);

/// The most shared first; of equally shared ones that of the earlier run. Runs of one kind and period are one attractor
/// where their mean S (by time and by impact) agree, or the S to which their chord leads. Members of a continuum
/// (family, torus, libration, circulation), chaotic runs and undecided ones have means of their own, run by run: they
/// are grouped by kind and outcome alone.
std::vector<SharedAttractor> attractors_of(std::span<const RunVerdict> runs);

// What is kept of the verdict on one of several runs.

/// The verdict on the run from a seed; `attractor` is not known yet.
RunVerdict run_verdict(std::uint64_t seed, const NamedMode& named);

// The attracting steady modes of a scene, and which share of its starts came to each: 0 of one that none found.

struct SteadyShare {
    double spin = 0;         ///< S
    double flight_time = 0;  ///< τ, in 1/ω_s
    double multiplier = 0;   ///< the largest |multiplier|, < 1
    double share = 0;        ///< of the runs; 0: none came to it
};

/// What a run says of where it came to.
struct SettledRun {
    analysis::Kind kind;
    double mean_spin;
};

/// Those with a flight time up to `longest_attracting_flight`, by branch and rising flight time (map/steady/README.md).
/// A run is of the mode whose S its mean is (`same_mean`); where two have one S (1, the swirl's), of the first. None of
/// a disk or without friction: their steady modes are families, which have no share each. Cost: half a millisecond;
/// with thousands of sides and little friction up to 1.1 s.
std::vector<SteadyShare> steady_shares(const Scene<double>& scene, std::span<const SettledRun> runs);

}  // namespace swirl::studies
