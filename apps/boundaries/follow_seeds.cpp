#include "analysis/boundaries/follow_boundary.hpp"
#include "apps/boundaries/born_curves.hpp"
#include "apps/boundaries/smooth_curve.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/system/shooting_map.hpp"

#include <algorithm>
#include <optional>

namespace swirl::apps::boundaries {

using analysis::Boundary;

/// Its state.
class CurveSearch::Walk {
public:
    Walk(const Scene<double>& scene, const Plane& plane, const FollowOptions& follow)
        : scene_(scene),
          plane_(plane),
          map_(plane_map_of(scene, plane.parameter(0), plane.parameter(1))),
          words_(word_map_of(scene, plane.parameter(0), plane.parameter(1))),
          options_(smooth_options(scene, plane, follow.longest_step)),
          border_options_{follow.longest_step, is_interrupted},
          follow_(follow) {}

    void follow(const Seed& seed) {
        ++result_.seeds;
        if (const auto kind = smooth_kind(seed.kind)) return follow_smooth(seed, *kind);
        if (is_on_border(seed.kind)) return follow_touch(seed);
        if (std::find(result_.left_out.begin(), result_.left_out.end(), seed.kind) == result_.left_out.end())
            result_.left_out.push_back(seed.kind);
    }

    /// Where curves that were followed since lead to others.
    std::vector<Seed> take_ends() { return std::exchange(ends_, {}); }
    const PlaneCurves& result() const { return result_; }
    bool is_quiet() const { return follow_.quiet; }

private:
    void follow_smooth(const Seed& seed, analysis::BoundaryKind kind) {
        if (analysis::is_on_boundary(map_, kind, seed.points, seed.p, seed.multiplier, options_, known_)) return;
        Boundary boundary;
        if (!analysis::follow_boundary(map_, kind, seed.points, seed.p, seed.multiplier, options_, boundary)) {
            ++result_.without;
            return;
        }
        if (is_interrupted()) return;  // cut short: not finished
        const analysis::ShootingMap coordinates = analysis::on_line(map_, 0, plane_.low());
        result_.curves.push_back(curve_of(boundary, coordinates));
        keep_end(result_.curves.back().points.front(), result_.curves.back().begins);
        keep_end(result_.curves.back().points.back(), result_.curves.back().ends);
        known_.push_back(std::move(boundary));
    }

    void follow_touch(const Seed& seed) {
        const auto cycle = border_cycle_of(words_, seed);
        if (!cycle) {
            ++result_.without;
            return;
        }
        for (const auto& known : borders_)
            if (is_on(words_, plane_, *cycle, border_options_, known)) return;
        auto curve = follow_border(words_, plane_, *cycle, border_options_);
        if (!curve) {
            ++result_.without;
            return;
        }
        if (is_interrupted()) return;
        result_.curves.push_back(curve_of(words_, *curve));
        BornSeeds born = seeds_born_on(words_, map_, plane_, options_, follow_.longest_period, *curve);
        result_.seeds += born.not_found;
        result_.without += born.not_found;
        for (Seed& seed_there : born.seeds) ends_.push_back(std::move(seed_there));
        borders_.push_back(std::move(*curve));
    }

    /// A smooth curve that ends on a border is a place to begin at on that border.
    void keep_end(const CurveCycle& last, const std::string& why) {
        if (!is_on_border(why)) return;
        Seed seed{why, last.points, last.parameters, 1};
        const auto shooting =
            analysis::shooting_residual(shooting_map_of(scene_at(scene_, plane_, last.parameters)), last.points, 0);
        if (!shooting.alive) return;
        name_flights(seed, shooting.steps);
        ends_.push_back(std::move(seed));
    }

    Scene<double> scene_;
    Plane plane_;
    analysis::PlaneMap map_;
    WordMap words_;
    analysis::BoundaryOptions options_;
    BorderOptions border_options_;
    FollowOptions follow_;
    PlaneCurves result_;
    std::vector<Boundary> known_;
    std::vector<BorderCurve> borders_;
    std::vector<Seed> ends_;
};

CurveSearch::CurveSearch(const Scene<double>& scene, const Plane& plane, const FollowOptions& options)
    : walk_(std::make_unique<Walk>(scene, plane, options)) {}

CurveSearch::~CurveSearch() = default;

void CurveSearch::follow(const std::vector<Seed>& seeds) {
    Progress progress("curves", static_cast<double>(seeds.size()), walk_->is_quiet());
    double done = 0;
    for (const Seed& seed : seeds) {
        if (is_interrupted()) return;
        walk_->follow(seed);
        progress.at(++done);
    }
    for (auto met = walk_->take_ends(); !met.empty(); met = walk_->take_ends())
        for (const Seed& seed : met)
            if (!is_interrupted()) walk_->follow(seed);
}

const PlaneCurves& CurveSearch::found() const {
    return walk_->result();
}

}  // namespace swirl::apps::boundaries
