#include "apps/bifurcate/bifurcate_command.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/ranks/packed.hpp"

#include <numeric>
#include <span>
#include <utility>

namespace swirl::apps::bifurcate {

/// Start r of column c is piece c R + r. It holds what it uses: after an interruption it may outlive the diagram.
NamedWork work_of(const BifurcateOptions& options, const Diagram& diagram) {
    const auto work = [of = settings_of(options, diagram.along)](std::span<const std::size_t> pieces,
                                                                 const KeepPiece& keep) {
        const auto runs = static_cast<std::size_t>(of.starts);
        std::vector<SceneStart> starts;
        for (const std::size_t piece : pieces) {
            const Scene<double> scene = column_scene(of, of.along.columns[piece / runs]);
            starts.push_back({scene, column_start(of, scene, static_cast<std::int64_t>(piece % runs))});
        }
        settle_all(starts, of.samples, is_interrupted, [pieces, runs, &keep](std::size_t place, Attractor attractor) {
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

}  // namespace swirl::apps::bifurcate
