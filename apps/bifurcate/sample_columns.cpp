#include "apps/bifurcate/bifurcate_command.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/ranks/packed.hpp"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace swirl::apps::bifurcate {

namespace {

RiskQuestion question_of(const DiagramSettings& of) {
    const auto starts = static_cast<std::size_t>(of.starts);
    const analysis::ClassifyOptions limits = limits_of(of.samples);
    return {
        of.along.columns.size() * starts, starts, of.risk, of.seed, early_look(limits), of.error, last_look(limits)};
}

/// A diagram whose columns are sampled.
struct SampledDiagram {
    const BifurcateOptions& options;
    Diagram& diagram;
    HandOut& hand_out;
    std::vector<char> done;  ///< 1 of each start whose attractor is kept
};

Attractor& attractor_of(Diagram& diagram, std::size_t run, std::size_t starts) {
    return diagram.columns[run / starts].attractors[run % starts];
}

/// Starts that were followed, to the look (0: to the limits). None if it was interrupted.
std::optional<std::vector<SeenRun>> follow(SampledDiagram& sampled, std::span<const std::size_t> runs,
                                           std::int64_t look) {
    const BifurcateOptions& options = sampled.options;
    Diagram& diagram = sampled.diagram;
    const RiskQuestion question = question_of(settings_of(options, diagram.along));
    const RiskPieces numbers{question.runs, question.look};
    std::vector<std::size_t> pieces;
    for (const std::size_t run : runs) pieces.push_back(numbers.number(run, look));
    Progress progress("bifurcate", static_cast<double>(pieces.size()), options.output.quiet);
    const auto keep = [&](const PieceResult& piece) {
        const std::size_t run = numbers.run(piece.piece);
        attractor_of(diagram, run, question.each) = unpacked<Attractor>(piece.bytes);
        sampled.done[run] = look == 0 ? 1 : 0;
    };
    const bool all = sampled.hand_out.run(pieces, options.output.threads, work_of(options, diagram), progress, keep);
    if (!all) return std::nullopt;
    std::vector<SeenRun> seen;
    for (const std::size_t run : runs) {
        const Attractor& attractor = attractor_of(diagram, run, question.each);
        seen.push_back(
            seen_of(attractor.kind, attractor.outcome, attractor.largest_exponent, attractor.mean_errors.per_time));
    }
    return seen;
}

}  // namespace

/// Start r of column c is piece c R + r where it is followed to the limits. It holds what it uses: after an
/// interruption it may outlive the diagram.
NamedWork work_of(const BifurcateOptions& options, const Diagram& diagram) {
    const DiagramSettings settings = settings_of(options, diagram.along);
    const RiskQuestion question = question_of(settings);
    const RiskPieces numbers{question.runs, question.look};
    const auto work = [of = settings, stop = interruption(), numbers](std::span<const std::size_t> pieces,
                                                                      const KeepPiece& keep) {
        const auto each = static_cast<std::size_t>(of.starts);
        for (const RiskPieces::Group& group : numbers.groups(pieces)) {
            std::vector<SceneStart> starts;
            for (const std::size_t run : group.runs) {
                const Scene<double> scene = column_scene(of, of.along.columns[run / each]);
                starts.push_back({scene, column_start(of, scene, static_cast<std::int64_t>(run % each))});
            }
            const auto take = [&](std::size_t place, Attractor attractor) {
                attractor.start = static_cast<std::int64_t>(group.runs[place] % each);
                keep({numbers.number(group.runs[place], group.look), packed(std::move(attractor))});
            };
            settle_all(starts, of.samples, stop, take, group.look);
        }
    };
    Settings named = diagram_scene(options, diagram);
    for (const auto& setting : diagram_settings(options, diagram)) named.push_back(setting);
    return {name_of_work(named), work, most_named_together()};
}

void sample_columns(const BifurcateOptions& options, Diagram& diagram, HandOut& hand_out) {
    const RiskQuestion question = question_of(settings_of(options, diagram.along));
    for (auto& column : diagram.columns) column.attractors.resize(question.each);
    SampledDiagram sampled{options, diagram, hand_out, std::vector<char>(question.runs, 0)};
    std::vector<std::size_t> all(question.runs);
    std::iota(all.begin(), all.end(), std::size_t{0});
    RunsAtRisk runs;
    runs.follow = [&](std::span<const std::size_t> some, std::int64_t look) { return follow(sampled, some, look); };
    runs.keep = [&](std::size_t run) { sampled.done[run] = 1; };
    const auto followed = follow_at_risk(question, all, runs);
    if (followed && options.risk > 0) diagram.risk = {followed->evidence};
    for (const std::size_t run : all)
        if (!sampled.done[run]) attractor_of(diagram, run, question.each).finished = false;
}

}  // namespace swirl::apps::bifurcate
