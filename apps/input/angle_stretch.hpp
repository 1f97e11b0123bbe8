// The longest part of a measured angle that can be followed, at even times.
#pragma once

#include "apps/input/measured_series.hpp"

#include <cstddef>
#include <vector>

namespace swirl::apps {

/// Of lost rows a few at a time are put in, on the straight line between their neighbours.
inline constexpr std::size_t most_bridged = 3;
/// More than so much of a stretch is not made up: then it ends where rows are lost.
inline constexpr double most_made_up = 0.05;

struct AngleStretch {
    std::size_t first = 0;         ///< row of the series' angle
    std::vector<double> angles;    ///< unwrapped, radians
    std::size_t bridged = 0;       ///< so many of them were lost
    double spacing = 0;            ///< of the even times that fit best, in the series' unit
    double largest_deviation = 0;  ///< of a time from them, in spacings

    /// Each row has a place of its own on the even times.
    bool is_even() const { return largest_deviation <= 0.5; }
};

/// A gap is bridged if its rows are few and the turn across it can only be the one that is nearest to the mean turn: as
/// far as turns from row to row deviate from their mean, so many times do not reach half a period. Longer ones, and
/// steps without a place on even times, end a stretch.
///
/// Where times are even but for their last digits, the angle may have been taken at the even times (the digits were
/// rounded), or at the times as they stand (the clock was not even): of θ_i and θ_i − S (t_i − even time) the second is
/// taken if it halves the sum of squared second differences. O(rows).
/// @throws BadInput if no two rows follow each other
AngleStretch longest_stretch(const MeasuredAngle& angle);

/// S of an angle, with what lies beside the gaps that longest_stretch() would bridge: the mean S across each of them.
/// None, where more than most_made_up of the rows would be made up. `bridged`: so many rows. O(rows).
struct BridgedSpin {
    std::vector<double> values;
    std::size_t bridged = 0;
};
BridgedSpin bridged_spin(const MeasuredSeries& series);

}  // namespace swirl::apps
