#include "apps/studies/tradeoff/risk_ladder.hpp"

#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/parallel/pieces.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iterator>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace swirl::studies::tradeoff {

namespace {

/// Runs to the look, or to the limits.
struct TimedRuns {
    std::vector<NamedMode> named;
    double seconds = 0;
};

/// Some runs, both ways, and the time that all took.
struct TimedPiece {
    std::vector<RunAtBoth> runs;
    double seconds = 0;
};

SeenRun seen_of(const NamedMode& named) {
    return studies::seen_of(named.verdict.kind, named.outcome, named.verdict.largest_exponent,
                            named.mean_errors.per_time);
}

/// Of starts first … first + count − 1; none if the budget was spent before.
std::optional<TimedRuns> name_timed(const Scene<double>& scene, const OrbitStarts& starts, std::size_t first,
                                    std::size_t count, std::int64_t look, const Budget& budget) {
    using Clock = std::chrono::steady_clock;
    std::vector<SceneStart> some;
    for (std::size_t i = first; i < first + count; ++i)
        some.push_back({scene, starts.start(scene.beta, static_cast<std::int64_t>(i))});
    NamingOptions options;
    options.look = look;
    options.stop = [&budget] { return budget.is_spent(risk_share); };
    TimedRuns timed;
    timed.named.resize(count);
    std::size_t named = 0;
    const auto begin = Clock::now();
    name_modes(some, options, [&](std::size_t place, const NamedMode& mode, const OrbitSamples&) {
        timed.named[place] = mode;
        ++named;
    });
    timed.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    return named == count ? std::optional(std::move(timed)) : std::nullopt;
}

/// How these runs are followed at one risk.
RiskRow row_at(std::span<const RunAtBoth> runs, double risk, std::uint64_t seed, std::int64_t look, double seconds) {
    RiskRow row;
    row.risk = risk;
    row.runs = std::ssize(runs);
    RunsAtRisk at_risk;
    at_risk.follow = [&](std::span<const std::size_t> some, std::int64_t to) -> std::optional<std::vector<SeenRun>> {
        std::vector<SeenRun> seen;
        for (const std::size_t run : some) {
            row.impacts += to > 0 ? runs[run].impacts_to_look : runs[run].impacts_to_limits;
            seen.push_back(to > 0 ? runs[run].at_look : runs[run].at_limits);
        }
        return seen;
    };
    at_risk.keep = [&](std::size_t run) {
        if (!runs[run].at_look.chaotic) return;
        ++row.runs_called;
        row.changed += runs[run].at_limits.chaotic ? 0 : 1;
    };
    std::vector<std::size_t> all(runs.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const auto followed = follow_at_risk({runs.size(), 1, risk, seed, look}, all, at_risk);
    if (followed && row.runs_called > 0) row.bound = followed->evidence.bound;
    row.seconds = seconds * static_cast<double>(row.impacts);
    row.share_that_differs = static_cast<double>(row.changed) / static_cast<double>(row.runs);
    return row;
}

}  // namespace

std::vector<double> risk_ladder() {
    return {0.005, 0.01, 0.02, 0.05, 0.1, 0.2};
}

std::vector<RiskRow> risk_rows(std::span<const RunAtBoth> runs, const std::vector<double>& risks, std::uint64_t seed,
                               std::int64_t look, double seconds) {
    std::vector<RiskRow> rows;
    if (runs.empty()) return rows;
    rows.push_back(row_at(runs, 0, seed, look, seconds));
    for (const double risk : risks) rows.push_back(row_at(runs, risk, seed, look, seconds));
    return rows;
}

std::vector<RiskRow> measure_risks(const Scene<double>& scene, const OrbitStarts& starts, std::int64_t count,
                                   const Budget& budget, const RunControl& control) {
    if (!starts.is_random) return {};
    constexpr std::size_t of_a_piece = 16;  // fewer fill no lanes, more are lost where the budget ends
    const std::int64_t look = early_look(analysis::ClassifyOptions{});
    const auto all = static_cast<std::size_t>(count), pieces = (all + of_a_piece - 1) / of_a_piece;
    const auto found = std::make_shared<std::vector<std::optional<TimedPiece>>>(pieces);
    const auto name_piece = [=, &budget](std::size_t piece) -> KeepResult {
        const std::size_t first = piece * of_a_piece, some = std::min(of_a_piece, all - first);
        if (budget.is_spent(risk_share)) return {};
        const auto to_look = name_timed(scene, starts, first, some, look, budget);
        if (!to_look) return {};
        const auto to_limits = name_timed(scene, starts, first, some, 0, budget);
        if (!to_limits) return {};
        TimedPiece timed{{}, to_look->seconds + to_limits->seconds};
        for (std::size_t i = 0; i < some; ++i)
            timed.runs.push_back({seen_of(to_look->named[i]), seen_of(to_limits->named[i]), to_look->named[i].impacts,
                                  to_limits->named[i].impacts});
        return [=] { (*found)[piece] = timed; };
    };
    run_pieces(pieces, "tradeoff: chaos at a risk", control, name_piece);
    std::vector<RunAtBoth> runs;
    double seconds = 0, impacts = 0;
    for (const auto& piece : *found) {
        if (!piece) break;  // the budget was spent: those before are a sample by themselves
        runs.insert(runs.end(), piece->runs.begin(), piece->runs.end());
        seconds += piece->seconds;
        for (const RunAtBoth& run : piece->runs)
            impacts += static_cast<double>(run.impacts_to_look + run.impacts_to_limits);
    }
    return risk_rows(runs, risk_ladder(), starts.seed, look, seconds / std::max(impacts, 1.0));
}

double recommended_risk(const std::vector<RiskRow>& rows) {
    if (rows.empty()) return 0;
    constexpr double worth_it = 0.1, enough = 0.5;
    const auto saves = [&](const RiskRow& row) { return static_cast<double>(rows.front().impacts - row.impacts); };
    double most = 0;
    for (const RiskRow& row : rows) most = std::max(most, saves(row));
    if (!(most >= worth_it * static_cast<double>(rows.front().impacts)) || most == 0) return 0;
    for (const RiskRow& row : rows)
        if (saves(row) >= enough * most) return row.risk;
    return 0;
}

}  // namespace swirl::studies::tradeoff
