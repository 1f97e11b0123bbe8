#include "apps/bifurcate/bifurcate_command.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/parallel_pieces.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/ranks/packed.hpp"
#include "map/orbit/orbit.hpp"

#include <array>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

namespace swirl::apps::bifurcate {

namespace {

Start<double> start_of(const BifurcateOptions& options, const Scene<double>& scene, std::int64_t run) {
    return random_start(scene.beta, options.start.speed(), options.start.seed() + static_cast<std::uint64_t>(run), 0);
}

/// The state as a start of another column's scene, if it can be one there.
std::optional<SectionPoint<double>> carried_over(const Scene<double>& scene,
                                                 const std::optional<SectionPoint<double>>& last) {
    if (!last) return std::nullopt;
    try {
        require_leaving(make_body(scene), *last);
    } catch (const std::invalid_argument&) {
        return std::nullopt;  // another vertex would be outside, say
    }
    return last;
}

/// One way along the columns; `sign` = +1 upwards in the parameter.
std::vector<Attractor> follow_way(const BifurcateOptions& options, ParameterRange along, Origin origin) {
    const std::size_t count = along.columns.size();
    std::vector<Attractor> found(count);
    std::optional<SectionPoint<double>> last;
    const bool forward = (origin == Origin::up) != along.falling;
    for (std::size_t i = 0; i < count && !is_interrupted(); ++i) {
        const std::size_t column = forward ? i : count - 1 - i;
        const Scene<double> scene = column_scene(options, along, along.columns[column]);
        const auto carried = carried_over(scene, last);
        found[column] = carried ? settle(scene, *carried, options.settings)
                                : settle(scene, start_of(options, scene, 0), options.settings);
        found[column].origin = origin;
        last = found[column].last;
    }
    return found;
}

}  // namespace

/// Start r of column c is piece c R + r. It holds what it uses but the options, which live until the process ends:
/// after an interruption it may outlive the diagram.
NamedWork work_of(const BifurcateOptions& options, const Diagram& diagram) {
    std::vector<double> values;
    for (const auto& column : diagram.columns) values.push_back(column.parameter);
    const auto work = [&options, along = diagram.along, values](std::span<const std::size_t> pieces,
                                                                const KeepPiece& keep) {
        const auto runs = static_cast<std::size_t>(options.starts);
        std::vector<SceneStart> starts;
        for (const std::size_t piece : pieces) {
            const Scene<double> scene = column_scene(options, along, values[piece / runs]);
            starts.push_back({scene, start_of(options, scene, static_cast<std::int64_t>(piece % runs))});
        }
        settle_all(starts, options.settings, [pieces, runs, &keep](std::size_t place, Attractor attractor) {
            attractor.start = static_cast<std::int64_t>(pieces[place] % runs);
            keep({pieces[place], packed(std::move(attractor))});
        });
    };
    Settings settings = diagram_scene(options, diagram);
    for (const auto& setting : diagram_settings(options, diagram)) settings.push_back(setting);
    return {name_of_work(settings), work, most_named_together()};
}

void sample_columns(const BifurcateOptions& options, Diagram& diagram, HandOut& hand_out) {
    const auto starts = static_cast<std::size_t>(options.starts);
    for (auto& column : diagram.columns) column.attractors.resize(starts);
    std::vector<std::size_t> pieces(diagram.columns.size() * starts);
    std::iota(pieces.begin(), pieces.end(), std::size_t{0});
    Progress progress("bifurcate", static_cast<double>(pieces.size()), options.output.quiet);
    hand_out.run(pieces, options.output.threads, work_of(options, diagram), progress, [&](const PieceResult& piece) {
        diagram.columns[piece.piece / starts].attractors[piece.piece % starts] = unpacked<Attractor>(piece.bytes);
    });
}

void follow_columns(const BifurcateOptions& options, Diagram& diagram) {
    // Each way is one piece.
    std::array<std::vector<Attractor>, 2> ways;
    Progress progress("bifurcate", 2, true);
    const ParameterRange along = diagram.along;
    run_pieces(2, options.output.threads, progress, [&options, along, &ways](std::size_t way) -> KeepResult {
        const auto found =
            std::make_shared<std::vector<Attractor>>(follow_way(options, along, way == 0 ? Origin::up : Origin::down));
        return [&ways, way, found] { ways[way] = std::move(*found); };
    });
    auto& [up, down] = ways;
    up.resize(diagram.columns.size());  // unfinished ones, where it was interrupted
    down.resize(diagram.columns.size());
    for (std::size_t c = 0; c < diagram.columns.size(); ++c) {
        diagram.columns[c].attractors.push_back(std::move(up[c]));
        diagram.columns[c].attractors.push_back(std::move(down[c]));
    }
}

void find_steady_modes(const BifurcateOptions& options, Diagram& diagram) {
    Progress progress("bifurcate: steady modes", static_cast<double>(diagram.columns.size()), options.output.quiet);
    struct Column {
        Scene<double> scene;
        std::vector<SettledRun> runs;
    };
    // Of the pieces' own: one that an interruption leaves alone may outlive the diagram.
    const auto columns = std::make_shared<std::vector<Column>>();
    for (const DiagramColumn& column : diagram.columns) {
        columns->push_back({column_scene(options, diagram.along, column.parameter), {}});
        for (const Attractor& attractor : column.attractors)
            if (attractor.origin == Origin::random)
                columns->back().runs.push_back({attractor.kind, attractor.mean_spin});
    }
    run_pieces(columns->size(), options.output.threads, progress, [columns, &diagram](std::size_t c) -> KeepResult {
        const auto modes =
            std::make_shared<std::vector<SteadyShare>>(steady_shares((*columns)[c].scene, (*columns)[c].runs));
        return [&diagram, c, modes] { diagram.columns[c].steady = std::move(*modes); };
    });
}

void keep_finished(Diagram& diagram) {
    for (auto& column : diagram.columns) {
        const auto wanted = column.attractors.size();
        std::erase_if(column.attractors, [](const Attractor& attractor) { return !attractor.finished; });
        column.complete = column.attractors.size() == wanted;
    }
    std::erase_if(diagram.columns, [](const DiagramColumn& column) { return column.attractors.empty(); });
}

}  // namespace swirl::apps::bifurcate
