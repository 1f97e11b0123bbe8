#include "analysis/fits/alike_impacts.hpp"

#include "analysis/fits/robust.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace swirl::analysis {

namespace {

using Velocities = Eigen::Matrix<double, 6, 1>;

/// Six normal errors reach so far once in 1000, by variances up to a third larger (errors that go together).
constexpr double cloud_reach = 30;
/// Per component, of a cloud's scatter in squared errors.
constexpr double widest_cloud = 2;

/// Both velocities in units of the median errors.
std::vector<Velocities> in_errors(std::span<const MeasuredImpact> impacts) {
    Velocities errors;
    for (Eigen::Index k = 0; k < 3; ++k) {
        std::vector<double> before, after;
        for (const MeasuredImpact& impact : impacts)
            before.push_back(impact.error_before[k]), after.push_back(impact.error_after[k]);
        errors[k] = quantile(std::move(before), 0.5), errors[3 + k] = quantile(std::move(after), 0.5);
    }
    std::vector<Velocities> all;
    for (const MeasuredImpact& impact : impacts) {
        Velocities both;
        both << impact.before, impact.after;
        all.emplace_back(both.cwiseQuotient(errors));
    }
    return all;
}

/// Of those that are left, within the reach of a place.
std::vector<std::size_t> within_reach(const std::vector<Velocities>& all, const std::vector<bool>& left,
                                      const Velocities& place) {
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (left[i] && (all[i] - place).squaredNorm() <= cloud_reach) near.push_back(i);
    return near;
}

/// How many of them lie within the reach of a place.
std::size_t count_within_reach(const std::vector<Velocities>& all, const std::vector<std::size_t>& left,
                               const Velocities& place) {
    return static_cast<std::size_t>(std::count_if(
        left.begin(), left.end(), [&](std::size_t i) { return (all[i] - place).squaredNorm() <= cloud_reach; }));
}

Velocities middle_of(const std::vector<Velocities>& all, const std::vector<std::size_t>& members) {
    Velocities sum = Velocities::Zero();
    for (const std::size_t i : members) sum += all[i];
    return sum / static_cast<double>(members.size());
}

/// About the densest place among those that are left: the members among those that are alone; empty if there is none.
std::vector<std::size_t> next_cloud(const std::vector<Velocities>& all, std::vector<bool>& left,
                                    const std::vector<bool>& alone) {
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (left[i]) candidates.push_back(i);
    std::size_t most = 0, densest = 0;
    for (const std::size_t i : candidates)
        if (const std::size_t near = count_within_reach(all, candidates, all[i]); near > most) most = near, densest = i;
    if (most < fewest_alike) return {};
    std::vector<std::size_t> cloud = within_reach(all, left, all[densest]);
    for (const std::size_t i : cloud) left[i] = false;
    constexpr int rounds = 5;
    for (int round = 0; round < rounds; ++round) {
        std::vector<std::size_t> moved = within_reach(all, alone, middle_of(all, cloud));
        if (moved.empty()) break;
        cloud = std::move(moved);
    }
    for (const std::size_t i : cloud) left[i] = false;
    return cloud;
}

bool is_narrow(const std::vector<Velocities>& all, const std::vector<std::size_t>& cloud) {
    const Velocities middle = middle_of(all, cloud);
    double sum = 0;
    for (const std::size_t i : cloud) sum += (all[i] - middle).squaredNorm();
    return sum <= 6 * widest_cloud * static_cast<double>(cloud.size() - 1);
}

/// Clouds in parts, so that there are enough groups, of `fewest_alike` members at least.
std::vector<AlikeImpacts> dealt(const std::vector<std::vector<std::size_t>>& clouds, std::size_t singles) {
    std::vector<AlikeImpacts> groups;
    const std::size_t wanted = singles + clouds.size() >= enough_groups || clouds.empty()
                                   ? 1
                                   : (enough_groups - singles + clouds.size() - 1) / clouds.size();
    for (std::size_t kind = 0; kind < clouds.size(); ++kind) {
        const std::size_t parts = std::clamp(clouds[kind].size() / fewest_alike, std::size_t{1}, wanted);
        for (std::size_t part = 0; part < parts; ++part) {
            AlikeImpacts group{{}, kind, parts};
            for (std::size_t k = part; k < clouds[kind].size(); k += parts) group.members.push_back(clouds[kind][k]);
            groups.push_back(std::move(group));
        }
    }
    return groups;
}

}  // namespace

