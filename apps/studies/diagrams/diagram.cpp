#include "apps/studies/diagrams/diagram.hpp"

#include "apps/studies/parallel/pieces.hpp"
#include "map/orbit/orbit.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

namespace swirl::studies::diagrams {

namespace {

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
std::vector<Attractor> follow_way(const DiagramSettings& settings, Origin origin, const RunControl& control) {
    const ParameterRange& along = settings.along;
    const std::size_t count = along.columns.size();
    std::vector<Attractor> found(count);
    std::optional<SectionPoint<double>> last;
    const bool forward = (origin == Origin::up) != along.falling;
    for (std::size_t i = 0; i < count && !control.is_stopped(); ++i) {
        const std::size_t column = forward ? i : count - 1 - i;
        const Scene<double> scene = column_scene(settings, along.columns[column]);
        const auto carried = carried_over(scene, last);
        found[column] = carried ? settle(scene, *carried, settings.samples, control.stop)
                                : settle(scene, column_start(settings, scene, 0), settings.samples, control.stop);
        found[column].origin = origin;
        last = found[column].last;
    }
    return found;
}

}  // namespace

Scene<double> column_scene(const DiagramSettings& settings, double value) {
    return validated(with_parameter(settings.scene, *settings.along.parameter, value));
}

Start<double> column_start(const DiagramSettings& settings, const Scene<double>& scene, std::int64_t run) {
    return random_start(scene.beta, settings.speed, settings.seed + static_cast<std::uint64_t>(run), 0);
}

const Attractor& typical(const DiagramColumn& column) {
    const auto same = [](const Attractor& a, const Attractor& b) { return a.mode == b.mode && a.period == b.period; };
    std::size_t best = 0;
    std::ptrdiff_t most = 0;
    for (std::size_t i = 0; i < column.attractors.size(); ++i) {
        const auto count = std::count_if(column.attractors.begin(), column.attractors.end(), [&](const Attractor& a) {
            return a.origin == column.attractors.front().origin && same(a, column.attractors[i]);
        });
        if (count > most) {
            most = count;
            best = i;
        }
    }
    return column.attractors[best];
}

void follow_columns(const DiagramSettings& settings, const RunControl& control, Diagram& diagram) {
    // Each way is one piece.
    std::array<std::vector<Attractor>, 2> ways;
    run_pieces(2, "", control, [settings, control, &ways](std::size_t way) -> KeepResult {
        const auto found = std::make_shared<std::vector<Attractor>>(
            follow_way(settings, way == 0 ? Origin::up : Origin::down, control));
        return [&ways, way, found] { ways[way] = std::move(*found); };
    });
    auto& [up, down] = ways;
    up.resize(diagram.columns.size());  // unfinished ones, where it was stopped
    down.resize(diagram.columns.size());
    for (std::size_t c = 0; c < diagram.columns.size(); ++c) {
        diagram.columns[c].attractors.push_back(std::move(up[c]));
        diagram.columns[c].attractors.push_back(std::move(down[c]));
    }
}

void find_steady_modes(const DiagramSettings& settings, const RunControl& control, Diagram& diagram) {
    struct Column {
        Scene<double> scene;
        std::vector<SettledRun> runs;
    };
    // Of the pieces' own: one that a stop leaves alone may outlive the diagram.
    const auto columns = std::make_shared<std::vector<Column>>();
    for (const DiagramColumn& column : diagram.columns) {
        columns->push_back({column_scene(settings, column.parameter), {}});
        for (const Attractor& attractor : column.attractors)
            if (attractor.origin == Origin::random)
                columns->back().runs.push_back({attractor.kind, attractor.mean_spin});
    }
    run_pieces(columns->size(), "bifurcate: steady modes", control, [columns, &diagram](std::size_t c) -> KeepResult {
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

}  // namespace swirl::studies::diagrams
