#include "apps/continue/branches.hpp"
#include "apps/scene_map/scene_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl::apps {

namespace {

/// S of each point of a cycle, NaN beyond its period.
void append_phases(std::vector<double>& spins, const analysis::CurvePoint& at, std::size_t longest) {
    for (std::size_t i = 0; i < longest; ++i)
        spins.push_back(i < at.points.size() ? at.points[i].tail(1)[0] : std::numeric_limits<double>::quiet_NaN());
}

struct Columns {
    std::vector<std::int64_t> branch, period, stable, index;
    std::vector<double> parameter, mean, largest, spins, time, residual;
    std::vector<std::string> kind;

    void add(const SceneBranches& scene, std::size_t b, const analysis::BranchPoint& point, std::size_t longest) {
        branch.push_back(static_cast<std::int64_t>(b));
        period.push_back(static_cast<std::int64_t>(point.at.points.size()));
        stable.push_back(point.stability == analysis::Stability::unstable ? 0 : 1);
        index.push_back(point.index);
        parameter.push_back(analysis::parameter_of(scene.options, scene.map.has_parameter, point.at));
        mean.push_back(point.mean);
        largest.push_back(std::abs(point.multipliers.front()));
        time.push_back(point.at.closing.duration);
        residual.push_back(point.at.closing.residual());
        append_phases(spins, point.at, longest);
    }

    void write(const RecordGroup& group, const std::string& rows) const {
        const std::vector<std::string> by_row{rows}, by_phase{rows, "phase"};
        group.write<std::int64_t>("branch", by_row, branch, {"1", "number of the branch", {}});
        group.write<std::int64_t>("period", by_row, period, {"1", "k", {}});
        group.write<std::int64_t>("stable", by_row, stable, {"1", "1: no multiplier outside the unit circle", {}});
        group.write<std::int64_t>("index", by_row, index, {"1", "multipliers outside the unit circle", {}});
        group.write<double>("parameter", by_row, parameter, {"1", "value of the parameter named by settings: along", {}});
        group.write<double>("mean_S", by_row, mean, {"omega_s", "time mean of S", {}});
        group.write<double>("return_time", by_row, time, {"1/omega_s", "sum of the flights", {}});
        group.write<double>("largest_multiplier", by_row, largest, {"1", "modulus", {}});
        group.write<double>("residual", by_row, residual, {"1", "largest |F(z_i) - z_(i+1)|", {}});
        group.write<double>("S", by_phase, spins, {"omega_s", "S after each impact of the cycle; NaN beyond it", {}});
    }
};

}  // namespace

void write_branches(const RecordGroup& root, const SceneBranches& scene, const std::vector<analysis::Branch>& branches) {
    std::size_t longest = 1;
    Columns points, special;
    for (const auto& branch : branches) longest = std::max(longest, branch.period());
    for (std::size_t b = 0; b < branches.size(); ++b) {
        for (const auto& point : branches[b].points) points.add(scene, b, point, longest);
        for (const auto& s : branches[b].special) {
            special.add(scene, b, s.cycle, longest);
            special.kind.push_back(kind_of(s));
        }
    }
    if (!points.branch.empty()) {
        const RecordGroup group = root.group("branches");
        group.dimension("point", points.branch.size());
        group.dimension("phase", longest);
        points.write(group, "point");
    }
    if (!special.branch.empty()) {
        const RecordGroup group = root.group("special");
        group.dimension("special_point", special.branch.size());
        group.dimension("phase", longest);
        special.write(group, "special_point");
        group.write_strings("kind", {"special_point"}, special.kind);
    }
}

}  // namespace swirl::apps
