#include "analysis/cycles/known_cycles.hpp"

#include "analysis/threads.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace swirl::analysis {

/// The mean of the first coordinate that is no angle; 0 if all are.
double KnownCycles::mean_of(const CyclePoints& points) const {
    const auto plain = std::find(map_.angle_periods.begin(), map_.angle_periods.end(), 0.0);
    if (plain == map_.angle_periods.end()) return 0;
    double sum = 0;
    for (const auto& z : points) sum += z[plain - map_.angle_periods.begin()];
    return sum / static_cast<double>(points.size());
}

std::optional<std::size_t> KnownCycles::position_of(const CyclePoints& points) const {
    const double mean = mean_of(points);
    const auto begin = by_mean_.lower_bound(mean - 2 * same_), end = by_mean_.upper_bound(mean + 2 * same_);
    const auto known = std::find_if(begin, end, [&](const auto& entry) {
        return distance_between(map_, cycles_[entry.second].points, points) <= same_;
    });
    if (known == end) return {};
    return known->second;
}

std::optional<std::size_t> KnownCycles::position_of_family_of(const CyclePoints& points, Eigen::Index dimension) const {
    for (std::size_t i = 0; i < cycles_.size(); ++i) {
        const Cycle& other = cycles_[i];
        if (!other.is_family() || other.period() != points.size()) continue;
        if (!curves_[i].members.empty() && belongs_to(map_, curves_[i], points)) return i;
        if (other.tangents.cols() > 1 && other.tangents.cols() == dimension &&
            (is_reachable(map_, p_, other.points, points) || is_reachable(map_, p_, points, other.points)))
            return i;
    }
    return {};
}

bool KnownCycles::add(const CyclePoints& points, double residual) {
    const auto seen_again = [this](std::size_t position) {
        ++cycles_[position].found;
        return false;
    };
    if (const auto position = position_of(points)) return seen_again(*position);
    const ShootingResidual shooting = shooting_residual(map_, points, p_);
    if (!shooting.alive) return false;
    const Eigen::MatrixXd tangents = family_directions(shooting, map_.dimension);
    if (one_per_family_ && tangents.cols() > 0)
        if (const auto position = position_of_family_of(points, tangents.cols())) return seen_again(*position);
    Cycle cycle;
    for (const auto& z : points) cycle.points.push_back(map_.normalised(z));
    cycle.residual = residual;
    cycle.found = 1;
    cycle.tangents = tangents;
    const bool curve = one_per_family_ && tangents.cols() == 1;
    curves_.push_back(curve ? walk_family(map_, p_, cycle) : FamilyCurve{});
    by_mean_.emplace(mean_of(points), cycles_.size());
    cycles_.push_back(std::move(cycle));
    return true;
}

std::vector<std::int64_t> KnownCycles::times_found() const {
    std::vector<std::int64_t> times;
    for (const Cycle& cycle : cycles_) times.push_back(cycle.found);
    return times;
}

std::vector<Cycle> KnownCycles::completed(int threads) const {
    std::vector<Cycle> cycles = cycles_;
    std::vector<char> done(cycles.size(), 0);
    on_threads(threads, [&] {
        tbb::parallel_for(std::size_t{0}, cycles.size(),
                          [&](std::size_t i) { done[i] = complete_cycle(map_, p_, cycles[i]) ? 1 : 0; });
    });
    std::vector<Cycle> result;
    for (std::size_t i = 0; i < cycles.size(); ++i)
        if (done[i] != 0) result.push_back(std::move(cycles[i]));
    return result;
}

}  // namespace swirl::analysis
