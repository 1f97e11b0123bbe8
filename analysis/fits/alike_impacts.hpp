// Impacts that differ by their errors alone are one impact that was measured many times.
//
// A body in a steady mode repeats one impact. Its measurements make a cloud, of which only the middle tells anything of
// the law: the cloud's shape is that of the errors, and a law fitted to it is fitted to what is assumed of them.
#pragma once

#include "analysis/fits/measured_impact.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::analysis {

/// Impacts that are fitted as one.
struct AlikeImpacts {
    std::vector<std::size_t> members;
    std::size_t kind = 0;   ///< parts of one cloud have the same
    std::size_t parts = 1;  ///< into so many it was dealt
    bool merged() const { return members.size() > 1; }
};

/// Clouds of `fewest_alike` impacts or more, and the others, each alone, in the order of their first members. The
/// members of a cloud lie within 5.5 errors of its middle in the six components of both velocities, and scatter about
/// it by no more than 1.4 times their errors: where impacts truly differ by more, the law is told by how they do. A
/// cloud is found about the impact with the most neighbours, then about the most of those that are left. If there are
/// fewer than `enough_groups`, clouds are dealt into equal parts, their members in turn. O(impacts²).
std::vector<AlikeImpacts> alike_impacts(std::span<const MeasuredImpact> impacts);
inline constexpr std::size_t fewest_alike = 8;
inline constexpr std::size_t enough_groups = 20;

/// What is common to the errors of alike impacts (frames about a kink on the wrong line, axes turned: squares of the
/// errors), in errors of one: no mean is better than this, however many there are.
inline constexpr double common_error = 0.2;

/// Impacts that count `weights` times.
struct WeighedImpacts {
    std::vector<MeasuredImpact> impacts;
    std::vector<double> weights;
};

/// One impact a group: the mean of its members, member i counted weights[i] times; its errors are √(1/n +
/// common_error²) of one's, and all of this once. A single member counts as often as its weight says; groups of weight
/// 0 are left at 0.
WeighedImpacts merged_impacts(std::span<const MeasuredImpact> impacts, std::span<const double> weights,
                              std::span<const AlikeImpacts> groups);

/// Each cloud moved by a common error drawn at random (all parts of one alike), as a resample sees it.
void move_clouds(WeighedImpacts& merged, std::span<const AlikeImpacts> groups, std::uint64_t seed, std::uint64_t draw);

}  // namespace swirl::analysis
