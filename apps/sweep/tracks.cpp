#include "apps/sweep/tracks.hpp"

#include "apps/modes/mode_fields.hpp"
#include "apps/output/write_table.hpp"
#include "apps/system/section_coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace swirl::apps::sweep {

std::vector<std::pair<std::size_t, std::size_t>> neighbours(const std::vector<GridAxis>& grid) {
    std::vector<std::pair<std::size_t, std::size_t>> sides;
    const std::size_t cells = cell_count(grid);
    for (std::size_t c = 0; c < cells; ++c) {
        std::size_t stride = cells, left = c;
        for (const GridAxis& axis : grid) {
            stride /= axis.points.size();
            const std::size_t place = left / stride;
            left %= stride;
            if (!axis.has_words() && axis.name != "sides" && place + 1 < axis.points.size())
                sides.emplace_back(c, c + stride);
        }
    }
    return sides;
}

void write_attractors(const RecordGroup& group, const Sweep& sweep) {
    std::vector<CellAttractor> rows;
    for (const auto& attractors : sweep.attractors) rows.insert(rows.end(), attractors.begin(), attractors.end());
    group.dimension("coordinate", polygon_dimension);
    write_attributes(group, tracking_table(), sweep.tracking);
    write_record(group, cell_attractor_table(true), rows);
}

std::vector<Track> tracks_of(const Sweep& sweep) {
    std::vector<Track> tracks;
    for (const auto& attractors : sweep.attractors)
        for (const CellAttractor& a : attractors) {
            if (a.track == no_track) continue;
            const auto place = static_cast<std::size_t>(a.track);
            if (place == tracks.size()) tracks.push_back({a, 0, a.share, a.share, a.mean_spin, a.mean_spin});
            Track& track = tracks[place];
            ++track.cells;
            track.least_share = std::min(track.least_share, a.share);
            track.largest_share = std::max(track.largest_share, a.share);
            track.least_spin = std::min(track.least_spin, a.mean_spin);
            track.largest_spin = std::max(track.largest_spin, a.mean_spin);
        }
    std::stable_sort(tracks.begin(), tracks.end(), [](const Track& a, const Track& b) { return a.cells > b.cells; });
    return tracks;
}

Table<Track> track_table() {
    using F = Field<Track>;
    const auto in_percent = [](const Value& value) { return fmt::format("{:>7.2f} %", 100 * std::get<double>(value)); };
    const auto mode = [](const Track& track) { return mode_of(track.first.first); };
    const auto kind = [](const Track& track) { return kind_of(track.first.first); };
    const auto period = [](const Track& track) { return static_cast<std::int64_t>(track.first.first.period); };
    const auto number = [](const Track& track) { return track.first.track; };
    return {{"track"},
            {F{"track", number, no_column}.shown("track", "{:>5}"),
             F{"mode", mode, no_column}.shown("mode", "  {:<12}"), kind_field<Track>(kind).shown("kind", " {:<19}"),
             period_field<Track>(period).shown("period", dash_for_zero(" {:>6}")),
             F{"cells", &Track::cells, no_column}.shown("cells", " {:>7}"),
             F{"least_share", &Track::least_share, no_column}.shown("share from", {" {:>11}", in_percent}),
             F{"largest_share", &Track::largest_share, no_column}.shown("to", {" {:>11}", in_percent}),
             F{"least_mean_S", &Track::least_spin, "1", "least of the cells"}.shown("mean S from", " {:>13.6g}"),
             F{"largest_mean_S", &Track::largest_spin, "1", "largest of the cells"}.shown("to", " {:>13.6g}")}};
}

}  // namespace swirl::apps::sweep
