#include "apps/studies/basins/tracks.hpp"

#include "analysis/special_values.hpp"
#include "apps/studies/basins/basins.hpp"
#include "apps/studies/basins/saddles.hpp"
#include "apps/studies/grids/starts.hpp"
#include "apps/studies/modes/attractors.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/parallel/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>

namespace swirl::studies::grids {

namespace {

RunVerdict verdict_of(const RunResult& run) {
    RunVerdict verdict;
    verdict.mode = mode_of(run);
    verdict.kind = kind_of(run);
    verdict.outcome = static_cast<Outcome>(static_cast<int>(run.outcome));
    verdict.period = static_cast<std::int64_t>(run.period);
    verdict.mean_spin = run.mean_spin;
    verdict.mean_spin_per_impact = run.mean_spin_per_impact;
    verdict.mean_errors.per_time = run.mean_spin_error;
    verdict.growth = growth_of(run);
    verdict.limit_spin = run.limit_spin;
    return verdict;
}

}  // namespace

std::vector<CellAttractor> cell_attractors(std::span<const RunResult> runs, std::size_t cell) {
    std::vector<RunVerdict> verdicts;
    verdicts.reserve(runs.size());
    for (const RunResult& run : runs) verdicts.push_back(verdict_of(run));
    std::vector<CellAttractor> found;
    const auto all = static_cast<double>(runs.size());
    for (const SharedAttractor& shared : attractors_of(verdicts)) {
        const double share = static_cast<double>(shared.runs.size()) / all;
        const std::size_t first = shared.runs.front();
        found.push_back({runs[first],
                         share,
                         wilson_interval(share, all),
                         shared.mean_spin,
                         shared.mean_spin_error,
                         first,
                         cell,
                         no_track,
                         {}});
    }
    return found;
}

bool spins_differ(std::span<const CellAttractor> attractors) {
    const auto error_of = [](const CellAttractor& a) { return std::isnan(a.spin_error) ? 0 : a.spin_error; };
    const auto differ = [&](const CellAttractor& a, const CellAttractor& b) {
        if (std::isnan(a.mean_spin) != std::isnan(b.mean_spin)) return true;
        const double errors = 2 * std::hypot(error_of(a), error_of(b));
        return !means_agree(a.mean_spin, b.mean_spin) && std::abs(a.mean_spin - b.mean_spin) > errors;
    };
    for (std::size_t i = 0; i < attractors.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (differ(attractors[i], attractors[j])) return true;
    return false;
}

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

namespace {

bool is_cycle(const RunResult& run) {
    using analysis::Kind;
    return kind_of(run) == Kind::fixed_point || kind_of(run) == Kind::cycle || kind_of(run) == Kind::landing;
}

bool is_carried(const RunResult& run) {
    return is_cycle(run) && run.period <= static_cast<double>(longest_tracked);
}

/// Of a landing cycle S per impact counts chatter's rebounds otherwise than a verdict does.
bool is_same_cycle(const CellAttractor& known, const CarriedCycle& cycle) {
    return is_cycle(known.first) && known.first.period == static_cast<double>(cycle.points.size()) &&
           means_agree(known.mean_spin, cycle.mean_spin) &&
           (kind_of(known.first) == analysis::Kind::landing ||
            means_agree(known.first.mean_spin_per_impact, cycle.mean_spin_per_impact));
}

/// An attractor of a cell, its number among those of all cells, and its points if it is a cycle.
struct Node {
    CellAttractor attractor;
    std::size_t number = 0;
    analysis::CyclePoints points;
};

struct TrackCell {
    Scene<double> scene;
    std::vector<Node> nodes;
};

TrackCell track_cell(const GridStudy& study, std::size_t c, std::span<const RunResult> runs,
                     const analysis::Stop& stop) {
    TrackCell cell{cell_scene(study, c), {}};
    for (const CellAttractor& attractor : cell_attractors(runs, c)) {
        cell.nodes.push_back({attractor, 0, {}});
        if (!is_carried(attractor.first) || (stop && stop())) continue;
        const LabStart<double> start = cell_start(study, cell.scene, c, attractor.run);
        const auto verdict = name_mode(cell.scene, start, study.settings, study.accuracy, stop).verdict;
        if (verdict.point.empty()) continue;
        const auto size = static_cast<Eigen::Index>(verdict.point.size());
        cell.nodes.back().points = analysis::orbit_from(shooting_map_of(cell.scene, study.accuracy),
                                                        Eigen::Map<const Eigen::VectorXd>(verdict.point.data(), size),
                                                        0, static_cast<int>(verdict.period));
    }
    return cell;
}

/// A cycle on its way: the place of its node in its cell, and the cell to which it is carried.
struct Way {
    std::size_t cell, place, to;
};

/// The cells, and which of their attractors are one. Nodes are added at the end of a cell, so that places stay.
class Tracker {
public:
    explicit Tracker(std::vector<TrackCell> cells) : cells_(std::move(cells)) {
        for (TrackCell& cell : cells_)
            for (Node& node : cell.nodes) number(node);
    }

    const TrackCell& cell(std::size_t c) const { return cells_[c]; }

    /// The ways to that cell of the cycles that are not known there.
    void add_ways(std::size_t from, std::size_t to, std::size_t first_place, std::vector<Way>& ways) {
        for (std::size_t i = first_place; i < cells_[from].nodes.size(); ++i) {
            const Node& node = cells_[from].nodes[i];
            const auto is_same = [&](const Node& other) { return is_one(node, other); };
            if (!node.points.empty() && std::none_of(cells_[to].nodes.begin(), cells_[to].nodes.end(), is_same))
                ways.push_back({from, i, to});
        }
    }

    /// What a cycle came to there is one with it.
    void arrive(const Way& way, const CarriedCycle& cycle, std::int64_t runs) {
        ++tracking_.carried;
        if (cycle.points.empty()) return;
        const Node from = cells_[way.cell].nodes[way.place];
        for (const Node& node : cells_[way.to].nodes)
            if (is_same_cycle(node.attractor, cycle)) {
                ++tracking_.arrived;
                return unite(from, node);
            }
        ++(cycle.stable ? tracking_.unseen : tracking_.not_attracting);
        if (!cycle.stable) return;
        Node unseen{from.attractor, 0, cycle.points};
        unseen.attractor.share = 0;
        unseen.attractor.interval = wilson_interval(0, static_cast<double>(runs));
        unseen.attractor.mean_spin = unseen.attractor.first.mean_spin = cycle.mean_spin;
        unseen.attractor.first.mean_spin_per_impact = cycle.mean_spin_per_impact;
        unseen.attractor.spin_error = analysis::nan;
        unseen.attractor.cell = way.to;
        number(unseen);
        unite(from, unseen);
        cells_[way.to].nodes.push_back(unseen);
    }

    const Tracking& tracking() const { return tracking_; }

    /// What has no points to be carried, and landing cycles that could not be.
    void unite_others(std::size_t a, std::size_t b) {
        for (const Node& node : cells_[a].nodes) {
            const RunResult& run = node.attractor.first;
            const bool has_points = is_cycle(run) && kind_of(run) != analysis::Kind::landing;
            if (!has_attractor(run) || has_points || only_one_like(run, cells_[a]) != &node) continue;
            if (const Node* other = only_one_like(run, cells_[b])) unite(node, *other);
        }
    }

    /// All attractors, those that are one by one number.
    std::vector<std::vector<CellAttractor>> numbered() {
        std::map<std::size_t, std::int64_t> numbers;
        std::vector<std::vector<CellAttractor>> all;
        for (TrackCell& cell : cells_) {
            all.emplace_back();
            for (Node& node : cell.nodes) {
                const auto next = static_cast<std::int64_t>(numbers.size());
                if (has_attractor(node.attractor.first))
                    node.attractor.track = numbers.emplace(first_of(node.number), next).first->second;
                if (!node.points.empty()) {
                    const Eigen::VectorXd& first = node.points.front();
                    node.attractor.point.assign(first.data(), first.data() + first.size());
                }
                all.back().push_back(node.attractor);
            }
        }
        return all;
    }

private:
    void number(Node& node) {
        node.number = earlier_.size();
        earlier_.push_back(node.number);
    }
    std::size_t first_of(std::size_t number) const {
        while (earlier_[number] != number) number = earlier_[number];
        return number;
    }
    void unite(const Node& a, const Node& b) {
        const auto [first, second] = std::minmax({first_of(a.number), first_of(b.number)});
        earlier_[second] = first;
    }
    bool is_one(const Node& a, const Node& b) const { return first_of(a.number) == first_of(b.number); }

    static const Node* only_one_like(const RunResult& run, const TrackCell& cell) {
        const Node* found = nullptr;
        for (const Node& node : cell.nodes) {
            const RunResult& other = node.attractor.first;
            const bool is_like = other.mode == run.mode && other.kind == run.kind && other.outcome == run.outcome &&
                                 other.period == run.period;
            if (!is_like) continue;
            if (found != nullptr) return nullptr;
            found = &node;
        }
        return found;
    }

    std::vector<TrackCell> cells_;
    Tracking tracking_;
    std::vector<std::size_t> earlier_;  ///< of each node one that it is one with, itself if it is the first
};

/// Carries cycles on all threads, then lets them arrive in their order. False if stopped.
bool carry(const std::vector<Way>& ways, const GridStudy& study, const RunControl& control, Tracker& tracker) {
    struct Piece {
        Scene<double> from, to;
        analysis::CyclePoints points;
    };
    auto pieces = std::make_shared<std::vector<Piece>>();  // a piece that a stop leaves alone may use them to its end
    for (const Way& way : ways)
        pieces->push_back(
            {tracker.cell(way.cell).scene, tracker.cell(way.to).scene, tracker.cell(way.cell).nodes[way.place].points});
    std::vector<CarriedCycle> arrived(ways.size());
    const auto look = [&arrived, pieces, accuracy = study.accuracy, control](std::size_t i) -> KeepResult {
        const Piece& piece = (*pieces)[i];
        const CarriedCycle there = carried(piece.from, piece.to, accuracy, piece.points, control.stop);
        if (control.is_stopped()) return {};
        return [&arrived, i, there] { arrived[i] = there; };
    };
    const bool all = run_pieces(ways.size(), "sweep: attractors from cell to cell", control, look);
    for (std::size_t i = 0; all && i < ways.size(); ++i) tracker.arrive(ways[i], arrived[i], study.runs);
    return all;
}

/// To later cells, then those that have not arrived to earlier ones, and on from where they were unknown.
bool follow_cycles(const GridStudy& study, const RunControl& control,
                   const std::vector<std::pair<std::size_t, std::size_t>>& sides, Tracker& tracker) {
    std::vector<std::size_t> begin(cell_count(study.grid), 0);  // the first place of each cell that is to be followed
    for (bool grows = true; grows;) {
        std::vector<std::size_t> end;
        for (std::size_t c = 0; c < begin.size(); ++c) end.push_back(tracker.cell(c).nodes.size());
        for (const bool onward : {true, false}) {
            std::vector<Way> ways;
            for (const auto& [a, b] : sides)
                onward ? tracker.add_ways(a, b, begin[a], ways) : tracker.add_ways(b, a, begin[b], ways);
            if (!carry(ways, study, control, tracker)) return false;
        }
        begin = end;
        grows = false;
        for (std::size_t c = 0; c < begin.size(); ++c) grows = grows || tracker.cell(c).nodes.size() > begin[c];
    }
    return true;
}

}  // namespace

std::optional<TrackedAttractors> track_attractors(const GridStudy& study, std::span<const RunResult> results,
                                                  const RunControl& control) {
    const std::size_t count = cell_count(study.grid);
    std::vector<TrackCell> cells(count);
    // A piece that a stop leaves alone may outlive the call: it has its own study and runs.
    const auto of = std::make_shared<const GridStudy>(study);
    const auto all_runs = std::make_shared<const std::vector<RunResult>>(results.begin(), results.end());
    const auto look = [&cells, of, all_runs, control](std::size_t c) -> KeepResult {
        const auto runs = static_cast<std::size_t>(of->runs);
        auto cell =
            std::make_shared<TrackCell>(track_cell(*of, c, std::span(*all_runs).subspan(c * runs, runs), control.stop));
        if (control.is_stopped()) return {};
        return [&cells, c, cell] { cells[c] = std::move(*cell); };
    };
    if (!run_pieces(count, "sweep: cycles of the cells", control, look)) return std::nullopt;
    Tracker tracker(std::move(cells));
    const auto sides = neighbours(study.grid);
    if (!follow_cycles(study, control, sides, tracker)) return std::nullopt;
    for (const auto& [a, b] : sides) tracker.unite_others(a, b);
    return TrackedAttractors{tracker.numbered(), tracker.tracking()};
}

}  // namespace swirl::studies::grids
