#include "apps/studies/tradeoff/evidence.hpp"

#include "apps/studies/modes/attractors.hpp"
#include "apps/studies/parallel/pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace swirl::studies::tradeoff {

namespace {

constexpr double next_level = 10.0 / 3;   // of the ladder: at most so many times the impacts, and the time
constexpr std::int64_t first_starts = 8;  // go up all of the ladder before any other start does
constexpr std::int64_t few_starts = 4;    // fewer are not worth a block of their own

/// A verdict on one number of impacts.
struct Judged {
    RunVerdict verdict;
    double seconds = 0;
};
/// On several starts.
using Level = std::vector<std::optional<Judged>>;

/// Starts by their numbers.
struct Block {
    std::int64_t first, end;
    std::size_t size() const { return static_cast<std::size_t>(end - first); }
};

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

/// One number of impacts, all starts of a block; nothing if the budget was spent before the last.
std::optional<Level> judge_all(const Scene<double>& scene, const OrbitStarts& starts, Block block,
                               std::int64_t collisions, const Level& before, const Budget& budget,
                               const RunControl& control) {
    const std::size_t count = block.size();
    const auto level = std::make_shared<Level>(count);
    const std::string task = fmt::format("tradeoff: verdicts on {} impacts", collisions);
    const bool whole = run_pieces(count, task, control, [=, &budget](std::size_t i) -> KeepResult {
        if (budget.is_spent(evidence_share)) return {};
        const std::int64_t run = block.first + static_cast<std::int64_t>(i);
        const auto judged = judge(scene, starts, run, collisions, before[i], budget);
        if (!judged) return {};
        return [level, i, judged] { (*level)[i] = judged; };
    });
    if (!whole) return std::nullopt;
    return *level;
}

/// The levels of a ladder for a block of starts, up to where the next would take more than is left.
std::vector<Level> judge_levels(const Scene<double>& scene, const OrbitStarts& starts, Block block,
                                std::span<const std::int64_t> ladder, const Budget& budget, const RunControl& control) {
    std::vector<Level> levels;
    Level before(block.size());
    double begin = budget.spent();
    for (const std::int64_t collisions : ladder) {
        const auto level = judge_all(scene, starts, block, collisions, before, budget, control);
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

/// Adds the verdicts on further starts to levels that have the first ones.
///   seconds  that these took
void add_starts(const Scene<double>& scene, const OrbitStarts& starts, std::span<const std::int64_t> ladder,
                double seconds, const Budget& budget, const RunControl& control, std::vector<Level>& levels) {
    auto have = static_cast<std::int64_t>(levels.front().size());
    double of_one = seconds / static_cast<double>(have);
    while (have < starts.count) {
        const double begin = budget.spent();
        const double fit = (more_starts_share * budget.seconds() - begin) / of_one;
        if (!(fit >= few_starts)) return;
        const Block block{have,
                          std::min({2 * have, have + static_cast<std::int64_t>(std::min(fit, 1e6)), starts.count})};
        const auto count = static_cast<double>(block.size());
        const std::vector<Level> more = judge_levels(scene, starts, block, ladder, budget, control);
        if (more.size() < levels.size()) return;
        for (std::size_t k = 0; k < levels.size(); ++k)
            levels[k].insert(levels[k].end(), more[k].begin(), more[k].end());
        of_one = std::max(of_one, (budget.spent() - begin) / count);
        have = block.end;
    }
}

/// How far mean S on one number of impacts is from that on the most: the root mean square over the starts.
double mean_spin_differs(const Level& level, const Level& most) {
    double squares = 0;
    int count = 0;
    for (std::size_t run = 0; run < level.size(); ++run) {
        const double off = level[run]->verdict.mean_spin - most[run]->verdict.mean_spin;
        if (!std::isfinite(off)) continue;
        squares += off * off;
        ++count;
    }
    return count > 0 ? std::sqrt(squares / count) : std::nan("");
}

std::vector<EvidenceRow> rows_of(const std::vector<std::int64_t>& ladder, const std::vector<Level>& levels) {
    std::vector<EvidenceRow> rows;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const Level &level = levels[k], &last = levels.back();
        EvidenceRow row;
        row.collisions = ladder[k];
        row.verdict = level.front()->verdict;
        row.seconds = level.front()->seconds;
        const RunVerdict& most = last.front()->verdict;
        row.mean_spin_off = row.verdict.mean_spin - most.mean_spin;
        row.exponent_off = row.verdict.largest_exponent - most.largest_exponent;
        row.mean_spin_error = row.verdict.mean_errors.per_time;
        row.mean_spin_differs = mean_spin_differs(level, last);
        row.runs = static_cast<std::int64_t>(level.size());
        for (std::size_t run = 0; run < level.size(); ++run)
            row.changed += level[run]->verdict.mode != last[run]->verdict.mode ? 1 : 0;
        row.changed_rate = analysis::rate_interval(row.changed, row.runs);
        rows.push_back(row);
    }
    return rows;
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
                         const Budget& budget, const RunControl& control) {
    const double begin = budget.spent();
    const Block first{0, std::min(first_starts, starts.count)};
    std::vector<Level> levels = judge_levels(scene, starts, first, ladder, budget, control);
    Evidence evidence;
    evidence.whole = evidence.judged_most = levels.size() == ladder.size();
    if (levels.empty()) return evidence;
    const auto reached = std::span(ladder).first(levels.size());
    add_starts(scene, starts, reached, budget.spent() - begin, budget, control, levels);
    evidence.rows = rows_of(ladder, levels);
    if (!starts.is_random) return evidence;
    std::vector<RunVerdict> last;
    for (const auto& judged : levels.back()) last.push_back(judged->verdict);
    const auto is_spent = [&budget] { return budget.is_spent(orbits_share); };
    evidence.escape =
        escape_of_any(scene, starts.speed, last, chaos_judged_after, Accuracy::double_precision, control, is_spent);
    evidence.whole &= !is_spent();
    return evidence;
}

}  // namespace swirl::studies::tradeoff
