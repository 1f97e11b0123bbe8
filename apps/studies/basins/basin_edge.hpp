// The edge of an attractor's basin in one scene: which starts are inside, and where it leads.
#pragma once

#include "apps/studies/basins/saddles.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <optional>
#include <vector>

namespace swirl::studies::grids {

template <int D>
class BasinEdge {
public:
    /// Of what `attractor` came to, by verdicts with these settings.
    ///   stop  true: starts are reported no more
    BasinEdge(const Scene<double>& scene, const analysis::ClassifyOptions& settings, Accuracy accuracy,
              const RunResult& attractor, const analysis::Stop& stop);

    /// Does a start come to the attractor? Nothing: its verdict names none. Cost: a run.
    std::optional<bool> is_inside(const Start<double>& start) const;

    /// Where the edge leads from between two starts of which the first alone is inside: an unstable cycle of up to 32
    /// impacts, polished, or an unstable torus fills `saddle`. Cost: about a run for each impact until it is there.
    analysis::StraddleEnd follow(const LabStart<double>& in, const LabStart<double>& out, Saddle& saddle) const;

private:
    using Points = std::vector<analysis::Vector<D>>;
    bool is_at_cycle(const Points& orbit, Saddle& saddle) const;
    bool take_cycle(const analysis::CyclePoints& cycle, Saddle& saddle) const;
    bool is_torus(const Points& orbit, Saddle& saddle) const;

    Scene<double> scene_;
    analysis::ClassifyOptions settings_;
    Accuracy accuracy_;
    RunResult attractor_;
    analysis::Stop stop_;
    SceneMap<D> map_;
    analysis::ShootingMap shooting_;
};

extern template class BasinEdge<disk_dimension>;
extern template class BasinEdge<polygon_dimension>;

/// Cycles by their points, tori by their means of S: a rotation number is one up to m ρ + k.
bool is_same_saddle(const analysis::ShootingMap& map, const Saddle& a, const Saddle& b);

}  // namespace swirl::studies::grids