std::vector<AlikeImpacts> alike_impacts(std::span<const MeasuredImpact> impacts) {
    const std::vector<Velocities> all = in_errors(impacts);
    std::vector<bool> left(all.size(), true), alone(all.size(), true);
    std::vector<std::vector<std::size_t>> clouds;
    std::size_t singles = all.size();
    while (true) {
        std::vector<std::size_t> cloud = next_cloud(all, left, alone);
        if (cloud.empty()) break;
        if (cloud.size() < fewest_alike || !is_narrow(all, cloud)) continue;
        for (const std::size_t i : cloud) alone[i] = false;
        singles -= cloud.size();
        clouds.push_back(std::move(cloud));
    }
    std::vector<AlikeImpacts> groups = dealt(clouds, singles);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (alone[i]) groups.push_back({{i}, clouds.size() + i, 1});
    std::sort(groups.begin(), groups.end(),
              [](const AlikeImpacts& a, const AlikeImpacts& b) { return a.members.front() < b.members.front(); });
    return groups;
}

WeighedImpacts merged_impacts(std::span<const MeasuredImpact> impacts, std::span<const double> weights,
                              std::span<const AlikeImpacts> groups) {
    WeighedImpacts merged;
    for (const AlikeImpacts& group : groups) {
        if (!group.merged()) {
            merged.impacts.push_back(impacts[group.members.front()]);
            merged.weights.push_back(weights[group.members.front()]);
            continue;
        }
        double count = 0;
        for (const std::size_t i : group.members) count += weights[i];
        const bool is_drawn = count > 0;
        if (!is_drawn) count = static_cast<double>(group.members.size());
        MeasuredImpact mean;
        mean.before.setZero(), mean.after.setZero(), mean.offset.setZero();
        Eigen::Vector3d before = Eigen::Vector3d::Zero(), after = before;  // squared errors
        std::optional<ImpactCovariance> covariance = impacts[group.members.front()].covariance;
        if (covariance) covariance->setZero();
        for (const std::size_t i : group.members) {
            const double share = (is_drawn ? weights[i] : 1) / count;
            mean.before += share * impacts[i].before, mean.after += share * impacts[i].after;
            mean.offset += share * impacts[i].offset;
            if (covariance) *covariance += share * impacts[i].covariance.value();
            before += share * impacts[i].error_before.cwiseAbs2(), after += share * impacts[i].error_after.cwiseAbs2();
        }
        const double share = 1 / count + common_error * common_error * static_cast<double>(group.parts);
        if (covariance) mean.covariance = share * *covariance;
        mean.error_before = (share * before).cwiseSqrt(), mean.error_after = (share * after).cwiseSqrt();
        merged.impacts.push_back(mean);
        merged.weights.push_back(is_drawn ? 1 : 0);
    }
    return merged;
}

void move_clouds(WeighedImpacts& merged, std::span<const AlikeImpacts> groups, std::uint64_t seed, std::uint64_t draw) {
    constexpr std::uint64_t clouds_after = 1ULL << 16;  // beyond the draws for frames
    for (std::size_t g = 0; g < groups.size(); ++g) {
        if (!groups[g].merged()) continue;
        MeasuredImpact& impact = merged.impacts[g];
        const double parts = static_cast<double>(groups[g].parts),
                     members = static_cast<double>(groups[g].members.size());
        const double share = common_error / std::sqrt(1 / members + common_error * common_error * parts);
        impact.before +=
            share * impact.error_before.cwiseProduct(normal_draws(seed, clouds_after + draw, 2 * groups[g].kind));
        impact.after +=
            share * impact.error_after.cwiseProduct(normal_draws(seed, clouds_after + draw, 2 * groups[g].kind + 1));
    }
}

}  // namespace swirl::analysis
