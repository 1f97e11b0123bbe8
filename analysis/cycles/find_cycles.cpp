#include "analysis/cycles/find_cycles.hpp"

#include "analysis/threads.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <utility>

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

namespace {

/// The variance of f₀ (Chao & Colwell 2005, for all f₂ ≥ 0).
double variance_of(double share, double once, double twice) {
    const double pairs = once * (once - 1), more = twice + 1, odd = 2 * once - 1;
    return share * pairs / (2 * more) + share * share * once * odd * odd / (4 * more * more) +
           share * share * once * once * twice * (once - 1) * (once - 1) / (4 * std::pow(more, 4));
}

}  // namespace

UnseenCycles unseen_cycles(std::span<const std::int64_t> times) {
    constexpr double normal = 1.96;  // standard deviations that hold 95 %
    UnseenCycles unseen;
    for (const std::int64_t n : times) {
        ++unseen.found;
        unseen.samples += n;
        unseen.once += n == 1 ? 1 : 0;
        unseen.twice += n == 2 ? 1 : 0;
    }
    if (unseen.samples == 0) return unseen;
    const auto n = static_cast<double>(unseen.samples), once = static_cast<double>(unseen.once);
    const auto twice = static_cast<double>(unseen.twice);
    const double share = (n - 1) / n;
    unseen.missed = share * once * std::max(0.0, once - 1) / (2 * (twice + 1));  // 0 has no sign
    if (unseen.missed == 0) return unseen;
    const double spread = variance_of(share, once, twice) / (unseen.missed * unseen.missed);
    const double factor = std::exp(normal * std::sqrt(std::log1p(spread)));
    unseen.least_missed = unseen.missed / factor;
    unseen.most_missed = unseen.missed * factor;
    return unseen;
}

namespace {

struct Solved {
    CyclePoints points;  ///< empty: nothing converged
    double residual = 0;
};

std::vector<Solved> solve_all(const ShootingMap& map, double p, const std::vector<CyclePoints>& candidates,
                              const SearchOptions& options, SearchCounts& counts) {
    std::vector<Solved> solved(candidates.size());
    std::mutex mutex;
    on_threads(options.threads, [&] {
        tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
            if (options.stop && options.stop()) return;
            ShootingResult shot = solve_shooting(map, candidates[i], p, options.accept, options.shooting);
            if (!shot.converged && options.timed != nullptr)
                shot = solve_near_grazing(map, *options.timed, candidates[i], p, options.accept, options.shooting);
            if (shot.converged) solved[i] = {minimal_cycle(map, shot.points, options.same), shot.residual};
            const std::lock_guard lock(mutex);
            ++counts.tried;
            if (options.progress) options.progress(static_cast<double>(counts.tried));
        });
    });
    return solved;
}

}  // namespace

SearchCounts add_cycles(const ShootingMap& map, double p, const std::vector<CyclePoints>& candidates,
                        const SearchOptions& options, KnownCycles& known) {
    SearchCounts counts;
    for (const Solved& found : solve_all(map, p, candidates, options, counts)) {
        if (found.points.empty()) continue;
        ++counts.converged;
        if (found.points.size() != static_cast<std::size_t>(options.period)) continue;
        if (!options.wanted || options.wanted(found.points)) known.add(found.points, found.residual);
    }
    return counts;
}

SearchResult find_cycles(const ShootingMap& map, double p, const std::vector<CyclePoints>& candidates,
                         const SearchOptions& options) {
    SearchResult result;
    KnownCycles known(map, p, options.same, options.one_per_family);
    result.counts = add_cycles(map, p, candidates, options, known);
    result.cycles = known.completed(options.threads);
    result.stopped = options.stop && options.stop();
    return result;
}

std::vector<CyclePoints> close_returns(const ShootingMap& map, const CyclePoints& trajectory, int k, int count,
                                       double vicinity) {
    const auto lag = static_cast<std::size_t>(k);
    if (trajectory.size() < lag + 3) return {};
    std::vector<double> returned;
    for (std::size_t i = 0; i + lag < trajectory.size(); ++i)
        returned.push_back((map.difference(trajectory[i + lag], trajectory[i])).norm());
    std::vector<std::pair<double, std::size_t>> minima;
    for (std::size_t i = 1; i + 1 < returned.size(); ++i)
        if (returned[i] <= vicinity && returned[i] <= returned[i - 1] && returned[i] <= returned[i + 1])
            minima.emplace_back(returned[i], i);
    std::sort(minima.begin(), minima.end());
    std::vector<CyclePoints> candidates;
    for (std::size_t i = 0; i < minima.size() && i < static_cast<std::size_t>(count); ++i) {
        const auto first = trajectory.begin() + static_cast<std::ptrdiff_t>(minima[i].second);
        candidates.emplace_back(first, first + k);
    }
    return candidates;
}

}  // namespace swirl::analysis
