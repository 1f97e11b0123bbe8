#include "apps/studies/basins/tracks.hpp"

#include <algorithm>

namespace swirl::studies::grids {

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

std::vector<Track> tracks_of(const std::vector<std::vector<CellAttractor>>& of_cells) {
    std::vector<Track> tracks;
    for (const auto& attractors : of_cells)
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

}  // namespace swirl::studies::grids
