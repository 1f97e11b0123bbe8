#include "apps/studies/fits/noisier_films.hpp"

#include "analysis/fits/robust.hpp"
#include "apps/studies/fits/film_impacts.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace swirl::studies {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Each alone where too few would be left.
std::vector<analysis::AlikeImpacts> groups_of(std::span<const analysis::MeasuredImpact> impacts) {
    std::vector<analysis::AlikeImpacts> groups = analysis::alike_impacts(impacts);
    if (groups.size() >= analysis::fewest_impacts) return groups;
    groups.clear();
    for (std::size_t i = 0; i < impacts.size(); ++i) groups.push_back({{i}, i, 1});
    return groups;
}

/// μ of a noisier film that is so many times the other, or less than one over that, is another minimum's.
constexpr double another_minimum = 1.5;

void lengthen(analysis::FittedNumber& number, double shift) {
    number.low = std::max(0.0, number.low - std::max(0.0, shift));
    number.high -= std::min(0.0, shift);
}

}  // namespace

FittedGroups fitted_groups(std::span<const analysis::MeasuredImpact> impacts) {
    const std::vector<analysis::AlikeImpacts> groups = groups_of(impacts);
    const auto singles = static_cast<std::size_t>(
        std::count_if(groups.begin(), groups.end(), [](const auto& group) { return !group.merged(); }));
    const std::size_t kept = std::min(singles, most_fitted_impacts);
    FittedGroups fitted;
    fitted.thinned = singles - kept;
    std::size_t single = 0;
    for (const analysis::AlikeImpacts& group : groups) {
        bool is_kept = group.merged();
        if (is_kept) {
            fitted.alike += group.members.size();
        } else {  // kept evenly
            is_kept = (single + 1) * kept / singles > single * kept / singles;
            ++single;
        }
        if (is_kept) fitted.groups.push_back(group);
    }
    return fitted;
}

std::vector<analysis::FilmFrame> with_more_noise(std::span<const analysis::FilmFrame> frames,
                                                 const Eigen::Matrix3d& covariance, std::uint64_t seed,
                                                 std::size_t draw) {
    const Eigen::Matrix3d root = covariance.llt().matrixL();
    std::vector<analysis::FilmFrame> noisier(frames.begin(), frames.end());
    for (std::size_t i = 0; i < noisier.size(); ++i) {
        Vector3d& place = noisier[i].place;
        Vector3d added = root * analysis::normal_draws(seed, draw, i);
        added.head<2>() = Eigen::Rotation2Dd(place[2]) * Vector2d(added.head<2>());
        place += added;
    }
    return noisier;
}

void add_share(std::vector<analysis::MeasuredImpact>& seen, double share,
               const std::vector<analysis::MeasuredImpact>& moved,
               const std::vector<analysis::MeasuredImpact>& impacts) {
    for (std::size_t i = 0; i < seen.size(); ++i) {
        seen[i].before += share * (moved[i].before - impacts[i].before);
        seen[i].after += share * (moved[i].after - impacts[i].after);
        seen[i].offset += share * (moved[i].offset - impacts[i].offset);
    }
}

NoiseShift add_noise_shift(analysis::ImpactFit& fit, std::span<const analysis::ImpactFit> noisier) {
    analysis::FittedNumber &e = fit.restitution, &mu = fit.friction;
    NoiseShift shift;
    std::vector<double> others;
    double near = 0;
    for (const analysis::ImpactFit& other : noisier) {
        shift.restitution += other.restitution.value - e.value;
        const double ratio = other.friction.value / mu.value;
        if (fit.friction_open || ratio > another_minimum || ratio * another_minimum < 1)
            others.push_back(other.friction.value);
        else
            shift.friction += other.friction.value - mu.value, near += 1;
    }
    if (noisier.empty()) return shift;
    shift.restitution /= static_cast<double>(noisier.size());
    shift.friction /= std::max(1.0, near);
    // Resamples of few different impacts may lie to one side of what they are resamples of.
    const double room = std::max(e.value - e.low, e.high - e.value);
    e.low = std::max(0.0, e.value - room), e.high = e.value + room;
    lengthen(e, shift.restitution);
    e.high = std::min(1.0, e.high);
    // Of μ where both ends belong to one minimum.
    constexpr double lopsided = 5;
    const double below = mu.value - mu.low, above = mu.high - mu.value;
    if (above < lopsided * below && below < lopsided * above)
        mu.low = std::max(0.0, mu.value - std::max(below, above)), mu.high = mu.value + std::max(below, above);
    lengthen(mu, shift.friction);
    for (const double other : others) mu.low = std::min(mu.low, other), mu.high = std::max(mu.high, other);
    constexpr double held = analysis::largest_friction / 2;  // no impact tells friction from any that is larger
    fit.friction_open = fit.friction_open || mu.high > held;
    if (fit.friction_open) mu.value = mu.high = analysis::nan;
    return shift;
}

}  // namespace swirl::studies
