#include "apps/sweep/run_cells.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/output/value.hpp"
#include "apps/ranks/packed.hpp"
#include "apps/studies/basins/cell_verdicts.hpp"
#include "apps/studies/grids/refine.hpp"
#include "apps/studies/grids/run_cells.hpp"
#include "apps/studies/modes/early_chaos.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <numeric>
#include <optional>

namespace swirl::apps::sweep {

namespace {

struct RunColumn {
    const char* name;
    double RunResult::*member;
    const char* units;
    const char* long_name;
    ElementType type = ElementType::float64;
    std::vector<std::string> meanings = {};  ///< of a name's number
    std::optional<double> before = {};       ///< what stands for it where an older record lacks it
};

/// A number that older records lack.
RunColumn added(const char* name, double RunResult::*member, const char* long_name) {
    return {name, member, "1", long_name, ElementType::float64, {}, analysis::nan};
}

/// What a record holds of each run.
std::vector<RunColumn> run_columns() {
    const auto names = ElementType::uint8, count = ElementType::int64;
    std::vector<std::string> modes;
    for (const auto mode : all_modes) modes.emplace_back(name_of(mode));
    return {
        {"run_mode", &RunResult::mode, "", "mode", names, modes},
        {"run_kind", &RunResult::kind, "", "kind", names, names_up_to(analysis::Kind::riding)},
        {"run_outcome", &RunResult::outcome, "", "outcome", names, names_up_to(Outcome::contact_over_dry_floor)},
        {"run_period", &RunResult::period, "1", "period, 0: none", count},
        {"run_mean_S", &RunResult::mean_spin, "1", "time mean of S"},
        {"run_mean_S_per_impact", &RunResult::mean_spin_per_impact, "1", "mean of S over impacts"},
        {"run_recurrence_rate", &RunResult::recurrence_rate, "1", "RC of S"},
        {"run_largest_exponent", &RunResult::largest_exponent, "1", "largest Lyapunov exponent per impact"},
        {"run_impacts", &RunResult::impacts, "1", "impacts followed", count},
        added("run_mean_S_error", &RunResult::mean_spin_error, "standard error of run_mean_S along the run"),
        added("run_mean_S_per_impact_error", &RunResult::mean_spin_per_impact_error, "that of run_mean_S_per_impact"),
        {"run_mean_S_kind", &RunResult::mean_kind, "", "how its mean was come by", names,
         names_up_to(MeanKind::too_short), 0},
        added("run_growth_exponent", &RunResult::growth, "of kind accelerated: power of n by which J grows"),
        added("run_growth_exponent_low", &RunResult::growth_low, "from this power on, at 95 %"),
        added("run_growth_exponent_high", &RunResult::growth_high, "up to this power"),
        added("run_limit_S", &RunResult::limit_spin, "of kind chord: S to which the chord leads"),
    };
}

/// `use.template operator()<T>()` with the column's type in a record.
template <class Use>
void in_type_of(const RunColumn& column, const Use& use) {
    if (column.type == ElementType::uint8)
        use.template operator()<std::uint8_t>();
    else if (column.type == ElementType::int64)
        use.template operator()<std::int64_t>();
    else
        use.template operator()<double>();
}

}  // namespace

std::vector<std::string> outcome_names(std::span<const RunResult> results) {
    const auto above = [&](Outcome outcome) {
        return std::any_of(results.begin(), results.end(),
                           [&](const RunResult& result) { return result.outcome > static_cast<double>(outcome); });
    };
    if (above(Outcome::contact_of_corner)) return names_up_to(Outcome::contact_over_dry_floor);
    if (above(Outcome::contact_with_drag)) return names_up_to(Outcome::contact_of_corner);
    return names_up_to(above(Outcome::unresolved) ? Outcome::contact_with_drag : Outcome::unresolved);
}

std::vector<std::string> kind_names(std::span<const RunResult> results) {
    const bool rides = std::any_of(results.begin(), results.end(), is_riding);
    return names_up_to(rides ? analysis::Kind::riding : analysis::Kind::chord);
}

void write_run_columns(const RecordGroup& group, const std::vector<std::string>& axes,
                       std::span<const RunResult> results) {
    for (const auto& column : run_columns())
        in_type_of(column, [&]<class T>() {
            std::vector<T> values;
            for (const auto& result : results) values.push_back(static_cast<T>(result.*column.member));
            const auto meanings = column.member == &RunResult::outcome ? outcome_names(results)
                                  : column.member == &RunResult::kind  ? kind_names(results)
                                                                       : column.meanings;
            group.write<T>(column.name, axes, values, {column.units, column.long_name, meanings});
        });
}

std::vector<RunResult> read_run_columns(const RecordReader& record, const std::string& group) {
    std::vector<RunResult> results;
    for (const auto& column : run_columns())
        in_type_of(column, [&]<class T>() {
            const std::string path = group + "/" + column.name;
            const auto values = column.before && !record.contains(path)
                                    ? std::vector<T>(results.size(), static_cast<T>(*column.before))
                                    : record.read<T>(path);
            if (results.empty()) results.resize(values.size());
            const auto named = [&](T value) {
                return column.meanings.empty() || static_cast<std::size_t>(value) < column.meanings.size();
            };
            if (values.size() != results.size() || !std::all_of(values.begin(), values.end(), named))
                throw BadInput(fmt::format("a record's {}/{} does not fit its runs", group, column.name));
            for (std::size_t i = 0; i < values.size(); ++i) results[i].*column.member = static_cast<double>(values[i]);
        });
    return results;
}

namespace {

RiskPieces risk_pieces_of(const GridStudy& study) {
    const std::size_t runs = cell_count(study.grid) * static_cast<std::size_t>(study.runs);
    return {runs, risk_question(study, runs).look};
}

}  // namespace

NamedWork work_of(const SweepOptions& options, const Sweep& sweep) {
    const GridStudy study = study_of(options, sweep.grid);
    const auto work = [study, stop = interruption(), numbers = risk_pieces_of(study)](
                          std::span<const std::size_t> pieces, const KeepPiece& keep) {
        for (const RiskPieces::Group& group : numbers.groups(pieces)) {
            const auto keep_run = [&](std::size_t run, const RunResult& result) {
                keep({numbers.number(run, group.look), packed(result)});
            };
            name_runs(study, group.runs, stop, keep_run, group.look);
        }
    };
    return {name_of_work(sweep.settings), work, most_named_together()};
}

namespace {

/// A sweep whose runs are followed.
struct RunningSweep {
    const SweepOptions& options;
    Sweep& sweep;
    std::vector<char>& done;  ///< 1 of each result that is there
    SweepJournal* journal;
    HandOut& hand_out;
};

void keep_run(RunningSweep& running, std::size_t run) {
    if (running.done[run]) return;
    running.done[run] = 1;
    if (running.journal != nullptr) running.journal->append(run, running.sweep.results[run]);
}

/// Runs that were followed, to the look (0: to the limits); of those that are done already nothing is followed. Results
/// go to their own places, whatever thread or rank makes them; those of a look are kept for good by `keep_run` alone.
/// None if it was interrupted.
std::optional<std::vector<SeenRun>> follow(RunningSweep& running, std::span<const std::size_t> runs, std::int64_t look,
                                           const std::string& task) {
    Sweep& sweep = running.sweep;
    const SweepOptions& options = running.options;
    const RiskPieces numbers = risk_pieces_of(study_of(options, sweep.grid));
    std::vector<std::size_t> pieces;
    for (const std::size_t run : runs)
        if (look > 0 || !running.done[run]) pieces.push_back(numbers.number(run, look));
    std::map<std::size_t, SeenRun> at_look;  // of those that are done, whose results stay
    const auto keep = [&](const PieceResult& piece) {
        const std::size_t run = numbers.run(piece.piece);
        const auto result = unpacked<RunResult>(piece.bytes);
        if (running.done[run]) {
            at_look[run] = seen_of(result);
            return;
        }
        sweep.results[run] = result;
        if (look == 0) keep_run(running, run);
    };
    Progress progress(task, static_cast<double>(pieces.size()), options.output.quiet);
    const bool all = running.hand_out.run(pieces, options.output.threads, work_of(options, sweep), progress, keep);
    if (running.journal != nullptr) running.journal->flush();
    if (!all) return std::nullopt;
    std::vector<SeenRun> seen;
    for (const std::size_t run : runs) {
        const auto found = at_look.find(run);
        seen.push_back(found != at_look.end() ? found->second : seen_of(sweep.results[run]));
    }
    return seen;
}

std::vector<std::size_t> runs_of(const std::vector<std::size_t>& cells, const Sweep& sweep) {
    const auto each = static_cast<std::size_t>(sweep.runs);
    std::vector<std::size_t> runs;
    for (const std::size_t cell : cells)
        for (std::size_t r = 0; r < each; ++r) runs.push_back(cell * each + r);
    return runs;
}

/// Runs what is not done of these cells.
///   population  the cells for whose runs a risk holds; `cells` are their places among these
bool run_cells(RunningSweep& running, const std::vector<std::size_t>& cells, const std::vector<std::size_t>& population,
               const std::string& task) {
    const std::vector<std::size_t> all = runs_of(population, running.sweep), own = runs_of(cells, running.sweep);
    const auto names_of = [&](std::span<const std::size_t> places) {
        std::vector<std::size_t> names;
        for (const std::size_t place : places) names.push_back(all[place]);
        return names;
    };
    RunsAtRisk runs;
    runs.follow = [&](std::span<const std::size_t> places, std::int64_t look) {
        const std::string to_look = look > 0 ? fmt::format("{}, the first {} impacts", task, look) : task;
        return follow(running, names_of(places), look, to_look);
    };
    runs.keep = [&](std::size_t place) { keep_run(running, all[place]); };
    const auto followed =
        follow_at_risk(risk_question(study_of(running.options, running.sweep.grid), all.size()), own, runs);
    if (followed && running.options.risk > 0) running.sweep.risk.push_back(followed->evidence);
    return followed.has_value();
}

/// Coarse points first, then those that the tree asks for, until it asks for none.
bool run_tree(RunningSweep& running) {
    Sweep& sweep = running.sweep;
    Lattice lattice{{}, running.options.refine};
    for (const auto& axis : sweep.grid) lattice.points.push_back(axis.points.size());
    sweep.visited.assign(lattice.size(), 0);
    CellVerdicts verdicts(sweep.grid);
    const auto verdict = [&](std::size_t cell) { return verdicts.of(sweep.cell(cell)); };
    int wave = 0;
    for (auto cells = coarse_points(lattice); !cells.empty(); cells = next_points(lattice, sweep.visited, verdict)) {
        const std::string task = wave == 0 ? "sweep" : fmt::format("sweep, refined {}", wave);
        std::vector<std::size_t> places(cells.size());
        std::iota(places.begin(), places.end(), std::size_t{0});
        if (!run_cells(running, places, cells, task)) return false;
        for (const std::size_t cell : cells) sweep.visited[cell] = 1;
        ++wave;
    }
    const auto runs = static_cast<std::ptrdiff_t>(sweep.runs);
    const std::vector<std::size_t> source = sources(lattice, sweep.visited);
    for (std::size_t cell = 0; cell < source.size(); ++cell) {
        if (source[cell] == cell) continue;
        const auto from = sweep.results.begin() + static_cast<std::ptrdiff_t>(source[cell]) * runs;
        std::copy(from, from + runs, sweep.results.begin() + static_cast<std::ptrdiff_t>(cell) * runs);
    }
    return true;
}

}  // namespace

SweepJournal::SweepJournal(const std::string& record, Sweep& sweep, std::vector<char>& done) {
    const std::string header = settings_text(sweep.settings);
    const auto bytes = std::as_bytes(std::span(header.data(), header.size()));
    const auto replay = [&](std::uint64_t index, std::span<const std::byte> payload) {
        if (index >= sweep.results.size() || payload.size() != sizeof(RunResult)) return;
        std::memcpy(&sweep.results[index], payload.data(), sizeof(RunResult));
        done[index] = 1;
    };
    try {
        journal_.emplace(journal_path(record), bytes, replay);
    } catch (const JournalMismatch&) {
        throw BadInput(fmt::format(
            "an unfinished sweep with other options lies beside '{}' ({}); give the same options, or remove it", record,
            journal_path(record).filename().string()));
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
}

void SweepJournal::append(std::size_t index, const RunResult& result) {
    journal_->append(index, std::as_bytes(std::span(&result, 1)));
    const auto now = std::chrono::steady_clock::now();
    if (now - flushed_ < std::chrono::milliseconds(500)) return;
    flushed_ = now;
    journal_->flush();
}

bool run_all(const SweepOptions& options, Sweep& sweep, std::vector<char>& done, SweepJournal* journal,
             HandOut& hand_out) {
    RunningSweep running{options, sweep, done, journal, hand_out};
    if (options.refine > 0) return run_tree(running);
    std::vector<std::size_t> cells, all(cell_count(sweep.grid));
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (const std::size_t c : all)
        if (sweep.is_visited(c)) cells.push_back(c);
    return run_cells(running, cells, all, "sweep");
}

}  // namespace swirl::apps::sweep
