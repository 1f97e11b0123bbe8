// A body's places and angles, of the columns that a choice names.
#pragma once

#include "apps/input/measured_series.hpp"
#include "apps/input/series_choice.hpp"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace swirl::apps::fit {

struct BodyTrack {
    MeasuredSeries turns;                     ///< of the angle
    std::vector<std::vector<double>> places;  ///< x and y of the angle's rows, in the columns' units, y as it points
    std::array<double, 2> zero = {0, 0};      ///< what was taken off them
    double step = 0;                          ///< the larger of those on which their values lie
    bool of_marks = false;                    ///< the angle is that of two points
    std::vector<std::string> notes;

    /// −1: y points down, or the swirl is seen from below.
    double mirror() const { return turns.y_down == turns.clockwise ? 1 : -1; }
    /// Standard deviation of x, y and θ by the rounding of what was written alone, each part of a step being as likely;
    /// places in units of `length`.
    Eigen::Vector3d rounding_noise(double length) const;
};

/// @throws BadInput for columns that are no body's places and angle
void require_body(const SeriesChoice& series, const std::string& angle);

/// Reads angle and places: `angle` or --marks, and --position, without which the first of the marks is the centre.
/// Frames that were lost are NaN, ends without values cut off.
///   swirl_rate  as text, see SeriesChoice::set_swirl_rate()
/// @throws BadInput for what read_series() refuses
BodyTrack read_track(const SeriesChoice& series, const std::string& angle, const std::string& swirl_rate);

/// Those that are not there yet.
void add_notes(std::vector<std::string>& notes, const std::vector<std::string>& others);

}  // namespace swirl::apps::fit
