// What the names of a table's columns say: times, frames, bodies, angles, points, what is no value.
#pragma once

#include "apps/input/delimited_file.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

/// "t", "Time", "time [s]", "t_ms": t or time, and then no letter or digit.
bool names_time(const std::string& name);
/// Times by another name: "seconds", "POSITION_T", "Item3.Timestamp", "Age [yr]".
bool may_name_time(const std::string& name);
/// "frame", "Frame#", "frame_idx", "imageNumber", "Slice n°", "fnum"; not OCTRON's frame_counter, which passes over
/// frames that were not analysed.
bool names_frame(const std::string& name);
/// "S" or "spin".
bool names_spin(const std::string& name);
/// A column that tells bodies apart: "particle", "track_id", "Track n°", "individual", "Arena".
bool names_body(const std::string& name);
/// "θ", "angle", "Orientation", "ELLIPSE_THETA".
bool names_angle(const std::string& name);
/// How sure a tracker is: "tip.likelihood", "confidence", "instance.score".
bool names_likelihood(const std::string& name);
/// No quantity that is measured of a body: a frame, an identity, a quality, an error, a row's number.
bool names_no_value(const std::string& name);

/// A unit of angles that is no radian: "deg", "degrees", "°".
bool names_degrees(const std::string& unit);

/// Two columns that are the coordinates of one point.
struct PointColumns {
    std::string name;  ///< what its two names share: "tip", "Arena0_Ind0"; "" of plain x and y
    std::size_t x = 0, y = 0;
    std::optional<std::size_t> likelihood;  ///< of this point, or of all
};

/// The pairs whose names differ in one word, x and y ("tip.x", "POSITION_X", "X (cm)", "x1", "X_Arena0_Ind0"), in the
/// order of the file; no boxes, speeds or errors.
std::vector<PointColumns> points_in(const DelimitedFile& file);

/// How many seconds a unit of time is: "ms" is 1e-3; nothing of what is no unit of time.
std::optional<double> seconds_in(const std::string& unit);

}  // namespace swirl::apps
