// A measured series: one column of a text file, with its times.
#pragma once

#include "apps/input/series_choice.hpp"
#include "apps/input/series_of_motion.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace swirl::apps {

/// What the values of a series are.
inline constexpr const char* as_measured = "as measured";
inline constexpr const char* spin_of_angle = "S of an angle";
inline constexpr const char* spin_of_rate = "S of a rate";
inline constexpr const char* distance_of_position = "distance of a position";

/// A turn of more than so much of half a period, from row to row, may have been one the other way.
inline constexpr double sure_turn = 0.9;

/// An angle as it was measured, with NaN for what is missing.
struct MeasuredAngle {
    std::vector<double> times, values;  ///< radians
    double period = 0;                  ///< that it is known modulo
    double resolution = 0;              ///< it is rounded to multiples of it (decimal_resolution); 0: it isn't
};

struct MeasuredSeries {
    std::string column;                     ///< its name, or its number from 1 on; of a position both, "x, y"
    std::string time;                       ///< of the column of times; empty: none
    std::vector<double> values;             ///< NaN: missing
    std::vector<double> times;              ///< rising
    std::size_t rows = 0;                   ///< of the file
    std::size_t missing = 0;                ///< samples that are NaN, rows that were lost among them
    std::size_t gaps = 0;                   ///< runs of them
    std::string quantity;                   ///< one of the four above
    double angle_unit = 1;                  ///< of an angle as the file has it, in radians
    MeasuredAngle angle;                    ///< of an angle: its rows, one more than `values` has
    double swirl_rate = 1;                  ///< of an angle or a rate: ω_s, in radians per unit of time
    double largest_turn = std::nan("");     ///< of an angle, see AngleRates
    std::string body;                       ///< the value of --where or --each; empty: all rows are of one
    std::array<double, 2> origin = {0, 0};  ///< of positions, in the units of the columns
    bool y_down = false;                    ///< y pointed down: turns were taken the other way round
    bool clockwise = false;                 ///< the swirl went clockwise, and all turns are seen from below
    std::vector<std::string> notes;  ///< what was decided where the flags said nothing, what is likely to be wrong
    bool even = true;                ///< times lie on an even grid, see `largest_deviation`
    double spacing = 1;              ///< mean distance of the times
    double largest_step = 1;         ///< between neighbouring rows
    /// The direction of every turn of an angle is known.
    bool is_unwrapped() const { return !(largest_turn > sure_turn); }
    /// Made of an angle or a position, and so a signal in time.
    bool is_motion() const { return quantity == spin_of_angle || quantity == distance_of_position; }
    /// Samples in time: times lie on an even grid, or but for few of them do the steps between them.
    bool is_film() const;
    double largest_deviation = 0;  ///< of a time from the even grid, in spacings; up to even_within counts as even
};

/// In spacings, beyond what the last digit of the times explains: 30 frames a second printed in whole milliseconds are
/// up to 3 % off (half a millisecond of their own and half of the ends'). At the Nyquist frequency 4 % is a phase of
/// 0.13.
inline constexpr double even_within = 0.04;

/// The column that is analysed is a rate of turn by its unit ("omega (rad/s)"): over --swirl-rate it is S.
bool is_rate_column(const DelimitedFile& file, const SeriesChoice& choice);

/// An angle that spans more, in radians, is unwound, or not in radians.
inline constexpr double more_than_turn = 7;

/// Reads a series. Which columns: series_columns.hpp; what is made of them: measured_motion.hpp. A missing value is
/// kept as NaN. Values are 0 or within a scene's bounds (10⁻⁷⁵ … 10⁷⁵), so that their fourth powers can be held;
/// smaller ones are allowed if at least one value is within them. Rows without a value at either end are cut off. Rows
/// that were lost between even times are NaN (fill_lost_rows). Of an angle the values are S, half-way between the rows
/// (rates_of_angle). Of `position` they are the distance from the origin of x and y, the swirl's centre in the
/// laboratory or the container's in its own frame: either is a function of the state that rotates with the swirl, as S
/// is; it swings along every flight, in a steady mode, too. A swirl that turns clockwise is seen from below: its rate
/// and all turns change their sign, so that S > 0 is with the swirl.
/// @throws BadInput naming file, line, its text and what is allowed: see delimited_file.hpp; a missing, repeated or
/// falling time; a value or time that is too large, values that are all too small; fewer than two values; several
/// bodies
MeasuredSeries read_series(const SeriesChoice& choice);

/// `count` samples from number `first` on. @throws BadInput with fewer than two values among them
MeasuredSeries part_of(const MeasuredSeries& series, std::size_t first, std::size_t count);

/// "note: …", a line each of at most 100 columns, for tables; empty without notes.
std::string notes_in_lines(const MeasuredSeries& series);

/// "column S, 3600 rows, spacing 0.0333333, 1 gap (2 samples missing)", for tables.
std::string series_in_words(const MeasuredSeries& series);

}  // namespace swirl::apps
