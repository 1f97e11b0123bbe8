// What the names above a table's numbers say: the rows of names, made into one name a column, and their meaning.
#pragma once

#include "apps/input/delimited_file.hpp"
#include "apps/input/table_layout.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

// What the names of a table's columns say: times, frames, bodies, angles, points, what is no value.

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

/// How many radians per second a unit of rates of turn is: "rad/s" is 1, "rpm" 2π/60; nothing of what is no such unit.
std::optional<double> turning_rate_in(const std::string& unit);
/// The same of a column, by its unit or the end of its name ("omega_rad_s", "spin_rpm").
std::optional<double> turning_rate_of(const DelimitedFile& file, std::size_t column);

/// Two columns that are the coordinates of one point.
struct PointColumns {
    std::string name;  ///< what its two names share: "tip", "Arena0_Ind0"; "" of plain x and y
    std::size_t x = 0, y = 0;
    std::optional<std::size_t> likelihood;  ///< of this point, or of all
};

/// The pairs whose names differ in one word, x and y ("tip.x", "POSITION_X", "X (cm)", "x1", "X_Arena0_Ind0"), in the
/// order of the file; no boxes, speeds or errors.
std::vector<PointColumns> points_in(const DelimitedFile& file);

/// The unit that a column names, without its brackets; empty where it names none.
std::string unit_of_column(const DelimitedFile& file, std::size_t column);

/// How many radians a unit of angles is: "deg", "turns", "gon", "mrad"; nothing of what is no such unit.
std::optional<double> radians_in(const std::string& unit);

/// How many seconds a unit of time is: "ms" is 1e-3; nothing of what is no unit of time.
std::optional<double> seconds_in(const std::string& unit);

// The rows of names above a table's numbers, made into one name a column.

/// No cell is a number, and one is a word (inf and 1e400 are numbers, if bad ones).
bool is_header(const std::vector<std::string>& cells);

/// The first cell names a row of DeepLabCut's header (scorer, individuals, bodyparts, coords); others may be numbers.
bool begins_pose_row(const std::vector<std::string>& cells);

/// Names and units of the columns from the rows above lines[layout.first_row] (table_layout.hpp says which forms); what
/// stands above these is a preamble, of which a note is made.
void take_header(const std::vector<TextRow>& lines, TableLayout& layout);

/// A header that has a name less or more than rows have cells: an empty name too much, an empty cell at the end of each
/// row, or row names before them. @throws BadInput where it is none of these
void fit_header(const std::string& file, const std::vector<TextRow>& lines, TableLayout& layout);

/// A last column without a name and without a value is none: rows end in a separator.
void drop_empty_column(const std::vector<TextRow>& lines, TableLayout& layout);

}  // namespace swirl::apps
