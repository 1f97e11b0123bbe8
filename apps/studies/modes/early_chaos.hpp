// Chaos that is called before the limits, at a risk that the user names.
//
// Nothing settles chaos: an orbit may leave it at any time, and is followed to the limits for that alone. How likely it
// is differs by orders of magnitude over a map, and little of it is seen in one run: after n impacts without an escape
// the rate of escape λ is below 3/n only (95 %), so that a run alone is never called before it is nearly at its limits.
// Three things tell more: whether another run of its cell has left, whether the scene's equations have an attracting
// steady mode that it may come to, and how fast neighbouring orbits part (long transients have small exponents).
//
// So all runs are followed to one early look. A run is a candidate if all runs of its cell are chaotic there (and the
// scene has no attracting steady mode, where that is asked), and its score is their mean exponent. Of a random sample
// of all runs the candidates are followed to the limits, too. By falling score, for more and more of them, N in all, of
// which k have another verdict at the limits, it is asked whether the share of such runs among all with that score or a
// higher one is below the risk: whether Clopper and Pearson's upper bound p(k, N) is, at 97.5 %. That share has the
// sample in it, whose changed runs are never called, so that those called have a larger one: where the sample is at
// most a third of all, the 97.5 % keep 95 % for them. With a larger sample nothing is called. The questions end with
// the first that is not answered so (a fixed sequence of tests, which keeps the chance for all of them together); the
// least score before is that from which chaos is called. All other runs are followed to the limits.
//
// Nothing is assumed of the law by which orbits leave, nor that the score is a good one: a bad one calls fewer.
// Sources: C. J. Clopper, E. S. Pearson, Biometrika 26 (1934) 404 (for draws without replacement on the safe side);
// Y. Geifman, R. El-Yaniv, Selective classification for deep neural networks, NeurIPS 30 (2017) (a threshold with a
// guaranteed risk); B. L. Wiens, Pharm. Stat. 2 (2003) 211 (fixed sequences of tests).
#pragma once

#include "apps/studies/modes/name_mode.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace swirl::studies {

/// What calls of chaos before the limits rest on.
struct RiskEvidence {
    std::int64_t runs = 0;                  ///< for which it holds
    std::int64_t impacts = 0;               ///< after which chaos is called; 0: at the limits alone
    double least_exponent = analysis::nan;  ///< mean over a cell's runs from which it is called; NaN: none
    std::int64_t least_runs = 0;      ///< fewer are all followed to the limits (least_runs below); 0: no look is early
    std::int64_t drawn = 0;           ///< runs of the sample
    std::int64_t followed = 0;        ///< candidates among them, which were followed to the limits
    std::int64_t judged = 0;          ///< those of them from that exponent on (of no call: of the first question) …
    std::int64_t changed = 0;         ///< … and of these so many have another verdict at the limits
    double bound = analysis::nan;     ///< the share of such runs among all that are called, at most (95 %)
    std::int64_t means_followed = 0;  ///< own runs that are called and whose mean was followed on
};

/// What is asked of runs that are numbered from 0, `each` after another of one cell.
struct RiskQuestion {
    std::size_t runs = 0, each = 1;
    double risk = 0;         ///< 0: none is taken
    std::uint64_t seed = 1;  ///< of the draws
    std::int64_t look = 0;   ///< when runs are looked at (early_look); 0: there is no room for it
    /// Runs that are called are followed on until the error of their mean S is no larger, to looks up to `last_look`,
    /// then to the limits.
    double error = std::numeric_limits<double>::infinity();
    std::int64_t last_look = 0;
};

/// A verdict, as far as calls need it.
struct SeenRun {
    bool known = false;  ///< it has settled or ended: its verdict is that at the limits
    bool chaotic = false;
    double exponent = 0;
    double mean_error = analysis::nan;  ///< standard error of mean S by time
};
SeenRun seen_of(analysis::Kind kind, Outcome outcome, double exponent, double mean_error);

