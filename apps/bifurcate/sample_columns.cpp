#include "apps/bifurcate/bifurcate_command.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "map/orbit/orbit.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <mutex>
#include <optional>
#include <stdexcept>

namespace swirl::apps::bifurcate {

namespace {

Start<double> start_of(const BifurcateOptions& options, const Scene<double>& scene, std::int64_t run) {
    return random_start(scene.beta, options.start.speed(), options.start.seed() + static_cast<std::uint64_t>(run), 0);
}

tbb::task_arena arena_of(const BifurcateOptions& options) {
    return tbb::task_arena(options.output.threads > 0 ? options.output.threads : tbb::task_arena::automatic);
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
std::vector<Attractor> follow_way(const BifurcateOptions& options, const Diagram& diagram, Origin origin) {
    const std::size_t count = diagram.columns.size();
    std::vector<Attractor> found(count);
    std::optional<SectionPoint<double>> last;
    const bool forward = (origin == Origin::up) != diagram.along.falling;
    for (std::size_t i = 0; i < count && !is_interrupted(); ++i) {
        const std::size_t column = forward ? i : count - 1 - i;
        const Scene<double> scene = column_scene(options, diagram.along, diagram.columns[column].parameter);
        const auto carried = carried_over(scene, last);
        found[column] = carried ? settle(scene, *carried, options.settings)
                                : settle(scene, start_of(options, scene, 0), options.settings);
        found[column].origin = origin;
        last = found[column].last;
    }
    return found;
}

}  // namespace

void sample_columns(const BifurcateOptions& options, Diagram& diagram) {
    const auto starts = static_cast<std::size_t>(options.starts);
    const std::size_t total = diagram.columns.size() * starts;
    for (auto& column : diagram.columns) column.attractors.resize(starts);
    Progress progress("bifurcate", static_cast<double>(total), options.output.quiet);
    std::mutex mutex;
    std::size_t finished = 0;
    arena_of(options).execute([&] {
        tbb::parallel_for(std::size_t{0}, total, [&](std::size_t i) {
            if (is_interrupted()) return;
            DiagramColumn& column = diagram.columns[i / starts];
            const auto run = static_cast<std::int64_t>(i % starts);
            const Scene<double> scene = column_scene(options, diagram.along, column.parameter);
            Attractor attractor = settle(scene, start_of(options, scene, run), options.settings);
            if (!attractor.finished) return;
            attractor.start = run;
            column.attractors[i % starts] = std::move(attractor);
            const std::lock_guard lock(mutex);
            progress.at(static_cast<double>(++finished));
        });
    });
}

void follow_columns(const BifurcateOptions& options, Diagram& diagram) {
    std::vector<Attractor> up, down;
    arena_of(options).execute([&] {
        tbb::parallel_invoke([&] { up = follow_way(options, diagram, Origin::up); },
                             [&] { down = follow_way(options, diagram, Origin::down); });
    });
    for (std::size_t c = 0; c < diagram.columns.size(); ++c) {
        diagram.columns[c].attractors.push_back(std::move(up[c]));
        diagram.columns[c].attractors.push_back(std::move(down[c]));
    }
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
