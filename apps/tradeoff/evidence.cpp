#include "apps/tradeoff/evidence.hpp"

#include "analysis/classification/tail.hpp"
#include "apps/command_line/parallel_pieces.hpp"
#include "apps/modes/run_verdict.hpp"
#include "apps/system/orbit_ending.hpp"
#include "apps/tradeoff/sampling_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

namespace swirl::apps::tradeoff {

namespace {

constexpr double next_level = 10.0 / 3;  // of the ladder: at most so many times the impacts, and the time

/// A verdict on one number of impacts.
struct Judged {
    RunVerdict verdict;
    double seconds = 0;
};
/// Of all starts; empty where the budget was spent.
using Level = std::vector<std::optional<Judged>>;

analysis::ClassifyOptions settings_for(std::int64_t collisions) {
    analysis::ClassifyOptions settings;
    settings.transient = settings.collisions = collisions;
    return settings;
}

/// The verdict on one start, where `before` is that on fewer impacts.
std::optional<Judged> judge(const Scene<double>& scene, const OrbitStarts& starts, std::int64_t run,
                            std::int64_t collisions, const std::optional<Judged>& before, const Budget& budget) {
    using Clock = std::chrono::steady_clock;
    if (before && before->verdict.outcome != Outcome::completed) return before;
    const auto begin = Clock::now();
    const NamedMode named =
        name_mode(scene, starts.start(scene.beta, run), settings_for(collisions), Accuracy::double_precision,
                  [&budget] { return budget.is_spent(evidence_share); });
    if (!named.finished) return std::nullopt;
    return Judged{run_verdict(starts.seed + static_cast<std::uint64_t>(run), named),
                  std::chrono::duration<double>(Clock::now() - begin).count()};
}

/// One number of impacts, all starts; nothing if the budget was spent before the last.
std::optional<Level> judge_all(const Scene<double>& scene, const OrbitStarts& starts, std::int64_t collisions,
                               const Level& before, const Budget& budget, const OutputOptions& output) {
    const auto count = static_cast<std::size_t>(starts.count);
    const auto level = std::make_shared<Level>(count);
    Progress progress(fmt::format("tradeoff: verdicts on {} impacts", collisions), static_cast<double>(count),
                      output.quiet);
    const bool whole = run_pieces(count, output.threads, progress, [=, &budget](std::size_t run) -> KeepResult {
        if (budget.is_spent(evidence_share)) return {};
        const auto judged = judge(scene, starts, static_cast<std::int64_t>(run), collisions, before[run], budget);
        if (!judged) return {};
        return [level, run, judged] { (*level)[run] = judged; };
    });
    if (!whole) return std::nullopt;
    return *level;
}

/// The levels of a ladder, up to where the next would take more than is left.
std::vector<Level> judge_levels(const Scene<double>& scene, const OrbitStarts& starts,
                                const std::vector<std::int64_t>& ladder, const Budget& budget,
                                const OutputOptions& output) {
    std::vector<Level> levels;
    Level before(static_cast<std::size_t>(starts.count));
    double begin = budget.spent();
    for (const std::int64_t collisions : ladder) {
        const auto level = judge_all(scene, starts, collisions, before, budget, output);
        if (!level) break;
        levels.push_back(*level);
        before = *level;
        const double took = budget.spent() - begin;
        begin = budget.spent();
        const bool ended = std::all_of(before.begin(), before.end(), [](const auto& judged) {
            return judged->verdict.outcome != Outcome::completed;
        });
        if (!ended && begin + next_level * took > evidence_share * budget.seconds()) break;
    }
    return levels;
}

/// Of the time mean of S over the impacts that the verdict on the first start looked at.
double sampling_error_of(const Scene<double>& scene, const OrbitStarts& starts, const EvidenceRung& rung) {
    if (rung.verdict.outcome != Outcome::completed) return std::nan("");
    if (rung.verdict.period > 0) return 0;
    return with_scene_map(scene, [&](const auto& map) {
        const OrbitBegin begin = begin_orbit(map, starts.start(scene.beta, 0));
        const auto tail = analysis::follow_tail(map, begin.state, rung.collisions + 1 - begin.impacts, rung.collisions);
        return time_mean(tail.integrals, tail.durations).error;
    });
}

std::vector<EvidenceRung> rungs_of(const Scene<double>& scene, const OrbitStarts& starts,
                                   const std::vector<std::int64_t>& ladder, const std::vector<Level>& levels) {
    std::vector<EvidenceRung> rungs;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const Level &level = levels[k], &last = levels.back();
        EvidenceRung rung;
        rung.collisions = ladder[k];
        rung.verdict = level.front()->verdict;
        rung.seconds = level.front()->seconds;
        const RunVerdict& most = last.front()->verdict;
        rung.mean_spin_off = rung.verdict.mean_spin - most.mean_spin;
        rung.exponent_off = rung.verdict.largest_exponent - most.largest_exponent;
        rung.mean_spin_error = sampling_error_of(scene, starts, rung);
        rung.runs = starts.count;
        for (std::size_t run = 0; run < level.size(); ++run)
            rung.changed += level[run]->verdict.mode != last[run]->verdict.mode ? 1 : 0;
        rung.changed_rate = analysis::rate_interval(rung.changed, rung.runs);
        rungs.push_back(rung);
    }
    return rungs;
}

}  // namespace

std::vector<std::int64_t> evidence_ladder(std::int64_t most) {
    std::vector<std::int64_t> ladder;
    for (std::int64_t decade = 100; decade <= most; decade *= 10)
        for (const std::int64_t collisions : {decade, 3 * decade})
            if (collisions <= most) ladder.push_back(collisions);
    return ladder;
}

Evidence gather_evidence(const Scene<double>& scene, const OrbitStarts& starts, const std::vector<std::int64_t>& ladder,
                         const Budget& budget, const OutputOptions& output) {
    const std::vector<Level> levels = judge_levels(scene, starts, ladder, budget, output);
    Evidence evidence;
    evidence.rungs = rungs_of(scene, starts, ladder, levels);
    evidence.whole = levels.size() == ladder.size();
    if (levels.empty() || !starts.is_random) return evidence;
    std::vector<RunVerdict> last;
    for (const auto& judged : levels.back()) last.push_back(judged->verdict);
    evidence.escape = escape_of(scene, starts.speed, last, output);
    return evidence;
}

}  // namespace swirl::apps::tradeoff