/// How runs are followed by who has them.
struct RunsAtRisk {
    /// To a look (0: to the limits), and what is seen of each; none if it was stopped. Verdicts at the limits are
    /// kept.
    std::function<std::optional<std::vector<SeenRun>>(std::span<const std::size_t> runs, std::int64_t look)> follow;
    /// Keeps a verdict that the look gave.
    std::function<void(std::size_t run)> keep;
};

/// What was found.
struct FollowedAtRisk {
    RiskEvidence evidence;
    std::vector<std::size_t> sample;  ///< runs whose candidates were followed to the limits; empty: none was drawn
};

/// The look, of limits: the last one before a ninth of their impacts, at 432 at least; 0 where the transient is
/// shorter. (Of a map of hexagons a later one costs more than it tells, an earlier one tells less of small risks.)
std::int64_t early_look(const analysis::ClassifyOptions& limits);

/// The last look within the transient's impacts, from which on a verdict is one of the limits; 0: none is.
std::int64_t last_look(const analysis::ClassifyOptions& limits);

/// From so many runs on, all of them chaotic early, a sample tells of the risk: a third of them are twice as many as
/// the first question is about, and a twentieth more. 0 for a risk of 0. @throws std::invalid_argument as
/// follow_at_risk
std::int64_t least_runs(double risk);

/// Follows runs at a risk; where the sample would be more than a third of them, to the limits. A pure function of the
/// question and of what `follow` gives. None if that was stopped. Those whose mean is followed on can only come nearer
/// to their verdict at the limits: the bound is of all that are called at the first look.
///   own  the runs that are wanted, whole cells: all or, of a part of the work, some of all that are asked about
/// Cost: all runs to the look, a sample of 1/16 of all (of small maps up to 6/risk) to the limits, and what is not
/// called. Where the sample shows that nothing will be called (but for a chance of 1/1000: that only calls fewer), the
/// others go to the limits at once.
/// @throws std::invalid_argument unless 0 ≤ risk < 1
std::optional<FollowedAtRisk> follow_at_risk(const RiskQuestion& question, std::span<const std::size_t> own,
                                             const RunsAtRisk& runs);

/// True if the scene's equations have an attracting steady mode (attractors.hpp): chaos beside it may be a
/// transient.
bool has_attracting_steady_mode(const Scene<double>& scene);

/// The look at which chaos of one run alone is called: the first from which on its chance of leaving before the limits
/// is below the risk (chance_of_leaving in analysis/classification/escape_rate.hpp). 0, the limits, for a risk below
/// 0.9.
std::int64_t look_of_one(double risk, const analysis::ClassifyOptions& limits);

/// Numbers 0 … count − 1 in a random order, each made when it is asked for. Fisher and Yates' shuffle; Philox keyed by
/// the seed.
class RandomOrder {
public:
    RandomOrder(std::size_t count, std::uint64_t seed) : count_(count), seed_(seed) {}
    std::size_t left() const { return count_ - taken_; }
    /// The next `count` of them, or all that are left.
    std::vector<std::size_t> take(std::size_t count);

private:
    std::size_t count_, taken_ = 0;
    std::uint64_t seed_;
    std::unordered_map<std::size_t, std::size_t> moved_;
};

/// Numbers of pieces of work: run i to the limits is piece i, to the look piece `runs` + i, to the look after that
/// 2 `runs` + i …
struct RiskPieces {
    std::size_t runs = 0;
    std::int64_t look = 0;

    std::size_t number(std::size_t run, std::int64_t to) const;
    std::size_t run(std::size_t piece) const { return piece % runs; }
    /// Runs that are followed to the limits, and runs that are followed to a look.
    struct Group {
        std::int64_t look;
        std::vector<std::size_t> runs;
    };
    std::vector<Group> groups(std::span<const std::size_t> pieces) const;
};

}  // namespace swirl::studies
